// SPDX-License-Identifier: MIT
#include "arete/openmesh/internal/large_pages.h"

#include <cstdint>
#include <type_traits>

#include "arete/openmesh/internal/known_types.h"
#ifdef __linux__
#include <sys/mman.h>
#endif

namespace arete::openmesh::detail {
namespace {

// Smaller blocks share their pages with others, or gain nothing.
constexpr std::size_t least_bytes = std::size_t{4} << 20;

void prefer_large_pages([[maybe_unused]] const void* data, std::size_t bytes) {
  if (bytes < least_bytes) return;
#if defined(__linux__) && defined(MADV_HUGEPAGE)
  constexpr std::uintptr_t page = std::uintptr_t{2} << 20;
  const auto begin = (reinterpret_cast<std::uintptr_t>(data) + page - 1) & ~(page - 1);
  const auto end = (reinterpret_cast<std::uintptr_t>(data) + bytes) & ~(page - 1);
  // A hint: where it fails, pages are small.
  if (begin < end)
    (void)madvise(reinterpret_cast<void*>(begin), end - begin, MADV_HUGEPAGE);  // NOLINT
#endif
}

template <class Iterator>
void prefer_large_pages(Iterator begin, Iterator end) {
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
  prefer_large_pages(mesh.vprops_begin(), mesh.vprops_end());
  prefer_large_pages(mesh.hprops_begin(), mesh.hprops_end());
  prefer_large_pages(mesh.eprops_begin(), mesh.eprops_end());
  prefer_large_pages(mesh.fprops_begin(), mesh.fprops_end());
}

}  // namespace arete::openmesh::detail
