// SPDX-License-Identifier: MIT
#include "arete/openmesh/internal/mesh_faces.h"

#include <string>

#include "arete/field/error.h"

namespace arete::openmesh::detail {
namespace {

template <class Handle>
void refuse_deleted(const OpenMesh::ArrayKernel& mesh, std::size_t count, const char* kind) {
  for (std::size_t i = 0; i < count; ++i)
    if (mesh.status(Handle(static_cast<int>(i))).deleted())
      throw InvalidField(std::string(kind) + " " + std::to_string(i) +
                         " is deleted but still stored; call garbage_collection() first");
}

}  // namespace

FaceList mesh_faces(const OpenMesh::ArrayKernel& mesh) {
  if (mesh.has_face_status()) refuse_deleted<OpenMesh::FaceHandle>(mesh, mesh.n_faces(), "face");
  if (mesh.has_vertex_status())
    refuse_deleted<OpenMesh::VertexHandle>(mesh, mesh.n_vertices(), "vertex");
  if (mesh.has_edge_status()) refuse_deleted<OpenMesh::EdgeHandle>(mesh, mesh.n_edges(), "edge");
  FaceList faces;
  faces.starts.reserve(mesh.n_faces() + 1);
  faces.corners.reserve(4 * mesh.n_faces());
  for (std::size_t f = 0; f < mesh.n_faces(); ++f) {
    const OpenMesh::HalfedgeHandle first =
        mesh.halfedge_handle(OpenMesh::FaceHandle(static_cast<int>(f)));
    OpenMesh::HalfedgeHandle h = first;
    do {
      faces.corners.push_back(mesh.to_vertex_handle(h).idx());
      h = mesh.next_halfedge_handle(h);
    } while (h != first);
    faces.starts.push_back(static_cast<int>(faces.corners.size()));
  }
  return faces;
}

std::uint64_t fingerprint(const OpenMesh::ArrayKernel& mesh) {
  // FNV-1a over whole numbers, one sum for each kind so that they run side by side.
  constexpr std::uint64_t prime = 1099511628211u;
  std::uint64_t to = 14695981039346656037u + mesh.n_vertices();
  std::uint64_t next = to * prime + mesh.n_faces();
  std::uint64_t face = next * prime;
  for (std::size_t i = 0; i < mesh.n_halfedges(); ++i) {
    const OpenMesh::HalfedgeHandle h(static_cast<int>(i));
    to = (to ^ static_cast<std::uint32_t>(mesh.to_vertex_handle(h).idx())) * prime;
    next = (next ^ static_cast<std::uint32_t>(mesh.next_halfedge_handle(h).idx())) * prime;
    face = (face ^ static_cast<std::uint32_t>(mesh.face_handle(h).idx())) * prime;
  }
  return (to * prime ^ next) * prime ^ face;
}

}  // namespace arete::openmesh::detail
