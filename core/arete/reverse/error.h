// SPDX-License-Identifier: MIT
#pragma once

#include <stdexcept>
#include <string>

namespace arete {

/// Bytes that are not a details file this program can use (foreign, damaged, cut off, newer); the
/// message says which, where, and what to do instead.
class InvalidDetails : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace arete
