// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "cli/error.h"
#include "cli/text_cells.h"

namespace arete::cli {

/// Between `fewest` and `most` finite numbers of an option, e.g. `200x160` or `0,0,100,80`.
/// \throws Misuse with the usage.
[[nodiscard]] inline std::vector<double> parse_numbers(const std::string& text, char separator,
                                                       std::size_t fewest, std::size_t most,
                                                       const std::string& usage) {
  std::vector<double> numbers;
  for (const std::string& cell : cells_of(text, std::string(1, separator))) {
    const auto number = number_in(cell);
    if (!number || !std::isfinite(*number)) throw Misuse(usage + " (got '" + text + "')");
    numbers.push_back(*number);
  }
  if (numbers.size() < fewest || numbers.size() > most)
    throw Misuse(usage + " (got '" + text + "')");
  return numbers;
}

}  // namespace arete::cli
