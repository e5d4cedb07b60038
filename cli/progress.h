// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <string>

namespace arete::cli {

/// A bar on the terminal for work that takes longer than a moment; nothing when stderr is not a
/// terminal. Also the place where long work notices Ctrl-C.
class ProgressBar {
 public:
  explicit ProgressBar(std::string what);
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  /// share in 0..1. \throws Interrupted
  void show(double share);

 private:
  std::string what_;
  bool terminal_;
  bool shown_ = false;
  int last_percent_ = -1;
  std::chrono::steady_clock::time_point start_;
};

}  // namespace arete::cli
