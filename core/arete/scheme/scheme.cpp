// SPDX-License-Identifier: MIT
#include "arete/scheme/scheme.h"

namespace arete {

std::string Scheme::text() const {
  std::string text = name_;
  char separator = ':';
  for (const ParameterValue& value : parameters_) {
    text += separator + value.name + "=";
    for (std::size_t i = 0; i < value.numbers.size(); ++i)
      text += (i == 0 ? "" : ";") + to_string(value.numbers[i]);
    separator = ',';
  }
  return text;
}

}  // namespace arete
