// SPDX-License-Identifier: MIT
// Searches families of schemes for extreme members: the roughest that is still C^1, the smoothest
// that interpolates.
#include <arete/analysis/hoelder.h>
#include <arete/analysis/smoothness_map.h>
#include <arete/scheme/catalogue.h>

#include <cstdio>
#include <functional>

using arete::Rational;

namespace {

// lambda = mu, nu = 1/2: the symmetric plane of the four-parameter scheme.
arete::Mask symmetric(const Rational& lambda, const Rational& omega) {
  return arete::make_scheme("four-parameter",
                            {{"lambda", {lambda}}, {"mu", {lambda}}, {"omega", {omega}}})
      .mask();
}

struct Found {
  Rational lambda;
  Rational omega;
  double exponent = 0;
};

// The best certified C^1 member of a lattice of 2 reach + 1 points a side, by `better` of
// exponents.
Found search(const Found& from, const Rational& step, int reach, bool lambda_too,
             const std::function<bool(double, double)>& better) {
  std::vector<Rational> lambdas, omegas;
  for (int i = -reach; i <= reach; ++i) {
    if (lambda_too || i == 0) lambdas.push_back(from.lambda + step * i);
    omegas.push_back(from.omega + step * i);
  }
  const auto cells = arete::smoothness_map(lambdas, omegas, symmetric);
  Found best = from;
  for (std::size_t at = 0; at < cells.size(); ++at) {
    const arete::MapCell& cell = cells[at];
    // A certificate of C^1 is a proof; the exponent's bound is one, too.
    if (cell.certified < 1 || !cell.stable) continue;
    if (best.exponent != 0 && !better(cell.hoelder_lower, best.exponent)) continue;
    best = {lambdas[at % lambdas.size()], omegas[at / lambdas.size()], cell.hoelder_lower};
  }
  return best;
}

// The lattice is laid around the best member again and again, each time finer.
Found refined_search(Found best, Rational step, int reach, bool lambda_too,
                     const std::function<bool(double, double)>& better) {
  for (int round = 0; round < 8; ++round) {
    best = search(best, step, round == 0 ? reach : 2, lambda_too, better);
    step /= 2;
  }
  return best;
}

// The largest exponent along b of the ternary scheme whose square interpolates.
std::pair<Rational, double> smoothest_two_step() {
  const auto exponent = [](const Rational& b) {
    return arete::hoelder_bounds(arete::make_scheme("ternary-two-step", {{"b", {b}}}).mask()).lower;
  };
  Rational best = Rational(1) / 10;  // the largest of the printed grid
  double highest = exponent(best);
  for (Rational step = Rational(1) / 20; step > Rational(1) / 10000000; step /= 2)
    for (const Rational& b : {Rational(best - step), Rational(best + step)})
      if (const double found = exponent(b); found > highest) {
        highest = found;
        best = b;
      }
  return {best, highest};
}

}  // namespace

int main() {
  const Found rough = refined_search({Rational(1) / 8, 0, 0}, Rational(1) / 32, 8, true,
                                     [](double a, double b) { return a < b; });
  std::printf(
      "roughest C^1 in the plane lambda = mu, nu = 1/2:\n"
      "    four-parameter:lambda=%s,mu=%s,omega=%s  exponent >= %.6f\n",
      arete::to_string(rough.lambda).c_str(), arete::to_string(rough.lambda).c_str(),
      arete::to_string(rough.omega).c_str(), rough.exponent);

  // lambda = 0 keeps the old samples.
  const Found smooth = refined_search({0, 0, 0}, Rational(1) / 48, 8, false,
                                      [](double a, double b) { return a > b; });
  std::printf("smoothest interpolatory one there:\n    four-point:omega=%s  exponent %.6f\n",
              arete::to_string(smooth.omega).c_str(), smooth.exponent);

  const auto [b, exponent] = smoothest_two_step();
  std::printf(
      "smoothest ternary scheme whose square interpolates:\n"
      "    ternary-two-step:b=%.6f  exponent %.7f\n",
      arete::to_double(b), exponent);
  const bool as_proved = rough.exponent > 1 && rough.exponent < 1.05 &&
                         smooth.omega == Rational(1) / 16 && exponent > 2.33151 &&
                         exponent < 2.33153;
  return as_proved ? 0 : 1;
}
