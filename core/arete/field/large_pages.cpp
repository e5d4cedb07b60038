// SPDX-License-Identifier: MIT
#include "arete/field/large_pages.h"

#include <cstdint>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace arete {

#ifdef __linux__
namespace {

constexpr std::uintptr_t large_page = std::uintptr_t{2} << 20;
// Smaller blocks would waste most of a page, or gain nothing.
constexpr std::size_t least_bytes = 2 * large_page;

}  // namespace

void prefer_large_pages(void* data, std::size_t bytes) noexcept {
  if (bytes < least_bytes) return;
  const auto begin = reinterpret_cast<std::uintptr_t>(data);
  const std::uintptr_t first = (begin + large_page - 1) & ~(large_page - 1);
  const std::uintptr_t last = (begin + bytes) & ~(large_page - 1);
  // Whole pages within the block alone: its neighbours are not ours.
  (void)madvise(static_cast<char*>(data) + (first - begin), last - first, MADV_HUGEPAGE);
}
#else
void prefer_large_pages(void*, std::size_t) noexcept {}
#endif

}  // namespace arete
