// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

#include "arete/reverse/details_file.h"
#include "arete/reverse/mesh_details_file.h"

namespace arete::cli {

/// Writes a details file, compressed when this program was built with zlib; returns its size in
/// bytes. \throws Failure if it cannot be written.
std::size_t write_details(const std::filesystem::path& path, const DetailsFile& details);
std::size_t write_details(const std::filesystem::path& path, const MeshDetailsFile& details);

/// Reads one. \throws Failure naming the path if it cannot be read, is foreign, damaged, cut off,
/// or of a newer version.
[[nodiscard]] DetailsFile read_details(const std::string& path);
[[nodiscard]] MeshDetailsFile read_mesh_details(const std::string& path);

/// Whether the file begins as the details of a mesh. \throws Failure if it cannot be read.
[[nodiscard]] bool holds_mesh_details(const std::string& path);

}  // namespace arete::cli
