// SPDX-License-Identifier: MIT
#include "arete/openmesh/internal/coarse_connectivity.h"

#include <limits>

#include "arete/openmesh/internal/mesh_faces.h"

namespace arete::openmesh::detail {
namespace {

using OpenMesh::ArrayKernel;
using OpenMesh::FaceHandle;
using OpenMesh::HalfedgeHandle;
using OpenMesh::VertexHandle;

int halfedge(const MeshNeighbours& mesh, Index from, Index to) {
  return static_cast<int>(2 * mesh.edge(from, to) + (from > to ? 1 : 0));
}

// For every corner, counted through the faces as plain_faces() lists them, the half-edge that ends
// there.
std::vector<int> corner_halfedges(const ArrayKernel& mesh) {
  std::vector<int> ends;
  for (std::size_t f = 0; f < mesh.n_faces(); ++f) {
    const HalfedgeHandle first = mesh.halfedge_handle(FaceHandle(static_cast<int>(f)));
    HalfedgeHandle h = first;
    do {
      ends.push_back(h.idx());
      h = mesh.next_halfedge_handle(h);
    } while (h != first);
  }
  return ends;
}

}  // namespace

MeshFaces plain_faces(const ArrayKernel& mesh) {
  const FaceList list = mesh_faces(mesh);
  MeshFaces faces{static_cast<Index>(mesh.n_vertices()), {}};
  for (int f = 0; f < list.count(); ++f) faces.faces.emplace_back(list[f].begin(), list[f].end());
  return faces;
}

CoarseSources coarse_sources(const ArrayKernel& fine, const RecoveredMesh& recovered,
                             MeshScheme scheme) {
  CoarseSources sources;
  const MeshFaces& coarse = recovered.coarse;
  const MeshNeighbours mesh(coarse);
  const auto vertices = vertex_order(recovered, scheme);
  sources.vertices.assign(vertices.begin(),
                          vertices.begin() + static_cast<std::ptrdiff_t>(coarse.vertices));
  for (const Index f : face_heirs(recovered, scheme)) sources.faces.push_back(static_cast<int>(f));

  sources.halfedges.assign(static_cast<std::size_t>(2 * mesh.edge_count()), -1);
  const auto corners = corner_order(recovered, scheme);
  const auto ends = corner_halfedges(fine);
  std::size_t corner = 0;
  for (const auto& face : coarse.faces)
    for (std::size_t i = 0; i < face.size(); ++i, ++corner)
      sources.halfedges[static_cast<std::size_t>(
          halfedge(mesh, face[(i + face.size() - 1) % face.size()], face[i]))] =
          ends[static_cast<std::size_t>(corners[corner])];
  std::vector<int> rim(fine.n_vertices(), -1);  // the half-edge without a face that ends there
  for (std::size_t i = 0; i < fine.n_halfedges(); ++i) {
    const HalfedgeHandle h(static_cast<int>(i));
    if (!fine.face_handle(h).is_valid())
      rim[static_cast<std::size_t>(fine.to_vertex_handle(h).idx())] = h.idx();
  }
  for (Index e = 0; e < mesh.edge_count(); ++e) {
    const auto [a, b] = mesh.edges()[static_cast<std::size_t>(e)];
    for (const auto& [from, to] : {std::pair(a, b), std::pair(b, a)}) {
      int& source = sources.halfedges[static_cast<std::size_t>(halfedge(mesh, from, to))];
      if (source < 0)
        source = rim[static_cast<std::size_t>(sources.vertices[static_cast<std::size_t>(to)])];
    }
    sources.edges.push_back(sources.halfedges[static_cast<std::size_t>(2 * e)] / 2);
  }
  return sources;
}

void write_connectivity(ArrayKernel& mesh, const MeshFaces& faces) {
  const MeshNeighbours neighbours(faces);
  if (std::max<Index>({faces.vertices, 2 * neighbours.edge_count(),
                       static_cast<Index>(faces.faces.size())}) > std::numeric_limits<int>::max())
    throw InvalidField("the mesh exceeds OpenMesh's 32-bit handles; split it");
  mesh.resize(static_cast<std::size_t>(faces.vertices),
              static_cast<std::size_t>(neighbours.edge_count()), faces.faces.size());
  std::vector<std::uint8_t> inner(mesh.n_halfedges(), 0);
  for (Index e = 0; e < neighbours.edge_count(); ++e) {
    const auto [a, b] = neighbours.edges()[static_cast<std::size_t>(e)];
    mesh.set_vertex_handle(HalfedgeHandle(static_cast<int>(2 * e)),
                           VertexHandle(static_cast<int>(b)));
    mesh.set_vertex_handle(HalfedgeHandle(static_cast<int>(2 * e + 1)),
                           VertexHandle(static_cast<int>(a)));
  }
  for (std::size_t f = 0; f < faces.faces.size(); ++f) {
    const auto& face = faces.faces[f];
    const std::size_t n = face.size();
    for (std::size_t i = 0; i < n; ++i) {
      const HalfedgeHandle h(halfedge(neighbours, face[i], face[(i + 1) % n]));
      const HalfedgeHandle next(halfedge(neighbours, face[(i + 1) % n], face[(i + 2) % n]));
      inner[static_cast<std::size_t>(h.idx())] = 1;
      mesh.set_face_handle(h, FaceHandle(static_cast<int>(f)));
      mesh.set_next_halfedge_handle(h, next);
      mesh.set_halfedge_handle(VertexHandle(static_cast<int>(face[i])), h);
      // Faces are listed by the vertices that their half-edges lead to.
      if (i + 1 == n) mesh.set_halfedge_handle(FaceHandle(static_cast<int>(f)), h);
    }
  }
  // A vertex of the boundary refers to the half-edge without a face that leaves it: there is one.
  for (std::size_t i = 0; i < inner.size(); ++i) {
    if (inner[i] != 0) continue;
    const HalfedgeHandle h(static_cast<int>(i));
    mesh.set_boundary(h);
    mesh.set_halfedge_handle(mesh.from_vertex_handle(h), h);
  }
  for (std::size_t i = 0; i < inner.size(); ++i) {
    if (inner[i] != 0) continue;
    const HalfedgeHandle h(static_cast<int>(i));
    mesh.set_next_halfedge_handle(h, mesh.halfedge_handle(mesh.to_vertex_handle(h)));
  }
}

}  // namespace arete::openmesh::detail
