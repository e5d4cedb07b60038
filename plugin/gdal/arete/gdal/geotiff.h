// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "arete/gdal/raster.h"

namespace arete::gdal {

enum class SampleType { float32, float64 };

/// What a new GeoTIFF shall be.
struct GeoTiffSpec {
  Extent extent;
  SampleType type = SampleType::float32;
  std::optional<Georeference> georeference;
  std::string crs;
  std::vector<BandInfo> bands;
  Metadata metadata;
  std::vector<ControlPoint> control_points;
  std::string control_point_crs;
  std::optional<double> nodata;
  int threads = 1;  ///< for compression
  /// KEY=VALUE of GDAL's GTiff driver; they win over the defaults TILED=YES, COMPRESS=DEFLATE with
  /// PREDICTOR=3, BIGTIFF=IF_SAFER, INTERLEAVE=BAND.
  std::vector<std::string> creation_options;
};

/// A GeoTIFF being written, band by band, rows in any order (best in runs of block_rows()).
/// The file is complete only after close(); until then, or after a failure, what stands at the path
/// must not be used.
class GeoTiffWriter {
 public:
  /// \throws RasterError for an unknown creation option, a size beyond GDAL's (2^31 - 1 a side), or
  /// a path that cannot be written.
  GeoTiffWriter(const std::string& path, const GeoTiffSpec& spec);
  ~GeoTiffWriter();

  [[nodiscard]] Index block_rows() const;

  /// Writes the rows first_row.. of band number `band` (from 1); from any thread, one at a time.
  /// \throws RasterError (disk full).
  template <class T>
  void write(int band, Index first_row, GridView<const T> rows);

  /// Writes all that is still held back. \throws RasterError if anything was lost.
  void close();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace arete::gdal
