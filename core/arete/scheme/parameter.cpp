// SPDX-License-Identifier: MIT
#include "arete/scheme/parameter.h"

#include <algorithm>

#include "arete/scheme/error.h"

namespace arete {

const Rational& number(const ParameterValues& values, const std::string& name) {
  const auto found =
      std::find_if(values.begin(), values.end(), [&](const auto& v) { return v.name == name; });
  if (found == values.end() || found->numbers.empty())
    throw InvalidScheme("parameter '" + name + "' has no value");
  return found->numbers.front();
}

int integer(const ParameterValues& values, const std::string& name) {
  return static_cast<int>(boost::multiprecision::numerator(number(values, name)));
}

}  // namespace arete
