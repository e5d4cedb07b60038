// SPDX-License-Identifier: GPL-3.0-or-later
#include "arete/cgal/internal/gradients.h"

#include <CGAL/Interpolation_gradient_fitting_traits_2.h>
#include <CGAL/natural_neighbor_coordinates_2.h>
#include <CGAL/sibson_gradient_fitting.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace arete::cgal::detail {
namespace {

// One neighbour: the equation coefficients . unknowns = value.
template <std::size_t N>
struct Equation {
  std::array<double, N> coefficients;
  double value;
};

// Least squares by modified Gram-Schmidt; unknowns that the equations leave open become 0.
template <std::size_t N>
std::array<double, N> least_squares(std::vector<Equation<N>> equations) {
  std::array<std::array<double, N>, N> r{};
  std::array<double, N> right{};
  std::array<bool, N> open{};
  const auto dot = [&](std::size_t i, std::size_t j) {
    double sum = 0;
    for (const auto& e : equations) sum += e.coefficients[i] * e.coefficients[j];
    return sum;
  };
  for (std::size_t j = 0; j < N; ++j) {
    const double length = std::sqrt(dot(j, j));
    for (std::size_t i = 0; i < j; ++i) {
      if (open[i]) continue;
      r[i][j] = dot(i, j);
      for (auto& e : equations) e.coefficients[j] -= r[i][j] * e.coefficients[i];
    }
    r[j][j] = std::sqrt(dot(j, j));
    open[j] = !(r[j][j] > 1e-10 * length);
    if (open[j]) continue;
    for (auto& e : equations) e.coefficients[j] /= r[j][j];
    for (const auto& e : equations) right[j] += e.coefficients[j] * e.value;
    for (auto& e : equations) e.value -= right[j] * e.coefficients[j];
  }
  std::array<double, N> unknowns{};
  for (std::size_t j = N; j-- > 0;) {
    if (open[j]) continue;
    unknowns[j] = right[j];
    for (std::size_t k = j + 1; k < N; ++k) unknowns[j] -= r[j][k] * unknowns[k];
    unknowns[j] /= r[j][j];
  }
  return unknowns;
}

void add_neighbours(const Delaunay& dt, Vertex vertex, std::vector<Vertex>& out) {
  auto around = dt.incident_vertices(vertex);
  const auto done = around;
  do {
    if (!dt.is_infinite(around)) out.push_back(around);
  } while (++around != done);
}

std::vector<Vertex> two_rings(const Delaunay& dt, Vertex vertex) {
  std::vector<Vertex> near;
  add_neighbours(dt, vertex, near);
  const std::vector<Vertex> first = near;
  for (const Vertex v : first) add_neighbours(dt, v, near);
  std::sort(near.begin(), near.end());
  near.erase(std::unique(near.begin(), near.end()), near.end());
  std::erase(near, vertex);
  // By place and not by address, so that sums are always taken in the same order.
  std::sort(near.begin(), near.end(), [](Vertex a, Vertex b) { return a->point() < b->point(); });
  return near;
}

Vector gradient_on_hull(const Delaunay& dt, Vertex vertex) {
  std::vector<Equation<3>> equations;
  for (const Vertex v : two_rings(dt, vertex)) {
    const Vector d = v->point() - vertex->point();
    const double distance = std::sqrt(d.squared_length());
    equations.push_back({{d.x() / distance, d.y() / distance, distance},
                         (v->info().z - vertex->info().z) / distance});
  }
  const auto fit = least_squares<3>(std::move(equations));
  return {fit[0], fit[1]};
}

Vector gradient_inside(const Delaunay& dt, Vertex vertex) {
  Weights weights;
  const double norm =
      CGAL::natural_neighbor_coordinates_2(dt, vertex, std::back_inserter(weights),
                                           CGAL::Identity<std::pair<Vertex, double>>())
          .second;
  const auto height = [](Vertex v) { return std::make_pair(v->info().z, true); };
  return CGAL::sibson_gradient_fitting(weights.begin(), weights.end(), norm, vertex->point(),
                                       vertex->info().z, height,
                                       CGAL::Interpolation_gradient_fitting_traits_2<Kernel>());
}

}  // namespace

void fit_gradients(Delaunay& dt, GradientsAt where, int threads, const Tell& tell) {
  std::vector<Vertex> vertices;
  std::vector<char> on_hull;
  for (Vertex v : dt.finite_vertex_handles()) {
    const bool hull = dt.is_edge(v, dt.infinite_vertex());
    if (!hull && where == GradientsAt::hull) continue;
    vertices.push_back(v);
    on_hull.push_back(hull ? 1 : 0);
  }
  constexpr Index batch = 1024;
  const auto count = static_cast<Index>(vertices.size());
  for_each_index((count + batch - 1) / batch, threads, tell, [&](Index number) {
    for (Index i = number * batch; i < std::min(count, (number + 1) * batch); ++i) {
      const Vertex v = vertices[static_cast<std::size_t>(i)];
      v->info().gradient = on_hull[static_cast<std::size_t>(i)] != 0 ? gradient_on_hull(dt, v)
                                                                     : gradient_inside(dt, v);
    }
  });
}

double plane_through_neighbours(const Delaunay& dt, Vertex vertex) {
  std::vector<Equation<3>> equations;
  std::vector<Vertex> near;
  add_neighbours(dt, vertex, near);
  if (near.size() < 4) near = two_rings(dt, vertex);
  for (const Vertex v : near) {
    const Vector d = v->point() - vertex->point();
    equations.push_back({{1, d.x(), d.y()}, v->info().z});
  }
  return least_squares<3>(std::move(equations))[0];
}

}  // namespace arete::cgal::detail
