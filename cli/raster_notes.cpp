// SPDX-License-Identifier: MIT
#include "cli/raster_notes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "cli/error.h"

namespace arete::cli {
namespace {

template <class T>
void write_as(gdal::GeoTiffWriter& writer, int band, const Grid<double>& samples,
              const ValidSamples& valid, std::optional<double> nodata) {
  const T missing = static_cast<T>(nodata.value_or(std::numeric_limits<double>::quiet_NaN()));
  const T beside = missing == T(0) ? std::numeric_limits<T>::min() : std::nextafter(missing, T(0));
  const Index block = std::max<Index>(1, writer.block_rows());
  Grid<T> rows({block, samples.cols()});
  for (Index first = 0; first < samples.rows(); first += block) {
    const Index count = std::min(block, samples.rows() - first);
    for (Index i = 0; i < count * samples.cols(); ++i) {
      const auto place = static_cast<std::size_t>(first * samples.cols() + i);
      const T value = static_cast<T>(samples.samples()[place]);
      const bool exists = valid.empty() || valid[place] != 0;
      rows.samples()[static_cast<std::size_t>(i)] = !exists            ? missing
                                                    : value == missing ? beside
                                                                       : value;
    }
    writer.write<T>(band, first, GridView<const T>(rows.row(0), {count, samples.cols()}));
  }
}

}  // namespace

RasterNotes RasterNotes::of(const gdal::Raster& raster) {
  RasterNotes notes;
  notes.georeference = raster.georeference();
  notes.integers = true;
  constexpr std::array<const char*, 5> short_types{"Byte", "Int8", "Int16", "UInt16", "Float32"};
  for (const gdal::BandInfo& band : raster.bands()) {
    notes.integers = notes.integers && !band.floating;
    notes.needs_float64 = notes.needs_float64 || std::find(short_types.begin(), short_types.end(),
                                                           band.type) == short_types.end();
    if (band.nodata && !notes.nodata) notes.nodata = band.nodata;
  }
  return notes;
}

std::string RasterNotes::text() const {
  nlohmann::ordered_json object{{"integers", integers}, {"needs_float64", needs_float64}};
  if (georeference) {
    object["affine"] = georeference->affine;
    object["point"] = georeference->registration == Registration::point;
  }
  // JSON has no infinities or NaN.
  if (nodata && std::isfinite(*nodata)) object["nodata"] = *nodata;
  if (nodata && std::isnan(*nodata)) object["nodata"] = "nan";
  return object.dump();
}

RasterNotes RasterNotes::parse(const std::string& text) {
  RasterNotes notes;
  try {
    const auto object = nlohmann::json::parse(text);
    notes.integers = object.at("integers");
    notes.needs_float64 = object.at("needs_float64");
    if (object.contains("affine"))
      notes.georeference =
          Georeference{object.at("affine").get<std::array<double, 6>>(),
                       object.at("point").get<bool>() ? Registration::point : Registration::area};
    if (object.contains("nodata"))
      notes.nodata = object.at("nodata").is_string() ? std::numeric_limits<double>::quiet_NaN()
                                                     : object.at("nodata").get<double>();
  } catch (const nlohmann::json::exception&) {
    throw Failure("the details say nothing about a raster; they were not made by 'arete coarsen'");
  }
  return notes;
}

gdal::GeoTiffSpec spec_like(const gdal::Raster& raster, Extent extent, gdal::SampleType type) {
  gdal::GeoTiffSpec spec;
  spec.extent = extent;
  spec.type = type;
  spec.crs = raster.crs();
  spec.bands = raster.bands();
  spec.metadata = raster.metadata();
  return spec;
}

void carry_control_points(const gdal::Raster& raster, const LevelPlace& from, const LevelPlace& to,
                          gdal::GeoTiffSpec& spec) {
  // Samples lie at the centres of pixels.
  const auto moved = [](double edge, const AxisPlacement& a, const AxisPlacement& b) {
    return (a.first + (edge - 0.5) * a.spacing - b.first) / b.spacing + 0.5;
  };
  for (gdal::ControlPoint point : raster.control_points()) {
    point.pixel = moved(point.pixel, from.cols, to.cols);
    point.line = moved(point.line, from.rows, to.rows);
    spec.control_points.push_back(point);
  }
  spec.control_point_crs = raster.control_point_crs();
}

void write_bands(const std::filesystem::path& path, gdal::GeoTiffSpec spec,
                 const std::vector<Grid<double>>& bands, const std::vector<ValidSamples>& valid) {
  if (spec.type == gdal::SampleType::float32 && spec.nodata) {
    constexpr double largest = std::numeric_limits<float>::max();
    if (std::isfinite(*spec.nodata)) *spec.nodata = std::clamp(*spec.nodata, -largest, largest);
    spec.nodata = static_cast<double>(static_cast<float>(*spec.nodata));
  }
  gdal::GeoTiffWriter writer(path.string(), spec);
  for (std::size_t i = 0; i < bands.size(); ++i) {
    const int band = static_cast<int>(i) + 1;
    if (spec.type == gdal::SampleType::float32)
      write_as<float>(writer, band, bands[i], valid[i], spec.nodata);
    else
      write_as<double>(writer, band, bands[i], valid[i], spec.nodata);
  }
  writer.close();
}

}  // namespace arete::cli
