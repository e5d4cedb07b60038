// SPDX-License-Identifier: MIT
#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
#include <OpenMesh/Tools/Subdivider/Uniform/CatmullClarkT.hh>
#include <memory>

#include "arete/topology/grid_faces.h"
#include "peer.h"

namespace arete::bench {
namespace {

using Mesh = OpenMesh::PolyMesh_ArrayKernelT<>;

Run catmull_clark(const Job& job) {
  auto coarse = std::make_shared<Mesh>();
  for (Index r = 0; r < job.heights.rows(); ++r)
    for (Index c = 0; c < job.heights.cols(); ++c)
      coarse->add_vertex({static_cast<float>(c), static_cast<float>(r), job.heights(r, c)});
  const FaceList faces = grid_faces(job.heights.extent(), true);
  for (int f = 0; f < faces.count(); ++f) {
    const auto q = faces[f];
    using V = Mesh::VertexHandle;
    coarse->add_face(V(q[0]), V(q[1]), V(q[2]), V(q[3]));
  }
  auto mesh = std::make_shared<Mesh>(*coarse);
  const auto levels = static_cast<std::size_t>(job.levels);
  return {[=] {
            *mesh = *coarse;
            OpenMesh::Subdivider::Uniform::CatmullClarkT<Mesh> subdivide;
            subdivide(*mesh, levels);
          },
          [=] {
            std::vector<Vertex> vertices;
            for (auto v : mesh->vertices()) {
              const auto p = mesh->point(v);
              vertices.push_back({p[0], p[1], p[2]});
            }
            return vertices;
          }};
}

}  // namespace

std::vector<Peer> openmesh_peers() {
  return {{"OpenMesh, CatmullClarkT", true, true, 250, 1, catmull_clark}};
}

}  // namespace arete::bench
