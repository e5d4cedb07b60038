// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "arete/algebra/rational.h"

namespace arete {

enum class ParameterKind { real, integer, list };

/// A closed interval of rationals.
struct ParameterRange {
  Rational lowest;
  Rational highest;
};

/// One knob of a scheme family: what the command line, the dialogs, the documentation and the law
/// tests all read.
struct Parameter {
  std::string name;    ///< the key in the text form, e.g. `omega`
  std::string symbol;  ///< as printed in the literature, e.g. `w`
  ParameterKind kind = ParameterKind::real;
  ParameterRange accepted;           ///< values outside are refused
  ParameterRange usual;              ///< where a slider should move
  std::optional<Rational> fallback;  ///< the default; none: the caller must give a value
  std::string meaning;               ///< one line
  int step = 1;                      ///< integers only: lowest, lowest + step, ...
  /// The key stands for name0, name1, ... (any number of them, without gaps).
  bool repeats = false;
};

/// A chosen value; `numbers` holds one number unless the parameter is a list.
struct ParameterValue {
  std::string name;
  std::vector<Rational> numbers;

  [[nodiscard]] friend bool operator==(const ParameterValue&, const ParameterValue&) = default;
};

using ParameterValues = std::vector<ParameterValue>;

/// The single number chosen for `name`. \pre the value is there (the catalogue fills all in).
[[nodiscard]] const Rational& number(const ParameterValues& values, const std::string& name);
/// The same for an integer parameter that is known to fit an int.
[[nodiscard]] int integer(const ParameterValues& values, const std::string& name);

}  // namespace arete
