// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <new>

#include "arete/field/grid.h"

namespace arete {

/// How the memory of a plane is had from the system. Huge pages (2 MiB, where the system offers
/// them; Linux: /sys/kernel/mm/transparent_hugepage/enabled = madvise or always) make the first
/// touch of a large plane two to three times as fast.
enum class Pages { huge, ordinary };

/// Owned samples for results: not initialised, and each row begins on a cache line, so rows are
/// `stride()` >= cols apart. The engine fills such memory fastest.
template <class T>
class Plane {
 public:
  /// Cache lines, and the largest vectors.
  static constexpr Index alignment = 64;

  Plane() = default;
  /// \throws InvalidField for a negative extent, std::bad_alloc.
  explicit Plane(Extent extent, Pages pages = Pages::huge);

  [[nodiscard]] Extent extent() const { return extent_; }
  [[nodiscard]] Index rows() const { return extent_.rows; }
  [[nodiscard]] Index cols() const { return extent_.cols; }
  [[nodiscard]] Index stride() const { return stride_; }
  [[nodiscard]] T* row(Index r) const { return memory_.get() + r * stride_; }
  [[nodiscard]] GridView<T> view() { return {memory_.get(), extent_, stride_}; }
  [[nodiscard]] GridView<const T> view() const { return {memory_.get(), extent_, stride_}; }

 private:
  struct Free {
    std::align_val_t alignment{};
    void operator()(T* memory) const { ::operator delete(memory, alignment); }
  };

  Extent extent_;
  Index stride_ = 0;
  std::unique_ptr<T[], Free> memory_;
};

}  // namespace arete
