// SPDX-License-Identifier: MIT
#include <cmath>
#include <string>

#include "plugin/openmesh/host_mesh.h"
#include "support/schemes.h"

namespace arete {
namespace {

using openmesh::AttributeRule;
using openmesh::GridSubdividerT;
using test::FloatMesh;
using test::Mesh;
using test::PolyMesh;

struct LabelledTraits : public test::DoubleTraits {
  template <class Base, class Refs>
  struct VertexT : public Base {
    std::string label;
  };
  template <class Base, class Refs>
  struct FaceT : public Base {
    int region = -1;
  };
  VertexAttributes(OpenMesh::Attributes::Normal | OpenMesh::Attributes::Status |
                   OpenMesh::Attributes::TexCoord2D);
  FaceAttributes(OpenMesh::Attributes::Normal);
};

int levels_of(const Scheme& scheme) { return scheme.mask().arity() > 3 ? 1 : 2; }

TEST(openmesh_attributes, linear_fields_are_exact_under_every_scheme) {
  for (const Scheme& scheme : test::sample_schemes()) {
    PolyMesh mesh;
    test::fill(mesh, test::shuffled(test::terrain_mesh(5, 6), 2));
    mesh.request_vertex_texcoords1D();
    mesh.request_vertex_texcoords2D();
    mesh.request_vertex_texcoords3D();
    OpenMesh::VPropHandleT<double> number;
    OpenMesh::VPropHandleT<OpenMesh::Vec3f> vector;
    OpenMesh::VPropHandleT<OpenMesh::Vec6d> long_vector;
    OpenMesh::VPropHandleT<std::array<double, 2>> pair;
    OpenMesh::VPropHandleT<int> integer;
    mesh.add_property(number, "number");
    mesh.add_property(vector, "vector");
    mesh.add_property(long_vector, "long vector");
    mesh.add_property(pair, "pair");
    mesh.add_property(integer, "integer");
    for (auto v : mesh.vertices()) {
      const double x = mesh.point(v)[0];
      const double y = mesh.point(v)[1];
      mesh.set_texcoord1D(v, static_cast<float>(x));
      mesh.set_texcoord2D(v, {x / 8, y / 8});
      mesh.set_texcoord3D(v, OpenMesh::Vec3f(OpenMesh::Vec3d(x, y, x - y)));
      mesh.property(number, v) = 3 * x - 2 * y + 1;
      mesh.property(vector, v) = OpenMesh::Vec3f(OpenMesh::Vec3d(x, y, x + y));
      mesh.property(long_vector, v) = OpenMesh::Vec6d(x, y, 1, 2, x + y, 5);
      mesh.property(pair, v) = {x, y};
      mesh.property(integer, v) = static_cast<int>(3600 * x - 7200 * y);
    }
    // Bilinear attributes sit at the places new points come from: x and y of the mesh are linear,
    // so they say where, unless the scheme does not reproduce them.
    GridSubdividerT<PolyMesh> subdivide(scheme);
    ASSERT_TRUE(subdivide(mesh, static_cast<std::size_t>(levels_of(scheme)), false));
    for (auto v : mesh.vertices()) {
      const double x = mesh.point(v)[0];
      const double y = mesh.point(v)[1];
      EXPECT_NEAR(mesh.texcoord1D(v), x, 1e-6) << scheme.text();
      EXPECT_NEAR(mesh.texcoord2D(v)[0], x / 8, 1e-15);
      EXPECT_NEAR(mesh.texcoord2D(v)[1], y / 8, 1e-15);
      EXPECT_NEAR(mesh.texcoord3D(v)[2], x - y, 1e-6);
      EXPECT_NEAR(mesh.property(number, v), 3 * x - 2 * y + 1, 1e-13);
      EXPECT_NEAR(mesh.property(vector, v)[2], x + y, 1e-6);
      EXPECT_NEAR(mesh.property(long_vector, v)[4], x + y, 1e-13);
      EXPECT_EQ(mesh.property(long_vector, v)[3], 2);
      EXPECT_NEAR(mesh.property(pair, v)[1], y, 1e-14);
      EXPECT_EQ(mesh.property(integer, v), std::lround(3600 * x - 7200 * y));
    }
  }
}

TEST(openmesh_attributes, the_rule_scheme_is_the_rule_of_positions) {
  PolyMesh mesh;
  test::fill(mesh, test::terrain_mesh(5, 6));
  OpenMesh::VPropHandleT<double> height;
  OpenMesh::VPropHandleT<double> other;
  mesh.add_property(height, "height");
  mesh.add_property(other, "other");
  for (auto v : mesh.vertices())
    mesh.property(height, v) = mesh.property(other, v) = mesh.point(v)[2];
  GridSubdividerT<PolyMesh> subdivide("craggy");
  subdivide.rules().by_name["height"] = AttributeRule::scheme;
  ASSERT_TRUE(subdivide(mesh, 2));
  double difference = 0;
  for (auto v : mesh.vertices()) {
    EXPECT_EQ(mesh.property(height, v), mesh.point(v)[2]);
    difference = std::max(difference, std::abs(mesh.property(other, v) - mesh.point(v)[2]));
  }
  EXPECT_GT(difference, 0.05) << "the other property was to be bilinear";
}

TEST(openmesh_attributes, a_constant_colour_stays_constant_under_every_scheme) {
  for (const Scheme& scheme : test::sample_schemes()) {
    for (AttributeRule rule : {AttributeRule::linear, AttributeRule::scheme}) {
      FloatMesh bytes;
      PolyMesh other;
      test::fill(bytes, test::terrain_mesh(4, 5));
      bytes.request_vertex_colors();
      for (auto v : bytes.vertices()) bytes.set_color(v, {255, 0, 77});
      GridSubdividerT<FloatMesh> subdivide(scheme);
      subdivide.rules().colors = rule;
      ASSERT_TRUE(subdivide(bytes, static_cast<std::size_t>(levels_of(scheme))));
      for (auto v : bytes.vertices())
        EXPECT_EQ(bytes.color(v), FloatMesh::Color(255, 0, 77)) << scheme.text();
    }
  }
}

TEST(openmesh_attributes, colours_that_overshoot_are_held_and_never_wrap_round) {
  FloatMesh mesh;
  test::fill(mesh, test::terrain_mesh(6, 6));
  mesh.request_vertex_colors();
  OpenMesh::VPropHandleT<double> exact;
  OpenMesh::VPropHandleT<signed char> small;
  mesh.add_property(exact, "exact");
  mesh.add_property(small, "small");
  for (auto v : mesh.vertices()) {
    const bool bright = (v.idx() / 3) % 2 == 0;
    mesh.set_color(v, bright ? FloatMesh::Color(255, 0, 128) : FloatMesh::Color(0, 255, 128));
    mesh.property(exact, v) = bright ? 255 : 0;
    mesh.property(small, v) = bright ? 127 : -128;
  }
  GridSubdividerT<FloatMesh> subdivide("craggy");
  subdivide.rules().colors = subdivide.rules().custom = AttributeRule::scheme;
  ASSERT_TRUE(subdivide(mesh, 2));
  int overshoots = 0;
  for (auto v : mesh.vertices()) {
    const double x = mesh.property(exact, v);
    // Halves may round either way.
    EXPECT_NEAR(mesh.color(v)[0], std::clamp(x, 0.0, 255.0), 0.5 + 1e-9);
    EXPECT_NEAR(mesh.property(small, v), std::clamp(x - 128, -128.0, 127.0), 0.5 + 1e-9);
    if (x < -0.5 || x > 255.5) ++overshoots;
  }
  EXPECT_GT(overshoots, 50) << "nothing overshot, so nothing was tested";
}

TEST(openmesh_attributes, float_colours_stay_within_one) {
  using ColorMesh = OpenMesh::PolyMesh_ArrayKernelT<OpenMesh::DefaultTraitsDouble>;
  ColorMesh mesh;
  test::fill(mesh, test::terrain_mesh(6, 6));
  mesh.request_vertex_colors();
  for (auto v : mesh.vertices())
    mesh.set_color(
        v, (v.idx() / 3) % 2 ? ColorMesh::Color(1, 0, 0.25f, 1) : ColorMesh::Color(0, 1, 0.25f, 1));
  GridSubdividerT<ColorMesh> subdivide("craggy");
  subdivide.rules().colors = AttributeRule::scheme;
  ASSERT_TRUE(subdivide(mesh, 2));
  for (auto v : mesh.vertices()) {
    for (int k = 0; k < 4; ++k) {
      EXPECT_GE(mesh.color(v)[k], 0);
      EXPECT_LE(mesh.color(v)[k], 1);
    }
    EXPECT_NEAR(mesh.color(v)[2], 0.25, 1e-6);
  }
}

TEST(openmesh_attributes, values_that_are_no_numbers_come_from_the_nearest_vertex) {
  for (const char* name : {"four-point", "chaikin", "ternary-four-point"}) {
    PolyMesh mesh;
    test::fill(mesh, test::shuffled(test::terrain_mesh(4, 5), 5));
    OpenMesh::VPropHandleT<std::string> text;
    OpenMesh::VPropHandleT<bool> flag;
    OpenMesh::VPropHandleT<int> label;
    mesh.add_property(text, "text");
    mesh.add_property(flag, "flag");
    mesh.add_property(label, "label");
    const auto place = [](const OpenMesh::Vec3d& p) {
      return std::to_string(std::lround(p[0])) + "," + std::to_string(std::lround(p[1]));
    };
    for (auto v : mesh.vertices()) {
      mesh.property(text, v) = place(mesh.point(v));
      mesh.property(flag, v) = mesh.point(v)[0] > 2;
      mesh.property(label, v) = static_cast<int>(100 * std::lround(mesh.point(v)[0]));
    }
    GridSubdividerT<PolyMesh> subdivide(name);
    subdivide.rules().by_name["label"] = AttributeRule::nearest;
    ASSERT_TRUE(subdivide(mesh, 2, false));
    for (auto v : mesh.vertices()) {
      const auto& p = mesh.point(v);
      const auto halfway = [](double x) { return std::abs(x - std::floor(x) - 0.5) < 1e-9; };
      if (halfway(p[0]) || halfway(p[1])) continue;
      EXPECT_EQ(mesh.property(text, v), place(p)) << name;
      EXPECT_EQ(mesh.property(flag, v), std::lround(p[0]) > 2);
      EXPECT_EQ(mesh.property(label, v), 100 * std::lround(p[0]));
    }
  }
}

TEST(openmesh_attributes, a_new_vertex_has_the_flags_all_around_it_have) {
  PolyMesh mesh;
  mesh.request_vertex_status();
  test::fill(mesh, test::terrain_mesh(4, 6));
  // Two columns selected, one vertex locked.
  for (auto v : mesh.vertices()) mesh.status(v).set_selected(mesh.point(v)[0] >= 4);
  mesh.status(PolyMesh::VertexHandle(0)).set_locked(true);
  GridSubdividerT<PolyMesh> subdivide("b-spline:degree=3");
  ASSERT_TRUE(subdivide(mesh, 2, false));
  int locked = 0;
  for (auto v : mesh.vertices()) {
    EXPECT_EQ(mesh.status(v).selected(), mesh.point(v)[0] >= 4);
    locked += mesh.status(v).locked();
  }
  EXPECT_EQ(locked, 1);
  EXPECT_TRUE(mesh.status(PolyMesh::VertexHandle(0)).locked());
}

TEST(openmesh_attributes, faces_inherit_from_the_face_they_lie_in) {
  std::mt19937 random(4);
  const Mesh quads = test::terrain_mesh(4, 5);
  const Mesh cut = test::triangulated(quads, [&](int) { return random() % 2 == 0; });
  for (const char* name : {"four-point", "ternary-two-step-9", "b-spline:degree=2"}) {
    for (const Mesh& plain : {quads, cut}) {
      // New cells of a dual scheme lie across old lines, their triangles across old diagonals.
      const bool dual = std::string(name) == "b-spline:degree=2";
      if (dual && plain.faces.count() != quads.faces.count()) continue;
      PolyMesh mesh;
      mesh.request_face_status();
      mesh.request_face_colors();
      test::fill(mesh, test::shuffled(plain, 8));
      OpenMesh::FPropHandleT<std::string> label;
      mesh.add_property(label, "label");
      struct Old {
        std::vector<OpenMesh::Vec3d> corners;
        std::string label;
      };
      std::vector<Old> old;
      for (auto f : mesh.faces()) {
        mesh.property(label, f) = "face " + std::to_string(f.idx());
        mesh.set_color(f, PolyMesh::Color(static_cast<unsigned char>(f.idx())));
        mesh.status(f).set_selected(f.idx() % 3 == 0);
        old.push_back({{}, mesh.property(label, f)});
        for (auto v : f.vertices()) old.back().corners.push_back(mesh.point(v));
      }
      GridSubdividerT<PolyMesh> subdivide(name);
      ASSERT_TRUE(subdivide(mesh, 2, false));
      // The centre of a face in plan lies in its parent, on the same side of every edge.
      for (auto f : mesh.faces()) {
        const int parent = std::stoi(mesh.property(label, f).substr(5));
        const auto centre = mesh.calc_face_centroid(f);
        const auto& corners = old[static_cast<std::size_t>(parent)].corners;
        for (std::size_t i = 0; i < corners.size(); ++i) {
          const auto a = corners[i];
          const auto b = corners[(i + 1) % corners.size()];
          const double side =
              (b[0] - a[0]) * (centre[1] - a[1]) - (b[1] - a[1]) * (centre[0] - a[0]);
          EXPECT_GT(side, -1e-9) << name << ", face " << f.idx() << " of " << parent;
        }
        EXPECT_EQ(mesh.color(f)[0], static_cast<unsigned char>(parent));
        EXPECT_EQ(mesh.status(f).selected(), parent % 3 == 0);
      }
    }
  }
}

TEST(openmesh_attributes, edges_inherit_from_the_edge_they_lie_on) {
  std::mt19937 random(4);
  const Mesh quads = test::terrain_mesh(4, 5);
  const Mesh cut = test::triangulated(quads, [&](int) { return random() % 2 == 0; });
  for (const Mesh& plain : {quads, cut}) {
    PolyMesh mesh;
    mesh.request_edge_status();
    test::fill(mesh, test::shuffled(plain, 6));
    OpenMesh::EPropHandleT<OpenMesh::Vec3d> middle;
    OpenMesh::HPropHandleT<std::string> direction;
    mesh.add_property(middle, "middle");
    mesh.add_property(direction, "direction");
    const auto towards = [](const OpenMesh::Vec3d& d) {
      return std::to_string((d[0] > 1e-9) - (d[0] < -1e-9)) + " " +
             std::to_string((d[1] > 1e-9) - (d[1] < -1e-9));
    };
    for (auto e : mesh.edges()) {
      mesh.property(middle, e) = mesh.calc_edge_midpoint(e);
      mesh.status(e).set_feature(true);
      for (int i : {0, 1})
        mesh.property(direction, e.h(static_cast<unsigned>(i))) =
            towards(mesh.calc_edge_vector(e.h(static_cast<unsigned>(i))));
    }
    const std::size_t old_edges = mesh.n_edges();
    GridSubdividerT<PolyMesh> subdivide("four-point");
    ASSERT_TRUE(subdivide(mesh, 2, false));
    std::size_t features = 0;
    for (auto e : mesh.edges()) {
      if (!mesh.status(e).feature()) {
        EXPECT_EQ(mesh.property(middle, e), OpenMesh::Vec3d(0, 0, 0)) << "not set by anybody";
        EXPECT_EQ(mesh.property(direction, e.h0()), "");
        continue;
      }
      ++features;
      const auto d = mesh.calc_edge_midpoint(e) - mesh.property(middle, e);
      EXPECT_LT(std::hypot(d[0], d[1]), 0.75) << "the edge lies on another one";
      for (auto h : {e.h0(), e.h1()})
        EXPECT_EQ(mesh.property(direction, h), towards(mesh.calc_edge_vector(h)));
    }
    EXPECT_EQ(features, 4 * old_edges);
  }
}

TEST(openmesh_attributes, nothing_is_left_behind_in_the_mesh) {
  PolyMesh mesh;
  test::fill(mesh, test::terrain_mesh(4, 5));
  mesh.request_vertex_normals();
  const auto counts = [&] {
    return std::array<std::size_t, 5>{mesh.n_vprops(), mesh.n_hprops(), mesh.n_eprops(),
                                      mesh.n_fprops(), mesh.n_mprops()};
  };
  const auto before = counts();
  GridSubdividerT<PolyMesh> subdivide(mesh);
  EXPECT_TRUE(subdivide(1));
  subdivide.detach();
  EXPECT_EQ(counts(), before);
}

TEST(openmesh_attributes, data_of_the_mesh_s_own_traits_is_carried) {
  using Own = OpenMesh::PolyMesh_ArrayKernelT<LabelledTraits>;
  Own mesh;
  test::fill(mesh, test::terrain_mesh(3, 3));
  for (auto v : mesh.vertices()) {
    mesh.data(v).label = std::to_string(v.idx());
    mesh.set_texcoord2D(v, {1, 2});
  }
  for (auto f : mesh.faces()) mesh.data(f).region = f.idx();
  GridSubdividerT<Own> subdivide("four-point");
  ASSERT_TRUE(subdivide(mesh, 2));
  for (int v = 0; v < 9; ++v) EXPECT_EQ(mesh.data(Own::VertexHandle(v)).label, std::to_string(v));
  for (auto v : mesh.vertices()) EXPECT_FALSE(mesh.data(v).label.empty());
  for (auto f : mesh.faces()) {
    const auto c = mesh.calc_face_centroid(f);
    EXPECT_EQ(mesh.data(f).region, 2 * static_cast<int>(-c[1]) + static_cast<int>(c[0]));
    EXPECT_NEAR(mesh.normal(f).norm(), 1, 1e-12);
  }
}

}  // namespace
}  // namespace arete
