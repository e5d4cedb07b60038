// SPDX-License-Identifier: MIT
#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
#include <cmath>
#include <limits>

#include "arete/openmesh/grid_subdivider.h"
#include "arete/openmesh/mesh_io.h"

namespace arete::openmesh {
namespace {

struct Traits : public OpenMesh::DefaultTraits {
  using Point = OpenMesh::Vec3d;
  using Normal = OpenMesh::Vec3d;
  using Color = OpenMesh::Vec4uc;
};
using Mesh = OpenMesh::PolyMesh_ArrayKernelT<Traits>;

// \pre the faces are those of grids, so that OpenMesh takes every one of them.
Mesh host_mesh(const MeshData& data) {
  Mesh mesh;
  const std::size_t faces = static_cast<std::size_t>(data.faces.count());
  mesh.reserve(data.points.size(), 2 * faces + 64, faces);
  for (const Point3& p : data.points) mesh.add_vertex({p[0], p[1], p[2]});
  if (!data.normals.empty()) mesh.request_vertex_normals();
  if (!data.colors.empty()) {
    mesh.request_vertex_colors();
    for (auto v : mesh.vertices()) {
      const auto& c = data.colors[static_cast<std::size_t>(v.idx())];
      mesh.set_color(v, {c[0], c[1], c[2], c[3]});
    }
  }
  if (!data.texcoords.empty()) {
    mesh.request_vertex_texcoords2D();
    for (auto v : mesh.vertices()) {
      const auto& t = data.texcoords[static_cast<std::size_t>(v.idx())];
      mesh.set_texcoord2D(v, {t[0], t[1]});
    }
  }
  if (!data.corner_texcoords.empty()) mesh.request_halfedge_texcoords2D();
  std::vector<Mesh::VertexHandle> corners;
  for (int f = 0; f < data.faces.count(); ++f) {
    corners.clear();
    for (int v : data.faces[f]) corners.emplace_back(v);
    const auto face = mesh.add_face(corners);
    if (!face.is_valid()) throw NotAGrid::at_face(f, "does not fit its neighbours");
    if (data.corner_texcoords.empty()) continue;
    const auto start = static_cast<std::size_t>(data.faces.starts[static_cast<std::size_t>(f)]);
    for (auto h : mesh.fh_range(face))
      for (std::size_t i = 0; i < corners.size(); ++i)
        if (corners[i] == mesh.to_vertex_handle(h)) {
          const auto& t = data.corner_texcoords[start + i];
          mesh.set_texcoord2D(h, {t[0], t[1]});
        }
  }
  return mesh;
}

MeshData plain_mesh(const Mesh& mesh) {
  MeshData data;
  data.points.reserve(mesh.n_vertices());
  for (auto v : mesh.vertices()) {
    const auto& p = mesh.point(v);
    data.points.push_back({p[0], p[1], p[2]});
    if (mesh.has_vertex_normals()) {
      const auto& n = mesh.normal(v);
      data.normals.push_back(
          {static_cast<float>(n[0]), static_cast<float>(n[1]), static_cast<float>(n[2])});
    }
    if (mesh.has_vertex_colors()) {
      const auto& c = mesh.color(v);
      data.colors.push_back({c[0], c[1], c[2], c[3]});
    }
    if (mesh.has_vertex_texcoords2D())
      data.texcoords.push_back({mesh.texcoord2D(v)[0], mesh.texcoord2D(v)[1]});
  }
  std::vector<int> corners;
  for (auto f : mesh.faces()) {
    corners.clear();
    for (auto h : mesh.fh_range(f)) {
      corners.push_back(mesh.to_vertex_handle(h).idx());
      if (mesh.has_halfedge_texcoords2D())
        data.corner_texcoords.push_back({mesh.texcoord2D(h)[0], mesh.texcoord2D(h)[1]});
    }
    data.faces.add(corners);
  }
  return data;
}

// What is wrong is named before OpenMesh complains of single faces.
std::vector<GridPatch> checked_grids(const MeshData& mesh) {
  if (mesh.points.size() > static_cast<std::size_t>(std::numeric_limits<int>::max()))
    throw InvalidField("the mesh exceeds 32-bit numbering; split it");
  for (std::size_t v = 0; v < mesh.points.size(); ++v)
    for (double x : mesh.points[v])
      if (!std::isfinite(x))
        throw InvalidField("vertex " + std::to_string(v) +
                           " has a coordinate that is no finite number; repair the mesh");
  return recover_grids(mesh.faces, static_cast<int>(mesh.points.size()), mesh.points);
}

// OpenMesh's vertices, two edges of 32 bytes a vertex (three with diagonals), faces; the plain
// arrays of the result; both with attributes.
double bytes_per_vertex(const MeshData& mesh, bool normals, bool triangles) {
  double bytes = triangles ? 140 : 100;
  bytes += triangles ? 24 + 2 * 16 : 24 + 20;
  if (normals) bytes += 24 + 12;
  if (!mesh.colors.empty()) bytes += 8;
  if (!mesh.texcoords.empty()) bytes += 16;
  if (!mesh.corner_texcoords.empty()) bytes += triangles ? 96 : 64;
  return bytes;
}

}  // namespace

RefinedMeshSize refined_size(const MeshData& mesh, const Scheme& along_rows,
                             const Scheme& along_cols, const MeshRefineOptions& options) {
  std::vector<GridPatch> patches = checked_grids(mesh);
  for (GridPatch& patch : patches) patch = oriented(patch, mesh.points);
  const detail::Rebuild plan =
      detail::plan_rebuild(std::move(patches), static_cast<int>(mesh.points.size()),
                           detail::rebuild_options(along_rows, along_cols, options.boundaries,
                                                   options.levels, options.on_limit));
  RefinedMeshSize size;
  size.vertices = plan.vertices;
  size.faces = plan.faces;
  const bool normals = options.normals || !mesh.normals.empty();
  for (const detail::RefinedPatch& patch : plan.patches) {
    size.patches.push_back({patch.coarse.extent, patch.fine()});
    size.bytes += bytes_per_vertex(mesh, normals, patch.triangles()) *
                  static_cast<double>(patch.fine().rows) * static_cast<double>(patch.fine().cols);
  }
  return size;
}

MeshData refine_mesh(const MeshData& mesh, const Scheme& along_rows, const Scheme& along_cols,
                     const MeshRefineOptions& options) {
  (void)checked_grids(mesh);
  if (options.levels <= 0) return mesh;
  Mesh host = host_mesh(mesh);
  if (options.normals) host.request_vertex_normals();
  GridSubdividerT<Mesh> subdivide;
  subdivide.set_schemes(along_rows, along_cols);
  subdivide.set_boundaries(options.boundaries);
  subdivide.set_threads(options.threads);
  subdivide.set_on_limit(options.on_limit);
  subdivide.refine_or_throw(host, static_cast<std::size_t>(options.levels));
  return plain_mesh(host);
}

}  // namespace arete::openmesh
