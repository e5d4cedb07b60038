// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Orthogonal_k_neighbor_search.h>
#include <CGAL/Search_traits_2.h>
#include <CGAL/Search_traits_adapter.h>
#include <CGAL/property_map.h>

#include <cmath>

#include "arete/cgal/internal/surface.h"

namespace arete::cgal::detail {
namespace {

using Item = std::pair<Point, double>;
using Traits = CGAL::Search_traits_adapter<Item, CGAL::First_of_pair_property_map<Item>,
                                           CGAL::Search_traits_2<Kernel>>;
using Search = CGAL::Orthogonal_k_neighbor_search<Traits>;

class InverseDistanceSurface final : public ScatteredSurface {
 public:
  InverseDistanceSurface(const std::vector<LocalPoint>& points, int neighbours, double power)
      : neighbours_(static_cast<unsigned>(neighbours)), power_(power) {
    for (const LocalPoint& p : points) tree_.insert({Point(p.x, p.y), p.z});
    // Built here because building on the first question would not be safe among threads.
    tree_.build();
  }

  double inside(const Point& place, Face) const override {
    // One more than count: where that one takes the place of another, both have no weight.
    const Search search(tree_, place, neighbours_ + 1);
    double nearest = 0;
    double beyond = 0;
    unsigned found = 0;
    for (const auto& [item, squared_distance] : search) {
      if (squared_distance == 0) return item.second;
      beyond = std::sqrt(squared_distance);
      if (found++ == 0) nearest = beyond;
    }
    // All points count, or all are equally far: nothing to fade out towards.
    const bool fades = found > neighbours_ && beyond > nearest;
    double sum = 0;
    double weights = 0;
    for (const auto& [item, squared_distance] : search) {
      const double distance = std::sqrt(squared_distance);
      // Relative to the nearest, so that no power of a distance leaves the range of double.
      double weight = nearest / distance;
      if (fades) weight *= (beyond - distance) / (beyond - nearest);
      weight = std::pow(weight, power_);
      sum += weight * item.second;
      weights += weight;
    }
    return sum / weights;
  }

  double on_hull(const HullFoot& foot) const override { return inside(foot.place, {}); }
  double beyond(const Point& place, const HullFoot&) const override { return inside(place, {}); }

 private:
  Search::Tree tree_;
  unsigned neighbours_;
  double power_;
};

}  // namespace

std::unique_ptr<ScatteredSurface> inverse_distance_surface(const std::vector<LocalPoint>& points,
                                                           int neighbours, double power) {
  return std::make_unique<InverseDistanceSurface>(points, neighbours, power);
}

}  // namespace arete::cgal::detail
