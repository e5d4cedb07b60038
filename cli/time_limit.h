// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

#include "arete/analysis/stop.h"

namespace arete::cli {

/// A limit on the time of one long computation. The computation is asked to stop at the limit and
/// then says what it has proved; where it cannot listen (one huge exact operation), the program is
/// ended with exit code 1 and a message at twice the limit plus five seconds. Nothing may be half
/// written while one is alive.
class TimeLimit {
 public:
  /// seconds <= 0: no limit. `what` names the work in the message.
  TimeLimit(double seconds, std::string what);
  ~TimeLimit();
  TimeLimit(const TimeLimit&) = delete;
  TimeLimit& operator=(const TimeLimit&) = delete;

  /// Also true once the user has pressed Ctrl-C (then call stop_if_interrupted).
  [[nodiscard]] Stop stop() const;
  /// Whether the limit has passed.
  [[nodiscard]] bool passed() const;

 private:
  void guard(double seconds, const std::string& what);

  bool limited_;
  std::chrono::steady_clock::time_point end_;
  std::mutex mutex_;
  std::condition_variable finished_;
  bool done_ = false;
  std::thread guard_;
};

}  // namespace arete::cli
