// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

namespace arete {

/// Asked often during long work, from the thread that works; true: stop, and give what has been
/// proved so far (everything else stays "undecided"). Empty: never stop. The time limits and Ctrl-C
/// of a program go through it.
using Stop = std::function<bool()>;

[[nodiscard]] inline bool must_stop(const Stop& stop) { return stop && stop(); }

}  // namespace arete
