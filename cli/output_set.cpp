// SPDX-License-Identifier: MIT
#include "cli/output_set.h"

#include <system_error>

namespace arete::cli {

const std::filesystem::path& OutputSet::add(const std::string& path) {
  files_.push_back(std::make_unique<OutputFile>(path, input_, overwrite_));
  paths_.push_back(path);
  return files_.back()->temporary();
}

void OutputSet::commit() {
  std::size_t done = 0;
  try {
    for (; done < files_.size(); ++done) files_[done]->commit();
  } catch (...) {
    std::error_code ignored;
    for (std::size_t k = 0; k < done; ++k) std::filesystem::remove(paths_[k], ignored);
    throw;
  }
}

}  // namespace arete::cli
