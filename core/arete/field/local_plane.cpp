// SPDX-License-Identifier: MIT
#include "arete/field/local_plane.h"

#include <cmath>
#include <iomanip>
#include <limits>
#include <numbers>
#include <sstream>

namespace arete {
namespace {

constexpr double earth_radius = 6371008.8;  // metres; mean radius of the GRS 80 ellipsoid
constexpr double radian = std::numbers::pi / 180;

std::string describe(WorldPoint origin) {
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << std::setprecision(std::numeric_limits<double>::digits10)
       << "x, y are metres east and north of longitude " << origin.x << ", latitude " << origin.y
       << " degrees (equirectangular, sphere of radius " << earth_radius << " m)";
  return text.str();
}

}  // namespace

LocalPlane local_plane(const Georeference& place, Extent extent, bool geographic) {
  LocalPlane plane;
  plane.placement = place;
  if (!geographic) return plane;

  const double row = static_cast<double>(extent.rows - 1) / 2;
  const double col = static_cast<double>(extent.cols - 1) / 2;
  plane.origin = place.position(row, col);
  if (!(std::abs(plane.origin.y) < 89.9))
    throw InvalidField("the raster's centre lies at latitude " + std::to_string(plane.origin.y) +
                       "; project it to a plane (gdalwarp -t_srs) first");
  plane.scale_x = earth_radius * radian * std::cos(plane.origin.y * radian);
  plane.scale_y = earth_radius * radian;
  plane.note = describe(plane.origin);

  // The affine map is rebuilt about the centre, not scaled term by term: g[0] holds degrees whose
  // product with 1e5 m would lose what the difference keeps.
  auto& g = plane.placement.affine;
  g[1] *= plane.scale_x;
  g[2] *= plane.scale_x;
  g[4] *= plane.scale_y;
  g[5] *= plane.scale_y;
  g[0] = -((col + 0.5) * g[1] + (row + 0.5) * g[2]);
  g[3] = -((col + 0.5) * g[4] + (row + 0.5) * g[5]);
  return plane;
}

}  // namespace arete
