// SPDX-License-Identifier: MIT
#include "arete/parallel/for_each_band.h"

#include <gtest/gtest.h>

#include <mutex>
#include <stdexcept>
#include <vector>

namespace arete {
namespace {

TEST(for_each_band, covers_every_row_once_with_any_number_of_threads) {
  for (const int threads : {1, 2, 0}) {
    for (const std::int64_t rows : {0, 1, 7, 8, 9, 100}) {
      std::vector<int> seen(static_cast<std::size_t>(rows), 0);
      std::mutex mutex;
      for_each_band(rows, 8, threads, [&](std::int64_t first, std::int64_t count) {
        const std::lock_guard lock(mutex);
        EXPECT_LE(count, 8);
        for (std::int64_t r = first; r < first + count; ++r) ++seen.at(static_cast<std::size_t>(r));
      });
      EXPECT_EQ(seen, std::vector<int>(static_cast<std::size_t>(rows), 1)) << threads;
    }
  }
}

// ThreadSanitizer sees here whether it is told of every handover (scripts/check-sanitizers).
TEST(for_each_band, what_threads_wrote_is_there_when_it_returns_and_at_the_next_call) {
  std::vector<int> values(1000, 0);
  for (int round = 0; round < 50; ++round) {
    for_each_band(1000, 10, 0, [&](std::int64_t first, std::int64_t count) {
      // Another band's values of the round before.
      for (std::int64_t i = first; i < first + count; ++i)
        values[static_cast<std::size_t>(999 - i)] += 1;
    });
    for (int& value : values) value += 1;
  }
  EXPECT_EQ(values, std::vector<int>(1000, 100));
}

TEST(for_each_band, throws_what_a_band_throws_with_any_number_of_threads) {
  for (const int threads : {1, 2, 0}) {
    EXPECT_THROW(for_each_band(100, 8, threads,
                               [](std::int64_t first, std::int64_t) {
                                 if (first == 48) throw std::runtime_error("a band failed");
                               }),
                 std::runtime_error)
        << threads;
  }
}

}  // namespace
}  // namespace arete
