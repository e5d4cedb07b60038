// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

namespace arete::meshlab {

/// Told how far the work is, 0..100; false asks to stop.
using Progress = std::function<bool(int percent, const char* what)>;

/// The host asked to stop. The mesh has not been touched.
class Cancelled : public std::runtime_error {
 public:
  Cancelled() : std::runtime_error("stopped on request; the mesh is as it was") {}
};

/// What an action has to say while it works: progress, and one fact a line for the log.
class Report {
 public:
  explicit Report(Progress progress = {}) : progress_(std::move(progress)) {}

  /// \throws Cancelled
  void progress(int percent, const char* what) const {
    if (progress_ && !progress_(percent, what)) throw Cancelled();
  }
  void log(std::string line) { lines_.push_back(std::move(line)); }
  [[nodiscard]] const std::vector<std::string>& lines() const { return lines_; }

 private:
  Progress progress_;
  std::vector<std::string> lines_;
};

}  // namespace arete::meshlab
