// SPDX-License-Identifier: MIT
#include "cli/data_file.h"

#include <system_error>

namespace arete::cli {

std::filesystem::path data_folder() {
  std::error_code unknown;
  const auto program = std::filesystem::read_symlink("/proc/self/exe", unknown);
  return program.parent_path().parent_path() / "share" / "arete" / "data";
}

}  // namespace arete::cli
