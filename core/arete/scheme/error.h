// SPDX-License-Identifier: MIT
#pragma once

#include <stdexcept>
#include <string>

namespace arete {

/// A scheme, a mask or a parameter that cannot be used; the message says what, where and what to
/// do instead.
class InvalidScheme : public std::invalid_argument {
 public:
  using std::invalid_argument::invalid_argument;
};

}  // namespace arete
