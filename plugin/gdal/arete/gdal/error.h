// SPDX-License-Identifier: MIT
#pragma once

#include <stdexcept>
#include <string>

namespace arete::gdal {

/// A raster that cannot be read or written; the message names the file, the place and the remedy.
class RasterError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// While it lives, GDAL prints nothing in this thread and its first failure is kept here.
class ErrorCollector {
 public:
  ErrorCollector();
  ~ErrorCollector();
  ErrorCollector(const ErrorCollector&) = delete;
  ErrorCollector& operator=(const ErrorCollector&) = delete;

  [[nodiscard]] bool failed() const { return failed_; }
  /// The text of the first failure; empty if there was none.
  [[nodiscard]] const std::string& message() const { return message_; }
  void record(std::string message);

 private:
  bool failed_ = false;
  std::string message_;
};

}  // namespace arete::gdal
