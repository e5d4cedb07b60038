// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Tools/Utils/MeshCheckerT.hh>
#include <sstream>
#include <string>
#include <vector>

#include "arete/openmesh/grid_subdivider.h"
#include "topology/meshes.h"

namespace arete::test {

struct DoubleTraits : public OpenMesh::DefaultTraits {
  using Point = OpenMesh::Vec3d;
  using Normal = OpenMesh::Vec3d;
  using TexCoord2D = OpenMesh::Vec2d;
};
using PolyMesh = OpenMesh::PolyMesh_ArrayKernelT<DoubleTraits>;
using FloatMesh = OpenMesh::PolyMesh_ArrayKernelT<>;
using TriMesh = OpenMesh::TriMesh_ArrayKernelT<DoubleTraits>;

/// The mesh in OpenMesh, vertices and faces with the same numbers.
template <class Host>
void fill(Host& host, const Mesh& mesh) {
  for (const Point3& p : mesh.points) host.add_vertex(typename Host::Point(p[0], p[1], p[2]));
  for (int f = 0; f < mesh.faces.count(); ++f) {
    std::vector<typename Host::VertexHandle> face;
    for (int v : mesh.faces[f]) face.emplace_back(v);
    ASSERT_TRUE(host.add_face(face).is_valid());
  }
}

/// Back to plain arrays.
template <class Host>
Mesh plain(const Host& host) {
  Mesh mesh;
  for (auto v : host.vertices()) {
    const auto& p = host.point(v);
    mesh.points.push_back({p[0], p[1], p[2]});
  }
  mesh.faces = openmesh::detail::mesh_faces(host);
  return mesh;
}

/// The patches of a mesh turned by where they lie.
inline std::vector<GridPatch> oriented_patches(const Mesh& mesh) {
  std::vector<GridPatch> patches = recover_grids(mesh.faces, mesh.vertices(), mesh.points);
  for (GridPatch& patch : patches) patch = oriented(patch, mesh.points);
  return patches;
}

/// One coordinate of a patch as a grid.
inline Grid<double> plane_of(const GridPatch& patch, const Mesh& mesh, std::size_t k) {
  Grid<double> plane(patch.extent);
  for (std::size_t i = 0; i < patch.vertices.size(); ++i)
    plane.samples()[i] = mesh.points[static_cast<std::size_t>(patch.vertices[i])][k];
  return plane;
}

template <class Host>
void expect_sound(const Host& host) {
  std::ostringstream complaints;
  EXPECT_TRUE(OpenMesh::Utils::MeshCheckerT<Host>(host).check(
      OpenMesh::Utils::MeshCheckerT<Host>::CHECK_ALL, complaints))
      << complaints.str();
  EXPECT_EQ(host.n_vertices(), host.property(host.points_property_handle()).n_elements());
  for (auto v : host.vertices()) {
    if (host.is_isolated(v)) continue;
    for (auto h : host.voh_range(v)) EXPECT_EQ(host.from_vertex_handle(h), v);
  }
}

/// What is written to omerr() while it lives.
class Complaints {
 public:
  Complaints() {
    omerr().disable();
    omerr().connect(stream_);
    omerr().enable();
    omerr().disconnect(std::cerr);
  }
  ~Complaints() {
    omerr().disconnect(stream_);
    omerr().connect(std::cerr);
  }
  [[nodiscard]] std::string text() const { return stream_.str(); }

 private:
  std::ostringstream stream_;
};

}  // namespace arete::test
