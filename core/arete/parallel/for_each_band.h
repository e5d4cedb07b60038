// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>

namespace arete {

/// How many threads this machine runs at a time, at least 1.
[[nodiscard]] int available_threads();

/// Calls work(first, count) for bands of at most `band_rows` >= 1 rows (or columns, or anything
/// numbered) that cover 0..rows-1. With more than one thread (0: as many as the machine has) bands run
/// at the same time, in any order; all have ended when it returns. What a band throws is thrown here.
/// Every thread that core starts is started here.
void for_each_band(std::int64_t rows, std::int64_t band_rows, int threads,
                   const std::function<void(std::int64_t first, std::int64_t count)>& work);

}  // namespace arete
