// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "arete/field/georeference.h"
#include "arete/field/grid.h"

namespace arete::vtk {

/// What the coordinates of the georeference are.
enum class Coordinates {
  planar,      ///< lengths, in the unit of the heights; +x east, +y north
  geographic,  ///< degrees of longitude (x) and latitude (y); heights in metres
};

/// A text kept in the field data of every file, under its name (not empty).
struct Note {
  std::string name;
  std::string text;
};

/// Partial derivatives of the height by the world coordinates, one pair a sample: height units per
/// metre (or whatever the plane's unit is), or per DEGREE for a geographic surface. NaN where there
/// is none.
struct Gradients {
  GridView<const float> dz_dx;
  GridView<const float> dz_dy;
};

/// A height field in its place in the world, borrowed: what every writer and the renderer take.
///
/// Heights are float or double, and stay so in files. A sample that is not finite is missing.
/// Without gradients, central differences of the heights are used, one-sided at the border and
/// beside missing samples, zero along a direction in which a sample has no neighbour.
///
/// Files that hold geometry (.vts, .vtp) and pictures need lengths in all three directions. For a
/// planar surface x and y are the world coordinates themselves, in double, so that metres of a UTM
/// zone keep their last digits. For a geographic one they are metres east and north of the
/// raster's centre (lon0, lat0) on the sphere of radius R = 6371008.8 m,
///
///     x = R cos(lat0) (lon - lon0),   y = R (lat - lat0)     (angles in radians),
///
/// and the field data say so. Right to first order only: over a few hundred kilometres, or near a
/// pole, project the raster instead. A .vti keeps the coordinates of the reference system.
struct Surface {
  std::variant<GridView<const float>, GridView<const double>> heights;
  Georeference georeference{};
  std::optional<Gradients> gradients{};
  std::string crs_wkt{};
  Coordinates coordinates = Coordinates::planar;
  std::vector<Note> notes{};

  [[nodiscard]] Extent extent() const;
  [[nodiscard]] double height(Index row, Index col) const;
  /// Whether the sample (row, col) exists.
  [[nodiscard]] bool valid(Index row, Index col) const;
};

/// \throws InvalidField unless there are samples, the gradients are of the same extent, the
/// georeference is finite, and notes have names.
void check_samples(const Surface& surface);

/// The same, and what geometry needs besides.
/// \throws InvalidField also for fewer than 2 x 2 samples, none of which valid, for a georeference
/// that maps the plane onto a line, and for a geographic centre at or beyond a pole.
void check_geometry(const Surface& surface);

}  // namespace arete::vtk
