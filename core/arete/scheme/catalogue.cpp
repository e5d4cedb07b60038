// SPDX-License-Identifier: MIT
#include "arete/scheme/catalogue.h"

#include "arete/scheme/family/b_spline.h"
#include "arete/scheme/family/corner_cutting.h"
#include "arete/scheme/family/difference.h"
#include "arete/scheme/family/dubuc_deslauriers.h"
#include "arete/scheme/family/four_parameter.h"
#include "arete/scheme/family/ternary.h"

namespace arete {
namespace {

using Q = Rational;
using Values = ParameterValues;

Parameter real(std::string name, std::string symbol, ParameterRange accepted, ParameterRange usual,
               std::optional<Rational> fallback, std::string meaning) {
  return {std::move(name),  std::move(symbol),   ParameterKind::real, std::move(accepted),
          std::move(usual), std::move(fallback), std::move(meaning)};
}

Parameter whole(std::string name, std::string symbol, int lowest, int highest,
                std::optional<Rational> fallback, std::string meaning, int step = 1) {
  return {std::move(name),   std::move(symbol),   ParameterKind::integer, {lowest, highest},
          {lowest, highest}, std::move(fallback), std::move(meaning),     step};
}

Parameter weight(std::string name, std::string symbol, std::string meaning,
                 const Rational& fallback) {
  return real(std::move(name), std::move(symbol), {-4, 4}, {0, Q(1, 4)}, fallback,
              std::move(meaning));
}

Parameter nu() {
  return real("nu", "nu", {-4, 5}, {0, 1}, Q(1, 2),
              "left-right balance of the edge rule, 1/2 is symmetric");
}

Parameter omega(const Rational& fallback, const Rational& usual_highest) {
  return real("omega", "w", {-4, 4}, {0, usual_highest}, fallback,
              "tension of the edge rule, larger is craggier");
}

Parameter smoothing_power() {
  return whole("m", "m", 1, 16, Q(1), "power of (1+z) in the difference symbol");
}

Parameter raise() {
  return whole("raise", "k", 0, 16, Q(1), "how often the scheme is raised by (1+z)/2");
}

Parameter difference_weight(std::string name, const Rational& fallback) {
  return real(name, name, {-4, 4}, {-1, 1}, fallback, "coefficient of the difference symbol");
}

Parameter ternary_b() {
  return real("b", "b_-1", {-100, 100}, {Q(-15, 32), Q(15, 32)}, Q(1, 10),
              "shape; C^2 for -0.4696 < b < 0.6192, smoothest near 0.0954");
}

Mask difference_mask(const Values& v) {
  std::vector<Rational> coefficients;
  for (const ParameterValue& value : v)
    if (value.name.front() == 'a') coefficients.push_back(value.numbers.front());
  const int m = integer(v, "m");
  Rational sum = 0;
  for (const Rational& c : coefficients) sum += c;
  if (sum * (1 << m) != 1)
    throw InvalidScheme("difference: the coefficients a0..an sum to " + to_string(sum) +
                        "; they must sum to 2^-m = " + to_string(Q(1, 1 << m)));
  return {2, family::difference<Q>(coefficients, m, integer(v, "raise"))};
}

Mask typed_mask(const Values& v) {
  for (const ParameterValue& value : v)
    if (value.name == "coefficients")
      return {integer(v, "arity"), integer(v, "first"), value.numbers};
  throw InvalidScheme("mask: coefficients are missing");
}

std::vector<Family> make_catalogue() {
  const std::string zhao = "Zhao, Peng, Ye: Improved four points subdivision scheme";
  const std::string shen =
      "Shen, Huang: A class of curve subdivision schemes with several parameters";
  const std::string zhong = "Zhong, Qi: Parameterized ternary two-step interpolatory scheme";
  const std::string kotarski = "Kotarski, Gdawiec: Direct and reverse subdivision schemes";
  return {
      {"four-parameter",
       "the four-parameter 4-point scheme",
       zhao + ", rule (1)",
       {weight("lambda", "l", "weight of the left neighbour at an old sample", 0),
        weight("mu", "m", "weight of the right neighbour at an old sample", 0), nu(),
        omega(Q(1, 16), Q(1, 3))},
       [](const Values& v) {
         return Mask(2, family::four_parameter<Q>(number(v, "lambda"), number(v, "mu"),
                                                  number(v, "nu"), number(v, "omega")));
       }},
      {"four-point",
       "interpolatory 4-point scheme, C^1 for 0 < omega < 0.1927",
       "Dyn, Gregory, Levin 1987",
       {omega(Q(1, 16), Q(3, 16))},
       [](const Values& v) { return Mask(2, family::four_point<Q>(number(v, "omega"))); }},
      {"four-parameter-c2",
       "the C^2 family of the four-parameter scheme, C^2 for omega < 1/16",
       zhao + ", theorem 3 solved",
       {nu(), omega(Q(1, 32), Q(1, 16))},
       [](const Values& v) {
         return Mask(2, family::four_parameter_c2<Q>(number(v, "nu"), number(v, "omega")));
       }},
      {"gentle",
       "the printed gentle landscape (7/32, 7/32, 1/2, 3/64), C^1",
       zhao + ", example 1",
       {},
       [](const Values&) { return Mask(2, family::gentle<Q>()); }},
      {"craggy",
       "the printed craggy landscape (1/30, 1/30, 1/2, 1/3), C^0",
       zhao + ", example 2",
       {},
       [](const Values&) { return Mask(2, family::craggy<Q>()); }},
      {"two-parameter",
       "from the difference symbol (az+b)(z+1)^m, b = 2^-m - a",
       shen + ", scheme (3)",
       {difference_weight("a", 0), smoothing_power(), raise()},
       [](const Values& v) {
         return Mask(
             2, family::two_parameter<Q>(number(v, "a"), integer(v, "m"), integer(v, "raise")));
       }},
      {"three-parameter",
       "from the difference symbol (az^2+bz+c)(z+1)^m, b = 2^-m - a - c",
       shen + ", scheme (5)",
       {difference_weight("a", Q(1, 12)), difference_weight("c", Q(1, 12)),
        whole("m", "m", 1, 16, Q(2), "power of (1+z) in the difference symbol"), raise()},
       [](const Values& v) {
         return Mask(2, family::three_parameter<Q>(number(v, "a"), number(v, "c"), integer(v, "m"),
                                                   integer(v, "raise")));
       }},
      {"difference",
       "from any difference symbol (a0 + a1 z + ... + an z^n)(z+1)^m",
       shen + ", section 2",
       {{"a",
         "a_i",
         ParameterKind::real,
         {-1000, 1000},
         {-1, 1},
         std::nullopt,
         "coefficients a0, a1, ... of the difference symbol, sum 2^-m",
         1,
         true},
        smoothing_power(),
        raise()},
       difference_mask},
      {"three-point",
       "asymmetric interpolatory 3-point scheme, C^1",
       shen + ", scheme (4)",
       {},
       [](const Values&) { return Mask(2, family::three_point<Q>()); }},
      {"ternary-two-step",
       "ternary dual scheme whose square interpolates",
       zhong + ", (3.1)",
       {ternary_b()},
       [](const Values& v) { return Mask(3, family::ternary_two_step<Q>(number(v, "b"))); }},
      {"ternary-two-step-9",
       "its two steps as one interpolatory 9-ary step",
       zhong + ", (3.2)",
       {ternary_b()},
       [](const Values& v) { return Mask(9, family::ternary_two_step_9<Q>(number(v, "b"))); }},
      {"ternary-four-point",
       "ternary interpolatory 4-point scheme, C^2 for 1/15 < mu < 1/9",
       "Hassan, Ivrissimtzis, Dodgson, Sabin 2002",
       {real("mu", "mu", {-4, 4}, {Q(1, 15), Q(1, 9)}, Q(1, 11), "tension")},
       [](const Values& v) { return Mask(3, family::ternary_four_point<Q>(number(v, "mu"))); }},
      {"corner-cutting",
       "general corner cutting, converges for u, v >= 0, 0 < u+v < 1",
       kotarski,
       {real("u", "u", {-1, 2}, {0, Q(1, 2)}, Q(1, 4), "cut near the first end of an edge"),
        real("v", "v", {-1, 2}, {0, Q(1, 2)}, Q(1, 4), "cut near the second end of an edge")},
       [](const Values& v) {
         return Mask(2, family::corner_cutting<Q>(number(v, "u"), number(v, "v")));
       }},
      {"chaikin",
       "corner cutting at 1/4, the quadratic B-spline, C^1",
       "Chaikin 1974",
       {},
       [](const Values&) { return Mask(2, family::chaikin<Q>()); }},
      {"de-rham",
       "corner cutting at 1/3",
       "de Rham 1947",
       {},
       [](const Values&) { return Mask(2, family::de_rham<Q>()); }},
      {"b-spline",
       "uniform B-spline, C^(degree-1); degree 3 is regular Catmull-Clark",
       "Lane, Riesenfeld 1980",
       {whole("degree", "d", 1, 32, Q(3), "degree of the spline")},
       [](const Values& v) { return Mask(2, family::b_spline<Q>(integer(v, "degree"))); }},
      {"dubuc-deslauriers",
       "interpolatory on 4, 6 or 8 points",
       "Dubuc 1986, Deslauriers 1989",
       {whole("points", "2n", 4, 8, Q(4), "how many samples an inserted one reads", 2)},
       [](const Values& v) { return Mask(2, family::dubuc_deslauriers<Q>(integer(v, "points"))); }},
      {"mask",
       "any mask you type",
       "",
       {whole("arity", "m", 2, Mask::largest_arity, Q(2), "how many new samples an old one makes"),
        whole("first", "first", -100000, 100000, std::nullopt, "index of the first coefficient"),
        {"coefficients",
         "a",
         ParameterKind::list,
         {-1000000, 1000000},
         {-1, 1},
         std::nullopt,
         "the mask, separated by semicolons"}},
       typed_mask},
  };
}

}  // namespace

const std::vector<Family>& catalogue() {
  static const std::vector<Family> table = make_catalogue();
  return table;
}

}  // namespace arete
