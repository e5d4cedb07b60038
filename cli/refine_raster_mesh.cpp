// SPDX-License-Identifier: MIT
#include "cli/refine_raster_mesh.h"

#include <cmath>
#include <limits>

#include "arete/field/local_plane.h"
#include "arete/openmesh/mesh_io.h"
#include "arete/topology/height_triangles.h"
#include "cli/find_band.h"
#include "cli/memory_size.h"
#include "cli/refine_grid.h"
#ifdef ARETE_HAVE_VTK
#include "arete/vtk/write_mesh.h"
#include "cli/triangles_picture.h"
#endif

namespace arete::cli {
namespace {

// Points, texture coordinates, faces, numbers of vertices.
constexpr double bytes_of_a_sample = 24 + 8 + 20 + 4;
// Candidates, and the triangulation with its mesh.
constexpr double bytes_per_triangulated_sample = 16;
constexpr double bytes_per_triangle = 250;

template <class T>
bool whole_quad(const Grid<T>& heights, Index r, Index c) {
  return std::isfinite(heights(r, c)) && std::isfinite(heights(r, c + 1)) &&
         std::isfinite(heights(r + 1, c)) && std::isfinite(heights(r + 1, c + 1));
}

template <class T>
Index whole_quads(const Grid<T>& heights) {
  Index quads = 0;
  for (Index r = 0; r + 1 < heights.rows(); ++r)
    for (Index c = 0; c + 1 < heights.cols(); ++c) quads += whole_quad(heights, r, c) ? 1 : 0;
  return quads;
}

// The vertex numbers of those samples that belong to a whole quad, -1 for the others.
template <class T>
std::vector<int> numbered(const Grid<T>& heights, int& count) {
  std::vector<int> numbers(heights.samples().size(), -1);
  const Index cols = heights.cols();
  for (Index r = 0; r + 1 < heights.rows(); ++r) {
    for (Index c = 0; c + 1 < cols; ++c) {
      if (!whole_quad(heights, r, c)) continue;
      for (Index i : {r * cols + c, r * cols + c + 1, (r + 1) * cols + c, (r + 1) * cols + c + 1})
        numbers[static_cast<std::size_t>(i)] = 0;
    }
  }
  count = 0;
  for (int& number : numbers)
    if (number == 0) number = count++;
  return numbers;
}

// A mesh between refined samples, put in their place.
template <class T>
class TerrainMesh {
 public:
  TerrainMesh(const Grid<T>& heights, const LocalPlane& plane, const Refiner<T>& refiner,
              bool textured)
      : heights_(heights),
        plane_(plane),
        rows_(refiner.y().placement()),
        cols_(refiner.x().placement()),
        input_(refiner.input()),
        textured_(textured) {
    const auto& g = plane.placement.affine;
    clockwise_ = g[1] * g[5] - g[2] * g[4] < 0;
  }

  openmesh::MeshData quads(Index count) {
    int vertices = 0;
    const std::vector<int> numbers = numbered(heights_, vertices);
    mesh_.points.reserve(static_cast<std::size_t>(vertices));
    mesh_.faces.starts.reserve(static_cast<std::size_t>(count) + 1);
    mesh_.faces.corners.reserve(4 * static_cast<std::size_t>(count));
    const Index cols = heights_.cols();
    for (std::size_t i = 0; i < numbers.size(); ++i)
      if (numbers[i] >= 0) add_vertex(static_cast<Index>(i));
    for (Index r = 0; r + 1 < heights_.rows(); ++r) {
      for (Index c = 0; c + 1 < cols; ++c) {
        if (!whole_quad(heights_, r, c)) continue;
        const auto at = [&](Index i, Index j) {
          return numbers[static_cast<std::size_t>(i * cols + j)];
        };
        // Rows to the south and columns to the east: (r, c), (r + 1, c), ... is counter-clockwise.
        const int second = clockwise_ ? at(r + 1, c) : at(r, c + 1);
        const int fourth = clockwise_ ? at(r, c + 1) : at(r + 1, c);
        mesh_.faces.add(std::array<int, 4>{at(r, c), second, at(r + 1, c + 1), fourth});
      }
    }
    return std::move(mesh_);
  }

  openmesh::MeshData triangles(const HeightTriangles& chosen) {
    mesh_.points.reserve(chosen.samples.size());
    for (const Index sample : chosen.samples) add_vertex(sample);
    for (const auto& [a, b, c] : chosen.triangles)
      mesh_.faces.add(clockwise_ ? std::array<int, 3>{a, c, b} : std::array<int, 3>{a, b, c});
    return std::move(mesh_);
  }

 private:
  void add_vertex(Index sample) {
    const auto row = static_cast<double>(sample / heights_.cols());
    const auto col = static_cast<double>(sample % heights_.cols());
    const WorldPoint p = plane_.placement.position(row, col);
    mesh_.points.push_back(
        {p.x, p.y, static_cast<double>(heights_.samples()[static_cast<std::size_t>(sample)])});
    if (!textured_) return;
    mesh_.texcoords.push_back({static_cast<float>((cols_.first + col * cols_.spacing + 0.5) /
                                                  static_cast<double>(input_.cols)),
                               static_cast<float>(1 - (rows_.first + row * rows_.spacing + 0.5) /
                                                          static_cast<double>(input_.rows))});
  }

  const Grid<T>& heights_;
  const LocalPlane& plane_;
  AxisPlacement rows_;
  AxisPlacement cols_;
  Extent input_;
  bool textured_;
  bool clockwise_ = false;
  openmesh::MeshData mesh_;
};

void write_mesh(const openmesh::MeshData& mesh, const std::filesystem::path& output,
                openmesh::MeshOutput form) {
#ifdef ARETE_HAVE_VTK
  if (form.format == "png" || form.format == "jpg")
    return draw_triangles(mesh.points, mesh.faces, output);
  if (form.format == "vtp") {
    vtk::PolygonMesh polygons{mesh.points, mesh.faces, {}, {}, mesh.texcoords};
    for (const std::string& comment : form.comments) polygons.notes.push_back({"comment", comment});
    vtk::write_mesh(polygons, output);
    return;
  }
#endif
  openmesh::write_mesh(output.string(), mesh, form);
}

template <class T>
RasterMesh refine_as(const gdal::Raster& input, int band, const std::filesystem::path& output,
                     const std::string& format, const Scheme& x, const Scheme& y,
                     const RefineOptions& options, std::optional<Index> most_triangles,
                     double max_memory, ProgressBar& progress) {
  const Refiner<T> refiner(x, y, input.extent(), options);
  const Extent size = refiner.output();
  const double samples = static_cast<double>(size.rows) * static_cast<double>(size.cols);
  const std::string what =
      "a mesh of " + std::to_string(size.cols) + " x " + std::to_string(size.rows) + " vertices";
  if (4 * samples > std::numeric_limits<int>::max())
    throw Failure(what + " exceeds 32-bit numbering; use fewer levels, or write a .tif");
  const double most = most_triangles ? static_cast<double>(*most_triangles) : 2 * samples;
  const double mesh_bytes =
      most < 2 * samples ? bytes_per_triangulated_sample * samples + bytes_per_triangle * most
                         : bytes_of_a_sample * samples;
  check_memory(what, samples * static_cast<double>(sizeof(T)) + mesh_bytes, max_memory);
  const Grid<T> coarse = gdal::read_band<T>(input, find_band(input, band));
  const Grid<T> heights = refine_with_progress(refiner, coarse.view(), progress, 0, 0.3);
  check_any_valid(input, heights);

  const LocalPlane plane = local_plane(refined(input.place(), refiner), size, input.geographic());
  RasterMesh done;
  done.raster = {input.extent(), size, 1, to_double(refiner.x().misplacement()),
                 to_double(refiner.y().misplacement())};
  if (options.detail)
    done.detail = detail_statistics(coarse.view(), heights.view(),
                                    std::pow(x.mask().arity(), options.levels));
  TerrainMesh<T> terrain(heights, plane, refiner, format != "stl");
  openmesh::MeshData mesh;
  const Index quads = whole_quads(heights);
  if (!most_triangles || 2 * quads <= *most_triangles) {
    mesh = terrain.quads(quads);
    done.quads = quads;
  } else {
    const HeightTriangles chosen = triangulate_heights(
        heights.view(), *most_triangles, [&](double share) { progress.show(0.3 + 0.5 * share); });
    mesh = terrain.triangles(chosen);
    done.triangles = static_cast<Index>(chosen.triangles.size());
    done.largest_error = chosen.largest_error;
    done.left_out = chosen.left_out;
  }
  done.vertices = static_cast<Index>(mesh.points.size());
  const double written = most_triangles ? 0.8 : 0.4;
  progress.show(written);
  openmesh::MeshOutput form;
  form.format = format;
  form.single_precision = std::is_same_v<T, float> && plane.note.size() > 0;
  form.comments = {"made by arete: " + x.text() + (x == y ? "" : " x " + y.text()) + ", levels " +
                   std::to_string(options.levels)};
  if (!plane.note.empty()) form.comments.push_back(plane.note);
  form.progress = [&](double share) { progress.show(written + (1 - written) * share); };
  write_mesh(mesh, output, std::move(form));
  return done;
}

}  // namespace

RasterMesh refine_to_mesh(const gdal::Raster& input, int band, const std::filesystem::path& output,
                          const std::string& format, const Scheme& x, const Scheme& y,
                          const RefineOptions& options, gdal::SampleType type,
                          std::optional<Index> most_triangles, double max_memory,
                          ProgressBar& progress) {
  return type == gdal::SampleType::float32
             ? refine_as<float>(input, band, output, format, x, y, options, most_triangles,
                                max_memory, progress)
             : refine_as<double>(input, band, output, format, x, y, options, most_triangles,
                                 max_memory, progress);
}

}  // namespace arete::cli
