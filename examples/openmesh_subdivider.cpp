// SPDX-License-Identifier: MIT
// Refines a terrain mesh with texture coordinates in OpenMesh; prints what came out.
#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
#include <iostream>

#include "arete/openmesh/grid_subdivider.h"

int main() {
  using Mesh = OpenMesh::PolyMesh_ArrayKernelT<OpenMesh::DefaultTraitsDouble>;
  Mesh mesh;
  mesh.request_vertex_texcoords2D();
  mesh.request_vertex_normals();
  const double heights[3][4] = {{5, 9, 4, 3}, {6, 14, 8, 2}, {4, 7, 6, 1}};
  for (int r = 0; r < 3; ++r) {
    for (int c = 0; c < 4; ++c) {
      const auto v = mesh.add_vertex({10.0 * c, -10.0 * r, heights[r][c]});
      mesh.set_texcoord2D(v, {c / 3.0f, r / 2.0f});
    }
  }
  const auto v = [](int r, int c) { return Mesh::VertexHandle(4 * r + c); };
  for (int r = 0; r < 2; ++r)
    for (int c = 0; c < 3; ++c) mesh.add_face(v(r, c), v(r + 1, c), v(r + 1, c + 1), v(r, c + 1));

  arete::openmesh::GridSubdividerT<Mesh> subdivide("four-point:omega=1/16");
  if (!subdivide(mesh, 4)) return 1;  // the reason is on omerr()

  const auto summit =
      v(1, 1);  // an old vertex: the same handle, and with this scheme the same place
  std::cout << subdivide.name() << ": " << mesh.n_vertices() << " vertices, " << mesh.n_faces()
            << " quads; summit " << mesh.point(summit) << ", normal " << mesh.normal(summit)
            << "\n";
  return mesh.n_vertices() == 33 * 49 ? 0 : 1;
}
