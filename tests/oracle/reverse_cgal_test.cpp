// SPDX-License-Identifier: MIT
// Meshes that CGAL subdivided come back as their control meshes.
#include <gtest/gtest.h>

#include "arete/cgal/subdivide_mesh.h"
#include "arete/reverse/mesh_levels.h"
#include "reverse/meshes.h"
#include "reverse/same_mesh.h"

namespace arete {
namespace {

TEST(reverse_of_cgal, gives_the_control_mesh_back) {
  for (const MeshScheme scheme :
       {MeshScheme::catmull_clark, MeshScheme::loop, MeshScheme::doo_sabin})
    for (const auto& [name, faces] : test::control_meshes(scheme)) {
      const test::PlacedMesh control{faces, test::random_positions(faces.vertices, 12)};
      for (const int levels : {1, 2, 3}) {
        const auto fine = cgal::subdivide({control.faces, control.positions}, scheme, levels);
        for (const ReverseMode mode : {ReverseMode::local, ReverseMode::least_squares}) {
          const auto steps = decompose_mesh_levels(fine.faces, fine.positions.view(),
                                                   candidate_rules(scheme), mode, levels);
          test::expect_same_mesh(
              {steps.back().mesh.coarse, steps.back().coarse}, control, 1e-10,
              name + ", " + std::to_string(levels) + " levels, " + std::string(to_string(scheme)));
        }
      }
    }
}

}  // namespace
}  // namespace arete
