// SPDX-License-Identifier: MIT
#include "cli/common_lattice.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "arete/gdal/band_source.h"
#include "arete/gdal/reference_system.h"
#include "cli/error.h"
#include "cli/find_band.h"
#include "cli/memory_size.h"

namespace arete::cli {
namespace {

constexpr double tolerance = 1e-3;  // of a sample

// Indices of a place in a raster, from its affine map.
WorldPoint indices_at(const Georeference& place, WorldPoint p) {
  const auto& g = place.affine;
  const double determinant = g[1] * g[5] - g[2] * g[4];
  const double x = p.x - g[0];
  const double y = p.y - g[3];
  return {(x * g[5] - y * g[2]) / determinant - 0.5, (y * g[1] - x * g[4]) / determinant - 0.5};
}

bool near_integer(double value) { return std::abs(value - std::round(value)) <= tolerance; }

// How `fine` holds the samples of `coarse`, if it does.
bool holds(const gdal::Raster& fine, const gdal::Raster& coarse, LatticeMatch& match) {
  const Georeference place = coarse.place();
  const double last_row = static_cast<double>(coarse.extent().rows - 1);
  const double last_col = static_cast<double>(coarse.extent().cols - 1);
  const WorldPoint a = indices_at(fine.place(), place.position(0, 0));
  const WorldPoint right = indices_at(fine.place(), place.position(0, std::max(1.0, last_col)));
  const WorldPoint down = indices_at(fine.place(), place.position(std::max(1.0, last_row), 0));
  const double col_step = std::round((right.x - a.x) / std::max(1.0, last_col));
  const double row_step = std::round((down.y - a.y) / std::max(1.0, last_row));
  const bool along = std::abs(right.y - a.y) <= tolerance && std::abs(down.x - a.x) <= tolerance;
  const bool ends = std::abs(a.x + col_step * std::max(1.0, last_col) - right.x) <= tolerance &&
                    std::abs(a.y + row_step * std::max(1.0, last_row) - down.y) <= tolerance;
  if (!(along && ends && col_step >= 1 && row_step >= 1 && near_integer(a.x) && near_integer(a.y)))
    return false;
  match.row_step = static_cast<Index>(row_step);
  match.col_step = static_cast<Index>(col_step);
  match.first_row = static_cast<Index>(std::round(a.y));
  match.first_col = static_cast<Index>(std::round(a.x));
  return true;
}

// Those indices of the coarser whose partner exists.
struct Run {
  Index first, last;
};
Run overlap(Index coarse_count, Index fine_count, Index step, Index offset) {
  const auto up = [&](Index a) { return a <= 0 ? 0 : (a + step - 1) / step; };
  return {up(-offset), std::min(coarse_count - 1, (fine_count - 1 - offset) / step)};
}

void read_samples(const gdal::Raster& raster, int band, Index first_row, Index row_step,
                  Index first_col, Index col_step, Grid<double>& out) {
  const gdal::BandSource<double> source(raster, find_band(raster, band));
  std::vector<double> line(static_cast<std::size_t>(raster.extent().cols));
  for (Index r = 0; r < out.rows(); ++r) {
    source.read(first_row + r * row_step, line.data());
    for (Index c = 0; c < out.cols(); ++c)
      out(r, c) = line[static_cast<std::size_t>(first_col + c * col_step)];
  }
}

}  // namespace

LatticeMatch match_lattices(const gdal::Raster& first, const gdal::Raster& second) {
  const std::string both = first.path() + " and " + second.path();
  if (first.georeference().has_value() != second.georeference().has_value())
    throw Failure(both +
                  ": only one of them has a place on earth; give the other one too "
                  "(gdal_edit.py -a_ullr)");
  if (!first.crs().empty() && !second.crs().empty() && !gdal::same_crs(first.crs(), second.crs()))
    throw Failure(both +
                  " name different reference systems; bring one to the other with gdalwarp "
                  "-t_srs");
  LatticeMatch match;
  if (holds(second, first, match)) return match;
  match.second_is_finer = false;
  if (holds(first, second, match)) return match;
  throw Failure(both +
                ": the samples of one lie between those of the other; bring one to the "
                "other's lattice with gdalwarp -tr -te");
}

CommonLattice read_common(const gdal::Raster& first, const gdal::Raster& second, int band,
                          double max_memory) {
  const LatticeMatch m = match_lattices(first, second);
  const gdal::Raster& coarse = m.second_is_finer ? first : second;
  const gdal::Raster& fine = m.second_is_finer ? second : first;
  const Run rows = overlap(coarse.extent().rows, fine.extent().rows, m.row_step, m.first_row);
  const Run cols = overlap(coarse.extent().cols, fine.extent().cols, m.col_step, m.first_col);
  if (rows.last < rows.first || cols.last < cols.first)
    throw Failure(first.path() + " and " + second.path() + " do not overlap; check their places");
  const Extent extent{rows.last - rows.first + 1, cols.last - cols.first + 1};
  check_memory("comparing " + first.path() + " and " + second.path(),
               32 * static_cast<double>(extent.rows) * static_cast<double>(extent.cols),
               max_memory);
  Grid<double> a(extent);
  Grid<double> b(extent);
  read_samples(coarse, band, rows.first, 1, cols.first, 1, a);
  read_samples(fine, band, m.first_row + rows.first * m.row_step, m.row_step,
               m.first_col + cols.first * m.col_step, m.col_step, b);
  const AxisPlacement row_place{extent.rows, static_cast<double>(rows.first), 1};
  const AxisPlacement col_place{extent.cols, static_cast<double>(cols.first), 1};
  const Georeference place = refined(coarse.place(), row_place, col_place);
  if (!m.second_is_finer) std::swap(a, b);
  return {std::move(a), std::move(b), place};
}

WorldPoint ground_spacing(const Georeference& place, Extent extent, bool degrees) {
  const auto& g = place.affine;
  WorldPoint unit{1, 1};
  if (degrees) {
    constexpr double metres_per_degree = 111120;  // sixty nautical miles, as gdaldem counts
    const double latitude =
        place.position(static_cast<double>(extent.rows) / 2, static_cast<double>(extent.cols) / 2)
            .y;
    unit = {metres_per_degree * std::cos(latitude * std::numbers::pi / 180), metres_per_degree};
  }
  return {std::hypot(g[1] * unit.x, g[4] * unit.y), std::hypot(g[2] * unit.x, g[5] * unit.y)};
}

}  // namespace arete::cli
