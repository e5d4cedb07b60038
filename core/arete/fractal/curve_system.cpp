// SPDX-License-Identifier: MIT
#include "arete/fractal/curve_system.h"

#include "arete/fractal/arc_matrices.h"
#include "arete/fractal/pairs.h"
#include "arete/scheme/catalogue.h"

namespace arete {
namespace {

constexpr int largest_degree = 64;

int degree_of(std::string_view text, std::string_view value) {
  const auto refuse = [&text] {
    throw InvalidScheme("'" + std::string(text.substr(0, 64)) +
                        "': the degree of a Bezier curve is "
                        "an integer from 1 to 64, as in bezier:degree=3");
  };
  Rational degree = 0;
  try {
    degree = parse_rational(value);
  } catch (const std::invalid_argument&) {
    refuse();
  }
  if (!is_integer(degree) || degree < 1 || degree > largest_degree) refuse();
  return degree.convert_to<int>();
}

CurveSystem bezier(std::string_view text, int count) {
  const std::string_view key = "bezier:degree=";
  int degree = count - 1;
  if (text != "bezier") {
    if (text.substr(0, key.size()) != key)
      throw InvalidScheme("'" + std::string(text.substr(0, 64)) +
                          "' is not bezier or bezier:degree=D");
    degree = degree_of(text, text.substr(key.size()));
  } else if (degree < 1 || degree > largest_degree) {
    throw InvalidField("one Bezier curve takes 2 to 65 control points, not " +
                       std::to_string(count) + "; give a chain, as in bezier:degree=3");
  }
  return {"bezier:degree=" + std::to_string(degree), bezier_pair<Rational>(degree), degree};
}

}  // namespace

CurveSystem parse_curve_system(std::string_view text, int count) {
  if (text == "bezier" || text.substr(0, 7) == "bezier:") return bezier(text, count);
  if (text == "perturbed-bezier") return {"perturbed-bezier", perturbed_bezier_pair<Rational>(), 3};
  if (text == "contour") return {"contour", bezier_pair<Rational>(2), 1, /*contour=*/true};
  if (text == "natural-spline") {
    CurveSystem system{"natural-spline", arc_matrices(parse_scheme("b-spline:degree=3").mask()).set,
                       1};
    system.natural_ends = true;
    return system;
  }
  const Scheme scheme = parse_scheme(text);
  return {scheme.text(), arc_matrices(scheme.mask()).set, 1};
}

int arc_count(const CurveSystem& system, int count, bool closed) {
  const std::string have = std::to_string(count) + " control points";
  if (system.contour) return count;
  const int n = system.set.size();
  if (closed) {
    if (system.natural_ends)
      throw InvalidField(system.text + " has two ends and cannot be closed; leave closing out");
    if (count < 1 || count % system.step != 0)
      throw InvalidField(system.text + " cannot be closed on " + have + "; give a multiple of " +
                         std::to_string(system.step));
    return count / system.step;
  }
  if (system.natural_ends) {
    if (count < 2) throw InvalidField(system.text + " takes 2 or more control points, not " + have);
    return count - 1;
  }
  if (count < n || (count - n) % system.step != 0)
    throw InvalidField(system.text + " takes " + std::to_string(n) +
                       (system.step == 1 ? " or more" : " + k " + std::to_string(system.step)) +
                       " control points, not " + std::to_string(count));
  return (count - n) / system.step + 1;
}

}  // namespace arete
