// SPDX-License-Identifier: MIT
#include "arete/openmesh/catmull_clark.h"

#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
#include <OpenMesh/Tools/Subdivider/Uniform/CatmullClarkT.hh>
#include <string>
#include <vector>

#include "arete/openmesh/internal/mesh_faces.h"
#include "arete/topology/grid_faces.h"
#include "arete/topology/height_mesh.h"

namespace arete::openmesh {
namespace {

struct Traits : public OpenMesh::DefaultTraits {
  using Point = OpenMesh::Vec3d;
};
using Mesh = OpenMesh::PolyMesh_ArrayKernelT<Traits>;

Mesh make_mesh(const Grid<double>& heights) {
  Mesh mesh;
  for (const Point3& p : height_points(heights)) mesh.add_vertex({p[0], p[1], p[2]});
  const FaceList faces = grid_faces(heights.extent(), true);
  std::vector<Mesh::VertexHandle> corners;
  for (int f = 0; f < faces.count(); ++f) {
    corners.clear();
    for (int v : faces[f]) corners.emplace_back(v);
    mesh.add_face(corners);
  }
  return mesh;
}

}  // namespace

Grid<double> catmull_clark(const Grid<double>& heights, int levels) {
  if (heights.rows() < 2 || heights.cols() < 2)
    throw InvalidField("Catmull-Clark needs a quad: give at least 2 x 2 samples");
  if (levels < 0 || levels > 10)
    throw InvalidField("levels = " + std::to_string(levels) + "; OpenMesh is asked for 0 to 10");
  Mesh mesh = make_mesh(heights);
  OpenMesh::Subdivider::Uniform::CatmullClarkT<Mesh> subdivide;
  subdivide(mesh, static_cast<std::size_t>(levels));

  std::vector<Point3> points;
  points.reserve(mesh.n_vertices());
  for (auto v : mesh.vertices()) {
    const auto& p = mesh.point(v);
    points.push_back({p[0], p[1], p[2]});
  }
  return heights_of(detail::mesh_faces(mesh), points);
}

}  // namespace arete::openmesh
