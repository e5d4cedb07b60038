// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

namespace arete {

/// Where the strands of a horizontal filter read, beside one another: strand i has `taps[i]` taps
/// and begins `first[i]` samples after the first sample that any of them reads.
struct Shape {
  static constexpr int most_strands = 9;

  int arity = 0;
  std::array<int, most_strands> first{};
  std::array<int, most_strands> taps{};

  /// Samples from the first to the last that are read for one turn.
  [[nodiscard]] constexpr int window() const {
    int last = 0;
    for (std::size_t i = 0; i < static_cast<std::size_t>(arity); ++i)
      last = first[i] + taps[i] > last ? first[i] + taps[i] : last;
    return last;
  }
};

/// The same strands begun one phase later, as rows are that begin elsewhere.
constexpr Shape turned(const Shape& shape) {
  Shape next;
  next.arity = shape.arity;
  const auto count = static_cast<std::size_t>(shape.arity);
  int lowest = 1 << 20;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t from = (i + 1) % count;
    next.taps[i] = shape.taps[from];
    next.first[i] = shape.first[from] + (from == 0 ? 1 : 0);
    lowest = next.first[i] < lowest ? next.first[i] : lowest;
  }
  for (std::size_t i = 0; i < count; ++i) next.first[i] -= lowest;
  return next;
}

constexpr Shape shape_of_two(int first_a, int taps_a, int first_b, int taps_b) {
  Shape shape;
  shape.arity = 2;
  shape.first = {first_a, first_b};
  shape.taps = {taps_a, taps_b};
  return shape;
}

/// The shapes that have loops of their own: every one of the catalogue. Any other shape is woven as
/// well, at about half the speed.
inline constexpr auto shapes = [] {
  constexpr std::size_t binary = 12;
  constexpr std::size_t ternary = 2;
  std::array<Shape, 2 * binary + 3 * ternary + 1 + 4> all{};
  std::size_t count = 0;
  for (const Shape& shape : {
           shape_of_two(0, 3, 0, 4),  // four-parameter, three-parameter, B-spline of degree 5
           shape_of_two(1, 1, 0, 4),  // four-point
           shape_of_two(0, 3, 1, 2),  // cubic B-spline
           shape_of_two(0, 2, 1, 2),  // quadratic B-spline, two-parameter, Chaikin
           shape_of_two(0, 3, 0, 3),  // B-spline of degree 4
           shape_of_two(1, 1, 0, 3),  // three-point
           shape_of_two(0, 1, 0, 2),  // linear
           shape_of_two(0, 1, 0, 1),  // constant
           shape_of_two(2, 1, 0, 6),  // Dubuc-Deslauriers, 6 points
           shape_of_two(3, 1, 0, 8),  // Dubuc-Deslauriers, 8 points
           shape_of_two(0, 4, 0, 4),  // B-spline of degree 6
           shape_of_two(0, 5, 1, 4),  // B-spline of degree 7
       }) {
    all[count++] = shape;
    all[count++] = turned(shape);
  }
  for (const Shape& shape : {
           Shape{3, {0, 0, 1}, {5, 5, 4}},  // ternary-two-step
           Shape{3, {1, 0, 0}, {1, 4, 4}},  // ternary-four-point
       }) {
    all[count++] = shape;
    all[count++] = turned(shape);
    all[count++] = turned(turned(shape));
  }
  all[count++] = {
      9, {2, 0, 0, 0, 0, 0, 0, 0, 0}, {1, 6, 6, 6, 6, 6, 6, 6, 6}};  // two steps at once
  // Filters of the last level.
  for (int taps : {1, 2, 3, 5}) all[count++] = {1, {0}, {taps}};
  return all;
}();

}  // namespace arete
