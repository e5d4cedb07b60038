// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "cli/output_file.h"

namespace arete::cli {

/// Several files that appear together when all are complete, or not at all.
class OutputSet {
 public:
  OutputSet(std::string input, bool overwrite) : input_(std::move(input)), overwrite_(overwrite) {}

  /// Where to write the next file, whose place is `path`. \throws as OutputFile does.
  const std::filesystem::path& add(const std::string& path);
  /// Moves all to their places; if one of them cannot be, those moved before are removed.
  /// \throws Failure
  void commit();

 private:
  std::string input_;
  bool overwrite_;
  std::vector<std::string> paths_;
  std::vector<std::unique_ptr<OutputFile>> files_;
};

}  // namespace arete::cli
