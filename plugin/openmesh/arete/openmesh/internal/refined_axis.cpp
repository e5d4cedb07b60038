// SPDX-License-Identifier: MIT
#include "arete/openmesh/internal/refined_axis.h"

#include <algorithm>
#include <string>
#include <utility>

namespace arete::openmesh::detail {
namespace {

// The place a / d of an old axis.
Location locate(Index a, Index d, Index coarse, bool wraps) {
  if (wraps) a = ((a % (coarse * d)) + coarse * d) % (coarse * d);
  const Index last_cell = wraps ? coarse - 1 : coarse - 2;
  Location place;
  place.cell = std::clamp(floor_divide(a, d), Index{0}, last_cell);
  place.t = static_cast<double>(a - place.cell * d) / static_cast<double>(d);
  if (a % d == 0) place.sample = a / d;
  return place;
}

}  // namespace

RefinedAxis refined_axis(AxisPlan plan, bool wraps) {
  RefinedAxis axis{std::move(plan), wraps, {}, {}, 0};
  const Index least = wraps ? 3 : 2;
  if (axis.fine() < least)
    throw InvalidField(
        "refinement leaves " + std::to_string(axis.fine()) +
        " samples along an axis, too few for a face; use another boundary than none");
  // first = p / d, spacing = q / d over their common denominator; the middle of cells over 2 d.
  const Rational& first = axis.plan.first_position();
  const Rational& spacing = axis.plan.spacing();
  const auto denominator =
      static_cast<Index>(Integer(lcm(Integer(boost::multiprecision::denominator(first)),
                                     Integer(boost::multiprecision::denominator(spacing)))));
  const auto over = [&](const Rational& value) {
    return static_cast<Index>(
        Integer(boost::multiprecision::numerator(Rational(value * denominator))));
  };
  const Index p = over(first);
  const Index q = over(spacing);
  axis.samples.reserve(static_cast<std::size_t>(axis.fine()));
  axis.middles.reserve(static_cast<std::size_t>(axis.fine_cells()));
  for (Index i = 0; i < axis.fine(); ++i)
    axis.samples.push_back(locate(p + i * q, denominator, axis.coarse(), wraps));
  for (Index i = 0; i < axis.fine_cells(); ++i)
    axis.middles.push_back(locate(2 * p + (2 * i + 1) * q, 2 * denominator, axis.coarse(), wraps));

  const Index stride = denominator / q;
  const Index full = wraps ? axis.coarse() * stride : (axis.coarse() - 1) * stride + 1;
  if (p == 0 && denominator % q == 0 && axis.fine() == full) axis.stride = stride;
  return axis;
}

}  // namespace arete::openmesh::detail
