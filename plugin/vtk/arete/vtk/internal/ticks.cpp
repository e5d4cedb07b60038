// SPDX-License-Identifier: MIT
#include "arete/vtk/internal/ticks.h"

#include <algorithm>
#include <cmath>
#include <locale>
#include <sstream>

namespace arete::vtk {
namespace {

/// With as many decimals as tell neighbours apart; a step of 0 means there are none.
std::string label(double value, double step) {
  std::ostringstream text;
  text.imbue(std::locale::classic());
  const double decimals = step > 0 ? std::max(0.0, -std::floor(std::log10(step) + 1e-9)) : 0;
  if (step == 0 || decimals > 4 || std::abs(value) >= 1e7) {
    text.precision(5);
  } else {
    text.setf(std::ios::fixed);
    text.precision(static_cast<int>(decimals));
  }
  text << (std::abs(value) < step * 1e-6 ? 0.0 : value);
  return text.str();
}

}  // namespace

std::vector<double> ticks(double low, double high, int most) {
  const double raw = (high - low) / most;
  const double power = std::pow(10, std::floor(std::log10(raw)));
  double step = 10 * power;
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= raw * (1 - 1e-9)) {
      step = factor * power;
      break;
    }
  }
  std::vector<double> values;
  for (double k = std::ceil(low / step - 1e-9); k * step <= high + step * 1e-9; ++k) {
    values.push_back(k * step);
  }
  return values;
}

std::vector<std::string> tick_labels(const std::vector<double>& values) {
  const double step = values.size() > 1 ? values[1] - values[0] : 0;
  std::vector<std::string> texts;
  for (const double value : values) texts.push_back(label(value, step));
  return texts;
}

}  // namespace arete::vtk
