// SPDX-License-Identifier: GPL-3.0-or-later
#include "arete/meshlab/memory.h"

#include <cstdlib>
#include <fstream>
#include <string>

#include "arete/field/error.h"

namespace arete::meshlab {
namespace {

// What the system says it could give without swapping; 0 where it does not say.
double available_memory() {
  std::ifstream meminfo("/proc/meminfo");
  std::string line;
  while (std::getline(meminfo, line))
    if (line.rfind("MemAvailable:", 0) == 0) return std::strtod(line.c_str() + 13, nullptr) * 1024;
  return 0;
}

std::string gigabytes(double bytes) {
  return std::to_string(static_cast<long long>(bytes / 1e9 + 0.5)) + " GB";
}

}  // namespace

void check_memory(double bytes, double new_vertices) {
  const double there = available_memory();
  const std::string count = std::to_string(static_cast<long long>(new_vertices));
  if (new_vertices > 5e8)
    throw InvalidField("the result would have " + count +
                       " vertices, more than MeshLab can hold; use fewer levels");
  if (there > 0 && bytes > 0.8 * there)
    throw InvalidField("the result would have " + count + " vertices and take about " +
                       gigabytes(bytes) + " of memory; " + gigabytes(there) +
                       " are free; use fewer levels");
}

}  // namespace arete::meshlab
