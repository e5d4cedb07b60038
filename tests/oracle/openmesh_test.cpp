// SPDX-License-Identifier: MIT
// GridSubdividerT against OpenSubdiv and against OpenMesh's own CatmullClarkT.
#include "arete/openmesh/grid_subdivider.h"

#include <gtest/gtest.h>

#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
#include <OpenMesh/Tools/Subdivider/Uniform/CatmullClarkT.hh>
#include <cmath>

#include "arete/openmesh/catmull_clark.h"
#include "arete/opensubdiv/catmull_clark.h"
#include "support/fields.h"
#include "topology/meshes.h"

namespace arete {
namespace {

struct Traits : public OpenMesh::DefaultTraits {
  using Point = OpenMesh::Vec3d;
};
using PolyMesh = OpenMesh::PolyMesh_ArrayKernelT<Traits>;

PolyMesh mesh_of(const Grid<double>& heights, unsigned seed) {
  test::Mesh mesh = test::terrain_mesh(heights.rows(), heights.cols());
  for (std::size_t i = 0; i < mesh.points.size(); ++i) mesh.points[i][2] = heights.samples()[i];
  mesh = test::shuffled(mesh, seed);
  PolyMesh host;
  for (const Point3& p : mesh.points) host.add_vertex({p[0], p[1], p[2]});
  for (int f = 0; f < mesh.faces.count(); ++f) {
    std::vector<PolyMesh::VertexHandle> face;
    for (int v : mesh.faces[f]) face.emplace_back(v);
    host.add_face(face);
  }
  return host;
}

Grid<double> heights_of(const PolyMesh& mesh) {
  std::vector<Point3> points;
  for (auto v : mesh.vertices())
    points.push_back({mesh.point(v)[0], mesh.point(v)[1], mesh.point(v)[2]});
  const GridPatch patch = oriented(
      recover_grids(openmesh::detail::mesh_faces(mesh), static_cast<int>(points.size())).at(0),
      points);
  Grid<double> heights(patch.extent);
  for (std::size_t i = 0; i < patch.vertices.size(); ++i)
    heights.samples()[i] = points[static_cast<std::size_t>(patch.vertices[i])][2];
  return heights;
}

TEST(openmesh, the_default_subdivider_is_opensubdiv_on_the_whole_grid) {
  for (Extent extent : {Extent{2, 2}, Extent{3, 5}, Extent{17, 9}, Extent{33, 33}}) {
    const Grid<double> heights = test::dyadic_heights(extent, 12);
    for (int level = 1; level <= 3; ++level) {
      PolyMesh mesh = mesh_of(heights, 5);
      openmesh::GridSubdividerT<PolyMesh> subdivide;
      ASSERT_TRUE(subdivide(mesh, static_cast<std::size_t>(level)));
      const Grid<double> theirs =
          opensubdiv::catmull_clark(heights, level, opensubdiv::CornerRule::sharp);
      EXPECT_EQ(heights_of(mesh).samples(), theirs.samples()) << extent.rows << " " << level;
    }
  }
}

// New vertices of OpenMesh 9's CatmullClarkT are made without their properties: what was in the
// memory before them is their texture coordinate.
TEST(openmesh, catmull_clark_of_openmesh_leaves_texture_coordinates_unset) {
  PolyMesh mesh = mesh_of(test::dyadic_heights({4, 4}), 1);
  mesh.request_vertex_texcoords2D();
  for (auto v : mesh.vertices()) mesh.set_texcoord2D(v, {0, 0});
  auto& texcoords = mesh.property(mesh.vertex_texcoords2D_pph()).data_vector();
  const std::size_t old = texcoords.size();
  texcoords.resize(1000, {123, 456});
  texcoords.resize(old);
  OpenMesh::Subdivider::Uniform::CatmullClarkT<PolyMesh> catmull_clark;
  ASSERT_TRUE(catmull_clark(mesh, 1));
  for (std::size_t v = old; v < mesh.n_vertices(); ++v)
    EXPECT_EQ(texcoords[v], PolyMesh::TexCoord2D(123, 456))
        << "the finding no longer holds: OpenMesh sets texture coordinates";
}

// OpenMesh 9's CatmullClarkT uses (V + m1 + m2) / 3 for a vertex of the rim, that is the mask
// [1, 3, 4, 3, 1] / 6, where Catmull-Clark has [1, 4, 6, 4, 1] / 8: its rim is no cubic B-spline.
// So it agrees inside and must not be used as a reference at the rim.
TEST(openmesh, catmull_clark_of_openmesh_agrees_inside_and_has_another_rim) {
  const Grid<double> heights = test::dyadic_heights({13, 10}, 4);
  for (int level = 1; level <= 3; ++level) {
    PolyMesh ours = mesh_of(heights, 3);
    PolyMesh theirs = mesh_of(heights, 3);
    openmesh::GridSubdividerT<PolyMesh> subdivide;
    ASSERT_TRUE(subdivide(ours, static_cast<std::size_t>(level)));
    OpenMesh::Subdivider::Uniform::CatmullClarkT<PolyMesh> catmull_clark;
    ASSERT_TRUE(catmull_clark(theirs, static_cast<std::size_t>(level)));
    const Grid<double> a = heights_of(ours);
    const Grid<double> b = heights_of(theirs);
    const Grid<double> adapter = openmesh::catmull_clark(heights, level);
    ASSERT_EQ(adapter.extent(), b.extent());
    ASSERT_EQ(a.extent(), b.extent());
    const Index inside = Index{2} << level;
    double rim = 0;
    for (Index r = 0; r < a.rows(); ++r) {
      for (Index c = 0; c < a.cols(); ++c) {
        EXPECT_NEAR(adapter(r, c), b(r, c), 1e-12);
        const double difference = std::abs(a(r, c) - b(r, c));
        const Index depth = std::min({r, c, a.rows() - 1 - r, a.cols() - 1 - c});
        if (depth >= inside) {
          EXPECT_LE(difference, 1e-12) << r << ", " << c;
        } else {
          rim = std::max(rim, difference);
        }
      }
    }
    EXPECT_GT(rim, 1) << "the finding no longer holds: OpenMesh has mended its rim";
    if (level == 1) {
      for (Index c = 1; c + 1 < heights.cols(); ++c) {
        const double p = heights(0, c);
        EXPECT_NEAR(b(0, 2 * c),
                    (p + (p + heights(0, c - 1)) / 2 + (p + heights(0, c + 1)) / 2) / 3, 1e-12);
        EXPECT_EQ(a(0, 2 * c), (6 * p + heights(0, c - 1) + heights(0, c + 1)) / 8);
      }
    }
  }
}

}  // namespace
}  // namespace arete
