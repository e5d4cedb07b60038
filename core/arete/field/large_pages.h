// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

namespace arete {

/// Asks the system to back memory that nobody has touched yet with pages of 2 MiB (Linux, where
/// /sys/kernel/mm/transparent_hugepage/enabled is madvise or always): the first touch of a large
/// result in pages of 4 KiB can take ten times as long as computing it. Only advice: it changes no
/// content, never fails, and does nothing below 4 MiB.
void prefer_large_pages(void* data, std::size_t bytes) noexcept;

}  // namespace arete
