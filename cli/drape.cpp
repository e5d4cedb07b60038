// SPDX-License-Identifier: MIT
#include "cli/drape.h"

#include <utility>

#include "arete/gdal/texture.h"

namespace arete::cli {

vtk::Texture drape(const std::string& path, const gdal::Raster& raster, const Georeference& place,
                   Extent extent, bool stretch) {
  constexpr int largest_side = 4096;  // what any driver and any viewer of models takes
  gdal::TextureImage read =
      gdal::read_texture(path, {extent, place, raster.crs(), raster.georeference().has_value()},
                         largest_side, stretch);
  vtk::Texture texture{{read.width, read.height, {}}, std::move(read.opacity)};
  texture.image.pixels.resize(read.rgb.size() / 3);
  for (std::size_t k = 0; k < read.rgb.size(); ++k)
    texture.image.pixels[k / 3][k % 3] = read.rgb[k];
  return texture;
}

}  // namespace arete::cli
