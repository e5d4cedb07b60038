// SPDX-License-Identifier: MIT
#include "arete/openmesh/catmull_clark.h"

#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
#include <OpenMesh/Tools/Subdivider/Uniform/CatmullClarkT.hh>
#include <string>
#include <vector>

#include "arete/openmesh/internal/mesh_faces.h"
#include "arete/topology/grid_faces.h"
#include "arete/topology/orient.h"
#include "arete/topology/recover.h"

namespace arete::openmesh {
namespace {

struct Traits : public OpenMesh::DefaultTraits {
  using Point = OpenMesh::Vec3d;
};
using Mesh = OpenMesh::PolyMesh_ArrayKernelT<Traits>;

Mesh make_mesh(const Grid<double>& heights) {
  Mesh mesh;
  for (Index r = 0; r < heights.rows(); ++r)
    for (Index c = 0; c < heights.cols(); ++c)
      mesh.add_vertex({static_cast<double>(c), -static_cast<double>(r), heights(r, c)});
  const FaceList faces = grid_faces(heights.extent(), true);
  using V = Mesh::VertexHandle;
  for (int f = 0; f < faces.count(); ++f) {
    const auto face = faces[f];
    mesh.add_face(V(face[0]), V(face[1]), V(face[2]), V(face[3]));
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
  const GridPatch patch = oriented(
      recover_grids(detail::mesh_faces(mesh), static_cast<int>(points.size())).front(), points);
  Grid<double> result(patch.extent);
  for (std::size_t i = 0; i < patch.vertices.size(); ++i)
    result.samples()[i] = points[static_cast<std::size_t>(patch.vertices[i])][2];
  return result;
}

}  // namespace arete::openmesh
