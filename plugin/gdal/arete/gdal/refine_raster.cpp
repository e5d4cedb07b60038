// SPDX-License-Identifier: MIT
#include "arete/gdal/refine_raster.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "arete/gdal/band_source.h"
#include "arete/gdal/write_behind.h"
#include "arete/variational/cardinal_source.h"

namespace arete::gdal {
namespace {

std::string megabytes(double bytes) {
  return std::to_string(static_cast<long long>(std::ceil(bytes / 1e6))) + " MB";
}

// Puts the nodata value where samples are missing, and moves results away from it.
template <class T>
void encode_missing(GridView<T> rows, T nodata) {
  const T beside = nodata == T(0) ? std::numeric_limits<T>::min() : std::nextafter(nodata, T(0));
  for (Index r = 0; r < rows.rows(); ++r)
    for (Index c = 0; c < rows.cols(); ++c) {
      T& value = rows(r, c);
      if (std::isnan(value))
        value = nodata;
      else if (value == nodata)
        value = beside;
    }
}

// Whether the limit shall pass through the input, and beside which boundaries.
struct Controls {
  const std::optional<LimitWeights>& weights;
  Boundaries boundaries;
};

template <class T>
bool has_valid(GridView<const T> rows) {
  for (Index r = 0; r < rows.rows(); ++r)
    if (!std::all_of(rows.row(r), rows.row(r) + rows.cols(), [](T v) { return std::isnan(v); }))
      return true;
  return false;
}

template <class T>
void refine_bands(const Raster& input, WriteBehind<T>& output, const Refiner<T>& refiner,
                  const std::optional<double>& nodata, const Controls& controls, Index chunk,
                  const Progress& progress) {
  const Index height = refiner.output().rows;
  const double total = static_cast<double>(height) * static_cast<double>(input.bands().size());
  double done = 0;
  int number = 0;
  bool any_valid = false;
  for (const BandInfo& band : input.bands()) {
    const BandSource<T> samples(input, band);
    std::optional<CardinalSource<T>> control;
    if (controls.weights)
      control.emplace(samples, controls.weights->x, controls.weights->y, controls.boundaries);
    const RowSource<T>& source = control ? static_cast<const RowSource<T>&>(*control) : samples;
    ++number;
    for (Index first = 0; first < height; first += chunk) {
      const Index count = std::min(chunk, height - first);
      const GridView<T> part = output.buffer(count);
      refiner.refine_rows(source, first, part);
      any_valid = any_valid || has_valid<T>(part);
      if (nodata) encode_missing(part, static_cast<T>(*nodata));
      output.write(number, first, part);
      done += static_cast<double>(count);
      if (progress) progress(done / total);
    }
  }
  output.finish();
  if (!any_valid)
    throw RasterError(input.path() +
                      " has no valid result: no four neighbouring samples are all "
                      "valid; check its nodata value with gdalinfo");
}

template <class T>
RasterReport refine_as(const Raster& input, const std::string& output, const Scheme& x,
                       const Scheme& y, const RefineOptions& options, const RasterOutput& form,
                       const Progress& progress) {
  const Refiner<T> refiner(x, y, input.extent(), options);
  const GeoTiffSpec spec = refined_spec(input, refiner.x(), refiner.y(), form, options.threads);

  const double row_bytes = static_cast<double>(refiner.output().cols) * sizeof(T);
  double working = refiner.working_bytes(256) + input.block_bytes();
  if (form.interpolate) {
    const BandSource<T> samples(input, input.bands().front());
    working +=
        CardinalSource<T>(samples, form.interpolate->x, form.interpolate->y, options.boundaries)
            .working_bytes();
  }
  // A row of tiles must stay in GDAL's cache until it is full.
  constexpr double block_rows = 256;
  limit_cache(std::max(64e6, 1.5 * block_rows * row_bytes));
  // The rows of tiles in the cache, and those that are filled and written.
  const bool overlap = options.threads != 1;
  const double buffers = overlap ? 2 : 1;
  const double least = working + (1.5 + buffers) * block_rows * row_bytes;
  if (least > form.max_memory)
    throw RasterError("refining " + input.path() + " needs " + megabytes(least) +
                      " of memory, more than the " + megabytes(form.max_memory) +
                      " allowed; raise --max-memory or use fewer levels");
  GeoTiffWriter writer(output, spec);
  const Index block = std::max<Index>(1, writer.block_rows());
  // A few rows of tiles at a time give every thread work; more would only take memory.
  constexpr double usual = 64e6;
  const double affordable = std::min(usual, (form.max_memory - working) / (1.5 + buffers));
  const Index chunk =
      block * std::clamp<Index>(static_cast<Index>(affordable / row_bytes) / block, 1, 4);
  WriteBehind<T> behind(writer, {std::min(chunk, refiner.output().rows), refiner.output().cols},
                        overlap);
  refine_bands(input, behind, refiner, spec.nodata, {form.interpolate, options.boundaries}, chunk,
               progress);
  writer.close();
  return {input.extent(), refiner.output(), static_cast<int>(input.bands().size()),
          to_double(refiner.x().misplacement()), to_double(refiner.y().misplacement())};
}

}  // namespace

GeoTiffSpec refined_spec(const Raster& input, const AxisPlan& x, const AxisPlan& y,
                         const RasterOutput& form, int threads) {
  GeoTiffSpec spec;
  spec.extent = {y.output_count(), x.output_count()};
  spec.type = form.type;
  spec.crs = input.crs();
  spec.bands = input.bands();
  spec.metadata = input.metadata();
  spec.threads = threads;
  spec.creation_options = form.creation_options;
  if (input.georeference())
    spec.georeference = refined(*input.georeference(), y.placement(), x.placement());
  const AxisPlacement rows = y.placement();
  const AxisPlacement cols = x.placement();
  for (ControlPoint point : input.control_points()) {
    point.pixel = (point.pixel - 0.5 - cols.first) / cols.spacing + 0.5;
    point.line = (point.line - 0.5 - rows.first) / rows.spacing + 0.5;
    spec.control_points.push_back(point);
  }
  spec.control_point_crs = input.control_point_crs();
  bool missing = false;
  for (const BandInfo& band : input.bands()) {
    if (band.nodata && !spec.nodata) spec.nodata = band.nodata;
    missing = missing || Raster::has_holes(band);
  }
  if (!spec.nodata && missing) spec.nodata = std::numeric_limits<double>::quiet_NaN();
  // The value must be one that the samples can hold.
  if (spec.nodata && form.type == SampleType::float32) {
    constexpr double largest = std::numeric_limits<float>::max();
    if (std::isfinite(*spec.nodata)) *spec.nodata = std::clamp(*spec.nodata, -largest, largest);
    spec.nodata = static_cast<double>(static_cast<float>(*spec.nodata));
  }
  return spec;
}

RasterReport refine_raster(const Raster& input, const std::string& output, const Scheme& x,
                           const Scheme& y, const RefineOptions& options, const RasterOutput& form,
                           const Progress& progress) {
  return form.type == SampleType::float32
             ? refine_as<float>(input, output, x, y, options, form, progress)
             : refine_as<double>(input, output, x, y, options, form, progress);
}

}  // namespace arete::gdal
