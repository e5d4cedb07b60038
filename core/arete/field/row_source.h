// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include "arete/field/grid.h"

namespace arete {

/// Where the engine gets its input: any row, in any order (ghost rows of a periodic axis come from
/// the other end), asked for from several threads at once. NaN stands for a missing sample.
template <class T>
class RowSource {
 public:
  virtual ~RowSource() = default;
  [[nodiscard]] virtual Extent extent() const = 0;
  /// Copies row 0 <= r < rows into `out`, which holds cols samples.
  virtual void read(Index r, T* out) const = 0;
};

/// Rows of samples in memory; the view must outlive the source.
template <class T>
class GridSource final : public RowSource<T> {
 public:
  explicit GridSource(GridView<const T> view) : view_(view) {}
  [[nodiscard]] Extent extent() const override { return view_.extent(); }
  void read(Index r, T* out) const override {
    std::copy_n(view_.row(r), static_cast<std::size_t>(view_.cols()), out);
  }

 private:
  GridView<const T> view_;
};

}  // namespace arete
