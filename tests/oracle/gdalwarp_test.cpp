// SPDX-License-Identifier: MIT
// gdalwarp's kernels on node-aligned extents are two members of the catalogue, exactly.
#include <gtest/gtest.h>

#include <cfloat>
#include <cmath>

#include "arete/analysis/limit_stencil.h"
#include "arete/gdal/band_source.h"
#include "arete/gdal/resample.h"
#include "arete/refine/refiner.h"
#include "arete/scheme/catalogue.h"
#include "support/fields.h"

namespace arete {
namespace {

Grid<double> warped(const Grid<double>& grid, const char* kernel, int factor) {
  return gdal::resampled(grid.view(), kernel, factor);
}

// gdalwarp lowers its order near the border, where it has no rule; `rim` input samples are left
// out.
double largest_difference(const Grid<double>& a, const Grid<double>& b, Index rim, int factor) {
  EXPECT_EQ(a.extent(), b.extent());
  double largest = 0;
  for (Index r = rim * factor; r < a.rows() - rim * factor; ++r)
    for (Index c = rim * factor; c < a.cols() - rim * factor; ++c)
      largest = std::max(largest, std::abs(a(r, c) - b(r, c)));
  return largest;
}

TEST(gdalwarp, one_level_of_the_four_point_scheme_is_the_cubic_kernel) {
  // Exactly where no rounding happens (integers and eighths, dyadic weights)...
  const gdal::Raster dem(std::string(ARETE_SOURCE_DIR) + "/data/jacksboro_srtm3.tif");
  for (const Grid<double>& input :
       {gdal::read_band<double>(dem, dem.bands().front()), test::dyadic_heights({21, 50}, 2)})
    EXPECT_EQ(largest_difference(refine(input, parse_scheme("four-point")),
                                 warped(input, "cubic", 2), 2, 2),
              0);
  // ... and to some ulps of the heights, up to 900, where sums are taken in another order.
  const Grid<double> input = test::random_heights({40, 33}, 1);
  EXPECT_LE(largest_difference(refine(input, parse_scheme("four-point")), warped(input, "cubic", 2),
                               2, 2),
            4 * 512 * DBL_EPSILON);
}

TEST(gdalwarp, the_limit_of_the_cubic_b_spline_is_the_cubicspline_kernel) {
  const Scheme scheme = parse_scheme("b-spline:degree=3");
  const Stencil limit = *limit_stencil(scheme.mask());
  for (const int levels : {3, 4}) {
    RefineOptions options;
    options.levels = levels;
    options.final_x = limit;
    options.final_y = limit;
    const Grid<double> input = test::random_heights({30, 24}, 5);
    const Grid<double> fine = refine(input, scheme, options);
    const int factor = 1 << levels;
    const Grid<double> kernel = warped(input, "cubicspline", factor);
    EXPECT_LE(largest_difference(fine, kernel, 2, factor), 1e-10);
    // Without the limit stencil level 3 is not there yet: the oracle can tell.
    options.final_x.reset();
    options.final_y.reset();
    EXPECT_GT(largest_difference(refine(input, scheme, options), kernel, 2, factor), 1e-3);
  }
}

}  // namespace
}  // namespace arete
