// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <mutex>

#include "arete/field/row_source.h"
#include "arete/gdal/raster.h"

namespace arete::gdal {

/// The rows of one band, read through GDAL's block cache as they are asked for. Samples that GDAL
/// calls invalid (nodata, mask, alpha) come as NaN. Serialises access to the dataset; two sources
/// of one Raster must not be used at the same time. The raster must outlive it.
template <class T>
class BandSource final : public RowSource<T> {
 public:
  BandSource(const Raster& raster, const BandInfo& band) : raster_(raster), band_(band) {}
  [[nodiscard]] Extent extent() const override { return raster_.extent(); }
  /// \throws RasterError if GDAL cannot read the row (file damaged or cut off).
  void read(Index r, T* out) const override;

 private:
  void read_row(int row, T* out) const;

  const Raster& raster_;
  const BandInfo& band_;
  mutable std::mutex mutex_;
  mutable int known_rows_ = 0;  ///< where rows follow each other: those that were read once
  mutable std::vector<std::uint8_t> mask_;
};

/// A whole band in memory.
template <class T>
[[nodiscard]] Grid<T> read_band(const Raster& raster, const BandInfo& band);

}  // namespace arete::gdal
