// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace arete::vtk {

/// Round values (1, 2 or 5 times a power of ten apart) from low to high, at most `most` + 1.
[[nodiscard]] std::vector<double> ticks(double low, double high, int most);

/// Their texts, with as many decimals as tell neighbours apart.
[[nodiscard]] std::vector<std::string> tick_labels(const std::vector<double>& values);

}  // namespace arete::vtk
