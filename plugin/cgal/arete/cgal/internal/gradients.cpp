// SPDX-License-Identifier: GPL-3.0-or-later
#include "arete/cgal/internal/gradients.h"

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

// Least squares by modified Gram-Schmidt. An unknown becomes 0 where the equations leave it open:
// the part of its column that the columns before it cannot tell is at most such a share of it.
template <std::size_t N>
std::array<double, N> least_squares(std::vector<Equation<N>> equations,
                                    const std::array<double, N>& open_below) {
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
    open[j] = !(r[j][j] > open_below[j] * length);
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

constexpr double rounding = 1e-10;
// Neighbours on a circle through the vertex cannot tell curvature from slope.
constexpr double curvature_told = 0.1;

void add_neighbours(const Delaunay& dt, Vertex vertex, std::vector<Vertex>& out) {
  auto around = dt.incident_vertices(vertex);
  const auto done = around;
  do {
    if (!dt.is_infinite(around)) out.push_back(around);
  } while (++around != done);
}

// Neighbours in the triangulation, their neighbours, and so on; the vertex itself left out.
std::vector<Vertex> with_neighbours(const Delaunay& dt, Vertex vertex, std::vector<Vertex> near) {
  if (near.empty()) near.push_back(vertex);
  const std::vector<Vertex> before = near;
  for (const Vertex v : before) add_neighbours(dt, v, near);
  std::sort(near.begin(), near.end());
  near.erase(std::unique(near.begin(), near.end()), near.end());
  std::erase(near, vertex);
  return near;
}

// By place and not by address, so that sums are always taken in the same order.
void sort_by_place(std::vector<Vertex>& near) {
  std::sort(near.begin(), near.end(), [](Vertex a, Vertex b) { return a->point() < b->point(); });
}

double squared_side(Face face, int opposite) {
  return CGAL::squared_distance(face->vertex(Delaunay::ccw(opposite))->point(),
                                face->vertex(Delaunay::cw(opposite))->point());
}

int longest_side(Face face) {
  int longest = 0;
  for (int i = 1; i < 3; ++i)
    if (squared_side(face, i) > squared_side(face, longest)) longest = i;
  return longest;
}

bool obtuse(Face face, int longest) {
  return squared_side(face, longest) >
         squared_side(face, Delaunay::ccw(longest)) + squared_side(face, Delaunay::cw(longest));
}

// Whether the centre of a triangle's circle lies in the hull, as a walk across longest sides tells
// roughly.
bool centred_inside(const Delaunay& dt, Face face) {
  constexpr int most_steps = 64;
  for (int step = 0; step < most_steps && !dt.is_infinite(face); ++step) {
    const int longest = longest_side(face);
    if (!obtuse(face, longest)) return true;
    face = face->neighbor(longest);
  }
  return false;
}

// How far from a vertex the surface may ask for its tangent plane: a place has those natural
// neighbours in the circle around one of whose triangles it lies. Of a circle centred outside the
// hull little more than the triangle is inside.
double reach_of(const Delaunay& dt, Vertex vertex) {
  double square = 0;
  auto face = dt.incident_faces(vertex);
  const auto done = face;
  do {
    if (dt.is_infinite(face)) continue;
    const int longest = longest_side(face);
    square = std::max(square, squared_side(face, longest));
    if (!obtuse(face, longest) || !centred_inside(dt, face)) continue;
    const Point& a = face->vertex(0)->point();
    const double area =
        CGAL::determinant(face->vertex(1)->point() - a, face->vertex(2)->point() - a);
    square = std::max(square, squared_side(face, 0) * squared_side(face, 1) *
                                  squared_side(face, 2) / (4 * area * area));
  } while (++face != done);
  return std::sqrt(square);
}

// Whether the neighbours lie so close to a line that they tell little about slopes across it.
bool thin(Vertex vertex, const std::vector<Vertex>& near, double reach) {
  double xx = 0;
  double xy = 0;
  double yy = 0;
  for (const Vertex v : near) {
    const Vector d = (v->point() - vertex->point()) / reach;
    xx += d.x() * d.x();
    xy += d.x() * d.y();
    yy += d.y() * d.y();
  }
  const double across = (xx + yy - std::hypot(xx - yy, 2 * xy)) / 2;
  constexpr double share = 0.1;
  return across < share * share;
}

// Two rings of neighbours, and more while they tell too little.
std::vector<Vertex> telling_neighbours(const Delaunay& dt, Vertex vertex, double reach) {
  constexpr std::size_t enough = 128;
  std::vector<Vertex> near = with_neighbours(dt, vertex, with_neighbours(dt, vertex, {}));
  while (near.size() < enough && thin(vertex, near, reach)) {
    std::vector<Vertex> more = with_neighbours(dt, vertex, near);
    if (more.size() == near.size()) break;
    near = std::move(more);
  }
  sort_by_place(near);
  return near;
}

// Lengths are shares of the reach, and weights even within it: two noisy points close to each other
// say nothing about a slope that is to hold that far.
Vector gradient_at(const Delaunay& dt, Vertex vertex) {
  const double reach = reach_of(dt, vertex);
  std::vector<Equation<3>> equations;
  for (const Vertex v : telling_neighbours(dt, vertex, reach)) {
    const Vector d = (v->point() - vertex->point()) / reach;
    const double square = d.squared_length();
    const double weight = 1 / (1 + square * square);
    equations.push_back({{weight * d.x(), weight * d.y(), weight * square},
                         weight * (v->info().z - vertex->info().z)});
  }
  const auto fit = least_squares<3>(std::move(equations), {rounding, rounding, curvature_told});
  return Vector(fit[0], fit[1]) / reach;
}

}  // namespace

void fit_gradients(Delaunay& dt, GradientsAt where, int threads, const Tell& tell) {
  std::vector<Vertex> vertices;
  for (Vertex v : dt.finite_vertex_handles())
    if (where == GradientsAt::everywhere || dt.is_edge(v, dt.infinite_vertex()))
      vertices.push_back(v);
  constexpr Index batch = 1024;
  const auto count = static_cast<Index>(vertices.size());
  for_each_index((count + batch - 1) / batch, threads, tell, [&](Index number) {
    for (Index i = number * batch; i < std::min(count, (number + 1) * batch); ++i) {
      const Vertex v = vertices[static_cast<std::size_t>(i)];
      v->info().gradient = gradient_at(dt, v);
    }
  });
}

double plane_through_neighbours(const Delaunay& dt, Vertex vertex) {
  std::vector<Equation<3>> equations;
  std::vector<Vertex> near;
  add_neighbours(dt, vertex, near);
  if (near.size() < 4) {
    near = with_neighbours(dt, vertex, with_neighbours(dt, vertex, {}));
    sort_by_place(near);
  }
  for (const Vertex v : near) {
    const Vector d = v->point() - vertex->point();
    equations.push_back({{1, d.x(), d.y()}, v->info().z});
  }
  return least_squares<3>(std::move(equations), {rounding, rounding, rounding})[0];
}

}  // namespace arete::cgal::detail
