// SPDX-License-Identifier: MIT
#include "arete/refine/for_each_band.h"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>

#include "arete/refine/refiner.h"

namespace arete {

void for_each_band(Index rows, Index band_rows, int threads,
                   const std::function<void(Index, Index)>& work) {
  const auto band = [&](Index first) { work(first, std::min(band_rows, rows - first)); };
  if (threads == 1 || rows <= band_rows) {
    for (Index first = 0; first < rows; first += band_rows) band(first);
    return;
  }
  const int available = available_threads();
  tbb::task_arena arena(std::min(threads > 0 ? threads : available, available));
  arena.execute([&] {
    tbb::parallel_for(Index{0}, (rows + band_rows - 1) / band_rows,
                      [&](Index i) { band(i * band_rows); });
  });
}

}  // namespace arete
