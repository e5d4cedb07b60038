// SPDX-License-Identifier: MIT
// Meshes in plain arrays taken apart, their details file, and back.
#include "arete/openmesh/reverse_mesh.h"

#include <gtest/gtest.h>

#include <random>

#include "reverse/meshes.h"

namespace arete {
namespace {

using openmesh::MeshData;

// A mesh refined twice with anything attached and its faces begun anywhere.
MeshData sample_mesh(MeshScheme scheme) {
  MeshFaces faces = scheme == MeshScheme::doo_sabin
                        ? test::prism(5)
                        : test::open_grid(3, 4, MeshRule(scheme).triangles());
  // Subdivided positions, disturbed: of arbitrary ones several control meshes may be as good.
  Grid<double> positions = test::random_positions(faces.vertices, 6);
  for (int level = 0; level < 2; ++level) {
    auto step = mesh_step<double>(faces, scheme);
    positions = test::subdivided_positions(step, positions);
    faces = std::move(step.fine);
  }
  std::mt19937 random(4);
  const Grid<double> noise = test::random_positions(faces.vertices, 7);
  for (std::size_t i = 0; i < noise.samples().size(); ++i)
    positions.samples()[i] += noise.samples()[i] / 50;
  MeshData mesh;
  for (Index v = 0; v < faces.vertices; ++v) {
    mesh.points.push_back({positions(v, 0), positions(v, 1), positions(v, 2)});
    const auto byte = [&] { return static_cast<std::uint8_t>(random()); };
    mesh.colors.push_back({byte(), byte(), byte(), byte()});
    mesh.texcoords.push_back({static_cast<float>(random()), 0.5F});
  }
  std::shuffle(faces.faces.begin(), faces.faces.end(), random);
  for (auto& face : faces.faces) {
    std::rotate(face.begin(), face.begin() + static_cast<std::ptrdiff_t>(random() % 3), face.end());
    std::vector<int> corners(face.begin(), face.end());
    mesh.faces.add(corners);
    for (std::size_t i = 0; i < corners.size(); ++i)
      mesh.corner_texcoords.push_back({static_cast<float>(random() % 1000), 0.25F});
  }
  return mesh;
}

void expect_same(const MeshData& a, const MeshData& b) {
  EXPECT_EQ(a.points, b.points);
  EXPECT_EQ(a.faces.corners, b.faces.corners);
  EXPECT_EQ(a.faces.starts, b.faces.starts);
  EXPECT_EQ(a.colors, b.colors);
  EXPECT_EQ(a.texcoords, b.texcoords);
  EXPECT_EQ(a.corner_texcoords, b.corner_texcoords);
}

constexpr MeshScheme schemes[] = {MeshScheme::catmull_clark, MeshScheme::loop,
                                  MeshScheme::loop_warren, MeshScheme::doo_sabin};

TEST(reverse_mesh_data, everything_comes_back_bit_for_bit_through_the_bytes_of_a_file) {
  for (const MeshScheme scheme : schemes)
    for (const ReverseMode mode : {ReverseMode::local, ReverseMode::least_squares}) {
      const MeshData mesh = sample_mesh(scheme);
      const auto done = openmesh::coarsen_mesh(mesh, {scheme, {}, mode, 2, {}, {}});
      EXPECT_EQ(done.coarse.colors.size(), done.coarse.points.size());
      EXPECT_EQ(done.coarse.corner_texcoords.size(), done.coarse.faces.corners.size());
      EXPECT_EQ(done.error.largest, 0);
      EXPECT_GT(done.count.kept, done.count.all / 2);
      const MeshDetailsFile again = decode_mesh_details(encode_mesh_details(done.details));
      expect_same(openmesh::restore_mesh(done.coarse, again, 2), mesh);
      // A level at a time is the same as one level taken apart.
      const auto once = openmesh::coarsen_mesh(mesh, {scheme, done.rule.rim, mode, 1, {}, {}});
      expect_same(openmesh::restore_mesh(done.coarse, again, 1), once.coarse);
      expect_same(openmesh::restore_mesh(done.coarse, again, 0), done.coarse);
    }
}

TEST(reverse_mesh_data, attributes_are_handed_over_and_not_filtered) {
  const MeshData mesh = sample_mesh(MeshScheme::loop);
  const auto done =
      openmesh::coarsen_mesh(mesh, {MeshScheme::loop, {}, ReverseMode::local, 1, {}, {}});
  for (std::size_t v = 0; v < done.coarse.points.size(); ++v) {
    const auto place = static_cast<std::size_t>(done.details.levels[0].place[v]);
    EXPECT_EQ(done.coarse.colors[v], mesh.colors[place]);
    EXPECT_EQ(done.coarse.texcoords[v], mesh.texcoords[place]);
  }
}

TEST(reverse_mesh_data, thresholds_do_what_they_say) {
  const MeshData mesh = sample_mesh(MeshScheme::catmull_clark);
  const auto coarsened = [&](std::optional<double> threshold, std::optional<double> target) {
    return openmesh::coarsen_mesh(mesh, {MeshScheme::catmull_clark, MeshRim::smooth,
                                         ReverseMode::least_squares, 2, threshold, target});
  };
  const auto lossless = coarsened({}, {});
  for (const double threshold : {0.05, 0.2, 1e9}) {
    const auto lossy = coarsened(threshold, {});
    // Counted apart: the details longer than the threshold.
    Index longer = 0;
    for (const auto& level : lossless.details.levels)
      for (Index i = 0; i < level.details.rows(); ++i)
        longer +=
            std::hypot(level.details(i, 0), level.details(i, 1), level.details(i, 2)) > threshold
                ? 1
                : 0;
    EXPECT_EQ(lossy.count.kept, longer);
    const MeshDetailsFile again = decode_mesh_details(encode_mesh_details(lossy.details));
    EXPECT_TRUE(again.lossy);
    const MeshData back = openmesh::restore_mesh(lossy.coarse, again, 2);
    double sum = 0;
    double largest = 0;
    for (std::size_t v = 0; v < mesh.points.size(); ++v) {
      double squared = 0;
      for (std::size_t k = 0; k < 3; ++k)
        squared += std::pow(back.points[v][k] - mesh.points[v][k], 2);
      sum += squared;
      largest = std::max(largest, std::sqrt(squared));
    }
    EXPECT_NEAR(lossy.error.rmse, std::sqrt(sum / static_cast<double>(mesh.points.size())), 1e-9);
    EXPECT_NEAR(lossy.error.largest, largest, 1e-9);
    EXPECT_EQ(back.colors, mesh.colors);
  }
  const auto target = coarsened({}, 0.1);
  EXPECT_LE(target.error.rmse, 0.1);
  EXPECT_GT(target.error.rmse, 0.05);
  EXPECT_LT(target.count.kept, lossless.count.kept);
  EXPECT_THROW((void)coarsened(-1.0, {}), InvalidField);
}

TEST(reverse_mesh_data, another_coarse_mesh_is_refused_unless_it_was_edited) {
  const MeshData mesh = sample_mesh(MeshScheme::catmull_clark);
  const auto done = openmesh::coarsen_mesh(
      mesh, {MeshScheme::catmull_clark, {}, ReverseMode::least_squares, 2, {}, {}});
  MeshData moved = done.coarse;
  for (Point3& p : moved.points) p[1] += 2;
  EXPECT_THROW((void)openmesh::restore_mesh(moved, done.details, 2), InvalidDetails);
  const MeshData back = openmesh::restore_mesh(moved, done.details, 2, true);
  for (std::size_t v = 0; v < mesh.points.size(); ++v)
    EXPECT_NEAR(back.points[v][1], mesh.points[v][1] + 2, 1e-11);
  MeshData turned = done.coarse;
  std::swap(turned.faces.corners[0], turned.faces.corners[1]);
  EXPECT_THROW((void)openmesh::restore_mesh(turned, done.details, 2, true), InvalidDetails);
  MeshData bare = done.coarse;
  bare.colors.clear();
  EXPECT_THROW((void)openmesh::restore_mesh(bare, done.details, 2), InvalidDetails);
  EXPECT_THROW((void)openmesh::restore_mesh(done.coarse, done.details, 3), InvalidField);
  MeshData nan = mesh;
  nan.points[3][2] = std::nan("");
  EXPECT_THROW((void)openmesh::coarsen_mesh(nan, {MeshScheme::catmull_clark, {}, {}, 1, {}, {}}),
               InvalidField);
}

// What the checksum cannot catch must be caught by the structure, or be harmless numbers.
TEST(reverse_mesh_data, changed_details_never_crash_a_restoration) {
  const MeshData mesh = sample_mesh(MeshScheme::loop);
  const auto done =
      openmesh::coarsen_mesh(mesh, {MeshScheme::loop, {}, ReverseMode::local, 2, {}, {}});
  std::mt19937 random(9);
  int refused = 0;
  for (int round = 0; round < 300; ++round) {
    MeshDetailsFile bad = done.details;
    MeshLevelDetails& level = bad.levels[random() % 2];
    switch (random() % 5) {
      case 0:
        level.place.pop_back();
        break;
      case 1:
        level.faces[random() % level.faces.size()].turn = static_cast<Index>(random());
        break;
      case 2:
        level.faces.pop_back();
        break;
      case 3:
        level.details = Grid<double>({level.details.rows() + 1, 3});
        break;
      default:
        level.attributes[random() % 3].pop_back();
    }
    try {
      (void)openmesh::restore_mesh(done.coarse, bad, 2);
    } catch (const InvalidDetails&) {
      ++refused;
    }
  }
  EXPECT_GT(refused, 250);
}

}  // namespace
}  // namespace arete
