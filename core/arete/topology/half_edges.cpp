// SPDX-License-Identifier: MIT
#include "arete/topology/half_edges.h"

#include <string>

#include "arete/field/at.h"
#include "arete/topology/not_a_grid.h"

namespace arete {
namespace {

[[noreturn]] void throw_same_direction(int face, int other, int from, int to) {
  throw NotAGrid::at_face(
      face, "and face " + std::to_string(other) + " both run from vertex " + std::to_string(from) +
                " to vertex " + std::to_string(to) +
                ": one is a duplicate, or flipped, or the edge has more than two faces; remove "
                "duplicate faces and orient the others coherently");
}

}  // namespace

HalfEdges::HalfEdges(const FaceList& faces, int vertex_count)
    : faces_(faces), vertex_count_(vertex_count), face_of_(faces.corners.size()) {
  for (int f = 0; f < faces.count(); ++f) {
    const auto corners = faces[f];
    if (corners.size() != 3 && corners.size() != 4)
      throw NotAGrid::at_face(
          f, "has " + std::to_string(corners.size()) +
                 " corners; a grid is made of quads or of their halves, triangles");
    for (std::size_t i = 0; i < corners.size(); ++i) {
      if (corners[i] < 0 || corners[i] >= vertex_count)
        throw NotAGrid::at_face(f, "names vertex " + std::to_string(corners[i]) + " of " +
                                       std::to_string(vertex_count) + "; the file is damaged");
      for (std::size_t j = 0; j < i; ++j)
        if (corners[i] == corners[j])
          throw NotAGrid::at_face(
              f, "has vertex " + std::to_string(corners[i]) + " twice; remove degenerate faces");
      face_of_[at(faces.starts[at(f)]) + i] = f;
    }
  }
  count_valences();
  find_twins();
  find_rim();
}

void HalfEdges::count_valences() {
  valences_.assign(at(vertex_count_), 0);
  for (int corner : faces_.corners) ++valences_[at(corner)];
  for (int v = 0; v < vertex_count_; ++v)
    if (valences_[at(v)] > largest_valence)
      throw NotAGrid::at_vertex(v, "has " + std::to_string(valences_[at(v)]) +
                                       " faces; at most 4 quads or 8 triangles meet in a grid");
}

void HalfEdges::find_twins() {
  // Half-edges sorted by the vertex they leave, filled one after the other: a twin that is already
  // there is found among the at most eight of the other end.
  struct Leaving {
    int to;
    int half_edge;
  };
  std::vector<int> first(at(vertex_count_) + 1, 0);
  for (int v = 0; v < vertex_count_; ++v) first[at(v) + 1] = first[at(v)] + valences_[at(v)];
  std::vector<int> fill(first.begin(), first.end() - 1);
  std::vector<Leaving> leaving(faces_.corners.size());

  twins_.assign(leaving.size(), -1);
  for (int f = 0; f < faces_.count(); ++f) {
    const int begin = faces_.starts[at(f)];
    const int end = faces_.starts[at(f) + 1];
    for (int h = begin; h < end; ++h) {
      const int a = faces_.corners[at(h)];
      const int b = faces_.corners[at(h + 1 < end ? h + 1 : begin)];
      for (int i = first[at(a)]; i < fill[at(a)]; ++i)
        if (leaving[at(i)].to == b) throw_same_direction(f, face(leaving[at(i)].half_edge), a, b);
      leaving[at(fill[at(a)]++)] = {b, h};
      for (int i = first[at(b)]; i < fill[at(b)]; ++i) {
        if (leaving[at(i)].to != a) continue;
        twins_[at(h)] = leaving[at(i)].half_edge;
        twins_[at(leaving[at(i)].half_edge)] = h;
      }
    }
  }
}

// Where an open fan of faces begins more than once, parts of the surface touch in one vertex.
void HalfEdges::find_rim() {
  rim_from_.assign(at(vertex_count_), -1);
  int offender = vertex_count_;
  for (int h = 0; h < count(); ++h) {
    if (twin(h) >= 0) continue;
    if (rim_from(from(h)) >= 0 && from(h) < offender) offender = from(h);
    rim_from_[at(from(h))] = h;
  }
  if (offender < vertex_count_)
    throw NotAGrid::at_vertex(offender,
                              "joins parts of the surface that touch only there; split it");
}

}  // namespace arete
