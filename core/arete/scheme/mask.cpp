// SPDX-License-Identifier: MIT
#include "arete/scheme/mask.h"

#include <utility>

namespace arete {

Mask::Mask(int arity, int first, std::vector<Rational> coefficients)
    : Mask(arity, LaurentPolynomial<Rational>(first, std::move(coefficients))) {}

Mask::Mask(int arity, LaurentPolynomial<Rational> symbol)
    : arity_(arity), symbol_(std::move(symbol)) {
  if (arity < 2 || arity > largest_arity)
    throw InvalidScheme("arity " + std::to_string(arity) + " is outside 2.." +
                        std::to_string(largest_arity));
  if (symbol_.is_zero()) throw InvalidScheme("a mask needs at least one non-zero coefficient");
  if (symbol_.coefficients().size() > largest_size)
    throw InvalidScheme("a mask may have at most " + std::to_string(largest_size) +
                        " coefficients, this one has " +
                        std::to_string(symbol_.coefficients().size()));
  // Phase r is read by every new sample k = r (mod m).
  std::vector<Rational> sums(static_cast<std::size_t>(arity), Rational(0));
  for (int k = symbol_.lowest(); k <= symbol_.highest(); ++k)
    sums[static_cast<std::size_t>(((k % arity) + arity) % arity)] += symbol_[k];
  bool affine = true;
  std::string listed;
  for (const Rational& sum : sums) {
    affine = affine && sum == 1;
    listed += (listed.empty() ? "" : ", ") + to_string(sum);
  }
  if (!affine)
    throw InvalidScheme("the phases of the mask sum to " + listed +
                        "; each must sum to 1, or constant terrain would not stay constant");
}

Rational Mask::tau() const { return symbol_.derivative().sum() / arity_; }

Mask iterated(const Mask& mask, int steps) {
  LaurentPolynomial<Rational> symbol(1);
  int arity = 1;
  for (int step = 0; step < steps; ++step) {
    symbol = symbol * mask.symbol().dilated(arity);
    arity *= mask.arity();
  }
  return {arity, symbol};
}

std::string coefficients_text(const Mask& mask) {
  std::string text = "[";
  for (const Rational& c : mask.coefficients())
    text += (text.size() > 1 ? ", " : "") + to_string(c);
  return text + "]";
}

}  // namespace arete
