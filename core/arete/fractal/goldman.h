// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "arete/fractal/matrix_set.h"

namespace arete {

/// Goldman's form of an arc as affine maps of space (R. Goldman, "The fractal nature of Bezier
/// curves", 2004): M_A = P^-1 A P, so that P M_A = A P, acting on ROW vectors from the right,
/// (x, y, 1) -> (x, y, 1) M_A. The point of the address w_1..w_k is p_0 M_{w_k} ... M_{w_1}.
struct GoldmanMaps {
  /// P: columns are the coordinates, 1, and then unit columns where more are needed.
  Matrix<Rational> padded;
  /// How many unit columns were added; what is computed in the first columns does not depend on
  /// which.
  int padding = 0;
  /// One a matrix of the set, n x n. The column of the coordinate 1 is that unit column.
  std::vector<Matrix<Rational>> maps;
};

/// Control points are rows of any dimension d. The columns (coordinates, 1) are padded with unit
/// columns e_0, e_1, ..., each taken iff it raises the rank (a patch of k^2 points in space needs
/// k^2 - 4 of them).
///
/// Nothing is returned where these columns are dependent, because the points do not span: collinear
/// triangles in the plane, repeated points, plane polygons in space, fewer than d + 1 points. Then
/// P is singular whatever the padding, and only the barycentric form (ifs.h) is there.
///
/// Exact; cost O(n^3) rational operations. \throws InvalidScheme see check_maps. \throws
/// InvalidField if the number of points is not that of the set.
[[nodiscard]] std::optional<GoldmanMaps> goldman_maps(const MatrixSet<Rational>& set,
                                                      const Matrix<Rational>& control);

}  // namespace arete
