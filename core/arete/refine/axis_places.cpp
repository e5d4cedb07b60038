// SPDX-License-Identifier: MIT
#include "arete/refine/axis_places.h"

#include <algorithm>

namespace arete {
namespace {

std::vector<AxisPlace> places(const AxisPlan& plan, IndexRange outputs, const Rational& shift) {
  std::vector<AxisPlace> result(static_cast<std::size_t>(outputs.count()));
  const Index count = plan.input_count();
  if (count == 1) return result;
  // a / d with a common denominator: integers are much faster than rationals.
  const Rational first = plan.first_position() + (outputs.first + shift) * plan.spacing();
  const auto d =
      static_cast<Index>(Integer(lcm(Integer(boost::multiprecision::denominator(first)),
                                     Integer(boost::multiprecision::denominator(plan.spacing())))));
  auto a = static_cast<Index>(Integer(boost::multiprecision::numerator(Rational(first * d))));
  const auto step =
      static_cast<Index>(Integer(boost::multiprecision::numerator(Rational(plan.spacing() * d))));
  const bool turn = plan.boundary() == Boundary::periodic;
  for (AxisPlace& place : result) {
    const Index inside = turn ? a - floor_divide(a, count * d) * count * d : a;
    place.cell = std::clamp(floor_divide(inside, d), Index{0}, turn ? count - 1 : count - 2);
    place.t = static_cast<double>(inside - place.cell * d) / static_cast<double>(d);
    a += step;
  }
  return result;
}

}  // namespace

std::vector<AxisPlace> sample_places(const AxisPlan& plan, IndexRange outputs) {
  return places(plan, outputs, 0);
}

std::vector<AxisPlace> middle_places(const AxisPlan& plan, IndexRange outputs) {
  return places(plan, outputs, Rational(1, 2));
}

}  // namespace arete
