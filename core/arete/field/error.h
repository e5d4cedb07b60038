// SPDX-License-Identifier: MIT
#pragma once

#include <stdexcept>
#include <string>

namespace arete {

/// Samples that cannot be used as asked (sizes, boundaries, levels); the message says what, where
/// and what to do instead.
class InvalidField : public std::invalid_argument {
 public:
  using std::invalid_argument::invalid_argument;
};

}  // namespace arete
