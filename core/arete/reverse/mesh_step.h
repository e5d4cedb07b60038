// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <numbers>
#include <string>
#include <type_traits>

#include "arete/algebra/rational.h"
#include "arete/reverse/mesh_faces.h"
#include "arete/reverse/sparse_rows.h"

namespace arete {

/// Subdivision of meshes of any connectivity.
enum class MeshScheme {
  catmull_clark,  ///< boundary: cubic B-spline curves (corners are rounded)
  loop,           ///< triangles; Warren's weights 3/16 (n = 3), 3/(8n); boundary as above
  doo_sabin       ///< every face gives a smaller face of its own; the boundary shrinks
};

/// One step of subdivision as a matrix: fine vertex i is row i over the coarse vertices.
///
/// Order of the fine vertices: Catmull-Clark vertex points, face points, edge points (edges by
/// their smaller, then larger vertex); Loop vertex points, edge points; Doo-Sabin every corner of
/// every face.
template <class R>
struct MeshStep {
  MeshFaces fine;
  SparseRows<R> s;
};

/// cos(2 pi k / n). Over rationals only where it is one. \throws InvalidField otherwise.
template <class R>
[[nodiscard]] R cosine(Index k, Index n) {
  if constexpr (std::is_floating_point_v<R>) {
    return std::cos(2 * std::numbers::pi_v<R> * static_cast<R>(k) / static_cast<R>(n));
  } else {
    const Index turn = ((12 * k / n) % 12 + 12) % 12;  // in twelfths
    if ((12 * k) % n != 0 || (turn % 2 != 0 && turn % 3 != 0))
      throw InvalidField("cos(2 pi " + std::to_string(k) + "/" + std::to_string(n) +
                         ") is not rational; use floating point");
    if (turn % 3 == 0) return turn == 0 ? R(1) : turn == 6 ? R(-1) : R(0);
    return (turn == 2 || turn == 10) ? R(1) / R(2) : R(-1) / R(2);
  }
}

/// Doo-Sabin's weight of a face's corner for the new vertex k corners away, n corners in all:
/// delta/4 + (3 + 2 cos(2 pi k/n))/(4n) (Doo and Sabin 1978).
template <class R>
[[nodiscard]] R doo_sabin_weight(Index k, Index n) {
  const R share = (R(3) + R(2) * cosine<R>(k, n)) / R(static_cast<int>(4 * n));
  return k % n == 0 ? share + R(1) / R(4) : share;
}

/// The inverse matrix's entry: 4 delta - (3 + 4 cos(2 pi k/n))/n.
template <class R>
[[nodiscard]] R doo_sabin_inverse(Index k, Index n) {
  const R share = (R(3) + R(4) * cosine<R>(k, n)) / R(static_cast<int>(n));
  return k % n == 0 ? R(4) - share : R(0) - share;
}

/// Warren's weight of each neighbour of a vertex of valence n in Loop's scheme.
template <class R>
[[nodiscard]] R loop_beta(Index valence) {
  return valence == 3 ? R(3) / R(16) : R(3) / R(static_cast<int>(8 * valence));
}

/// One step. \throws InvalidField see MeshNeighbours; for Loop also when a face is no triangle.
template <class R>
[[nodiscard]] MeshStep<R> mesh_step(const MeshFaces& coarse, MeshScheme scheme);

extern template MeshStep<double> mesh_step(const MeshFaces&, MeshScheme);
extern template MeshStep<Rational> mesh_step(const MeshFaces&, MeshScheme);

}  // namespace arete
