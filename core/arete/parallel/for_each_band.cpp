// SPDX-License-Identifier: MIT
#include "arete/parallel/for_each_band.h"

#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>

#include "arete/parallel/fork.h"

namespace arete {

int available_threads() { return tbb::info::default_concurrency(); }

void for_each_band(std::int64_t rows, std::int64_t band_rows, int threads,
                   const std::function<void(std::int64_t, std::int64_t)>& work) {
  const auto band = [&](std::int64_t first) { work(first, std::min(band_rows, rows - first)); };
  if (threads == 1 || rows <= band_rows) {
    for (std::int64_t first = 0; first < rows; first += band_rows) band(first);
    return;
  }
  // More threads than the machine has would only make oneTBB complain.
  const int available = available_threads();
  tbb::task_arena arena(std::min(threads > 0 ? threads : available, available));
  Fork fork;
  arena.execute([&] {
    tbb::parallel_for(std::int64_t{0}, (rows + band_rows - 1) / band_rows, [&](std::int64_t i) {
      const Fork::Branch branch(fork);
      band(i * band_rows);
    });
  });
}

}  // namespace arete
