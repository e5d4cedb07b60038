// SPDX-License-Identifier: MIT
#include "arete/gdal/texture.h"

#include <cpl_conv.h>
#include <cpl_string.h>
#include <cpl_vsi.h>
#include <gdal_alg.h>
#include <gdal_priv.h>
#include <gdal_utils.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "arete/gdal/error.h"
#include "arete/gdal/internal/dataset.h"
#include "arete/gdal/raster.h"
#include "arete/gdal/remote.h"

namespace arete::gdal {
namespace {

/// Damaged JPEGs are read as grey areas with a warning unless this is set.
class StrictJpeg {
 public:
  StrictJpeg() { CPLSetThreadLocalConfigOption("GDAL_ERROR_ON_LIBJPEG_WARNING", "YES"); }
  ~StrictJpeg() { CPLSetThreadLocalConfigOption("GDAL_ERROR_ON_LIBJPEG_WARNING", nullptr); }
  StrictJpeg(const StrictJpeg&) = delete;
  StrictJpeg& operator=(const StrictJpeg&) = delete;
};

[[noreturn]] void fail(const std::string& path, const std::string& why) {
  throw RasterError("the texture " + path + " " + why);
}

std::string reason(const ErrorCollector& errors) {
  return errors.failed() ? " (GDAL: " + errors.message() + ")" : "";
}

/// gdal_translate into a VRT: made as it is read.
Dataset translated(GDALDataset& source, const std::vector<std::string>& words) {
  CPLStringList list;
  list.AddString("-of");
  list.AddString("VRT");
  for (const std::string& word : words) list.AddString(word.c_str());
  GDALTranslateOptions* options = GDALTranslateOptionsNew(list.List(), nullptr);
  int wrong = 0;
  Dataset result(
      GDALDataset::FromHandle(GDALTranslate("", GDALDataset::ToHandle(&source), options, &wrong)));
  GDALTranslateOptionsFree(options);
  return result;
}

Dataset open(const std::string& path, const ErrorCollector& errors) {
  refuse_remote(path);
  VSIStatBufL status;
  if (VSIStatL(path.c_str(), &status) != 0) fail(path, "does not exist; check the path");
  Dataset dataset(GDALDataset::Open(path.c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY));
  if (!dataset)
    fail(path, "is not a picture that GDAL can read" + reason(errors) +
                   "; give a PNG, JPEG, TIFF or another that 'gdalinfo' opens");
  if (dataset->GetRasterCount() == 0 || dataset->GetRasterXSize() < 1 ||
      dataset->GetRasterYSize() < 1)
    fail(path, "has no pixels");
  return dataset;
}

/// Which bands are red, green, blue and (0: none) alpha.
struct Channels {
  std::array<int, 3> color{1, 1, 1};
  int alpha = 0;
};

Channels channels_of(const std::string& path, GDALDataset& picture) {
  Channels channels;
  int colors = 0;
  for (int number = 1; number <= picture.GetRasterCount(); ++number) {
    GDALRasterBand& band = *picture.GetRasterBand(number);
    if (band.GetRasterDataType() != GDT_Byte)
      fail(path, "has samples of type " +
                     std::string(GDALGetDataTypeName(band.GetRasterDataType())) +
                     ", a picture has 8 bits a channel; convert it with gdal_translate -ot Byte "
                     "-scale");
    if (band.GetColorInterpretation() == GCI_AlphaBand)
      channels.alpha = number;
    else
      ++colors;
  }
  if (colors == 0) fail(path, "has an alpha channel only");
  if (colors >= 3) {
    std::size_t next = 0;
    for (int number = 1; number <= picture.GetRasterCount() && next < 3; ++number)
      if (number != channels.alpha) channels.color[next++] = number;
  } else {
    channels.color.fill(channels.alpha == 1 ? 2 : 1);
  }
  return channels;
}

bool is_referenced(GDALDataset& picture) {
  std::array<double, 6> affine{};
  return picture.GetGeoTransform(affine.data()) == CE_None || picture.GetGCPCount() > 0;
}

TextureImage with_size(int width, int height, bool opacity) {
  TextureImage image{width, height, {}, {}, false};
  const auto pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  image.rgb.resize(3 * pixels);
  if (opacity) image.opacity.resize(pixels);
  return image;
}

/// Reads bands of `source`, all of it, at the image's size.
void read_into(TextureImage& image, GDALDataset& source, const Channels& channels,
               const std::string& path, const ErrorCollector& errors) {
  GDALRasterIOExtraArg how;
  INIT_RASTERIO_EXTRA_ARG(how);
  how.eResampleAlg = GRIORA_Average;
  const auto read = [&](int number, std::uint8_t* to, GSpacing pixel) {
    const CPLErr error = source.GetRasterBand(number)->RasterIO(
        GF_Read, 0, 0, source.GetRasterXSize(), source.GetRasterYSize(), to, image.width,
        image.height, GDT_Byte, pixel, pixel * image.width, &how);
    if (error != CE_None || errors.failed())
      fail(path, "is damaged and cannot be read to its end" + reason(errors));
  };
  for (std::size_t c = 0; c < 3; ++c) read(channels.color[c], image.rgb.data() + c, 3);
  if (channels.alpha != 0) read(channels.alpha, image.opacity.data(), 1);
}

TextureImage stretched(GDALDataset& picture, const Channels& channels, int largest_side,
                       const std::string& path, const ErrorCollector& errors) {
  const double longest = std::max(picture.GetRasterXSize(), picture.GetRasterYSize());
  const double shrink = std::min(1.0, largest_side / longest);
  const auto size = [&](int side) { return std::max(1, static_cast<int>(side * shrink)); };
  TextureImage image = with_size(size(picture.GetRasterXSize()), size(picture.GetRasterYSize()),
                                 channels.alpha != 0);
  read_into(image, picture, channels, path, errors);
  return image;
}

/// The box as a raster in memory: red, green, blue, alpha.
Dataset canvas(const DrapeBox& box, int width, int height) {
  GDALDriver* memory = GetGDALDriverManager()->GetDriverByName("MEM");
  Dataset result(memory->Create("", width, height, 4, GDT_Byte, nullptr));
  if (!result) throw RasterError("there is not enough memory for a texture");
  result->GetRasterBand(4)->SetColorInterpretation(GCI_AlphaBand);
  auto g = box.georeference.affine;
  const double x = static_cast<double>(box.extent.cols) / width;
  const double y = static_cast<double>(box.extent.rows) / height;
  g[1] *= x;
  g[4] *= x;
  g[2] *= y;
  g[5] *= y;
  result->SetGeoTransform(g.data());
  if (!box.crs.empty()) {
    OGRSpatialReference reference;
    reference.importFromWkt(box.crs.c_str());
    reference.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    result->SetSpatialRef(&reference);
  }
  return result;
}

/// How many of the picture's pixels lie along the sides of the box.
std::array<int, 2> size_in_pixels(GDALDataset& picture, const DrapeBox& box, int largest_side,
                                  const std::string& path, const ErrorCollector& errors) {
  const Dataset unit = canvas(box, 1, 1);
  void* transform = GDALCreateGenImgProjTransformer2(GDALDataset::ToHandle(&picture),
                                                     GDALDataset::ToHandle(unit.get()), nullptr);
  std::array<double, 4> x{0, 1, 0, 1};
  std::array<double, 4> y{0, 0, 1, 1};
  std::array<double, 4> z{};
  std::array<int, 4> done{};
  const bool mapped =
      transform != nullptr &&
      GDALGenImgProjTransform(transform, TRUE, 4, x.data(), y.data(), z.data(), done.data()) != 0;
  if (transform != nullptr) GDALDestroyGenImgProjTransformer(transform);
  if (!mapped || std::count(done.begin(), done.end(), 0) > 0)
    fail(path, "cannot be brought into the terrain's reference system" + reason(errors) +
                   "; check its CRS with gdalinfo, or lay it over the whole terrain with "
                   "--stretch");
  const auto side = [&](std::size_t a, std::size_t b) {
    return std::hypot(x[b] - x[a], y[b] - y[a]);
  };
  const double width = std::max(side(0, 1), side(2, 3));
  const double height = std::max(side(0, 2), side(1, 3));
  const double shrink = std::min(1.0, largest_side / std::max({width, height, 1.0}));
  return {std::max(1, static_cast<int>(std::ceil(width * shrink))),
          std::max(1, static_cast<int>(std::ceil(height * shrink)))};
}

TextureImage draped(GDALDataset& picture, const Channels& channels, const DrapeBox& box,
                    int largest_side, const std::string& path, const ErrorCollector& errors) {
  const auto [width, height] = size_in_pixels(picture, box, largest_side, path, errors);
  const Dataset result = canvas(box, width, height);
  std::vector<std::string> order;
  for (const int number : channels.color) order.insert(order.end(), {"-b", std::to_string(number)});
  if (channels.alpha != 0)
    order.insert(order.end(), {"-b", std::to_string(channels.alpha), "-colorinterp_4", "alpha"});
  const Dataset ordered = translated(picture, order);
  if (!ordered) fail(path, "cannot be read" + reason(errors));

  CPLStringList how;
  for (const char* word : {"-r", "bilinear", "-q"}) how.AddString(word);
  GDALWarpAppOptions* options = GDALWarpAppOptionsNew(how.List(), nullptr);
  GDALDatasetH source = GDALDataset::ToHandle(ordered.get());
  int wrong = 0;
  GDALWarp(nullptr, GDALDataset::ToHandle(result.get()), 1, &source, options, &wrong);
  GDALWarpAppOptionsFree(options);
  if (wrong != 0 || errors.failed()) fail(path, "cannot be laid over the terrain" + reason(errors));

  TextureImage image = with_size(width, height, true);
  read_into(image, *result, {{1, 2, 3}, 4}, path, errors);
  image.draped = true;
  if (std::all_of(image.opacity.begin(), image.opacity.end(), [](auto a) { return a == 0; }))
    fail(path, "lies beside the terrain" +
                   std::string(picture.GetSpatialRef() == nullptr && !box.crs.empty()
                                   ? " (it has no reference system, so the terrain's was taken)"
                                   : "") +
                   "; check both with gdalinfo, correct it with gdal_edit.py -a_srs, or lay it "
                   "over the whole terrain with --stretch");
  if (std::all_of(image.opacity.begin(), image.opacity.end(), [](auto a) { return a == 255; }))
    image.opacity.clear();
  return image;
}

}  // namespace

TextureImage read_texture(const std::string& path, const DrapeBox& box, int largest_side,
                          bool stretch) {
  register_formats();
  const ErrorCollector errors;
  const StrictJpeg strict;
  const Dataset opened = open(path, errors);
  const bool indexed = opened->GetRasterBand(1)->GetColorTable() != nullptr;
  // Reads from the one above, so that it has to go first.
  const Dataset expanded = indexed ? translated(*opened, {"-expand", "rgba"}) : nullptr;
  if (indexed && !expanded) fail(path, "has a palette that GDAL cannot expand" + reason(errors));
  GDALDataset* picture = indexed ? expanded.get() : opened.get();
  const Channels channels = channels_of(path, *picture);
  return !stretch && box.referenced && is_referenced(*picture)
             ? draped(*picture, channels, box, largest_side, path, errors)
             : stretched(*picture, channels, largest_side, path, errors);
}

}  // namespace arete::gdal
