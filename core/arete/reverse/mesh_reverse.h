// SPDX-License-Identifier: MIT
#pragma once

#include "arete/reverse/axis_reverse.h"
#include "arete/reverse/mesh_step.h"

namespace arete {

/// V = vertex v' + edge sum(e) + face sum(f): a coarse vertex from its own fine point and the edge
/// and face points around it.
template <class R>
struct VertexReverse {
  R vertex{};
  R edge{};
  R face{};
};

/// Catmull-Clark at an inner vertex of valence n != 3: V = (n v' - (4/n) sum e + (1/n) sum
/// f)/(n-3). At n = 3 the vertex point does not contain V. \pre n >= 2, n != 3
template <class R>
[[nodiscard]] VertexReverse<R> catmull_clark_reverse(Index n) {
  const R valence(static_cast<int>(n));
  const R over = R(1) / (valence * (valence - R(3)));
  return {valence * valence * over, R(-4) * over, over};
}

/// Loop at an inner vertex of valence n with the weight beta of each neighbour:
/// V = (v' - (8 beta/5) sum e)/(1 - 8 n beta/5). For Loop's own beta the denominator is
/// (8/5)(3/8 + cos(2 pi/n)/4)^2 > 0, for Warren's it is 2/5 (n > 3).
template <class R>
[[nodiscard]] VertexReverse<R> loop_reverse(Index n, const R& beta) {
  const R share = R(8) * beta / R(5);
  const R denominator = R(1) - R(static_cast<int>(n)) * share;
  return {R(1) / denominator, (R(0) - share) / denominator, R(0)};
}

/// Coarse positions found for fine ones.
template <class R>
struct MeshCoarse {
  Grid<R> positions;  ///< one vertex a row
  /// False where Catmull-Clark does not determine them: a closed part of the mesh in which every
  /// vertex has valence 3 and the edge graph has no odd cycle (a cube, a prism over an even
  /// polygon). Adding +t and -t alternately then changes no fine point; the positions returned are
  /// those of least norm.
  bool unique = true;
};

/// The reverse of one step of subdivision of `coarse`: positions of its vertices from fine ones in
/// the order of mesh_step.
///
/// - local: the formulas above; at the boundary V = 2 v' - (e_1 + e_2)/2 (sharp corners: v'; rim
///   `thirds`: 3 v' - e_1 - e_2); Doo-Sabin's vertex is the mean over its faces of what each face
///   alone gives. Catmull-Clark vertices of valence 3 follow
///   from neighbours E by V = 4 e - E - f_1 - f_2, the mean over those known, in sweeps of
///   ascending vertices. A closed part with valence 3 everywhere is left to least squares.
/// - least squares: the positions whose subdivision is nearest.
///
/// Both give subdivided data back exactly (to rounding). On other data local formulas amplify
/// noise: Catmull-Clark by up to (n+5)/(n-3), Loop 4, Doo-Sabin 4 (quads); least squares hardly.
/// Cost: local O(fine); least squares in double a sparse Cholesky factorisation with a fill-reducing
/// order, about O(n^1.5) for a surface of n vertices.
/// \throws InvalidField if the number of fine rows is not that of the step.
template <class R>
[[nodiscard]] MeshCoarse<R> reverse_mesh_step(const MeshFaces& coarse, MeshRule rule,
                                              GridView<const R> fine, ReverseMode mode);

/// How many dimensions of coarse positions no fine point shows: for Catmull-Clark the number of
/// closed connected parts with valence 3 everywhere and no odd cycle, otherwise 0. The theorem is
/// in docs/reverse.md. One row for each, +1 and -1 on the part's vertices, 0 elsewhere.
[[nodiscard]] std::vector<std::vector<int>> invisible_patterns(const MeshFaces& coarse,
                                                               MeshScheme scheme);

extern template MeshCoarse<double> reverse_mesh_step(const MeshFaces&, MeshRule,
                                                     GridView<const double>, ReverseMode);
extern template MeshCoarse<Rational> reverse_mesh_step(const MeshFaces&, MeshRule,
                                                       GridView<const Rational>, ReverseMode);

}  // namespace arete
