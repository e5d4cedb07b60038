// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "arete/field/grid.h"

namespace arete {

/// An index of the grid as one of a standard container.
constexpr std::size_t at(Index index) { return static_cast<std::size_t>(index); }

}  // namespace arete
