// SPDX-License-Identifier: MIT
#include "cli/point_stream.h"

#include <charconv>

#include "cli/error.h"

namespace arete::cli {

PointStream::PointStream(const std::filesystem::path& path, const std::vector<std::string>& header)
    : path_(path), stream_(path, std::ios::binary) {
  for (std::size_t c = 0; c < header.size(); ++c) stream_ << (c == 0 ? "" : ",") << header[c];
  if (!header.empty()) stream_ << '\n';
}

void PointStream::write(const std::vector<double>& point) {
  char text[64];
  for (std::size_t c = 0; c < point.size(); ++c) {
    if (c != 0) stream_ << ',';
    stream_.write(text, std::to_chars(text, text + sizeof text, point[c]).ptr - text);
  }
  stream_ << '\n';
}

void PointStream::close() {
  stream_.close();
  if (!stream_) throw Failure(path_.string() + " cannot be written; check free space");
}

}  // namespace arete::cli
