// SPDX-License-Identifier: MIT
#include "arete/vtk/write_polydata.h"

#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataWriter.h>

#include "arete/vtk/internal/field_data.h"
#include "arete/vtk/internal/point_arrays.h"
#include "arete/vtk/internal/quads.h"
#include "arete/vtk/internal/xml_file.h"

namespace arete::vtk {

void write_polydata(const Surface& surface, const std::filesystem::path& path,
                    const WriteOptions& options) {
  check_geometry(surface);
  const LocalPlane plane = local_plane(surface);
  const Index cols = surface.extent().cols;
  vtkNew<vtkPolyData> mesh;
  const std::vector<Index> samples = set_quads(surface, *mesh);
  if (samples.empty()) {
    throw InvalidField("no four neighbouring samples are all valid: there is no quad to write");
  }
  const auto sample_of = [&](Index point) -> Sample {
    const Index sample = samples[static_cast<std::size_t>(point)];
    return {sample / cols, sample % cols};
  };
  add_surface_points(surface, plane, static_cast<Index>(samples.size()), sample_of, *mesh);
  add_field_data(surface, plane, *mesh);
  vtkNew<vtkXMLPolyDataWriter> writer;
  write_xml(*writer, *mesh, path, options);
}

}  // namespace arete::vtk
