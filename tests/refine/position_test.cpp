// SPDX-License-Identifier: MIT
// Where refined samples lie: planes in world coordinates must be found again.
#include <gtest/gtest.h>

#include "arete/analysis/polynomial.h"
#include "arete/refine/refiner.h"
#include "support/schemes.h"

namespace arete {
namespace {

// Rotated and sheared, dyadic.
const Georeference world{{500, 30, 8, 4200, 6, -28}, Registration::area};

TEST(position, every_sample_of_a_world_plane_equals_its_own_coordinates) {
  for (const Scheme& scheme : test::sample_schemes()) {
    if (sum_rules(scheme.mask()) < 2) continue;
    for (int levels : {1, 2}) {
      for (Alignment alignment : {Alignment::nodes, Alignment::cells}) {
        if (scheme.mask().arity() > 3 && levels > 1) continue;
        RefineOptions options;
        options.levels = levels;
        options.alignment = alignment;
        const Refiner<double> refiner(scheme, {6, 9}, options);
        const Georeference fine_world = refined(world, refiner);
        for (bool easting : {true, false}) {
          Grid<double> input({6, 9});
          for (Index r = 0; r < 6; ++r)
            for (Index c = 0; c < 9; ++c) {
              const WorldPoint p = world.position(static_cast<double>(r), static_cast<double>(c));
              input(r, c) = easting ? p.x : p.y;
            }
          const Grid<double> fine = refiner(input.view());
          for (Index r = 0; r < fine.rows(); ++r)
            for (Index c = 0; c < fine.cols(); ++c) {
              const WorldPoint p =
                  fine_world.position(static_cast<double>(r), static_cast<double>(c));
              ASSERT_NEAR(fine(r, c), easting ? p.x : p.y, 1e-9)
                  << scheme.text() << " level " << levels << " at " << r << ", " << c;
            }
        }
      }
    }
  }
}

TEST(position, dual_cells_leave_the_box_as_it_is_and_primal_nodes_shrink_it_to_the_samples) {
  RefineOptions options;
  options.levels = 4;
  options.alignment = Alignment::cells;
  const Georeference plain{{100, 16, 0, 900, 0, -16}, Registration::area};
  for (const char* name : {"chaikin", "b-spline:degree=3"}) {
    const Georeference fine = refined(plain, Refiner<double>(parse_scheme(name), {5, 7}, options));
    EXPECT_EQ(fine.affine, (std::array<double, 6>{100, 1, 0, 900, 0, -1}));
  }
  options.alignment = Alignment::nodes;
  const Georeference nodes =
      refined(plain, Refiner<double>(parse_scheme("gentle"), {5, 7}, options));
  // (1 - 1/16)/2 of a source pixel on each side.
  EXPECT_EQ(nodes.affine, (std::array<double, 6>{107.5, 1, 0, 892.5, 0, -1}));
}

}  // namespace
}  // namespace arete
