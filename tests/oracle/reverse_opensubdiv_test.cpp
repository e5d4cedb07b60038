// SPDX-License-Identifier: MIT
// Meshes that OpenSubdiv subdivided come back as their control meshes.
#include <gtest/gtest.h>

#include "arete/opensubdiv/subdivide_mesh.h"
#include "arete/reverse/mesh_levels.h"
#include "reverse/meshes.h"
#include "reverse/same_mesh.h"

namespace arete {
namespace {

TEST(reverse_of_opensubdiv, gives_the_control_mesh_back) {
  for (const MeshRule rule : {MeshRule(MeshScheme::catmull_clark),
                              {MeshScheme::catmull_clark, MeshRim::sharp_corners},
                              MeshRule(MeshScheme::loop),
                              {MeshScheme::loop, MeshRim::sharp_corners}})
    for (const auto& [name, faces] : test::control_meshes(rule)) {
      const test::PlacedMesh control{faces, test::random_positions(faces.vertices, 11)};
      for (const int levels : {1, 2, 3}) {
        const auto fine = opensubdiv::subdivide({control.faces, control.positions}, rule, levels);
        for (const ReverseMode mode : {ReverseMode::local, ReverseMode::least_squares}) {
          const auto steps = decompose_mesh_levels(fine.faces, fine.positions.view(),
                                                   candidate_rules(rule.scheme), mode, levels);
          test::expect_same_mesh({steps.back().mesh.coarse, steps.back().coarse}, control, 1e-10,
                                 name + ", " + std::to_string(levels) + " levels, " +
                                     std::string(to_string(rule.scheme)));
        }
      }
    }
}

// Loop's weights and Warren's differ where the valence is neither 3 nor 6.
TEST(reverse_of_opensubdiv, has_loops_own_weights) {
  const MeshFaces faces = test::bipyramid(7);
  const auto fine = opensubdiv::subdivide({faces, test::random_positions(faces.vertices, 11)},
                                          MeshScheme::loop, 1);
  const auto longest = [&](MeshScheme scheme) {
    const auto parts =
        decompose_mesh<double>(fine.faces, fine.positions.view(), scheme, ReverseMode::local);
    double longest = 0;
    for (const double detail : parts.details.samples())
      longest = std::max(longest, std::abs(detail));
    return longest;
  };
  EXPECT_LE(longest(MeshScheme::loop), 1e-12);
  EXPECT_GT(longest(MeshScheme::loop_warren), 1e-2);
}

}  // namespace
}  // namespace arete
