// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

#include "arete/field/grid.h"

namespace arete {

/// Calls work(first, count) for bands of at most `band_rows` rows that cover `rows` rows. With more
/// than one thread (0: as many as the machine has) bands run at the same time, in any order.
void for_each_band(Index rows, Index band_rows, int threads,
                   const std::function<void(Index first, Index count)>& work);

}  // namespace arete
