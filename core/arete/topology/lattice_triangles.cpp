// SPDX-License-Identifier: MIT
#include "arete/topology/lattice_triangles.h"

#include <cmath>

namespace arete {
namespace {

int next(int corner) { return (corner + 1) % 3; }
int last(int corner) { return (corner + 2) % 3; }

// Whether d lies clearly within the circle through a, b, c, which turn from x to y: in doubt not,
// so that flips come to an end.
bool in_circle(const LatticeTriangles::Corner& a, const LatticeTriangles::Corner& b,
               const LatticeTriangles::Corner& c, const LatticeTriangles::Corner& d) {
  const auto from_d = [&d](const LatticeTriangles::Corner& p) {
    return std::array<double, 2>{static_cast<double>(p.x - d.x), static_cast<double>(p.y - d.y)};
  };
  const auto [ax, ay] = from_d(a);
  const auto [bx, by] = from_d(b);
  const auto [cx, cy] = from_d(c);
  const double aa = ax * ax + ay * ay;
  const double bb = bx * bx + by * by;
  const double cc = cx * cx + cy * cy;
  const double sum = aa * (bx * cy - by * cx) + bb * (cx * ay - cy * ax) + cc * (ax * by - ay * bx);
  const double size = aa * (std::abs(bx * cy) + std::abs(by * cx)) +
                      bb * (std::abs(cx * ay) + std::abs(cy * ax)) +
                      cc * (std::abs(ax * by) + std::abs(ay * bx));
  return sum > 1e-14 * size;
}

}  // namespace

LatticeTriangles::LatticeTriangles(Extent extent) {
  const Index right = extent.cols - 1;
  const Index bottom = extent.rows - 1;
  vertices_ = {{0, 0}, {right, 0}, {right, bottom}, {0, bottom}};
  add({0, 1, 2}, {-1, 1, -1}, false);
  add({0, 2, 3}, {-1, -1, 0}, false);
}

std::array<LatticeTriangles::Corner, 3> LatticeTriangles::corners(int triangle) const {
  std::array<Corner, 3> places;
  for (std::size_t k = 0; k < 3; ++k)
    places[k] = vertices_[static_cast<std::size_t>((*this)[triangle].corners[k])];
  return places;
}

int LatticeTriangles::edge_under(int triangle, const Corner& sample) const {
  const auto places = corners(triangle);
  for (int k = 0; k < 3; ++k) {
    if (area(places[static_cast<std::size_t>(next(k))], places[static_cast<std::size_t>(last(k))],
             sample) == 0)
      return k;
  }
  return -1;
}

const std::vector<int>& LatticeTriangles::insert(int triangle, const Corner& sample) {
  changed_.clear();
  doubtful_.clear();
  const int edge = edge_under(triangle, sample);
  const auto vertex = static_cast<int>(vertices_.size());
  vertices_.push_back(sample);
  if (edge < 0)
    cut_inside(triangle, vertex);
  else
    cut_edge(triangle, edge, vertex);
  restore_delaunay(vertex);
  return changed_;
}

int LatticeTriangles::add(std::array<int, 3> corners, std::array<int, 3> across, bool frozen) {
  triangles_.push_back({corners, across, frozen});
  changed_.push_back(count() - 1);
  return count() - 1;
}

void LatticeTriangles::set(int triangle, std::array<int, 3> corners, std::array<int, 3> across) {
  Triangle& t = triangles_[static_cast<std::size_t>(triangle)];
  t.corners = corners;
  t.across = across;
  changed_.push_back(triangle);
}

int LatticeTriangles::corner_of(const Triangle& triangle, int vertex) {
  return triangle.corners[0] == vertex ? 0 : triangle.corners[1] == vertex ? 1 : 2;
}

int LatticeTriangles::edge_to(const Triangle& triangle, int neighbour) {
  return triangle.across[0] == neighbour ? 0 : triangle.across[1] == neighbour ? 1 : 2;
}

// Tells a triangle that what was its neighbour `from` is `to` now.
void LatticeTriangles::relink(int triangle, int from, int to) {
  if (triangle < 0) return;
  Triangle& t = triangles_[static_cast<std::size_t>(triangle)];
  t.across[static_cast<std::size_t>(edge_to(t, from))] = to;
}

// a b c -> p b c, a p c, a b p.
void LatticeTriangles::cut_inside(int triangle, int vertex) {
  const Triangle whole = (*this)[triangle];
  const auto [a, b, c] = whole.corners;
  const int second = count();
  const int third = second + 1;
  set(triangle, {vertex, b, c}, {whole.across[0], second, third});
  add({a, vertex, c}, {triangle, whole.across[1], third}, whole.frozen);
  add({a, b, vertex}, {triangle, second, whole.across[2]}, whole.frozen);
  relink(whole.across[1], triangle, second);
  relink(whole.across[2], triangle, third);
  doubtful_ = {triangle, second, third};
}

// The triangle a b c and, beyond its edge b c, d c b, with p on that edge: a b p, a p c, and beyond
// d p b, d c p.
void LatticeTriangles::cut_edge(int triangle, int edge, int vertex) {
  const Triangle near = (*this)[triangle];
  const auto corner = [](const Triangle& t, int k) {
    return t.corners[static_cast<std::size_t>(k)];
  };
  const auto across = [](const Triangle& t, int k) {
    return t.across[static_cast<std::size_t>(k)];
  };
  const int a = corner(near, edge);
  const int b = corner(near, next(edge));
  const int c = corner(near, last(edge));
  const int beyond = across(near, edge);
  const int near_c = count();
  const int far_c = beyond < 0 ? -1 : near_c + 1;

  set(triangle, {a, b, vertex}, {beyond, near_c, across(near, last(edge))});
  add({a, vertex, c}, {far_c, across(near, next(edge)), triangle}, near.frozen);
  relink(across(near, next(edge)), triangle, near_c);
  doubtful_ = {triangle, near_c};
  if (beyond < 0) return;

  const Triangle far = (*this)[beyond];
  const int at = edge_to(far, triangle);
  const int d = corner(far, at);
  const int over_b = across(far, next(at));  // of d b
  const int over_c = across(far, last(at));  // of d c
  set(beyond, {d, vertex, b}, {triangle, over_b, far_c});
  add({d, c, vertex}, {near_c, beyond, over_c}, far.frozen);
  relink(over_c, beyond, far_c);
  doubtful_.push_back(beyond);
  doubtful_.push_back(far_c);
}

bool LatticeTriangles::flips(int triangle, int corner, int beyond, int opposite) const {
  const Triangle& t = (*this)[triangle];
  const Triangle& u = (*this)[beyond];
  if (t.frozen || u.frozen) return false;
  const auto place = [this](const Triangle& of, int k) {
    return vertices_[static_cast<std::size_t>(of.corners[static_cast<std::size_t>(k)])];
  };
  const Corner p = place(t, corner);
  const Corner b = place(t, next(corner));
  const Corner c = place(t, last(corner));
  const Corner d = place(u, opposite);
  return in_circle(p, b, c, d) && area(p, b, d) > 0 && area(p, d, c) > 0;
}

// Flips edges opposite the new vertex until all circles are empty.
void LatticeTriangles::restore_delaunay(int vertex) {
  while (!doubtful_.empty()) {
    const int t = doubtful_.back();
    doubtful_.pop_back();
    const Triangle near = (*this)[t];
    const int at = corner_of(near, vertex);
    const int u = near.across[static_cast<std::size_t>(at)];
    if (u < 0) continue;
    const Triangle far = (*this)[u];
    const int opposite = edge_to(far, t);
    if (!flips(t, at, u, opposite)) continue;
    const int b = near.corners[static_cast<std::size_t>(next(at))];
    const int c = near.corners[static_cast<std::size_t>(last(at))];
    const int d = far.corners[static_cast<std::size_t>(opposite)];
    const int over_pc = near.across[static_cast<std::size_t>(next(at))];
    const int over_pb = near.across[static_cast<std::size_t>(last(at))];
    const int over_db = far.across[static_cast<std::size_t>(next(opposite))];
    const int over_dc = far.across[static_cast<std::size_t>(last(opposite))];
    // p b c, d c b -> p b d, p d c.
    set(t, {vertex, b, d}, {over_db, u, over_pb});
    set(u, {vertex, d, c}, {over_dc, over_pc, t});
    relink(over_db, u, t);
    relink(over_pc, t, u);
    doubtful_.push_back(t);
    doubtful_.push_back(u);
  }
}

}  // namespace arete
