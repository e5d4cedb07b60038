// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

#include "arete/reverse/details_file.h"

namespace arete::cli {

/// Writes a details file, compressed when this program was built with zlib; returns its size in
/// bytes. \throws Failure if it cannot be written.
std::size_t write_details(const std::filesystem::path& path, const DetailsFile& details);

/// Reads one. \throws Failure naming the path if it cannot be read, is foreign, damaged, cut off,
/// or of a newer version.
[[nodiscard]] DetailsFile read_details(const std::string& path);

}  // namespace arete::cli
