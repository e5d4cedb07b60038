// SPDX-License-Identifier: MIT
#include "cli/disk_space.h"

#include <algorithm>
#include <filesystem>

#include "cli/error.h"
#include "cli/memory_size.h"

namespace arete::cli {

void check_disk(const std::string& path, const std::vector<std::string>& creation_options,
                double bytes) {
  const bool plain =
      std::any_of(creation_options.begin(), creation_options.end(),
                  [](const std::string& option) { return option == "COMPRESS=NONE"; });
  constexpr double best_ratio = 50;
  const double needed = plain ? bytes : bytes / best_ratio;
  const auto folder = std::filesystem::absolute(path).parent_path();
  std::error_code unknown;
  const auto space = std::filesystem::space(folder, unknown);
  if (unknown || needed <= static_cast<double>(space.available)) return;
  throw Failure(path + " would take " + (plain ? "" : "at least ") + memory_text(needed) +
                " but only " + room_text(static_cast<double>(space.available)) +
                " are free; use fewer levels or another disk");
}

}  // namespace arete::cli
