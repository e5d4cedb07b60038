// SPDX-License-Identifier: MIT
#include "arete/gdal/band_source.h"

#include <gdal_priv.h>

#include <limits>
#include <type_traits>

namespace arete::gdal {

template <class T>
void BandSource<T>::read(Index r, T* out) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  const int row = static_cast<int>(r);
  if (raster_.rows_follow_each_other())
    for (; known_rows_ < row; ++known_rows_) read_row(known_rows_, out);
  read_row(row, out);
}

template <class T>
void BandSource<T>::read_row(int row, T* out) const {
  constexpr GDALDataType type = std::is_same_v<T, float> ? GDT_Float32 : GDT_Float64;
  const ErrorCollector errors;
  GDALRasterBand* band = raster_.dataset().GetRasterBand(band_.number);
  const int cols = static_cast<int>(raster_.extent().cols);
  CPLErr status = band->RasterIO(GF_Read, 0, row, cols, 1, out, cols, 1, type, 0, 0, nullptr);
  if (status == CE_None && (band_.masked || band_.alpha_band != 0)) {
    mask_.resize(static_cast<std::size_t>(cols));
    GDALRasterBand* mask =
        band_.masked ? band->GetMaskBand() : raster_.dataset().GetRasterBand(band_.alpha_band);
    status =
        mask->RasterIO(GF_Read, 0, row, cols, 1, mask_.data(), cols, 1, GDT_Byte, 0, 0, nullptr);
    for (int c = 0; c < cols; ++c)
      if (mask_[static_cast<std::size_t>(c)] == 0) out[c] = std::numeric_limits<T>::quiet_NaN();
  }
  if (status != CE_None)
    throw RasterError(raster_.path() + ", band " + std::to_string(band_.number) + ", row " +
                      std::to_string(row) + " cannot be read (GDAL: " + errors.message() +
                      "); the file may be damaged or cut off");
}

template <class T>
Grid<T> read_band(const Raster& raster, const BandInfo& band) {
  Grid<T> grid(raster.extent());
  const BandSource<T> source(raster, band);
  for (Index r = 0; r < grid.rows(); ++r) source.read(r, grid.row(r));
  return grid;
}

template class BandSource<float>;
template class BandSource<double>;
template Grid<float> read_band(const Raster&, const BandInfo&);
template Grid<double> read_band(const Raster&, const BandInfo&);

}  // namespace arete::gdal
