// SPDX-License-Identifier: MIT
#include "arete/variational/minimal_patch.h"

#include <string>

#include "arete/field/error.h"

namespace arete {
namespace {

std::size_t number(Extent samples, Index r, Index c) {
  return static_cast<std::size_t>(r * samples.cols + c);
}

bool on_border(Extent samples, bool ring, Index r, Index c) {
  return r == 0 || r == samples.rows - 1 || (!ring && (c == 0 || c == samples.cols - 1));
}

double parameter(Index i, Index cells) {
  return static_cast<double>(i) / static_cast<double>(cells);
}

// at(u, v) of a sample of the border.
Point3 border_point(const PatchBoundary& boundary, Extent samples, Index r, Index c) {
  return boundary.at(parameter(c, boundary.ring ? samples.cols : samples.cols - 1),
                     parameter(r, samples.rows - 1));
}

Point3 middle(const Point3& a, const Point3& b) {
  return {(a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2};
}

SurfaceMesh mesh_of(std::vector<Point3> points, Extent samples, bool ring) {
  SurfaceMesh mesh{std::move(points), grid_triangles(samples, ring), {}};
  mesh.fixed.resize(mesh.points.size());
  for (Index r = 0; r < samples.rows; ++r)
    for (Index c = 0; c < samples.cols; ++c)
      mesh.fixed[number(samples, r, c)] = on_border(samples, ring, r, c);
  return mesh;
}

Extent refined_extent(Extent samples, bool ring) {
  return {2 * samples.rows - 1, ring ? 2 * samples.cols : 2 * samples.cols - 1};
}

// Middles of edges and quads; the border from the boundary itself.
std::vector<Point3> refined_points(const std::vector<Point3>& coarse, Extent samples,
                                   const PatchBoundary& boundary) {
  const Extent fine = refined_extent(samples, boundary.ring);
  const auto at = [&](Index r, Index c) { return coarse[number(samples, r, c % samples.cols)]; };
  std::vector<Point3> points(static_cast<std::size_t>(fine.rows * fine.cols));
  for (Index r = 0; r < fine.rows; ++r)
    for (Index c = 0; c < fine.cols; ++c) {
      Point3& point = points[number(fine, r, c)];
      if (on_border(fine, boundary.ring, r, c)) {
        point = border_point(boundary, fine, r, c);
        continue;
      }
      const Index i = r / 2, j = c / 2, di = r % 2, dj = c % 2;
      point = middle(middle(at(i, j), at(i + di, j)), middle(at(i, j + dj), at(i + di, j + dj)));
    }
  return points;
}

void check_options(const PatchBoundary& boundary, const MinimalOptions& options) {
  if (options.levels < 0 || options.levels > 10)
    throw InvalidField("levels = " + std::to_string(options.levels) +
                       " of a minimal surface; give 0 to 10");
  const int fewest = boundary.ring ? 3 : 1;
  if (options.start_rows < 1 || options.start_cols < fewest)
    throw InvalidField("the coarsest grid of a minimal surface needs at least 1 x " +
                       std::to_string(fewest) + " cells");
  constexpr int most = 4096;
  if (options.start_rows > most || options.start_cols > most ||
      (std::max(options.start_rows, options.start_cols) << options.levels) > most)
    throw InvalidField(
        "a minimal surface of more than 4096 cells a side is beyond the solver; use "
        "fewer levels");
}

}  // namespace

std::vector<std::array<int, 3>> grid_triangles(Extent samples, bool ring) {
  std::vector<std::array<int, 3>> triangles;
  const Index cells = ring ? samples.cols : samples.cols - 1;
  for (Index r = 0; r + 1 < samples.rows; ++r)
    for (Index c = 0; c < cells; ++c) {
      const Index next = (c + 1) % samples.cols;
      const auto a = static_cast<int>(number(samples, r, c));
      const auto b = static_cast<int>(number(samples, r, next));
      const auto d = static_cast<int>(number(samples, r + 1, c));
      const auto e = static_cast<int>(number(samples, r + 1, next));
      triangles.push_back({a, b, e});
      triangles.push_back({a, e, d});
    }
  return triangles;
}

std::vector<Point3> coons_patch(const PatchBoundary& boundary, Extent samples) {
  if (samples.rows < 2 || samples.cols < (boundary.ring ? 3 : 2))
    throw InvalidField("a patch needs at least 2 x 2 samples, a ring 2 x 3");
  const Index last_row = samples.rows - 1;
  const Index last_col = samples.cols - 1;
  const auto at = [&](Index r, Index c) { return border_point(boundary, samples, r, c); };
  std::vector<Point3> points(static_cast<std::size_t>(samples.rows * samples.cols));
  for (Index r = 0; r < samples.rows; ++r)
    for (Index c = 0; c < samples.cols; ++c) {
      Point3& point = points[number(samples, r, c)];
      if (on_border(samples, boundary.ring, r, c)) {
        point = at(r, c);
        continue;
      }
      const double v = parameter(r, last_row);
      const Point3 bottom = at(0, c), top = at(last_row, c);
      for (std::size_t k = 0; k < 3; ++k) point[k] = (1 - v) * bottom[k] + v * top[k];
      if (boundary.ring) continue;
      const double u = parameter(c, last_col);
      const Point3 left = at(r, 0), right = at(r, last_col);
      const Point3 p00 = at(0, 0), p01 = at(0, last_col), p10 = at(last_row, 0),
                   p11 = at(last_row, last_col);
      for (std::size_t k = 0; k < 3; ++k)
        point[k] +=
            (1 - u) * left[k] + u * right[k] -
            ((1 - v) * ((1 - u) * p00[k] + u * p01[k]) + v * ((1 - u) * p10[k] + u * p11[k]));
    }
  return points;
}

MinimalSurface minimal_surface(const PatchBoundary& boundary, const MinimalOptions& asked) {
  MinimalOptions options = asked;
  if (options.start_cols == 0) options.start_cols = boundary.ring ? 16 : 4;
  check_options(boundary, options);
  MinimalSurface surface;
  surface.ring = boundary.ring;
  surface.samples = {options.start_rows + 1,
                     boundary.ring ? options.start_cols : options.start_cols + 1};
  surface.mesh = mesh_of(coons_patch(boundary, surface.samples), surface.samples, boundary.ring);
  for (int level = 0; level <= options.levels; ++level) {
    if (level > 0) {
      auto points = refined_points(surface.mesh.points, surface.samples, boundary);
      surface.samples = refined_extent(surface.samples, boundary.ring);
      surface.mesh = mesh_of(std::move(points), surface.samples, boundary.ring);
    }
    RelaxOptions relaxing = options.relax;
    // What is beyond the spacing's accuracy the next level does anyhow; one spreading step evens
    // out the middles.
    if (level < options.levels) relaxing.tolerance = std::max(relaxing.tolerance, 1e-4);
    if (level > 0) relaxing.spreading_steps = std::min(relaxing.spreading_steps, 1);
    const RelaxReport report = relax(surface.mesh, relaxing);
    surface.levels.push_back({surface.samples, report.areas.front(), report.areas.back(),
                              report.max_mean_curvature, static_cast<int>(report.areas.size()) - 1,
                              report.converged});
  }
  return surface;
}

}  // namespace arete
