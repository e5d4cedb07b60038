// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "arete/scheme/catalogue.h"

namespace arete::cli {

/// `omega=0:1/2:101` or, for parameters that move together, `lambda,mu=0:1/4:51`.
struct MapRange {
  std::string name;               ///< as typed: `lambda,mu`
  std::vector<std::string> keys;  ///< none for an axis that does not exist
  std::vector<Rational> values;

  [[nodiscard]] int count() const { return static_cast<int>(values.size()); }
  /// The value at a share 0..1 of the way from the first to the last.
  [[nodiscard]] Rational at(const Rational& share) const {
    return values.front() + (values.back() - values.front()) * share;
  }
};

/// \throws Misuse that names the option
[[nodiscard]] MapRange parse_range(const std::string& text, const char* option);

/// The range of an axis that does not exist: one row, no key.
[[nodiscard]] inline MapRange no_range() { return {"", {}, {Rational(0)}}; }

/// The members of one family over two axes of parameters.
class MapPlane {
 public:
  /// `text` is the family with values for its other parameters. \throws InvalidScheme
  MapPlane(const std::string& text, const MapRange& x, const MapRange& y);

  /// Nothing where there is no scheme.
  [[nodiscard]] std::optional<Scheme> scheme(const Rational& x, const Rational& y) const;

 private:
  std::string family_;
  ParameterValues values_;
  std::vector<std::string> x_;
  std::vector<std::string> y_;
};

}  // namespace arete::cli
