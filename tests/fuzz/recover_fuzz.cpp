// SPDX-License-Identifier: MIT
// Any faces as a mesh, soups of numbers and grids that were tampered with: they are refused as no
// grid, or every patch is a grid of faces that are there.
#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <vector>

#include "arete/topology/grid_faces.h"
#include "arete/topology/orient.h"
#include "arete/topology/recover.h"
#include "byte_reader.h"

namespace {

using namespace arete;

void require(bool law) {
  if (!law) std::abort();
}

// Faces of any number of corners, corners of any number near the vertices there are.
FaceList soup(ByteReader& bytes, int vertices) {
  FaceList faces;
  while (!bytes.empty() && faces.count() < 400) {
    std::vector<int> face(
        static_cast<std::size_t>(bytes.below(8) == 7 ? bytes.below(7) : 3 + bytes.below(2)));
    for (int& corner : face) corner = bytes.below(vertices + 2) - 1;
    faces.add(face);
  }
  return faces;
}

FaceList triangulated(const FaceList& quads, int pattern) {
  FaceList faces;
  for (int f = 0; f < quads.count(); ++f) {
    const auto q = quads[f];
    const std::size_t turn = (pattern >> (f % 7)) & 1;
    faces.add(std::vector<int>{q[turn], q[turn + 1], q[turn + 2]});
    faces.add(std::vector<int>{q[turn + 2], q[(turn + 3) % 4], q[turn]});
  }
  return faces;
}

void tamper(ByteReader& bytes, FaceList& faces, int vertices) {
  const int changes = bytes.below(6);
  for (int k = 0; k < changes; ++k) {
    const auto at = bytes.take<std::uint16_t>() % faces.corners.size();
    const auto other = bytes.take<std::uint16_t>() % faces.corners.size();
    const int action = bytes.below(3);
    if (action == 0) faces.corners[at] = bytes.below(vertices + 2) - 1;
    if (action == 1) std::swap(faces.corners[at], faces.corners[other]);
    if (action == 2) {  // one vertex becomes another, everywhere
      const int from = faces.corners[at];
      std::replace(faces.corners.begin(), faces.corners.end(), from, faces.corners[other]);
    }
  }
}

// The faces in another order, each begun at another corner.
FaceList shuffled(ByteReader& bytes, const FaceList& faces) {
  std::vector<int> order(static_cast<std::size_t>(faces.count()));
  for (std::size_t f = 0; f < order.size(); ++f) order[f] = static_cast<int>(f);
  const int swaps = bytes.below(64);
  for (int k = 0; k < swaps; ++k)
    std::swap(order[bytes.take<std::uint16_t>() % order.size()],
              order[bytes.take<std::uint16_t>() % order.size()]);
  FaceList result;
  for (const int f : order) {
    std::vector<int> face(faces[f].begin(), faces[f].end());
    std::rotate(face.begin(), face.begin() + f % static_cast<int>(face.size()), face.end());
    result.add(face);
  }
  return result;
}

// Whether all corners of a face are corners of the cell.
bool lies_in(std::span<const int> face, const std::array<int, 4>& cell) {
  return std::all_of(face.begin(), face.end(),
                     [&](int v) { return std::find(cell.begin(), cell.end(), v) != cell.end(); });
}

void check(const GridPatch& patch, const FaceList& faces, int vertices) {
  const Extent extent = patch.extent;
  require(extent.rows >= 2 && extent.cols >= 2);
  require(static_cast<Index>(patch.vertices.size()) == extent.rows * extent.cols);
  for (const int v : patch.vertices) require(v >= 0 && v < vertices);
  for (Index r = 0; r < patch.cell_rows(); ++r)
    for (Index c = 0; c < patch.cell_cols(); ++c) {
      const Index below = (r + 1) % extent.rows, right = (c + 1) % extent.cols;
      const std::array<int, 4> corners{patch.vertex(r, c), patch.vertex(r, right),
                                       patch.vertex(below, right), patch.vertex(below, c)};
      const GridCell& cell = patch.cell(r, c);
      require(cell.faces[0] >= 0 && cell.faces[0] < faces.count());
      require(lies_in(faces[cell.faces[0]], corners));
      if (cell.diagonal != Diagonal::none) require(lies_in(faces[cell.faces[1]], corners));
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  ByteReader bytes(data, size);
  const int kind = bytes.below(4);
  int vertices = 1 + bytes.below(60);
  FaceList faces;
  try {
    if (kind == 0) {
      faces = soup(bytes, vertices);
    } else {
      const Extent extent{2 + bytes.below(7), 2 + bytes.below(7)};
      vertices = static_cast<int>(extent.rows * extent.cols);
      const int turns = bytes.below(8);
      faces = grid_faces(extent, (turns & 1) != 0, (turns & 2) != 0, (turns & 4) != 0);
      if (kind == 2) faces = triangulated(faces, bytes.below(128));
      tamper(bytes, faces, vertices);
      if (kind == 3) faces = shuffled(bytes, faces);
    }
    std::vector<Point3> points(static_cast<std::size_t>(vertices));
    for (std::size_t v = 0; v < points.size(); ++v)
      points[v] = {static_cast<double>(v % 7), static_cast<double>(v / 7), 0};
    for (const GridPatch& patch : recover_grids(faces, vertices, points)) {
      check(patch, faces, vertices);
      check(oriented(patch, points), faces, vertices);
    }
  } catch (const InvalidField&) {
  }
  return 0;
}
