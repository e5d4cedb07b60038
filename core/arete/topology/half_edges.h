// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "arete/topology/face_list.h"

namespace arete {

/// Who neighbours whom in a mesh of triangles and quads. Half-edge h is number h of
/// FaceList::corners: it leaves that corner towards the next one of its face.
///
/// Linear in the number of corners: a vertex with more than eight faces cannot belong to a grid
/// (four cells of two triangles) and is refused before neighbours are searched.
class HalfEdges {
 public:
  static constexpr int largest_valence = 8;

  /// The face list must outlive this. \throws NotAGrid for a vertex number out of range, a face
  /// that is neither triangle nor quad or repeats a vertex, a vertex with more than eight faces,
  /// two faces that run along one edge in the same direction (a duplicate, a flipped face, or
  /// three faces on an edge), and a vertex that joins parts that touch only there.
  HalfEdges(const FaceList& faces, int vertex_count);

  [[nodiscard]] const FaceList& faces() const { return faces_; }
  [[nodiscard]] int vertex_count() const { return vertex_count_; }
  [[nodiscard]] int count() const { return static_cast<int>(twins_.size()); }

  /// The half-edge of the neighbouring face along the same edge, -1 at the rim.
  [[nodiscard]] int twin(int h) const { return twins_[static_cast<std::size_t>(h)]; }
  [[nodiscard]] int face(int h) const { return face_of_[static_cast<std::size_t>(h)]; }
  [[nodiscard]] int from(int h) const { return faces_.corners[static_cast<std::size_t>(h)]; }
  [[nodiscard]] int to(int h) const { return from(next(h)); }
  [[nodiscard]] int next(int h) const { return h + 1 == end(h) ? begin(h) : h + 1; }
  [[nodiscard]] int previous(int h) const { return h == begin(h) ? end(h) - 1 : h - 1; }
  /// The half-edge along the rim that leaves this vertex, -1 when the vertex is not on the rim.
  [[nodiscard]] int rim_from(int vertex) const {
    return rim_from_[static_cast<std::size_t>(vertex)];
  }
  /// How many faces meet at a vertex.
  [[nodiscard]] int valence(int vertex) const {
    return valences_[static_cast<std::size_t>(vertex)];
  }

 private:
  [[nodiscard]] int begin(int h) const { return faces_.starts[static_cast<std::size_t>(face(h))]; }
  [[nodiscard]] int end(int h) const {
    return faces_.starts[static_cast<std::size_t>(face(h)) + 1];
  }
  void count_valences();
  void find_twins();
  void find_rim();

  const FaceList& faces_;
  int vertex_count_;
  std::vector<int> face_of_;
  std::vector<int> valences_;
  std::vector<int> twins_;
  std::vector<int> rim_from_;
};

}  // namespace arete
