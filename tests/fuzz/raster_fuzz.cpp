// SPDX-License-Identifier: MIT
// Any bytes as a raster, by whichever of GDAL's formats takes them: they are refused, or the header
// is read, and the first, middle and last rows of the first bands are read or refused.
#include <cpl_conv.h>
#include <cpl_vsi.h>

#include <cstdint>
#include <cstdlib>
#include <vector>

#include "arete/gdal/band_source.h"
#include "arete/gdal/remote.h"

namespace {

using namespace arete;

constexpr const char* path = "/vsimem/fuzz.dat";
constexpr Index widest = 1 << 16;

void read_rows(const gdal::Raster& raster, const gdal::BandInfo& band) {
  const gdal::BandSource<float> source(raster, band);
  const Extent extent = source.extent();
  std::vector<float> row(static_cast<std::size_t>(extent.cols));
  for (const Index r : {Index{0}, extent.rows / 2, extent.rows - 1}) try {
      source.read(r, row.data());
    } catch (const gdal::RasterError&) {
    }
}

void read() {
  try {
    const gdal::Raster raster(path);
    if (raster.extent().rows < 1 || raster.extent().cols < 1 || raster.bands().empty())
      std::abort();
    (void)raster.place();
    if (raster.extent().cols > widest) return;
    for (std::size_t b = 0; b < raster.bands().size() && b < 3; ++b)
      read_rows(raster, raster.bands()[b]);
  } catch (const gdal::RasterError&) {
  }
}

}  // namespace

extern "C" int LLVMFuzzerInitialize(int*, char***) {
  gdal::forbid_remote_access();
  gdal::limit_cache(64e6);
  // A sidecar or a folder that a file names is not looked for: the bytes alone are the input.
  CPLSetConfigOption("GDAL_DISABLE_READDIR_ON_OPEN", "EMPTY_DIR");
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::vector<std::uint8_t> bytes(data, data + size);
  VSIFCloseL(VSIFileFromMemBuffer(path, bytes.data(), size, FALSE));
  read();
  VSIUnlink(path);
  return 0;
}
