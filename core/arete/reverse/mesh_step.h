// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>

#include "arete/algebra/rational.h"
#include "arete/reverse/mesh_faces.h"
#include "arete/reverse/sparse_rows.h"

namespace arete {

/// Subdivision of meshes of any connectivity.
enum class MeshScheme {
  catmull_clark,
  loop,         ///< triangles; Loop's own weights, as OpenMesh, CGAL and OpenSubdiv have them
  loop_warren,  ///< triangles; Warren's weights 3/16 (n = 3), 3/(8n)
  doo_sabin     ///< every face gives a smaller face of its own; the boundary shrinks
};

/// What happens to the vertices of an open mesh's boundary (not in Doo-Sabin). Boundary edges are
/// halved.
enum class MeshRim {
  smooth,  ///< (1, 6, 1)/8, a cubic B-spline curve: CGAL, OpenSubdiv EDGE_ONLY, OpenMesh's LoopT
  sharp_corners,  ///< the same, but a vertex of a single face stays: OpenSubdiv EDGE_AND_CORNER
  thirds          ///< (1, 4, 1)/6, no B-spline: OpenMesh's CatmullClarkT
};

/// A scheme with its rule at the boundary.
struct MeshRule {
  MeshScheme scheme;
  MeshRim rim;
  constexpr MeshRule(MeshScheme of, MeshRim at_rim = MeshRim::smooth)  // NOLINT: a scheme is a rule
      : scheme(of), rim(at_rim) {}
  [[nodiscard]] constexpr bool triangles() const {
    return scheme == MeshScheme::loop || scheme == MeshScheme::loop_warren;
  }
  [[nodiscard]] friend constexpr bool operator==(const MeshRule&, const MeshRule&) = default;
};

/// `catmull-clark`, `loop`, `loop-warren`, `doo-sabin`; nothing for any other text.
[[nodiscard]] std::optional<MeshScheme> parse_mesh_scheme(std::string_view text);
[[nodiscard]] std::string_view to_string(MeshScheme scheme);
/// `smooth`, `sharp-corners`, `thirds`; nothing for any other text.
[[nodiscard]] std::optional<MeshRim> parse_mesh_rim(std::string_view text);
[[nodiscard]] std::string_view to_string(MeshRim rim);

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

/// The weight of each neighbour of a vertex of valence n: Warren's, or Loop's own (Loop 1987)
/// (5/8 - (3/8 + cos(2 pi/n)/4)^2)/n.
template <class R>
[[nodiscard]] R loop_beta(MeshScheme scheme, Index valence) {
  if (scheme == MeshScheme::loop_warren)
    return valence == 3 ? R(3) / R(16) : R(3) / R(static_cast<int>(8 * valence));
  const R inner = R(3) / R(8) + cosine<R>(1, valence) / R(4);
  return (R(5) / R(8) - inner * inner) / R(static_cast<int>(valence));
}

/// The weight of each of the two neighbours along the boundary of a vertex there, `faces` of which
/// meet in it.
template <class R>
[[nodiscard]] R rim_weight(MeshRim rim, std::size_t faces) {
  if (rim == MeshRim::sharp_corners && faces == 1) return R(0);
  return R(1) / R(rim == MeshRim::thirds ? 6 : 8);
}

/// One step. \throws InvalidField see MeshNeighbours; for Loop also when a face is no triangle.
template <class R>
[[nodiscard]] MeshStep<R> mesh_step(const MeshFaces& coarse, MeshRule rule);

extern template MeshStep<double> mesh_step(const MeshFaces&, MeshRule);
extern template MeshStep<Rational> mesh_step(const MeshFaces&, MeshRule);

}  // namespace arete
