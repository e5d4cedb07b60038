// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

namespace arete::cli {

/// A file that appears only when it is complete: it is written under a temporary name beside its
/// place and renamed by commit(); without that, whatever was written is removed.
class OutputFile {
 public:
  /// \throws Failure if the place exists and may not be overwritten, is `input` itself, or its
  /// folder cannot be written.
  OutputFile(const std::string& path, const std::string& input, bool overwrite);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  /// Where to write; has the extension of the final name.
  [[nodiscard]] const std::filesystem::path& temporary() const { return temporary_; }
  /// Moves the complete file (and GDAL's side file, if there is one) to its place.
  void commit();

 private:
  std::filesystem::path place_;
  std::filesystem::path temporary_;
};

/// Removes what OutputFiles of this process have not committed. May be called by a signal's
/// handler.
void remove_unfinished_outputs() noexcept;

}  // namespace arete::cli
