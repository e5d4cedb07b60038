// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <memory>
#include <new>

#include "arete/field/grid.h"

namespace arete {

/// Memory for pipes one after the other: rows that begin on cache lines and are followed by slack
/// for the kernels. It is zeroed when it is made and always holds numbers afterwards: what lies in
/// the slack is computed with and thrown away, and the denormals of stale memory would cost.
template <class T>
class Workspace {
 public:
  static constexpr std::size_t alignment = 64;

  /// Samples that a row of `count` takes.
  [[nodiscard]] static Index stride(Index count, Index slack) {
    constexpr Index line = alignment / sizeof(T);
    return (count + slack + line - 1) / line * line;
  }

  /// Gives back all rows and makes room for `samples` of the next ones.
  void restart(Index samples) {
    used_ = 0;
    if (samples <= capacity_) return;
    const auto bytes = static_cast<std::size_t>(samples) * sizeof(T);
    memory_.reset(static_cast<T*>(::operator new (bytes, std::align_val_t{alignment})));
    std::fill_n(memory_.get(), samples, T(0));
    capacity_ = samples;
  }
  /// \pre samples is a multiple of a stride and was asked for in restart.
  [[nodiscard]] T* take(Index samples) {
    T* start = memory_.get() + used_;
    used_ += samples;
    return start;
  }

 private:
  struct Free {
    void operator()(T* memory) const { ::operator delete (memory, std::align_val_t{alignment}); }
  };

  std::unique_ptr<T[], Free> memory_;
  Index capacity_ = 0;
  Index used_ = 0;
};

}  // namespace arete
