// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Exact_rational.h>
#include <CGAL/Interpolation_traits_2.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/interpolation_functions.h>
#include <CGAL/natural_neighbor_coordinates_2.h>

#include <algorithm>
#include <cmath>

#include "arete/cgal/internal/surface.h"

namespace arete::cgal::detail {
namespace {

// Sibson's weights depend on the natural neighbours alone, so that a triangulation of these few,
// in exact arithmetic, gives the same weights.
void exact_weights(const Point& place, Weights& weights) {
  using Exact = CGAL::Simple_cartesian<CGAL::Exact_rational>;
  using ExactDelaunay = CGAL::Delaunay_triangulation_2<
      Exact, CGAL::Triangulation_data_structure_2<
                 CGAL::Triangulation_vertex_base_with_info_2<std::size_t, Exact>>>;
  std::vector<std::pair<Exact::Point_2, std::size_t>> sites;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    const Point& p = weights[i].first->point();
    sites.emplace_back(Exact::Point_2(p.x(), p.y()), i);
  }
  const ExactDelaunay dt(sites.begin(), sites.end());
  std::vector<std::pair<ExactDelaunay::Vertex_handle, Exact::FT>> exact;
  const auto found = CGAL::natural_neighbors_2(dt, Exact::Point_2(place.x(), place.y()),
                                               std::back_inserter(exact));
  for (auto& weight : weights) weight.second = 0;
  for (const auto& [vertex, area] : exact)
    weights[vertex->info()].second = CGAL::to_double(Exact::FT(area / found.second));
}

// Whether the weighted mean of the neighbours is the place, as it is for Sibson's weights.
bool accurate(const Point& place, const Weights& weights) {
  Vector mean(0, 0);
  double reach = 0;
  for (const auto& [vertex, weight] : weights) {
    const Vector d = vertex->point() - place;
    mean = mean + weight * d;
    reach = std::max(reach, d.squared_length());
  }
  constexpr double tolerance = 1e-12;
  return mean.squared_length() <= tolerance * tolerance * reach;
}

class NaturalNeighbourSurface final : public ScatteredSurface {
 public:
  explicit NaturalNeighbourSurface(const Delaunay& dt) : dt_(dt) {}

  double inside(const Point& place, Face face) const override {
    thread_local Weights weights;
    natural_weights(dt_, place, face, weights);
    return interpolated(place, weights);
  }

  // On the hull the only natural neighbours are the two ends of its edge.
  double on_hull(const HullFoot& foot) const override {
    Weights weights;
    if (foot.t < 1) weights.emplace_back(foot.a, 1 - foot.t);
    if (foot.t > 0) weights.emplace_back(foot.b, foot.t);
    return interpolated(foot.place, weights);
  }

 private:
  static double interpolated(const Point& place, const Weights& weights) {
    const auto height = [](Vertex v) { return std::make_pair(v->info().z, true); };
    const auto gradient = [](Vertex v) { return std::make_pair(v->info().gradient, true); };
    return CGAL::sibson_c1_interpolation(weights.begin(), weights.end(), 1.0, place, height,
                                         gradient, CGAL::Interpolation_traits_2<Kernel>())
        .first;
  }

  const Delaunay& dt_;
};

}  // namespace

void natural_weights(const Delaunay& dt, const Point& place, Face face, Weights& out) {
  out.clear();
  const auto found = CGAL::natural_neighbors_2(dt, place, std::back_inserter(out), face);
  for (auto& weight : out) weight.second /= found.second;
  if (out.size() > 2 && !accurate(place, out)) exact_weights(place, out);
  std::erase_if(out, [](const auto& weight) { return !(weight.second > 0); });
}

std::unique_ptr<ScatteredSurface> natural_neighbour_surface(const Delaunay& dt) {
  return std::make_unique<NaturalNeighbourSurface>(dt);
}

}  // namespace arete::cgal::detail
