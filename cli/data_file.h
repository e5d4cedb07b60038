// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

namespace arete::cli {

/// The folder of the data that come with the program: share/arete/data beside the bin/ the running
/// program lies in (built and installed programs alike, wherever they were moved).
[[nodiscard]] std::filesystem::path data_folder();

}  // namespace arete::cli
