// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "arete/field/grid.h"

namespace arete::cgal::detail {

/// Told the share done; may throw.
using Tell = std::function<void(double)>;

/// Calls work(i) for i = 0..count-1 on `threads` threads (0: all of the machine's), each i once, in
/// any order; `tell` in the calling thread. The first exception of any of them ends the others and
/// comes out.
void for_each_index(Index count, int threads, const Tell& tell,
                    const std::function<void(Index)>& work);

}  // namespace arete::cgal::detail
