// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "arete/field/georeference.h"

namespace arete::gdal {

/// The box of a raster's pixels in its place on earth.
struct DrapeBox {
  Extent extent{};
  Georeference georeference{};
  std::string crs{};       ///< WKT; empty when unknown
  bool referenced = true;  ///< whether georeference and crs are known at all
};

/// A picture over a box: its first row along row 0 of the box, its first column along column 0.
struct TextureImage {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgb;  ///< three a pixel, row by row
  std::vector<std::uint8_t>
      opacity;          ///< one a pixel, 0 where the picture is not; empty: everywhere
  bool draped = false;  ///< laid by georeference, not stretched
};

/// Reads any picture that GDAL reads (8 bits a channel: grey, palette, RGB, with or without alpha).
/// If it has a georeference and the box has one, it is warped onto the box, out of its own
/// reference system if that is another one (bilinear, averaging when it is reduced); a picture
/// without reference system is taken to be in the box's. Otherwise, or with `stretch`, it is laid
/// over the whole box. No side gets longer than `largest_side` pixels, none finer than the
/// picture's own.
/// \throws RasterError if the file is missing, unreadable, damaged, not of 8 bits, cannot be
/// brought into the box's reference system, or lies beside the box.
[[nodiscard]] TextureImage read_texture(const std::string& path, const DrapeBox& box,
                                        int largest_side, bool stretch = false);

}  // namespace arete::gdal
