// SPDX-License-Identifier: MIT
// Touches every installed component, so that headers, libraries and their dependencies are there.
#include <arete/refine/refiner.h>
#include <arete/scheme/catalogue.h>
#ifdef WITH_GDAL
#include <arete/gdal/raster.h>
#endif
#ifdef WITH_VTK
#include <arete/vtk/write_image.h>
#endif
#ifdef WITH_OPENSUBDIV
#include <arete/opensubdiv/catmull_clark.h>
#endif

#include <exception>

int main() {
  const arete::Grid<double> fine =
      arete::refine(arete::Grid<double>({4, 5}, 3), arete::parse_scheme("gentle"));
  if (fine.extent() != arete::Extent{7, 9}) return 1;
#ifdef WITH_GDAL
  try {
    const arete::gdal::Raster raster("/absent.tif");
    return 2;
  } catch (const arete::gdal::RasterError&) {
  }
#endif
#ifdef WITH_VTK
  try {
    arete::vtk::write_image({fine.view()}, "/absent/folder/image.vti");
    return 3;
  } catch (const std::exception&) {
  }
#endif
  return 0;
}
