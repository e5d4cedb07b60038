// SPDX-License-Identifier: MIT
#include "arete/field/plane.h"

#include "arete/field/large_pages.h"

namespace arete {
namespace {

constexpr std::size_t huge_page = std::size_t{2} << 20;

}  // namespace

template <class T>
Plane<T>::Plane(Extent extent, Pages pages) : extent_(extent) {
  if (extent.rows < 0 || extent.cols < 0) throw InvalidField("a plane cannot have negative extent");
  constexpr Index line = alignment / static_cast<Index>(sizeof(T));
  stride_ = (extent.cols + line - 1) / line * line;
  const std::size_t bytes =
      static_cast<std::size_t>(extent.rows) * static_cast<std::size_t>(stride_) * sizeof(T);
  if (bytes == 0) return;
  // Small planes would waste most of a huge page.
  const bool huge = pages == Pages::huge && bytes >= 2 * huge_page;
  const std::align_val_t place{huge ? huge_page : static_cast<std::size_t>(alignment)};
  memory_ = {static_cast<T*>(::operator new(bytes, place)), Free{place}};
  if (huge) prefer_large_pages(memory_.get(), bytes);
}

template class Plane<float>;
template class Plane<double>;

}  // namespace arete
