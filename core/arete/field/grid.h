// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "arete/field/error.h"
#include "arete/field/large_pages.h"

namespace arete {

/// Signed, so that ghost samples may have negative indices; 64 bits, so that no raster overflows.
using Index = std::int64_t;

/// How many rows and columns of samples.
struct Extent {
  Index rows = 0;
  Index cols = 0;

  [[nodiscard]] friend bool operator==(const Extent&, const Extent&) = default;
};

/// Borrowed samples in row-major order; consecutive rows start `stride` samples apart.
/// Row 0 is whatever the caller says it is (for rasters: the northern edge).
template <class T>
class GridView {
 public:
  GridView(T* data, Extent extent, Index stride) : data_(data), extent_(extent), stride_(stride) {}
  GridView(T* data, Extent extent) : GridView(data, extent, extent.cols) {}
  /// A view to change is also a view to read.
  operator GridView<const T>() const { return {data_, extent_, stride_}; }  // NOLINT

  [[nodiscard]] Extent extent() const { return extent_; }
  [[nodiscard]] Index rows() const { return extent_.rows; }
  [[nodiscard]] Index cols() const { return extent_.cols; }
  [[nodiscard]] Index stride() const { return stride_; }
  [[nodiscard]] T* row(Index r) const { return data_ + r * stride_; }
  [[nodiscard]] T& operator()(Index r, Index c) const { return data_[r * stride_ + c]; }

 private:
  T* data_;
  Extent extent_;
  Index stride_;
};

/// Owned samples in row-major order without gaps. T is float or double in the engine; a missing
/// sample is a NaN (see validity.h), never a number with a meaning of its own.
template <class T>
class Grid {
 public:
  Grid() = default;
  /// \throws InvalidField for a negative extent.
  explicit Grid(Extent extent, T value = T(0)) : extent_(extent) {
    const std::size_t count = size(extent);
    samples_.reserve(count);
    prefer_large_pages(samples_.data(), count * sizeof(T));
    samples_.resize(count, value);
  }

  [[nodiscard]] Extent extent() const { return extent_; }
  [[nodiscard]] Index rows() const { return extent_.rows; }
  [[nodiscard]] Index cols() const { return extent_.cols; }
  [[nodiscard]] T* row(Index r) { return samples_.data() + r * extent_.cols; }
  [[nodiscard]] const T* row(Index r) const { return samples_.data() + r * extent_.cols; }
  [[nodiscard]] T& operator()(Index r, Index c) { return row(r)[c]; }
  [[nodiscard]] const T& operator()(Index r, Index c) const { return row(r)[c]; }
  [[nodiscard]] const std::vector<T>& samples() const { return samples_; }
  [[nodiscard]] std::vector<T>& samples() { return samples_; }
  [[nodiscard]] GridView<T> view() { return {samples_.data(), extent_}; }
  [[nodiscard]] GridView<const T> view() const { return {samples_.data(), extent_}; }

 private:
  static std::size_t size(Extent extent) {
    if (extent.rows < 0 || extent.cols < 0)
      throw InvalidField("a grid cannot have negative extent");
    return static_cast<std::size_t>(extent.rows) * static_cast<std::size_t>(extent.cols);
  }

  Extent extent_;
  std::vector<T> samples_;
};

}  // namespace arete
