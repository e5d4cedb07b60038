// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string_view>

#include "arete/field/georeference.h"

namespace arete::cgal {

/// How a height is found between scattered points.
enum class GridMethod {
  natural_neighbour,  ///< Sibson 1981, C^1 with gradients fitted at the points: passes through the
                      ///< points, reproduces a + b.x + c |x|^2 inside the hull; noise in the
                      ///< heights is not amplified, however close points lie
  linear,             ///< on the Delaunay triangles; passes through the points, never overshoots
  inverse_distance    ///< Shepard 1968 on the nearest points, whose weights fade out towards the
                      ///< next one (Franke 1982); passes through the points, flat there
};

/// What stands outside the convex hull of the points.
enum class OutsideHull {
  nodata,      ///< NaN
  nearest,     ///< the height at the nearest place of the hull
  extrapolate  ///< from there on along the gradient; inverse distance goes on as it is
};

/// Reads `natural-neighbour`, `linear`, `idw` (or `natural-neighbor`). \throws InvalidField
[[nodiscard]] GridMethod parse_grid_method(std::string_view text);
/// Reads `nodata`, `nearest`, `extrapolate`. \throws InvalidField
[[nodiscard]] OutsideHull parse_outside(std::string_view text);
[[nodiscard]] std::string_view to_string(GridMethod method);
[[nodiscard]] std::string_view to_string(OutsideHull outside);

/// Points as three equally long arrays; x and y in one plane of equal units (project longitudes
/// and latitudes first where distances matter), z in any unit. A point with a coordinate that is
/// not finite is passed over and counted.
struct ScatteredPoints {
  std::span<const double> x;
  std::span<const double> y;
  std::span<const double> z;
};

struct PlaneBox {
  double x_min = 0, y_min = 0, x_max = 0, y_max = 0;
};

/// The grid asked for. Either `spacing` or `size` is given.
struct GridRequest {
  /// Distance of columns (x) and rows (y): samples at x_min + i dx, y_min + j dy within the box.
  std::optional<WorldPoint> spacing{};
  /// Columns and rows, the outermost on the box's edges. At least 2 x 2.
  std::optional<Extent> size{};
  /// Where samples lie; the bounding box of the points unless given. All points count anyway.
  std::optional<PlaneBox> box{};
  GridMethod method = GridMethod::natural_neighbour;
  OutsideHull outside = OutsideHull::nodata;
  int neighbours = 12;  ///< inverse distance: how many of the nearest points
  double power = 2;  ///< inverse distance: weights (1/d - 1/R)^power, R the next point's distance
  /// Drops points further than this many robust standard deviations (1.4826 MAD) from the plane
  /// through their Delaunay neighbours, worst of each neighbourhood first; none unless given.
  std::optional<double> drop_outliers{};
  int threads = 0;  ///< 0: as many as the machine has. The result does not depend on it.
  /// Told the share done, 0..1, in the calling thread; may throw to stop the work.
  std::function<void(double)> progress{};
};

/// The extent and place of the grid, point registration, row 0 in the north (largest y).
struct GridPlace {
  Extent extent;
  Georeference georeference;
  PlaneBox box;  ///< of the outermost samples, to the last bit those of the box asked for
  WorldPoint spacing;
};

/// Where the samples will lie. \throws InvalidField as grid_points().
[[nodiscard]] GridPlace place_grid(const ScatteredPoints& points, const GridRequest& request);

struct GriddedPoints {
  Grid<double> heights;  ///< NaN where there is none
  Georeference georeference;
  Index given = 0;       ///< points in
  Index not_finite = 0;  ///< passed over
  Index merged = 0;      ///< points at the place of another; the mean height of all counts
  Index outliers = 0;    ///< dropped
  Index used = 0;        ///< different places that made the grid
  Index missing = 0;     ///< samples without height
  /// How far the grid, read bilinearly, passes by the used points; NaN if it covers none.
  Index covered = 0;
  double rmse = 0;
  double largest_error = 0;
};

/// Heights on a regular grid from scattered points.
///
/// Coordinates are shifted to a local origin first, so that large offsets (UTM northings) cost no
/// digits. Weights of natural neighbours that double cannot hold (slivers along the hull) are
/// taken in exact arithmetic. Time O(n log n + samples); about 300 bytes a point.
///
/// \throws InvalidField: arrays of different lengths; no finite point; fewer than three different
/// places, or all on a line (natural_neighbour, linear); neither or both of spacing and size;
/// spacing, size, box, neighbours, power, drop_outliers, threads out of range; more than 2^31 - 1
/// samples; no sample with a height.
[[nodiscard]] GriddedPoints grid_points(const ScatteredPoints& points, const GridRequest& request);

}  // namespace arete::cgal
