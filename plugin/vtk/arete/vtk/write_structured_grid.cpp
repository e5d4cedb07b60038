// SPDX-License-Identifier: MIT
#include "arete/vtk/write_structured_grid.h"

#include <vtkNew.h>
#include <vtkStructuredGrid.h>
#include <vtkXMLStructuredGridWriter.h>

#include <limits>

#include "arete/vtk/internal/field_data.h"
#include "arete/vtk/internal/point_arrays.h"
#include "arete/vtk/internal/xml_file.h"

namespace arete::vtk {

void write_structured_grid(const Surface& surface, const std::filesystem::path& path,
                           const WriteOptions& options) {
  check_geometry(surface);
  const LocalPlane plane = local_plane(surface);
  const SampleOrder order = right_handed_order(surface);
  const Extent extent = surface.extent();
  constexpr Index most = std::numeric_limits<int>::max();
  if (extent.rows > most || extent.cols > most) {
    throw InvalidField("a .vts holds at most 2147483647 samples a side");
  }
  vtkNew<vtkStructuredGrid> grid;
  grid->SetDimensions(static_cast<int>(extent.cols), static_cast<int>(extent.rows), 1);
  add_surface_points(
      surface, plane, extent.rows * extent.cols, [&](Index point) { return order.at(point); },
      *grid);
  add_field_data(surface, plane, *grid);
  vtkNew<vtkXMLStructuredGridWriter> writer;
  write_xml(*writer, *grid, path, options);
}

}  // namespace arete::vtk
