// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <fstream>
#include <vector>

namespace arete::cli {

/// Points written one by one, so that any number of them takes no memory; the same text as
/// write_points.
class PointStream {
 public:
  PointStream(const std::filesystem::path& path, const std::vector<std::string>& header);
  void write(const std::vector<double>& point);
  /// \throws Failure if not all of it could be written.
  void close();

 private:
  std::filesystem::path path_;
  std::ofstream stream_;
};

}  // namespace arete::cli
