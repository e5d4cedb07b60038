// SPDX-License-Identifier: GPL-3.0-or-later
#include "arete/cgal/scattered_grid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "arete/cgal/internal/gradients.h"
#include "arete/cgal/internal/outliers.h"
#include "arete/cgal/internal/surface.h"

namespace arete::cgal {
namespace {

using namespace detail;

constexpr double missing = std::numeric_limits<double>::quiet_NaN();

HullFoot foot_on(Vertex a, Vertex b, const Point& place) {
  const Vector along = b->point() - a->point();
  const double t = std::clamp(((place - a->point()) * along) / along.squared_length(), 0.0, 1.0);
  return {a, b, t, t == 1 ? b->point() : a->point() + t * along};
}

// `seen` is the infinite face where `place` was located. Along those edges of a convex hull that
// are seen from a place outside there is one nearest, and distances grow away from it.
HullFoot nearest_on_hull(const Delaunay& dt, Face seen, const Point& place) {
  const auto at = [&](Face f) {
    const int infinite = f->index(dt.infinite_vertex());
    return foot_on(f->vertex(Delaunay::ccw(infinite)), f->vertex(Delaunay::cw(infinite)), place);
  };
  HullFoot best = at(seen);
  double shortest = CGAL::squared_distance(best.place, place);
  for (const bool forward : {true, false}) {
    Face f = seen;
    while (true) {
      const int infinite = f->index(dt.infinite_vertex());
      f = f->neighbor(forward ? Delaunay::ccw(infinite) : Delaunay::cw(infinite));
      const HullFoot next = at(f);
      const double distance = CGAL::squared_distance(next.place, place);
      if (!(distance <= shortest) || f == seen) break;
      if (distance < shortest) best = next;
      shortest = distance;
    }
  }
  return best;
}

// The grid's samples in local coordinates. Those on the edges of the box lie there to the last bit,
// so that none falls off a hull that has the same edges.
class Lattice {
 public:
  Lattice(const GridPlace& place, const LocalPoints& points)
      : extent_(place.extent),
        dx_(points.scaled(place.spacing.x)),
        dy_(points.scaled(place.spacing.y)),
        low_{points.scaled(place.box.x_min - points.origin.x),
             points.scaled(place.box.y_min - points.origin.y)},
        high_{points.scaled(place.box.x_max - points.origin.x),
              points.scaled(place.box.y_max - points.origin.y)} {}

  [[nodiscard]] Point operator()(Index row, Index col) const {
    const Index up = extent_.rows - 1 - row;
    return {col + 1 == extent_.cols ? high_.x : low_.x + static_cast<double>(col) * dx_,
            row == 0 ? high_.y : low_.y + static_cast<double>(up) * dy_};
  }
  /// Column (x) and row (y) of a place, fractions of steps included.
  [[nodiscard]] WorldPoint indices_of(const LocalPoint& p) const {
    return {(p.x - low_.x) / dx_, static_cast<double>(extent_.rows - 1) - (p.y - low_.y) / dy_};
  }
  [[nodiscard]] Extent extent() const { return extent_; }

 private:
  Extent extent_;
  double dx_, dy_;
  WorldPoint low_, high_;
};

void fill_row(const Delaunay& dt, const ScatteredSurface& surface, OutsideHull outside,
              const Lattice& lattice, Index row, double* out) {
  // The walk to each place starts at the one before; a row starts afresh, so that the sums do not
  // depend on which thread has which row.
  Face hint{};
  for (Index c = 0; c < lattice.extent().cols; ++c) {
    const Point place = lattice(row, c);
    Delaunay::Locate_type type;
    int number = 0;
    hint = dt.locate(place, type, number, hint);
    if (type != Delaunay::OUTSIDE_CONVEX_HULL) {
      // A place on an edge of the hull may have been found in the infinite face.
      const Face face =
          dt.is_infinite(hint) ? hint->neighbor(hint->index(dt.infinite_vertex())) : hint;
      out[c] = surface.inside(place, face);
    } else if (outside == OutsideHull::nodata) {
      out[c] = missing;
    } else {
      const HullFoot foot = nearest_on_hull(dt, hint, place);
      out[c] =
          outside == OutsideHull::nearest ? surface.on_hull(foot) : surface.beyond(place, foot);
    }
  }
}

// All points on a line (or one): inverse distance only.
void fill_row_without_hull(const std::vector<LocalPoint>& points, const ScatteredSurface& surface,
                           OutsideHull outside, const Lattice& lattice, Index row, double* out) {
  const Point a(points.front().x, points.front().y);
  const Vector along = Point(points.back().x, points.back().y) - a;
  for (Index c = 0; c < lattice.extent().cols; ++c) {
    Point place = lattice(row, c);
    if (outside == OutsideHull::nearest) {
      const double length = along.squared_length();
      const double t = length > 0 ? std::clamp(((place - a) * along) / length, 0.0, 1.0) : 0;
      place = a + t * along;
    }
    out[c] = surface.inside(place, {});
  }
}

// How far the grid, read bilinearly, passes by the points.
void measure_distance(const std::vector<LocalPoint>& points, const Lattice& lattice,
                      GriddedPoints& result) {
  const Grid<double>& z = result.heights;
  double squares = 0;
  for (const LocalPoint& p : points) {
    const WorldPoint at = lattice.indices_of(p);
    const auto cell = [](double index, Index count) {
      return std::clamp(static_cast<Index>(std::floor(index)), Index{0},
                        std::max<Index>(0, count - 2));
    };
    constexpr double slack = 1e-9;
    if (!(at.x >= -slack && at.x <= static_cast<double>(z.cols() - 1) + slack && at.y >= -slack &&
          at.y <= static_cast<double>(z.rows() - 1) + slack))
      continue;
    const Index c = cell(at.x, z.cols());
    const Index r = cell(at.y, z.rows());
    const double u = at.x - static_cast<double>(c);
    const double v = at.y - static_cast<double>(r);
    // A corner without weight need not exist.
    const auto corner = [&](Index i, Index j, double weight) {
      return std::abs(weight) < slack
                 ? 0
                 : weight * z(std::min(i, z.rows() - 1), std::min(j, z.cols() - 1));
    };
    const double read = corner(r, c, (1 - v) * (1 - u)) + corner(r, c + 1, (1 - v) * u) +
                        corner(r + 1, c, v * (1 - u)) + corner(r + 1, c + 1, v * u);
    if (std::isnan(read)) continue;
    ++result.covered;
    squares += (read - p.z) * (read - p.z);
    result.largest_error = std::max(result.largest_error, std::abs(read - p.z));
  }
  result.rmse =
      result.covered > 0 ? std::sqrt(squares / static_cast<double>(result.covered)) : missing;
  if (result.covered == 0) result.largest_error = missing;
}

void check(const GridRequest& request) {
  if (request.neighbours < 1 || request.neighbours > 1000000)
    throw InvalidField("neighbours = " + std::to_string(request.neighbours) +
                       "; inverse distance takes 1 to 1000000 nearest points");
  if (!(request.power > 0 && request.power <= 100))
    throw InvalidField("power = " + std::to_string(request.power) +
                       "; inverse distance takes a power above 0 and up to 100, e.g. 2");
  if (request.drop_outliers && !(*request.drop_outliers > 0))
    throw InvalidField("outliers are told by a positive number of deviations, e.g. 8");
  if (request.threads < 0 || request.threads > 4096)
    throw InvalidField("threads = " + std::to_string(request.threads) + "; give 0 to 4096");
}

// The triangulation without outliers; the points left go to `local`.
Delaunay triangulate(LocalPoints& local, const GridRequest& request, Index& outliers) {
  std::vector<std::pair<Point, Site>> sites;
  sites.reserve(local.points.size());
  for (const LocalPoint& p : local.points) sites.push_back({Point(p.x, p.y), Site{p.z}});
  Delaunay dt(sites.begin(), sites.end());
  if (dt.dimension() < 2 || !request.drop_outliers) return dt;
  outliers = remove_outliers(dt, *request.drop_outliers);
  if (outliers == 0) return dt;
  std::vector<LocalPoint> left;
  for (const Vertex v : dt.finite_vertex_handles())
    left.push_back({v->point().x(), v->point().y(), v->info().z});
  std::sort(left.begin(), left.end(), [](const LocalPoint& a, const LocalPoint& b) {
    return a.x != b.x ? a.x < b.x : a.y < b.y;
  });
  local.points = std::move(left);
  // Afresh, so that nothing depends on the order in which points were removed.
  sites.clear();
  for (const LocalPoint& p : local.points) sites.push_back({Point(p.x, p.y), Site{p.z}});
  return {sites.begin(), sites.end()};
}

void refuse_flat(const LocalPoints& local, const GridRequest& request) {
  const std::string what =
      local.points.size() == 1 ? "all points lie at one place" : "all points lie on one line";
  if (request.method != GridMethod::inverse_distance)
    throw InvalidField(what + "; the method " + std::string(to_string(request.method)) +
                       " needs three points that do not (or use idw and an outside rule)");
  if (request.outside == OutsideHull::nodata)
    throw InvalidField(what +
                       ", so that no sample is inside their hull; ask for the outside rule nearest "
                       "or extrapolate");
}

}  // namespace

GriddedPoints grid_points(const ScatteredPoints& points, const GridRequest& request) {
  check(request);
  const GridPlace place = place_grid(points, request);
  LocalPoints local = local_points(points);
  GriddedPoints result;
  Delaunay dt = triangulate(local, request, result.outliers);
  const bool flat = dt.dimension() < 2;
  if (flat) refuse_flat(local, request);

  const bool by_distance = request.method == GridMethod::inverse_distance;
  const bool natural = request.method == GridMethod::natural_neighbour;
  // Shares of the work, roughly.
  const double fitted = natural ? 0.5 : 0.1;
  const auto tell = [&](double from, double to) -> Tell {
    if (!request.progress) return {};
    return [&request, from, to](double share) { request.progress(from + (to - from) * share); };
  };
  if (!by_distance && (natural || request.outside == OutsideHull::extrapolate))
    fit_gradients(dt, natural ? GradientsAt::everywhere : GradientsAt::hull, request.threads,
                  tell(0.05, fitted));
  const auto surface =
      by_distance ? inverse_distance_surface(local.points, request.neighbours, request.power)
      : natural   ? natural_neighbour_surface(dt)
                  : linear_surface();

  result.heights = Grid<double>(place.extent);
  result.georeference = place.georeference;
  const Lattice lattice(place, local);
  for_each_index(place.extent.rows, request.threads, tell(fitted, 1), [&](Index row) {
    double* out = result.heights.row(row);
    if (flat)
      fill_row_without_hull(local.points, *surface, request.outside, lattice, row, out);
    else
      fill_row(dt, *surface, request.outside, lattice, row, out);
  });

  for (const double z : result.heights.samples()) result.missing += std::isnan(z) ? 1 : 0;
  if (result.missing == static_cast<Index>(result.heights.samples().size()))
    throw InvalidField(
        "no sample of the grid is inside the hull of the points; take a smaller spacing, another "
        "box, or an outside rule");
  result.given = static_cast<Index>(points.x.size());
  result.not_finite = local.not_finite;
  result.merged = local.merged;
  result.used = static_cast<Index>(local.points.size());
  measure_distance(local.points, lattice, result);
  return result;
}

}  // namespace arete::cgal
