// SPDX-License-Identifier: MIT
// A GeoTIFF in, a finer GeoTIFF on the same ground out: refine_a_raster IN.tif OUT.tif
#include <arete/gdal/raster.h>
#include <arete/gdal/refine_raster.h>
#include <arete/scheme/catalogue.h>

#include <cstdio>
#include <exception>

int main(int count, char** arguments) try {
  if (count != 3) return 2;
  const arete::gdal::Raster dem(arguments[1]);
  const arete::Scheme scheme = arete::parse_scheme("gentle");
  arete::gdal::RasterOutput form;
  form.max_memory = 200e6;  // bytes, whatever the size of the raster
  const auto report = arete::gdal::refine_raster(dem, arguments[2], scheme, scheme, {.levels = 2},
                                                 form, [](double) {});
  std::printf("%lld x %lld samples\n", static_cast<long long>(report.output.cols),
              static_cast<long long>(report.output.rows));
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
