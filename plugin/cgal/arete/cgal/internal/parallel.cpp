// SPDX-License-Identifier: GPL-3.0-or-later
#include "arete/cgal/internal/parallel.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace arete::cgal::detail {

void for_each_index(Index count, int threads, const Tell& tell,
                    const std::function<void(Index)>& work) {
  std::atomic<Index> next{0};
  std::mutex mutex;
  std::exception_ptr failure;
  const auto run = [&](bool telling) {
    try {
      for (Index i = next++; i < count; i = next++) {
        work(i);
        if (telling && tell) tell(static_cast<double>(i + 1) / static_cast<double>(count));
      }
    } catch (...) {
      next = count;
      const std::lock_guard<std::mutex> lock(mutex);
      if (!failure) failure = std::current_exception();
    }
  };
  const Index wanted = threads > 0 ? threads : std::max(1u, std::thread::hardware_concurrency());
  {
    std::vector<std::jthread> helpers;
    for (Index i = 1; i < std::min(wanted, count); ++i) helpers.emplace_back(run, false);
    run(true);
  }
  if (failure) std::rethrow_exception(failure);
}

}  // namespace arete::cgal::detail
