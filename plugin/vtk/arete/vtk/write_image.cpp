// SPDX-License-Identifier: MIT
#include "arete/vtk/write_image.h"

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkXMLImageDataWriter.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "arete/vtk/internal/field_data.h"
#include "arete/vtk/internal/point_arrays.h"
#include "arete/vtk/internal/xml_file.h"

namespace arete::vtk {
namespace {

/// Where an image with VTK's conventions lies, and which sample its point (0, 0) is.
struct Placement {
  SampleOrder order;
  std::array<double, 2> spacing{};
  std::array<double, 9> direction{1, 0, 0, 0, 1, 0, 0, 0, 1};
};

void check_shear(const Surface& surface) {
  const auto& g = surface.georeference.affine;
  const double col_step = std::hypot(g[1], g[4]);
  const double row_step = std::hypot(g[2], g[5]);
  if (!(col_step > 0 && row_step > 0)) {
    throw InvalidField("the georeference gives the samples no spacing");
  }
  const double cosine = (g[1] * g[2] + g[4] * g[5]) / (col_step * row_step);
  const auto length = static_cast<double>(std::max(surface.extent().rows, surface.extent().cols));
  if (std::abs(cosine) * length > 1e-3) {
    throw InvalidField(
        "the georeference is sheared, which a .vti cannot express; write .vts or .vtp instead");
  }
}

Placement place(const Surface& surface) {
  const auto& g = surface.georeference.affine;
  Placement placement;
  placement.order = right_handed_order(surface);
  placement.spacing = {std::hypot(g[1], g[4]), std::hypot(g[2], g[5])};
  if (g[2] == 0 && g[4] == 0) {
    // Axis-aligned: by flipping alone, since many filters look at origin and spacing only.
    placement.order.flip_cols = g[1] < 0;
    placement.order.flip_rows = g[5] < 0;
    return placement;
  }
  const double sign = placement.order.flip_rows ? -1 : 1;
  const auto [dx, dy] = placement.spacing;
  placement.direction = {g[1] / dx, sign * g[2] / dy, 0, g[4] / dx, sign * g[5] / dy, 0, 0, 0, 1};
  return placement;
}

int dimension(Index count) {
  if (count > std::numeric_limits<int>::max()) {
    throw InvalidField("a .vti holds at most 2147483647 samples a side");
  }
  return static_cast<int>(count);
}

}  // namespace

void write_image(const Surface& surface, const std::filesystem::path& path,
                 const WriteOptions& options) {
  check_samples(surface);
  check_shear(surface);
  const Extent extent = surface.extent();
  const Placement placement = place(surface);
  const Sample first = placement.order.at(0);
  const WorldPoint origin =
      surface.georeference.position(static_cast<double>(first.row), static_cast<double>(first.col));
  vtkNew<vtkImageData> image;
  image->SetDimensions(dimension(extent.cols), dimension(extent.rows), 1);
  image->SetOrigin(origin.x, origin.y, 0);
  image->SetSpacing(placement.spacing[0], placement.spacing[1], 1);
  image->SetDirectionMatrix(placement.direction.data());
  add_heights(
      surface, extent.rows * extent.cols, [&](Index point) { return placement.order.at(point); },
      *image);
  add_field_data(surface, *image);
  vtkNew<vtkXMLImageDataWriter> writer;
  write_xml(*writer, *image, path, options);
}

}  // namespace arete::vtk
