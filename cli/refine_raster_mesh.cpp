// SPDX-License-Identifier: MIT
#include "cli/refine_raster_mesh.h"

#include <limits>

#include "arete/field/local_plane.h"
#include "arete/openmesh/mesh_io.h"
#include "cli/find_band.h"
#include "cli/memory_size.h"
#include "cli/refine_grid.h"

namespace arete::cli {
namespace {

// Points, texture coordinates, faces, numbers of vertices.
constexpr double bytes_per_sample = 24 + 8 + 20 + 4;

template <class T>
bool whole_quad(const Grid<T>& heights, Index r, Index c) {
  return std::isfinite(heights(r, c)) && std::isfinite(heights(r, c + 1)) &&
         std::isfinite(heights(r + 1, c)) && std::isfinite(heights(r + 1, c + 1));
}

// The vertex numbers of those samples that belong to a whole quad, -1 for the others.
template <class T>
std::vector<int> numbered(const Grid<T>& heights, int& count, std::size_t& quads) {
  std::vector<int> numbers(heights.samples().size(), -1);
  const Index cols = heights.cols();
  quads = 0;
  for (Index r = 0; r + 1 < heights.rows(); ++r) {
    for (Index c = 0; c + 1 < cols; ++c) {
      if (!whole_quad(heights, r, c)) continue;
      ++quads;
      for (Index i : {r * cols + c, r * cols + c + 1, (r + 1) * cols + c, (r + 1) * cols + c + 1})
        numbers[static_cast<std::size_t>(i)] = 0;
    }
  }
  count = 0;
  for (int& number : numbers)
    if (number == 0) number = count++;
  return numbers;
}

template <class T>
openmesh::MeshData mesh_of(const Grid<T>& heights, const LocalPlane& plane,
                           const Refiner<T>& refiner, bool textured) {
  int vertices = 0;
  std::size_t quads = 0;
  const std::vector<int> numbers = numbered(heights, vertices, quads);
  openmesh::MeshData mesh;
  mesh.points.reserve(static_cast<std::size_t>(vertices));
  mesh.faces.starts.reserve(quads + 1);
  mesh.faces.corners.reserve(4 * quads);
  const AxisPlacement rows = refiner.y().placement();
  const AxisPlacement cols = refiner.x().placement();
  const auto& g = plane.placement.affine;
  // Rows to the south and columns to the east: (r, c), (r + 1, c), ... is counter-clockwise.
  const bool clockwise = g[1] * g[5] - g[2] * g[4] < 0;
  for (Index r = 0; r < heights.rows(); ++r) {
    for (Index c = 0; c < heights.cols(); ++c) {
      const int number = numbers[static_cast<std::size_t>(r * heights.cols() + c)];
      if (number < 0) continue;
      const auto row = static_cast<double>(r);
      const auto col = static_cast<double>(c);
      const WorldPoint p = plane.placement.position(row, col);
      mesh.points.push_back({p.x, p.y, static_cast<double>(heights(r, c))});
      if (textured)
        mesh.texcoords.push_back(
            {static_cast<float>((cols.first + col * cols.spacing + 0.5) /
                                static_cast<double>(refiner.input().cols)),
             static_cast<float>(1 - (rows.first + row * rows.spacing + 0.5) /
                                        static_cast<double>(refiner.input().rows))});
    }
  }
  for (Index r = 0; r + 1 < heights.rows(); ++r) {
    for (Index c = 0; c + 1 < heights.cols(); ++c) {
      if (!whole_quad(heights, r, c)) continue;
      const auto at = [&](Index i, Index j) {
        return numbers[static_cast<std::size_t>(i * heights.cols() + j)];
      };
      const int second = clockwise ? at(r + 1, c) : at(r, c + 1);
      const int fourth = clockwise ? at(r, c + 1) : at(r + 1, c);
      mesh.faces.add(std::array<int, 4>{at(r, c), second, at(r + 1, c + 1), fourth});
    }
  }
  return mesh;
}

template <class T>
gdal::RasterReport refine_as(const gdal::Raster& input, int band,
                             const std::filesystem::path& output, const std::string& format,
                             const Scheme& x, const Scheme& y, const RefineOptions& options,
                             double max_memory, ProgressBar& progress) {
  const Refiner<T> refiner(x, y, input.extent(), options);
  const Extent size = refiner.output();
  const double samples = static_cast<double>(size.rows) * static_cast<double>(size.cols);
  const std::string what =
      "a mesh of " + std::to_string(size.cols) + " x " + std::to_string(size.rows) + " vertices";
  if (4 * samples > std::numeric_limits<int>::max())
    throw Failure(what + " exceeds 32-bit numbering; use fewer levels, or write a .tif");
  check_memory(what, samples * (static_cast<double>(sizeof(T)) + bytes_per_sample), max_memory);
  const Grid<T> coarse = gdal::read_band<T>(input, find_band(input, band));
  const Grid<T> heights = refine_with_progress(refiner, coarse.view(), progress, 0, 0.3);
  check_any_valid(input, heights);

  const LocalPlane plane = local_plane(refined(input.place(), refiner), size, input.geographic());
  const openmesh::MeshData mesh = mesh_of(heights, plane, refiner, format != "stl");
  progress.show(0.4);
  openmesh::MeshOutput form;
  form.format = format;
  form.single_precision = std::is_same_v<T, float> && plane.note.size() > 0;
  form.comments = {"made by arete: " + x.text() + (x == y ? "" : " x " + y.text()) + ", levels " +
                   std::to_string(options.levels)};
  if (!plane.note.empty()) form.comments.push_back(plane.note);
  form.progress = [&](double share) { progress.show(0.4 + 0.6 * share); };
  openmesh::write_mesh(output.string(), mesh, form);
  return {input.extent(), size, 1, to_double(refiner.x().misplacement()),
          to_double(refiner.y().misplacement())};
}

}  // namespace

gdal::RasterReport refine_to_mesh(const gdal::Raster& input, int band,
                                  const std::filesystem::path& output, const std::string& format,
                                  const Scheme& x, const Scheme& y, const RefineOptions& options,
                                  gdal::SampleType type, double max_memory, ProgressBar& progress) {
  return type == gdal::SampleType::float32
             ? refine_as<float>(input, band, output, format, x, y, options, max_memory, progress)
             : refine_as<double>(input, band, output, format, x, y, options, max_memory, progress);
}

}  // namespace arete::cli
