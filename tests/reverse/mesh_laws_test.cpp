// SPDX-License-Identifier: MIT
// Laws of reverse subdivision of meshes: shuffled fine meshes come back as their control meshes.
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <set>

#include "arete/reverse/mesh_recover.h"
#include "meshes.h"
#include "rational_grid.h"
#include "same_mesh.h"

namespace arete {
namespace {

using test::relative_difference;

constexpr MeshRule rules[] = {MeshScheme::catmull_clark,
                              {MeshScheme::catmull_clark, MeshRim::sharp_corners},
                              {MeshScheme::catmull_clark, MeshRim::thirds},
                              MeshScheme::loop,
                              {MeshScheme::loop, MeshRim::sharp_corners},
                              MeshScheme::loop_warren,
                              MeshScheme::doo_sabin};
constexpr ReverseMode modes[] = {ReverseMode::local, ReverseMode::least_squares};

using test::expect_same_mesh;
using Mesh = test::PlacedMesh;

Mesh refined(Mesh mesh, MeshRule scheme, int levels) {
  for (int level = 0; level < levels; ++level) {
    auto step = mesh_step<double>(mesh.faces, scheme);
    mesh = {std::move(step.fine), test::subdivided_positions(step, mesh.positions)};
  }
  return mesh;
}

// The same mesh with vertices, faces and first corners in another order.
Mesh shuffled(const Mesh& mesh, unsigned seed) {
  std::mt19937 random(seed);
  std::vector<Index> number(static_cast<std::size_t>(mesh.faces.vertices));
  std::iota(number.begin(), number.end(), Index{0});
  std::shuffle(number.begin(), number.end(), random);
  Mesh result = mesh;
  for (Index v = 0; v < mesh.faces.vertices; ++v)
    std::copy_n(mesh.positions.row(v), 3,
                result.positions.row(number[static_cast<std::size_t>(v)]));
  for (auto& face : result.faces.faces) {
    for (Index& v : face) v = number[static_cast<std::size_t>(v)];
    std::rotate(face.begin(), face.begin() + static_cast<std::ptrdiff_t>(random() % face.size()),
                face.end());
  }
  std::shuffle(result.faces.faces.begin(), result.faces.faces.end(), random);
  return result;
}

TEST(reverse_mesh, shuffled_fine_meshes_come_back_as_their_control_meshes) {
  for (const MeshRule& scheme : rules)
    for (const auto& [name, faces] : test::control_meshes(scheme)) {
      const Mesh control{faces, test::random_positions(faces.vertices, 7)};
      for (const ReverseMode mode : modes)
        for (const int levels : {1, 2, 3}) {
          const std::string what = name + ", " + std::string(to_string(mode)) + ", " +
                                   std::to_string(levels) + " levels";
          Mesh mesh = shuffled(refined(control, scheme, levels), 3);
          for (int level = 0; level < levels; ++level) {
            auto parts = decompose_mesh<double>(mesh.faces, mesh.positions.view(), scheme, mode);
            EXPECT_TRUE(parts.unique) << what;
            for (const double detail : parts.details.samples()) ASSERT_LE(std::abs(detail), 1e-9);
            EXPECT_EQ(reconstruct_mesh(parts).samples(), mesh.positions.samples()) << what;
            EXPECT_EQ(refined_faces(parts.mesh, scheme.scheme), mesh.faces) << what;
            mesh = {std::move(parts.mesh.coarse), std::move(parts.coarse)};
          }
          expect_same_mesh(mesh, control, 1e-10, what);
        }
    }
}

TEST(reverse_mesh, any_data_on_a_subdivided_mesh_come_back_with_their_details) {
  for (const MeshRule& scheme : rules)
    for (const auto& [name, faces] : test::control_meshes(scheme))
      for (const ReverseMode mode : modes) {
        const MeshFaces fine = mesh_step<double>(faces, scheme).fine;
        const Grid<double> any = test::random_positions(fine.vertices, 5);
        const auto parts = decompose_mesh<double>(fine, any.view(), scheme, mode);
        EXPECT_EQ(reconstruct_mesh(parts).samples(), any.samples()) << name;
      }
}

// Coordinates of very different size: adding details alone would round the small ones away.
TEST(reverse_mesh, every_bit_comes_back_whatever_the_sizes_of_the_numbers) {
  const MeshFaces fine = mesh_step<double>(test::torus(5, 4, false), rules[0]).fine;
  Grid<double> any = test::random_positions(fine.vertices, 5);
  for (Index v = 0; v < fine.vertices; ++v)
    for (Index c = 0; c < 3; ++c)
      any(v, c) *= std::pow(10.0, static_cast<double>((7 * v) % 13) - 6);
  for (const ReverseMode mode : modes) {
    const auto parts = decompose_mesh<double>(fine, any.view(), rules[0], mode);
    EXPECT_EQ(reconstruct_mesh(parts).samples(), any.samples());
    EXPECT_GT(std::count_if(parts.remainder.samples().begin(), parts.remainder.samples().end(),
                            [](double r) { return r != 0; }),
              0)
        << "the test is too easy";
  }
}

TEST(reverse_mesh, the_rule_at_the_rim_is_found_by_its_details) {
  for (const MeshRule& rule : rules) {
    if (rule.scheme == MeshScheme::doo_sabin) continue;
    const Mesh control{test::open_grid(4, 5, rule.triangles()), test::random_positions(20, 7)};
    const Mesh fine = shuffled(refined(control, rule, 2), 3);
    for (const ReverseMode mode : modes) {
      const auto parts = decompose_mesh<double>(fine.faces, fine.positions.view(),
                                                candidate_rules(rule.scheme), mode);
      EXPECT_EQ(parts.rule, rule) << to_string(rule.rim);
      for (const double detail : parts.details.samples()) ASSERT_LE(std::abs(detail), 1e-9);
    }
  }
}

TEST(reverse_mesh, several_parts_are_taken_apart_by_one_rule) {
  for (const MeshRule& rule : rules) {
    const MeshFaces closed = rule.triangles() ? test::bipyramid(5) : test::torus(3, 4, false);
    const MeshFaces open = rule.scheme == MeshScheme::doo_sabin
                               ? test::prism(5)
                               : test::open_grid(3, 4, rule.triangles());
    Mesh control{closed, {}};
    for (auto face : open.faces) {
      for (Index& v : face) v += closed.vertices;
      control.faces.faces.push_back(face);
    }
    control.faces.vertices += open.vertices;
    control.positions = test::random_positions(control.faces.vertices, 4);
    const Mesh fine = shuffled(refined(control, rule, 1), 6);
    const auto parts = decompose_mesh<double>(fine.faces, fine.positions.view(),
                                              candidate_rules(rule.scheme), modes[1]);
    EXPECT_EQ(reconstruct_mesh(parts).samples(), fine.positions.samples());
    EXPECT_EQ(refined_faces(parts.mesh, rule.scheme), fine.faces);
    EXPECT_EQ(parts.rule, rule);
    expect_same_mesh({parts.mesh.coarse, parts.coarse}, control, 1e-10,
                     std::string(to_string(rule.scheme)));
  }
}

double squared(const Grid<double>& grid) {
  double sum = 0;
  for (const double v : grid.samples()) sum += v * v;
  return sum;
}

TEST(reverse_mesh, least_squares_has_the_smallest_details) {
  for (const MeshRule& scheme : rules)
    for (const auto& [name, faces] : test::control_meshes(scheme)) {
      const auto step = mesh_step<double>(faces, scheme);
      const Grid<double> any = test::random_positions(step.fine.vertices, 5);
      const auto residual = [&](const Grid<double>& coarse) {
        Grid<double> fine = test::subdivided_positions(step, coarse);
        for (std::size_t i = 0; i < fine.samples().size(); ++i)
          fine.samples()[i] -= any.samples()[i];
        return squared(fine);
      };
      const auto best =
          reverse_mesh_step<double>(faces, scheme, any.view(), ReverseMode::least_squares);
      const auto local = reverse_mesh_step<double>(faces, scheme, any.view(), ReverseMode::local);
      const double least = residual(best.positions);
      EXPECT_LE(least, residual(local.positions) * (1 + 1e-12)) << name;
      for (std::size_t i = 0; i < best.positions.samples().size(); ++i) {
        Grid<double> moved = best.positions;
        moved.samples()[i] += 0.1;
        EXPECT_GT(residual(moved), least) << name;
      }
    }
}

TEST(reverse_mesh, a_cube_is_found_up_to_what_cannot_be_seen) {
  for (const MeshFaces& faces : {test::prism(4), test::prism(6), test::prism(8)}) {
    const Mesh control{faces, test::random_positions(faces.vertices, 2)};
    const auto patterns = invisible_patterns(faces, MeshScheme::catmull_clark);
    ASSERT_EQ(patterns.size(), 1u);
    const Mesh fine = refined(control, MeshScheme::catmull_clark, 1);
    // The pattern changes no fine point.
    Mesh other = control;
    for (Index v = 0; v < faces.vertices; ++v)
      other.positions(v, 0) += 3 * patterns[0][static_cast<std::size_t>(v)];
    EXPECT_LE(
        relative_difference(refined(other, MeshScheme::catmull_clark, 1).positions, fine.positions),
        1e-14);
    for (const ReverseMode mode : modes) {
      const auto parts = decompose_mesh<double>(fine.faces, fine.positions.view(),
                                                MeshScheme::catmull_clark, mode);
      EXPECT_FALSE(parts.unique);
      EXPECT_LE(squared(parts.details), 1e-20);
      EXPECT_LE(squared(parts.coarse), squared(control.positions));
      const auto found = invisible_patterns(parts.mesh.coarse, MeshScheme::catmull_clark);
      for (Index c = 0; c < 3; ++c) {
        double along = 0;
        for (Index v = 0; v < faces.vertices; ++v)
          along += parts.coarse(v, c) * found[0][static_cast<std::size_t>(v)];
        EXPECT_NEAR(along, 0, 1e-11);
      }
    }
    // The others are no help to it: Doo-Sabin sees everything.
    EXPECT_TRUE(invisible_patterns(faces, MeshScheme::doo_sabin).empty());
  }
}

void expect_refused(const MeshFaces& mesh, MeshScheme scheme, const std::string& part) {
  const Grid<double> positions = test::random_positions(mesh.vertices, 1);
  try {
    (void)decompose_mesh<double>(mesh, positions.view(), scheme, ReverseMode::local);
    ADD_FAILURE() << "accepted; expected '" << part << "'";
  } catch (const InvalidField& error) {
    EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
  }
}

TEST(reverse_mesh, meshes_without_subdivision_structure_are_refused_with_the_reason) {
  const auto cc = MeshScheme::catmull_clark;
  const auto loop = MeshScheme::loop;
  const auto ds = MeshScheme::doo_sabin;
  for (const MeshScheme scheme : {cc, loop, ds}) {
    expect_refused(test::prism(5), scheme, "does not have the structure");
    expect_refused(test::tetrahedron(), scheme, "does not have the structure");
  }
  expect_refused(test::torus(3, 5, false), cc, "does not have the structure");
  expect_refused(test::torus(5, 5, true), loop, "does not have the structure");
  expect_refused(test::open_grid(4, 4, false), cc, "does not have the structure");
  expect_refused(test::open_grid(5, 5, false), ds, "boundary");
  // One quad of a subdivided mesh turned into two triangles, or one removed.
  Mesh fine = refined({test::prism(5), test::random_positions(10, 1)}, cc, 1);
  MeshFaces split = fine.faces;
  const auto quad = split.faces.back();
  split.faces.back() = {quad[0], quad[1], quad[2]};
  split.faces.push_back({quad[0], quad[2], quad[3]});
  expect_refused(split, cc, "does not have the structure");
  MeshFaces holed = fine.faces;
  holed.faces.pop_back();
  expect_refused(holed, cc, "does not have the structure");
  // What is no mesh at all.
  expect_refused({4, {{0, 1, 2}, {0, 1, 3}}}, loop, "the same way");
  expect_refused({4, {{0, 1, 2}}}, loop, "vertex 3 is in no face");
  expect_refused({3, {{0, 1, 3}}}, loop, "names vertex 3");
  expect_refused({3, {{0, 1, 1}}}, loop, "twice");
  expect_refused({3, {{0, 1}}}, loop, "needs three");
  expect_refused({5, {{0, 1, 2}, {0, 3, 4}}}, loop, "do not hang together");
  // The first obstacle is named.
  expect_refused(test::tetrahedron(), cc, "face 0 has 3 corners, not 4");
  expect_refused(test::torus(3, 5, false), cc, "odd number of edges");
  expect_refused(test::prism(4), loop, "face 0 has 4 corners, not 3");
  expect_refused(test::bipyramid(7), ds, "vertex 7 has valence 7");
  expect_refused(test::open_grid(3, 4, false), cc, "vertex ");
  const Grid<double> few = test::random_positions(3, 1);
  EXPECT_THROW((void)decompose_mesh<double>(test::tetrahedron(), few.view(), cc, modes[0]),
               InvalidField);
  EXPECT_THROW((void)reverse_mesh_step<double>(test::tetrahedron(), cc, few.view(), modes[0]),
               InvalidField);
  EXPECT_THROW((void)mesh_step<double>(test::prism(4), loop), InvalidField);
  EXPECT_THROW((void)mesh_step<Rational>(test::prism(5), ds), InvalidField);  // cos(2 pi/5)
  EXPECT_THROW((void)recover_coarse({6, {{0, 1, 2}, {3, 4, 5}}}, loop), InvalidField);
}

TEST(reverse_mesh, noise_gains_on_tori_are_those_of_the_specification) {
  const auto gain = [](MeshScheme scheme, ReverseMode mode) {
    const MeshFaces faces = test::torus(8, 8, scheme == MeshScheme::loop);
    const Index fine = mesh_step<double>(faces, scheme).s.rows();
    Grid<double> impulses({fine, fine});
    for (Index i = 0; i < fine; ++i) impulses(i, i) = 1;
    return std::sqrt(
        squared(reverse_mesh_step<double>(faces, scheme, impulses.view(), mode).positions) /
        static_cast<double>(faces.vertices));
  };
  EXPECT_NEAR(gain(MeshScheme::catmull_clark, modes[0]), 4.50, 0.01);
  EXPECT_NEAR(gain(MeshScheme::loop, modes[0]), 2.57, 0.01);
  EXPECT_NEAR(gain(MeshScheme::doo_sabin, modes[0]), 1.25, 0.01);
  EXPECT_NEAR(gain(MeshScheme::catmull_clark, modes[1]), 1.60, 0.15);
  EXPECT_NEAR(gain(MeshScheme::loop, modes[1]), 1.11, 0.05);
  EXPECT_NEAR(gain(MeshScheme::doo_sabin, modes[1]), 1.03, 0.05);
}

}  // namespace
}  // namespace arete
