// SPDX-License-Identifier: MIT
#include "arete/openmesh/mesh_io.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>

#include "arete/scheme/catalogue.h"
#include "arete/topology/not_a_grid.h"
#include "topology/meshes.h"

namespace arete {
namespace {

using openmesh::MeshData;
using openmesh::MeshFileError;

std::string scratch(const std::string& name) {
  return ::testing::TempDir() + "arete_mesh_io_" + name;
}

std::string written(const std::string& name, const std::string& text) {
  std::ofstream(scratch(name)) << text;
  return scratch(name);
}

MeshData terrain() {
  const test::Mesh mesh = test::shuffled(test::terrain_mesh(4, 5), 2);
  MeshData data;
  data.points = mesh.points;
  data.faces = mesh.faces;
  return data;
}

template <class F>
std::string message(F&& work) {
  try {
    work();
  } catch (const std::exception& error) {
    return error.what();
  }
  return "";
}

TEST(openmesh_io, quads_and_positions_survive_to_the_last_bit) {
  MeshData data = terrain();
  for (const char* name : {"a.obj", "a.off", "a.ply", "A.PLY"}) {
    openmesh::write_mesh(scratch(name), data);
    const MeshData back = openmesh::read_mesh(scratch(name));
    EXPECT_EQ(back.points, data.points) << name;
    EXPECT_EQ(back.faces.corners, data.faces.corners) << name;
    EXPECT_EQ(back.faces.starts, data.faces.starts) << name;
    std::filesystem::remove(scratch(name));
  }
}

TEST(openmesh_io, stl_has_triangles_with_shared_vertices) {
  openmesh::write_mesh(scratch("a.stl"), terrain());
  const MeshData back = openmesh::read_mesh(scratch("a.stl"));
  EXPECT_EQ(back.points.size(), 20u);
  EXPECT_EQ(back.faces.count(), 24);
  const MeshData fine =
      openmesh::refine_mesh(back, parse_scheme("four-point"), parse_scheme("four-point"), {});
  EXPECT_EQ(fine.points.size(), 63u);
  std::filesystem::remove(scratch("a.stl"));
}

TEST(openmesh_io, colours_and_texcoords_survive) {
  MeshData data = terrain();
  for (std::size_t v = 0; v < data.points.size(); ++v) {
    data.colors.push_back({static_cast<std::uint8_t>(v), 7, 255, 128});
    data.texcoords.push_back({static_cast<float>(v) / 8, 0.5f});
  }
  openmesh::write_mesh(scratch("b.ply"), data);
  MeshData back = openmesh::read_mesh(scratch("b.ply"));
  ASSERT_EQ(back.colors.size(), data.colors.size());
  EXPECT_EQ(back.colors, data.colors);
  EXPECT_EQ(back.texcoords, data.texcoords);

  openmesh::write_mesh(scratch("b.off"), data);
  back = openmesh::read_mesh(scratch("b.off"));
  EXPECT_EQ(back.colors, data.colors);
  EXPECT_EQ(back.texcoords, data.texcoords);

  data = terrain();
  for (int corner : data.faces.corners)
    data.corner_texcoords.push_back({static_cast<float>(corner) / 4, 0.25f});
  data.corner_texcoords[3] = {9, 9};
  openmesh::write_mesh(scratch("b.obj"), data);
  back = openmesh::read_mesh(scratch("b.obj"));
  EXPECT_EQ(back.corner_texcoords, data.corner_texcoords);
  for (const char* name : {"b.ply", "b.off", "b.obj"}) std::filesystem::remove(scratch(name));
}

TEST(openmesh_io, normals_survive_and_are_made_anew_by_refinement) {
  MeshData data = terrain();
  for (std::size_t v = 0; v < data.points.size(); ++v)
    data.normals.push_back({0.25f * static_cast<float>(v), 0, 1});
  for (const char* name : {"n.obj", "n.ply", "n.off"}) {
    openmesh::write_mesh(scratch(name), data);
    EXPECT_EQ(openmesh::read_mesh(scratch(name)).normals, data.normals) << name;
    std::filesystem::remove(scratch(name));
  }
  const Scheme scheme = parse_scheme("gentle");
  const MeshData fine = openmesh::refine_mesh(data, scheme, scheme, {});
  ASSERT_EQ(fine.normals.size(), fine.points.size());
  for (const auto& n : fine.normals) EXPECT_NEAR(n[0] * n[0] + n[1] * n[1] + n[2] * n[2], 1, 1e-6);
  EXPECT_TRUE(openmesh::refine_mesh(terrain(), scheme, scheme, {}).normals.empty());
  EXPECT_EQ(openmesh::refine_mesh(data, scheme, scheme, {.levels = 0}).normals, data.normals);
}

TEST(openmesh_io, texture_coordinates_of_corners_go_where_the_format_has_a_place) {
  MeshData data = terrain();
  for (int v : data.faces.corners) {
    const Point3& p = data.points[static_cast<std::size_t>(v)];
    data.corner_texcoords.push_back({static_cast<float>(p[0]), static_cast<float>(p[1])});
  }
  EXPECT_TRUE(openmesh::is_seamless(data));
  openmesh::write_mesh(scratch("w.ply"), data);
  EXPECT_EQ(openmesh::read_mesh(scratch("w.ply")).corner_texcoords, data.corner_texcoords);
  openmesh::write_mesh(scratch("w.off"), data);
  const MeshData back = openmesh::read_mesh(scratch("w.off"));
  for (std::size_t v = 0; v < back.points.size(); ++v)
    EXPECT_EQ(back.texcoords.at(v)[0], static_cast<float>(back.points[v][0]));
  data.corner_texcoords[5] = {7, 7};
  EXPECT_FALSE(openmesh::is_seamless(data));
  openmesh::write_mesh(scratch("w.off"), data);
  EXPECT_TRUE(openmesh::read_mesh(scratch("w.off")).texcoords.empty());
  std::filesystem::remove(scratch("w.ply"));
  std::filesystem::remove(scratch("w.off"));
}

TEST(openmesh_io, comments_single_precision_and_progress) {
  openmesh::MeshOutput output;
  output.comments = {"metres east\nand north"};
  output.single_precision = true;
  double told = 0;
  output.progress = [&](double share) { told = share; };
  for (const char* name : {"c.obj", "c.ply", "c.off"}) {
    openmesh::write_mesh(scratch(name), terrain(), output);
    EXPECT_EQ(told, 1) << name;
    const MeshData back = openmesh::read_mesh(scratch(name));
    EXPECT_EQ(back.faces.count(), 12) << name;
    for (std::size_t v = 0; v < back.points.size(); ++v)
      for (std::size_t k = 0; k < 3; ++k)
        EXPECT_EQ(static_cast<float>(back.points[v][k]), static_cast<float>(terrain().points[v][k]))
            << name;
    std::ifstream stream(scratch(name), std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(stream), {}};
    EXPECT_NE(bytes.find(" metres east and north\n"), std::string::npos) << name;
    std::filesystem::remove(scratch(name));
  }
}

TEST(openmesh_io, the_size_is_known_before_and_a_vertex_that_is_not_finite_is_named) {
  MeshData data = terrain();
  const Scheme scheme = parse_scheme("chaikin");
  const auto size = openmesh::refined_size(data, scheme, scheme, {.levels = 2});
  const MeshData fine = openmesh::refine_mesh(data, scheme, scheme, {.levels = 2});
  EXPECT_EQ(size.vertices, static_cast<double>(fine.points.size()));
  EXPECT_EQ(size.faces, fine.faces.count());
  ASSERT_EQ(size.patches.size(), 1u);
  EXPECT_EQ(size.patches[0].coarse, (Extent{4, 5}));
  EXPECT_EQ(size.patches[0].fine.rows * size.patches[0].fine.cols, std::ssize(fine.points));
  data.points[7][1] = std::nan("");
  EXPECT_NE(
      message([&] { (void)openmesh::refine_mesh(data, scheme, scheme, {}); }).find("vertex 7"),
      std::string::npos);
}

TEST(openmesh_io, ply_properties_nobody_knows_are_skipped) {
  const std::string path =
      written("k.ply",
              "ply\nformat ascii 1.0\nelement vertex 4\nproperty double x\nproperty double y\n"
              "property float quality\nproperty double z\nelement face 1\n"
              "property list uchar int vertex_indices\nproperty int label\nend_header\n"
              "0 0 7 1\n1 0 7 2\n1 1 7 3\n0 1 7 0.1\n4 0 1 2 3 5\n");
  const MeshData data = openmesh::read_mesh(path);
  ASSERT_EQ(data.points.size(), 4u);
  EXPECT_EQ(data.points[3], (Point3{0, 1, 0.1}));
  EXPECT_EQ(data.faces.corners, (std::vector<int>{0, 1, 2, 3}));
  std::filesystem::remove(path);
}

TEST(openmesh_io, obj_is_read_with_its_quirks) {
  const std::string path = written(
      "q.obj",
      "# a quad in UTM\r\no name\nv 500000.123456789 5400000.5 1e2\nv 1 0 0\nv 1 1 0 1 0 0.5\n"
      "vn 0 0 1\nvt 0.5 1\nv +0 1 .5\nf 1/1/1 2//1 \\\n 3 -1\n");
  const MeshData data = openmesh::read_mesh(path);
  ASSERT_EQ(data.points.size(), 4u);
  EXPECT_EQ(data.points[0], (Point3{500000.123456789, 5400000.5, 100}));
  EXPECT_EQ(data.points[3], (Point3{0, 1, 0.5}));
  EXPECT_EQ(data.faces.corners, (std::vector<int>{0, 1, 2, 3}));
  EXPECT_EQ(data.corner_texcoords[0], (std::array<float, 2>{0.5f, 1}));
  EXPECT_EQ(data.colors[2], (std::array<std::uint8_t, 4>{255, 0, 128, 255}));
  std::filesystem::remove(path);
  const std::string bad = written("bad.obj", "v 0 0 0\nv 1 0 0\nf 1 2 3\n");
  EXPECT_NE(
      message([&] { (void)openmesh::read_mesh(bad); }).find("line 3: a face names vertex 3 of 2"),
      std::string::npos);
  std::filesystem::remove(bad);
}

TEST(openmesh_io, ply_elements_that_nothing_bounds_or_that_come_twice_are_refused) {
  const std::string head = "ply\nformat ascii 1.0\n";
  const std::string vertex =
      "element vertex 1\nproperty float x\nproperty float y\nproperty float z\n";
  for (const auto& [text, reason] : std::vector<std::pair<std::string, std::string>>{
           {head + "element vertex 1000000000000\nend_header\n", "has no property"},
           {head + vertex + "element note 1000000000000\nend_header\n0 0 0\n", "has no property"},
           {head + vertex + "property uchar red\n" + vertex + "end_header\n0 0 0 1\n0 0 0\n",
            "vertex is there twice"}}) {
    const std::string path = written("twice.ply", text);
    EXPECT_NE(message([&] { (void)openmesh::read_mesh(path); }).find(reason), std::string::npos)
        << text;
    std::filesystem::remove(path);
  }
}

TEST(openmesh_io, big_endian_ply_and_text_stl_are_read) {
  std::string bytes =
      "ply\nformat binary_big_endian 1.0\nelement vertex 1\nproperty float x\n"
      "property short y\nproperty uchar z\nend_header\n";
  bytes += std::string("\x3f\x80\x00\x00\xff\xfe\x07", 7);
  const MeshData data = openmesh::read_mesh(written("be.ply", bytes));
  EXPECT_EQ(data.points.at(0), (Point3{1, -2, 7}));
  std::filesystem::remove(scratch("be.ply"));
  const MeshData text = openmesh::read_mesh(
      written("t.stl",
              "solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n"
              "vertex 0 1 0\nendloop\nendfacet\nfacet normal 0 0 1\nouter loop\n"
              "vertex 1 0 0\nvertex 1 1 0\nvertex -0 1 0\nendloop\nendfacet\nendsolid\n"));
  EXPECT_EQ(text.points.size(), 4u);
  EXPECT_EQ(text.faces.count(), 2);
  std::filesystem::remove(scratch("t.stl"));
}

TEST(openmesh_io, a_file_cut_short_anywhere_is_refused_or_read_in_part_but_never_crashes) {
  for (const char* name : {"s.obj", "s.off", "s.ply", "s.stl"}) {
    openmesh::write_mesh(scratch(name), terrain());
    std::ifstream stream(scratch(name), std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(stream), {}};
    int refused = 0;
    for (std::size_t size = 0; size < bytes.size(); size += 7) {
      written(name, bytes.substr(0, size));
      try {
        (void)openmesh::read_mesh(scratch(name));
      } catch (const MeshFileError&) {
        ++refused;
      }
    }
    // OBJ says nothing about how long it is.
    EXPECT_GT(refused,
              name[2] == 'o' && name[3] == 'b' ? 1 : static_cast<int>(bytes.size() / 7) - 2)
        << name;
    std::filesystem::remove(scratch(name));
  }
}

TEST(openmesh_io, what_is_not_manifold_is_read_as_it_stands) {
  const std::string path = written("c.off",
                                   "OFF\n6 3 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n1 0 1\n"
                                   "4 0 1 2 3\n4 1 0 4 5\n4 0 1 5 4\n");
  const MeshData data = openmesh::read_mesh(path);
  EXPECT_EQ(data.faces.count(), 3);
  const std::string said = message([&] {
    (void)openmesh::refine_mesh(data, parse_scheme("gentle"), parse_scheme("gentle"), {});
  });
  EXPECT_NE(said.find("face 2"), std::string::npos) << said;
  std::filesystem::remove(path);
}

TEST(openmesh_io, attributes_are_refined_with_the_mesh) {
  MeshData data = terrain();
  for (const Point3& p : data.points) {
    data.texcoords.push_back({static_cast<float>(p[0]) / 4, static_cast<float>(p[1]) / 4});
    data.colors.push_back({static_cast<std::uint8_t>(40 * p[0]), 9, 9, 255});
  }
  const Scheme scheme = parse_scheme("dubuc-deslauriers:points=6");
  const MeshData fine = openmesh::refine_mesh(data, scheme, scheme, {2, {}, 2});
  ASSERT_EQ(fine.points.size(), 13u * 17u);
  EXPECT_EQ(fine.faces.count(), 12 * 16);
  for (std::size_t v = 0; v < fine.points.size(); ++v) {
    EXPECT_NEAR(fine.texcoords[v][0], fine.points[v][0] / 4, 1e-6);
    EXPECT_NEAR(fine.texcoords[v][1], fine.points[v][1] / 4, 1e-6);
    EXPECT_EQ(fine.colors[v][0], std::lround(40 * fine.points[v][0]));
    EXPECT_EQ(fine.colors[v][3], 255);
  }
}

TEST(openmesh_io, errors_name_the_file_and_the_remedy) {
  EXPECT_NE(message([] { (void)openmesh::read_mesh("/nowhere/x.obj"); }).find("/nowhere/x.obj"),
            std::string::npos);
  EXPECT_NE(message([] { (void)openmesh::read_mesh("x.vtk"); }).find(".obj, .ply, .off or .stl"),
            std::string::npos);
  EXPECT_NE(message([] { openmesh::write_mesh("/nowhere/x.obj", terrain()); }).find("cannot write"),
            std::string::npos);
  for (const char* name : {"d.off", "d.ply", "d.obj", "d.stl"}) {
    const std::string path = written(name, "this is no mesh\n");
    EXPECT_THROW((void)openmesh::read_mesh(path), MeshFileError) << name;
    std::filesystem::remove(path);
  }
  EXPECT_TRUE(openmesh::is_mesh_file("A/b.OBJ"));
  EXPECT_FALSE(openmesh::is_mesh_file("obj"));
  EXPECT_FALSE(openmesh::is_mesh_file("a.obj/b"));
}

TEST(openmesh_io, a_format_may_be_named_for_another_file_name) {
  openmesh::write_mesh(scratch("e.tmp"), terrain(), {.format = "ply"});
  std::filesystem::rename(scratch("e.tmp"), scratch("e.ply"));
  EXPECT_EQ(openmesh::read_mesh(scratch("e.ply")).points, terrain().points);
  std::filesystem::remove(scratch("e.ply"));
}

}  // namespace
}  // namespace arete
