// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "arete/cgal/internal/delaunay.h"
#include "arete/cgal/internal/local_points.h"

namespace arete::cgal::detail {

/// The place of the hull nearest to a place outside: on the hull's edge from a to b, the share t
/// along it.
struct HullFoot {
  Vertex a, b;
  double t = 0;
  Point place;
};

/// A surface through scattered points, asked for heights by any number of threads.
class ScatteredSurface {
 public:
  virtual ~ScatteredSurface() = default;
  /// The height at a place of the convex hull, in the finite face that holds it.
  [[nodiscard]] virtual double inside(const Point& place, Face face) const = 0;
  /// The height at a place of the hull's edge.
  [[nodiscard]] virtual double on_hull(const HullFoot& foot) const = 0;
  /// The height beyond it: on from on_hull() along the gradient there.
  [[nodiscard]] virtual double beyond(const Point& place, const HullFoot& foot) const {
    return on_hull(foot) +
           ((1 - foot.t) * foot.a->info().gradient + foot.t * foot.b->info().gradient) *
               (place - foot.place);
  }
};

/// The triangulation (dimension 2, gradients fitted) must outlive these.
[[nodiscard]] std::unique_ptr<ScatteredSurface> natural_neighbour_surface(const Delaunay& dt);
[[nodiscard]] std::unique_ptr<ScatteredSurface> linear_surface();
/// Needs no triangulation: `face` is not looked at.
[[nodiscard]] std::unique_ptr<ScatteredSurface> inverse_distance_surface(
    const std::vector<LocalPoint>& points, int neighbours, double power);

/// Natural neighbours of a place inside the hull and Sibson's weights, which sum to 1 and whose
/// mean of the neighbours is the place itself to 1e-12 of their distance.
void natural_weights(const Delaunay& dt, const Point& place, Face face, Weights& out);

}  // namespace arete::cgal::detail
