// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "arete/reverse/least_squares_reverse.h"
#include "arete/reverse/local_problem.h"

namespace arete {

// Reverse of the halving of Bezier curves (de Casteljau at 1/2): a chain of 2K pieces of degree n,
// 2Kn + 1 control points with shared joints, becomes K pieces, Kn + 1 points, and Kn details. Two
// halves of one piece come back as that piece with details 0; analysis and synthesis are inverse to
// each other for any points. Over float, double or Rational.

/// The matrix that halves a chain of K pieces of degree n >= 1: (2Kn + 1) x (Kn + 1).
/// \throws InvalidField unless 1 <= degree <= 30 and pieces >= 1.
template <class R>
[[nodiscard]] SparseRows<R> bezier_halving(int degree, Index pieces) {
  if (degree < 1 || degree > 30 || pieces < 1)
    throw InvalidField(
        "a chain of Bezier curves needs a degree from 1 to 30 and at least one piece");
  const Index n = degree;
  std::vector<std::vector<R>> blends{{R(1)}};  // C(i, j) / 2^i
  for (Index i = 1; i <= n; ++i) {
    std::vector<R> row(static_cast<std::size_t>(i) + 1, R(0));
    for (std::size_t j = 0; j < blends.back().size(); ++j) {
      row[j] = row[j] + blends.back()[j] / R(2);
      row[j + 1] = row[j + 1] + blends.back()[j] / R(2);
    }
    blends.push_back(std::move(row));
  }
  SparseRows<R> s(pieces * n + 1);
  for (Index i = 0; i <= 2 * n * pieces; ++i) {
    const Index piece = std::min(i / (2 * n), pieces - 1);
    const Index inside = i - 2 * n * piece;
    typename SparseRows<R>::Row row;
    // Point i of the left half blends points 0..i; the right half is its mirror image.
    const Index reach = inside <= n ? inside : 2 * n - inside;
    for (Index j = 0; j <= reach; ++j)
      row.push_back({piece * n + (inside <= n ? j : n - j),
                     blends[static_cast<std::size_t>(reach)][static_cast<std::size_t>(j)]});
    s.push_row(std::move(row));
  }
  return s;
}

/// The best chain of `pieces` pieces; for one piece of degree 2 the filters (9, 2, 0, -2, 1)/10,
/// (-3, 4, 4, 4, -3)/6 and the mirror image of the first. Errors as bezier_halving.
template <class R>
[[nodiscard]] LeastSquaresReverse<R> bezier_least_squares(int degree, Index pieces) {
  SparseRows<R> s = bezier_halving<R>(degree, pieces);
  // Points 0..n/2 follow from the left half, the others from the right one.
  std::vector<Index> anchors;
  for (Index piece = 0; piece < pieces; ++piece)
    for (Index i = 0; i < degree; ++i)
      anchors.push_back(2 * degree * piece + (i <= degree / 2 ? i : degree + i));
  anchors.push_back(2 * degree * pieces);
  return {std::move(s), std::move(anchors)};
}

/// Local filters, degrees 2 and 3; joints stay where they are:
/// degree 2: c_1 = f_1 + f_3 - (f_0 + f_4)/2; degree 3: c_1 = 2 f_1 - f_0, c_2 = 2 f_5 - f_6.
/// \throws InvalidField for any other degree, or no piece.
template <class R>
[[nodiscard]] LocalReverse<R> bezier_local(int degree, Index pieces) {
  if (degree != 2 && degree != 3)
    throw InvalidField("Bezier curves of degree " + std::to_string(degree) +
                       " have no local reverse here (2 and 3 have); use least squares");
  const SparseRows<R> s = bezier_halving<R>(degree, pieces);
  const R half = R(1) / R(2);
  SparseRows<R> analysis(s.rows());
  SparseRows<R> detail(s.rows() + s.cols());
  std::vector<typename SparseRows<R>::Row> synthesis_rows;
  for (Index i = 0; i < s.rows(); ++i) synthesis_rows.push_back(s.row(i));
  const auto keep = [&](Index row) {
    synthesis_rows[static_cast<std::size_t>(row)].push_back({s.cols() + detail.rows(), R(1)});
    detail.push_row(residual_row(s, row));
  };
  for (Index piece = 0; piece < pieces; ++piece) {
    const Index f = 2 * degree * piece;
    analysis.push_row({{f, R(1)}});
    if (degree == 2) {
      analysis.push_row({{f, R(0) - half}, {f + 1, R(1)}, {f + 3, R(1)}, {f + 4, R(0) - half}});
      // The residuals of f_1 and f_3 are opposite.
      synthesis_rows[static_cast<std::size_t>(f + 3)].push_back({s.cols() + detail.rows(), R(-1)});
      keep(f + 1);
      keep(f + 2);
    } else {
      analysis.push_row({{f, R(-1)}, {f + 1, R(2)}});
      analysis.push_row({{f + 5, R(2)}, {f + 6, R(-1)}});
      for (Index i = 2; i <= 4; ++i) keep(f + i);
    }
  }
  analysis.push_row({{s.rows() - 1, R(1)}});
  SparseRows<R> synthesis(s.cols() + detail.rows());
  for (auto& row : synthesis_rows) synthesis.push_row(std::move(row));
  return {std::move(analysis), std::move(detail), std::move(synthesis)};
}

}  // namespace arete
