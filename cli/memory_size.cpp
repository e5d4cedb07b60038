// SPDX-License-Identifier: MIT
#include "cli/memory_size.h"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iomanip>
#include <sstream>

#include "cli/error.h"

namespace arete::cli {

double parse_memory_size(const std::string& text) {
  char* end = nullptr;
  const double number = std::strtod(text.c_str(), &end);
  std::string unit(end);
  if (unit.size() > 1 && unit.back() == 'B') unit.pop_back();
  const bool binary = unit.size() == 2 && unit.back() == 'i';
  if (binary) unit.pop_back();
  const double step = binary ? 1024 : 1000;
  double scale = 0;
  if (unit.empty() || unit == "B") scale = 1;
  if (unit == "K" || unit == "k") scale = step;
  if (unit == "M") scale = step * step;
  if (unit == "G") scale = step * step * step;
  if (unit == "T") scale = step * step * step * step;
  if (end == text.c_str() || scale == 0 || !std::isfinite(number) || number <= 0)
    throw Misuse("--max-memory '" + text + "' is not a size; write e.g. 800M or 2G");
  return number * scale;
}

double default_memory() {
  return 0.5 * static_cast<double>(sysconf(_SC_PHYS_PAGES)) *
         static_cast<double>(sysconf(_SC_PAGE_SIZE));
}

namespace {

// Sizes that are asked for may lie beyond every integer.
std::string whole_text(double number) {
  std::ostringstream text;
  text << std::fixed << std::setprecision(0) << number;
  return text.str();
}

}  // namespace

std::string memory_text(double bytes) { return whole_text(std::ceil(bytes / 1e6)) + " MB"; }

std::string room_text(double bytes) {
  if (bytes < 1e3) return whole_text(std::floor(bytes)) + " B";
  if (bytes < 1e6) return whole_text(std::floor(bytes / 1e3)) + " kB";
  return whole_text(std::floor(bytes / 1e6)) + " MB";
}

void check_memory(const std::string& what, double needed, double allowed) {
  if (needed > allowed)
    throw Failure(what + " needs " + memory_text(needed) + " of memory, more than the " +
                  room_text(allowed) +
                  " allowed; use fewer levels, raise --max-memory, or write a GeoTIFF, which takes "
                  "little memory at any height");
}

}  // namespace arete::cli
