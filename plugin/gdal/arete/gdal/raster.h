// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "arete/field/georeference.h"
#include "arete/gdal/error.h"

class GDALDataset;

namespace arete::gdal {

using Metadata = std::vector<std::pair<std::string, std::string>>;

/// What a band says about itself.
struct BandInfo {
  int number = 1;         ///< counted from 1, as GDAL does
  std::string type;       ///< GDAL's name, e.g. Int16
  bool floating = false;  ///< may hold NaN
  bool masked = false;    ///< GDAL offers a mask of it: nodata, mask band, alpha of bytes
  int alpha_band = 0;     ///< otherwise the alpha band (0: none); 0 in it means no sample
  std::optional<double> nodata;
  std::optional<double> scale;
  std::optional<double> offset;
  std::string unit;
  std::string description;
  int color_interpretation = 0;  ///< GDALColorInterp
  Metadata metadata;
};

/// A tie of the raster (in pixels and lines, from edges) to the world.
struct ControlPoint {
  std::string id, info;
  double pixel = 0, line = 0;
  double x = 0, y = 0, z = 0;
};

/// A raster opened for reading by GDAL, any format it knows. Alpha bands are taken as validity, not
/// as data: they are not among bands().
class Raster {
 public:
  /// \throws RasterError if the file is missing or unreadable, not a raster, without data bands,
  /// holds complex numbers or palette indices, or claims rows or blocks that take more than half of
  /// the machine's memory.
  explicit Raster(const std::string& path);

  [[nodiscard]] const std::string& path() const { return path_; }
  [[nodiscard]] Extent extent() const { return extent_; }
  [[nodiscard]] const std::vector<BandInfo>& bands() const { return bands_; }
  /// Nothing when the file has no georeference.
  [[nodiscard]] const std::optional<Georeference>& georeference() const { return georeference_; }
  /// The georeference, or, when there is none, one that puts sample (row, col) at x = col, y =
  /// -row.
  [[nodiscard]] Georeference place() const;
  /// The coordinate reference system as WKT; empty when there is none.
  [[nodiscard]] const std::string& crs() const { return crs_; }
  /// Coordinates are longitudes and latitudes in degrees.
  [[nodiscard]] bool geographic() const { return geographic_; }
  [[nodiscard]] const Metadata& metadata() const { return metadata_; }
  [[nodiscard]] const std::vector<ControlPoint>& control_points() const { return control_points_; }
  [[nodiscard]] const std::string& control_point_crs() const { return control_point_crs_; }

  /// Bytes of its largest block: GDAL decodes all of it for any one sample.
  [[nodiscard]] double block_bytes() const { return block_bytes_; }

  /// Whether GDAL finds the rows of this format only by reading those before: asked first for a row
  /// behind the end of a file cut off, it would try 2^row times.
  [[nodiscard]] bool rows_follow_each_other() const { return rows_follow_each_other_; }

  /// Whether samples of the band can be missing.
  [[nodiscard]] static bool has_holes(const BandInfo& band) {
    return band.masked || band.floating || band.alpha_band != 0;
  }

  /// The handle, for the other parts of this adapter. Not to be used by two threads at once.
  [[nodiscard]] GDALDataset& dataset() const { return *dataset_; }

 private:
  void read_reference();
  void read_bands();
  void check_claims();

  struct Close {
    void operator()(GDALDataset* dataset) const;
  };

  std::string path_;
  std::unique_ptr<GDALDataset, Close> dataset_;
  Extent extent_;
  std::vector<BandInfo> bands_;
  double block_bytes_ = 0;
  bool rows_follow_each_other_ = false;
  std::optional<Georeference> georeference_;
  std::string crs_;
  bool geographic_ = false;
  Metadata metadata_;
  std::vector<ControlPoint> control_points_;
  std::string control_point_crs_;
};

/// Lets GDAL know its formats; called by everything here that needs it.
void register_formats();

/// Limits GDAL's cache of blocks, in bytes.
void limit_cache(double bytes);

}  // namespace arete::gdal
