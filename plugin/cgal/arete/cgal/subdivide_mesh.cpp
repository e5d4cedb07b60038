// SPDX-License-Identifier: GPL-3.0-or-later
#include "arete/cgal/subdivide_mesh.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/subdivision_method_3.h>

namespace arete::cgal {
namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Surface = CGAL::Surface_mesh<Kernel::Point_3>;
using Vertex = Surface::Vertex_index;

Surface surface_of(const Mesh& mesh) {
  Surface surface;
  for (Index v = 0; v < mesh.positions.rows(); ++v)
    surface.add_vertex({mesh.positions(v, 0), mesh.positions(v, 1), mesh.positions(v, 2)});
  std::vector<Vertex> corners;
  for (std::size_t f = 0; f < mesh.faces.faces.size(); ++f) {
    corners.clear();
    for (const Index v : mesh.faces.faces[f]) corners.emplace_back(static_cast<unsigned>(v));
    if (surface.add_face(corners) == Surface::null_face())
      throw InvalidField("CGAL refused face " + std::to_string(f));
  }
  return surface;
}

Mesh plain(Surface& surface) {
  surface.collect_garbage();
  const auto vertices = static_cast<Index>(surface.number_of_vertices());
  Mesh mesh{{vertices, {}}, Grid<double>({vertices, 3})};
  for (const Vertex v : surface.vertices()) {
    const auto& p = surface.point(v);
    for (int k = 0; k < 3; ++k) mesh.positions(static_cast<Index>(v.idx()), k) = p[k];
  }
  for (const auto f : surface.faces()) {
    auto& face = mesh.faces.faces.emplace_back();
    for (const Vertex v : vertices_around_face(surface.halfedge(f), surface))
      face.push_back(static_cast<Index>(v.idx()));
  }
  return mesh;
}

}  // namespace

Mesh subdivide(const Mesh& mesh, MeshRule rule, int levels) {
  if (rule.rim != MeshRim::smooth || rule.scheme == MeshScheme::loop_warren)
    throw InvalidField("CGAL has no such rule");
  namespace Method = CGAL::Subdivision_method_3;
  Surface surface = surface_of(mesh);
  const auto times = CGAL::parameters::number_of_iterations(static_cast<unsigned>(levels));
  if (rule.triangles())
    Method::Loop_subdivision(surface, times);
  else if (rule.scheme == MeshScheme::doo_sabin)
    Method::DooSabin_subdivision(surface, times);
  else
    Method::CatmullClark_subdivision(surface, times);
  return plain(surface);
}

}  // namespace arete::cgal
