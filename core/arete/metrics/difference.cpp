// SPDX-License-Identifier: MIT
#include "arete/metrics/difference.h"

#include <cmath>
#include <limits>
#include <string>

#include "arete/metrics/slope.h"

namespace arete {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

void check_extents(GridView<const double> first, GridView<const double> second) {
  if (first.extent() == second.extent()) return;
  const auto text = [](Extent e) {
    return std::to_string(e.cols) + " x " + std::to_string(e.rows);
  };
  throw InvalidField("fields of " + text(first.extent()) + " and " + text(second.extent()) +
                     " samples cannot be compared sample by sample; bring them to one size");
}

}  // namespace

HeightDifference compare_heights(GridView<const double> first, GridView<const double> second) {
  check_extents(first, second);
  HeightDifference result;
  double squares = 0;
  double sum = 0;
  double absolute = 0;
  for (Index r = 0; r < first.rows(); ++r) {
    double row_squares = 0;
    double row_sum = 0;
    double row_absolute = 0;
    for (Index c = 0; c < first.cols(); ++c) {
      const bool a = std::isfinite(first(r, c));
      const bool b = std::isfinite(second(r, c));
      result.only_first += a && !b ? 1 : 0;
      result.only_second += b && !a ? 1 : 0;
      if (!a || !b) continue;
      ++result.compared;
      const double difference = second(r, c) - first(r, c);
      row_squares += difference * difference;
      row_sum += difference;
      row_absolute += std::abs(difference);
      if (std::abs(difference) > result.largest) {
        result.largest = std::abs(difference);
        result.largest_row = r;
        result.largest_col = c;
      }
    }
    squares += row_squares;
    sum += row_sum;
    absolute += row_absolute;
  }
  const auto count = static_cast<double>(result.compared);
  result.rmse = result.compared > 0 ? std::sqrt(squares / count) : none;
  result.mean = result.compared > 0 ? sum / count : none;
  result.mean_absolute = result.compared > 0 ? absolute / count : none;
  if (result.compared == 0) result.largest = none;
  return result;
}

SlopeDifference compare_slopes(GridView<const double> first, GridView<const double> second,
                               WorldPoint spacing) {
  check_extents(first, second);
  SlopeDifference result;
  double squares = 0;
  std::vector<double> a(static_cast<std::size_t>(first.cols()));
  std::vector<double> b(a.size());
  for (Index r = 0; r < first.rows(); ++r) {
    slope_degrees(first, spacing, r, a.data());
    slope_degrees(second, spacing, r, b.data());
    double row_squares = 0;
    for (std::size_t c = 0; c < a.size(); ++c) {
      const double difference = b[c] - a[c];
      if (!std::isfinite(difference)) continue;
      ++result.compared;
      row_squares += difference * difference;
    }
    squares += row_squares;
  }
  result.rmse =
      result.compared > 0 ? std::sqrt(squares / static_cast<double>(result.compared)) : none;
  return result;
}

}  // namespace arete
