// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <future>
#include <system_error>

#include "arete/field/plane.h"
#include "arete/gdal/geotiff.h"

namespace arete::gdal {

/// Two buffers of rows for one writer: while one is written in a thread of its own, the next is
/// filled. `overlap` false writes in the caller's thread.
template <class T>
class WriteBehind {
 public:
  WriteBehind(GeoTiffWriter& writer, Extent buffer, bool overlap)
      : writer_(writer),
        overlap_(overlap),
        buffers_{Plane<T>(buffer), Plane<T>(buffer_of(buffer, overlap))} {}
  ~WriteBehind() {
    if (pending_.valid()) pending_.wait();
  }
  WriteBehind(const WriteBehind&) = delete;
  WriteBehind& operator=(const WriteBehind&) = delete;

  /// `rows` rows to fill, not in use.
  [[nodiscard]] GridView<T> buffer(Index rows) {
    const GridView<T> whole = buffers_[current_].view();
    return {whole.row(0), {rows, whole.cols()}, whole.stride()};
  }

  /// Writes what buffer() gave, once what was given before is written.
  /// \throws RasterError of this or the earlier writing.
  void write(int band, Index first_row, GridView<T> rows) {
    finish();
    if (!overlap_) {
      writer_.write<T>(band, first_row, rows);
      return;
    }
    try {
      pending_ = std::async(std::launch::async, [this, band, first_row, rows] {
        writer_.write<T>(band, first_row, rows);
      });
      current_ = 1 - current_;
    } catch (const std::system_error&) {  // no more threads
      overlap_ = false;
      writer_.write<T>(band, first_row, rows);
    }
  }

  /// Waits until all is written. \throws RasterError
  void finish() {
    if (pending_.valid()) pending_.get();
  }

 private:
  static Extent buffer_of(Extent buffer, bool overlap) { return overlap ? buffer : Extent{0, 0}; }

  GeoTiffWriter& writer_;
  bool overlap_;
  std::array<Plane<T>, 2> buffers_;
  std::size_t current_ = 0;
  std::future<void> pending_;
};

}  // namespace arete::gdal
