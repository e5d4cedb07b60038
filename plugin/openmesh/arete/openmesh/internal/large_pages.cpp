// SPDX-License-Identifier: MIT
#include "arete/openmesh/internal/large_pages.h"

#include "arete/field/large_pages.h"
#include "arete/openmesh/internal/known_types.h"

namespace arete::openmesh::detail {
namespace {

template <class Iterator>
void prefer_large_pages_for(Iterator begin, Iterator end) {
  for (Iterator it = begin; it != end; ++it) {
    if (!*it) continue;
    KnownTypes::visit(**it, []<class T>(OpenMesh::PropertyT<T>& property) {
      auto& values = property.data_vector();
      prefer_large_pages(values.data(), values.capacity() * sizeof(T));
    });
  }
}

}  // namespace

void reserve_in_large_pages(OpenMesh::ArrayKernel& mesh, std::size_t vertices, std::size_t edges,
                            std::size_t faces) {
  using OpenMesh::ArrayItems;
  if (mesh.n_vertices() == 0 || mesh.n_edges() == 0 || mesh.n_faces() == 0) return;
  mesh.reserve(vertices, edges, faces);
  prefer_large_pages(&mesh.vertex(OpenMesh::VertexHandle(0)),
                     vertices * sizeof(ArrayItems::Vertex));
  prefer_large_pages(&mesh.edge(OpenMesh::EdgeHandle(0)), edges * sizeof(ArrayItems::Edge));
  prefer_large_pages(&mesh.face(OpenMesh::FaceHandle(0)), faces * sizeof(ArrayItems::Face));
  prefer_large_pages_for(mesh.vprops_begin(), mesh.vprops_end());
  prefer_large_pages_for(mesh.hprops_begin(), mesh.hprops_end());
  prefer_large_pages_for(mesh.eprops_begin(), mesh.eprops_end());
  prefer_large_pages_for(mesh.fprops_begin(), mesh.fprops_end());
}

}  // namespace arete::openmesh::detail
