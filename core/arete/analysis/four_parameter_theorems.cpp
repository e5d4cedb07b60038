// SPDX-License-Identifier: MIT
#include "arete/analysis/four_parameter_theorems.h"

#include <algorithm>

namespace arete {

FourParameterTheorems four_parameter_theorems(const Rational& l, const Rational& m,
                                              const Rational& n, const Rational& w) {
  const Rational half(Rational(1) / 2);
  const Rational wn = w * n;
  const auto larger = [](const Rational& a, const Rational& b) { return std::max(a, b); };
  FourParameterTheorems t;
  t.theorem1_value = larger(abs(2 * wn) + abs(half - l + 2 * w - 4 * wn) + abs(2 * w + m - 2 * wn),
                            abs(l + 2 * wn) + abs(half - 2 * w - m + 4 * wn) + abs(2 * w - 2 * wn));
  t.theorem2_residual = m - l + 4 * w - 8 * wn;
  t.theorem2_value =
      2 * larger(abs(2 * wn) + abs(half - 2 * l + 2 * w - 8 * wn) + abs(2 * w - 2 * wn),
                 abs(l + 4 * wn) + abs(2 * l - m - 4 * w + 12 * wn));
  t.theorem3_residuals = {t.theorem2_residual, -half - m - 4 * w + 5 * l + 24 * wn};
  t.theorem3_value = 4 * larger(abs(2 * wn) + abs(half - 3 * l + 2 * w - 14 * wn),
                                abs(l + 6 * wn) + abs(2 * w - 2 * wn));
  return t;
}

std::vector<TheoremResult> four_parameter_results(const Rational& lambda, const Rational& mu,
                                                  const Rational& nu, const Rational& omega) {
  const FourParameterTheorems t = four_parameter_theorems(lambda, mu, nu, omega);
  const std::string who = " (Zhao, Peng, Ye)";
  std::vector<TheoremResult> results(3);
  results[0] = {
      "theorem 1" + who,
      "max{|2wn| + |1/2-l+2w-4wn| + |2w+m-2wn|, |l+2wn| + |1/2-2w-m+4wn| + |2w(1-n)|} < 1",
      0,
      t.theorem1_value < 1,
      {t.theorem1_value},
      {},
      true,
      {}};
  results[1] = {"theorem 2" + who,
                "m-l+4w-8wn = 0 and "
                "2 max{|2wn| + |1/2-2l+2w-8wn| + |2w-2wn|, |l+4wn| + |2l-m-4w+12wn|} < 1",
                1,
                t.theorem2_value < 1 && t.theorem2_residual == 0,
                {t.theorem2_value},
                {t.theorem2_residual},
                true,
                {}};
  results[2] = {
      "theorem 3" + who,
      "m-l+4w-8wn = 0, -1/2-m-4w+5l+24wn = 0 and "
      "4 max{|2wn| + |1/2-3l+2w-14wn|, |l+6wn| + |2w-2wn|} < 1",
      2,
      t.theorem3_value < 1 && t.theorem3_residuals[0] == 0 && t.theorem3_residuals[1] == 0,
      {t.theorem3_value},
      {t.theorem3_residuals[0], t.theorem3_residuals[1]},
      true,
      {}};
  return results;
}

}  // namespace arete
