// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace arete::details {

// Fixed numbers of the details file, shared by its writer and its reader (details_file.h).
constexpr std::array<std::uint8_t, 8> magic{0x89, 'A', 'R', 'D', 0x0D, 0x0A, 0x1A, 0x0A};
constexpr std::uint32_t version = 1;
constexpr std::ptrdiff_t length_place = 16;  // behind magic, version and header length
constexpr std::size_t prologue = 24;
constexpr std::uint8_t stored = 0;
constexpr std::uint8_t packed = 1;

}  // namespace arete::details
