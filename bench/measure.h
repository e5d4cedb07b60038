// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <chrono>
#include <ctime>
#include <functional>
#include <vector>

#include "arete/field/grid.h"

namespace arete::bench {

/// Processor time of this process, all threads, page faults included: neighbours do not count.
inline double cpu_seconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

inline double wall_seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

inline double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

using Clock = double (*)();

/// Medians of the times of some works done in turn, so that what disturbs one disturbs all.
inline std::vector<double> interleaved(int repetitions, Clock clock,
                                       const std::vector<std::function<void()>>& works) {
  std::vector<std::vector<double>> times(works.size());
  for (int i = -1; i < repetitions; ++i) {
    for (std::size_t w = 0; w < works.size(); ++w) {
      const double start = clock();
      works[w]();
      if (i >= 0) times[w].push_back(clock() - start);  // the first round only warms up
    }
  }
  std::vector<double> medians;
  for (auto& of_work : times) medians.push_back(median(std::move(of_work)));
  return medians;
}

/// Fills memory past the cache: the write limit of the machine. `samples` aligned to 64 bytes.
void fill_past_cache(float* samples, Index count);

/// Hills with full mantissas, as rough as terrain.
Grid<float> terrain(Extent extent);

}  // namespace arete::bench
