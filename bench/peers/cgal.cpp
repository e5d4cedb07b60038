// SPDX-License-Identifier: MIT
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/subdivision_method_3.h>

#include <memory>

#include "arete/topology/grid_faces.h"
#include "peer.h"

namespace arete::bench {
namespace {

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<float>::Point_3>;

Run catmull_clark(const Job& job) {
  auto coarse = std::make_shared<Mesh>();
  for (Index r = 0; r < job.heights.rows(); ++r)
    for (Index c = 0; c < job.heights.cols(); ++c)
      coarse->add_vertex({static_cast<float>(c), static_cast<float>(r), job.heights(r, c)});
  const FaceList faces = grid_faces(job.heights.extent(), true);
  for (int f = 0; f < faces.count(); ++f) {
    const auto q = faces[f];
    using V = Mesh::Vertex_index;
    coarse->add_face(V(q[0]), V(q[1]), V(q[2]), V(q[3]));
  }
  auto mesh = std::make_shared<Mesh>();
  const auto levels = static_cast<unsigned>(job.levels);
  return {[=] {
            *mesh = *coarse;
            CGAL::Subdivision_method_3::CatmullClark_subdivision(
                *mesh, CGAL::parameters::number_of_iterations(levels));
          },
          [=] {
            std::vector<Vertex> vertices;
            for (const auto v : mesh->vertices()) {
              const auto& p = mesh->point(v);
              vertices.push_back({p.x(), p.y(), p.z()});
            }
            return vertices;
          }};
}

}  // namespace

std::vector<Peer> cgal_peers() {
  return {{"CGAL, CatmullClark_subdivision", true, true, 200, 1, catmull_clark}};
}

}  // namespace arete::bench
