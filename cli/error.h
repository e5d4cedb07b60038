// SPDX-License-Identifier: MIT
#pragma once

#include <stdexcept>

namespace arete::cli {

/// The command line itself is wrong: exit code 2.
class Misuse : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The work could not be done: exit code 1.
class Failure : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The user pressed Ctrl-C (or the system asked to end): exit code 130.
class Interrupted : public std::runtime_error {
 public:
  Interrupted() : std::runtime_error("interrupted; nothing was written") {}
};

}  // namespace arete::cli
