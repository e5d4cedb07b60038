// SPDX-License-Identifier: GPL-3.0-or-later
#include "arete/cgal/catmull_clark.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/subdivision_method_3.h>

#include <string>
#include <vector>

#include "arete/topology/grid_faces.h"
#include "arete/topology/height_mesh.h"

namespace arete::cgal {
namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Vertex = Mesh::Vertex_index;

Mesh make_mesh(const Grid<double>& heights) {
  Mesh mesh;
  for (const Point3& p : height_points(heights)) mesh.add_vertex({p[0], p[1], p[2]});
  const FaceList faces = grid_faces(heights.extent(), true);
  for (int f = 0; f < faces.count(); ++f) {
    const auto face = faces[f];
    mesh.add_face(Vertex(face[0]), Vertex(face[1]), Vertex(face[2]), Vertex(face[3]));
  }
  return mesh;
}

}  // namespace

Grid<double> catmull_clark(const Grid<double>& heights, int levels) {
  if (heights.rows() < 2 || heights.cols() < 2)
    throw InvalidField("Catmull-Clark needs a quad: give at least 2 x 2 samples");
  if (levels < 0 || levels > 10)
    throw InvalidField("levels = " + std::to_string(levels) + "; CGAL is asked for 0 to 10");
  Mesh mesh = make_mesh(heights);
  CGAL::Subdivision_method_3::CatmullClark_subdivision(
      mesh, CGAL::parameters::number_of_iterations(static_cast<unsigned>(levels)));

  std::vector<Point3> points;
  for (Vertex v : mesh.vertices()) {
    const auto& p = mesh.point(v);
    points.push_back({p.x(), p.y(), p.z()});
  }
  FaceList faces;
  std::vector<int> corners;
  for (auto f : mesh.faces()) {
    corners.clear();
    for (Vertex v : vertices_around_face(mesh.halfedge(f), mesh))
      corners.push_back(static_cast<int>(v.idx()));
    faces.add(corners);
  }
  return heights_of(faces, points);
}

}  // namespace arete::cgal
