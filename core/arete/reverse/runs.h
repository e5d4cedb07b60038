// SPDX-License-Identifier: MIT
#pragma once

#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>

#include "arete/field/boundary.h"

namespace arete {

/// Calls work(first, count) for runs of `width` things that cover 0..count-1, on `threads` threads
/// (0: all there are).
template <class Work>
void for_runs(Index all, Index width, int threads, Work&& work) {
  const Index runs = ceil_divide(all, width);
  const auto run = [&](Index i) {
    const Index first = i * width;
    work(first, std::min(width, all - first));
  };
  if (threads == 1) {
    for (Index i = 0; i < runs; ++i) run(i);
    return;
  }
  tbb::task_arena arena(threads > 0 ? threads : tbb::info::default_concurrency());
  arena.execute([&] { tbb::parallel_for(Index{0}, runs, run); });
}

}  // namespace arete
