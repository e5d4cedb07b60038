// SPDX-License-Identifier: GPL-3.0-or-later
#include "convert.h"

#include <algorithm>
#include <cmath>

namespace arete::meshlab {
namespace {

namespace tri = vcg::tri;

// Which optional numbers of a vertex exist; the order of the channels.
struct Layout {
  bool colour = false, quality = false, texture = false, radius = false;

  Layout() = default;
  explicit Layout(const MeshModel& mesh)
      : colour(mesh.hasDataMask(MeshModel::MM_VERTCOLOR)),
        quality(mesh.hasDataMask(MeshModel::MM_VERTQUALITY)),
        texture(tri::HasPerVertexTexCoord(mesh.cm)),
        radius(tri::HasPerVertexRadius(mesh.cm)) {}
};

// Calls action(channel, blend, get, set) for every channel.
template <class Action>
void for_each_channel(const Layout& layout, const Action& action) {
  std::size_t channel = 0;
  if (layout.colour)
    for (int k = 0; k < 4; ++k)
      action(
          channel++, Blend::within,
          [k](const CVertexO& v) { return static_cast<float>(v.cC()[k]); },
          [k](CVertexO& v, float x) {
            v.C()[k] = static_cast<unsigned char>(std::clamp(std::lround(x), 0L, 255L));
          });
  if (layout.quality)
    action(
        channel++, Blend::within, [](const CVertexO& v) { return static_cast<float>(v.cQ()); },
        [](CVertexO& v, float x) { v.Q() = x; });
  if (layout.texture) {
    action(
        channel++, Blend::linear, [](const CVertexO& v) { return static_cast<float>(v.cT().U()); },
        [](CVertexO& v, float x) { v.T().U() = x; });
    action(
        channel++, Blend::linear, [](const CVertexO& v) { return static_cast<float>(v.cT().V()); },
        [](CVertexO& v, float x) { v.T().V() = x; });
    action(
        channel++, Blend::nearest, [](const CVertexO& v) { return static_cast<float>(v.cT().N()); },
        [](CVertexO& v, float x) { v.T().N() = static_cast<short>(x); });
  }
  if (layout.radius)
    action(
        channel++, Blend::within, [](const CVertexO& v) { return static_cast<float>(v.cR()); },
        [](CVertexO& v, float x) { v.R() = x; });
}

// What a face hands down to those in its place.
struct FaceAttributes {
  std::vector<bool> selected;
  std::vector<vcg::Color4b> colours;
  std::vector<float> qualities;

  explicit FaceAttributes(const CMeshO& cm) {
    const bool colour = tri::HasPerFaceColor(cm);
    const bool quality = tri::HasPerFaceQuality(cm);
    for (const CFaceO& f : cm.face) {
      if (f.IsD()) continue;
      selected.push_back(f.IsS());
      if (colour) colours.push_back(f.cC());
      if (quality) qualities.push_back(static_cast<float>(f.cQ()));
    }
  }
};

void drop_stale_components(MeshModel& mesh) {
  mesh.clearDataMask(MeshModel::MM_FACEFACETOPO | MeshModel::MM_VERTFACETOPO |
                     MeshModel::MM_VERTCURV | MeshModel::MM_VERTCURVDIR |
                     MeshModel::MM_FACECURVDIR);
  // Components that another filter enabled behind the mask's back, and one that MeshLab's
  // clearDataMask forgets.
  CMeshO& cm = mesh.cm;
  if (cm.face.IsFFAdjacencyEnabled()) cm.face.DisableFFAdjacency();
  if (cm.face.IsVFAdjacencyEnabled()) cm.face.DisableVFAdjacency();
  if (cm.vert.IsVFAdjacencyEnabled()) cm.vert.DisableVFAdjacency();
  if (cm.face.IsCurvatureDirEnabled()) cm.face.DisableCurvatureDir();
}

void resize_elements(CMeshO& cm, std::size_t vertices, std::size_t faces) {
  using Allocator = tri::Allocator<CMeshO>;
  Allocator::CompactEveryVector(cm);
  if (vertices > cm.vert.size()) Allocator::AddVertices(cm, vertices - cm.vert.size());
  if (faces > cm.face.size()) Allocator::AddFaces(cm, faces - cm.face.size());
  for (std::size_t f = faces; f < cm.face.size(); ++f) Allocator::DeleteFace(cm, cm.face[f]);
}

void set_point(Point3m& point, const Point3& value) {
  point = Point3m(static_cast<Scalarm>(value[0]), static_cast<Scalarm>(value[1]),
                  static_cast<Scalarm>(value[2]));
}

void set_vertices(const MeshArrays& arrays, const Layout& layout, CMeshO& cm) {
  for (std::size_t v = 0; v < arrays.positions.size(); ++v)
    set_point(cm.vert[v].P(), arrays.positions[v]);
  for_each_channel(layout, [&](std::size_t k, Blend, const auto&, const auto& set) {
    for (std::size_t v = 0; v < arrays.positions.size(); ++v)
      set(cm.vert[v], arrays.channels[k].values[v]);
  });
}

// `sources`: for every face the one whose attributes it takes over; empty: none.
void set_faces(const MeshArrays& arrays, const std::vector<int>& sources, const FaceAttributes& old,
               bool keep_quads, CMeshO& cm) {
  for (std::size_t i = 0; i < arrays.triangles.size(); ++i) {
    CFaceO& f = cm.face[i];
    f.Flags() = 0;
    for (int k = 0; k < 3; ++k) {
      const auto corner = static_cast<std::size_t>(k);
      f.V(k) = &cm.vert[static_cast<std::size_t>(arrays.triangles[i][corner])];
      if (keep_quads && ((arrays.inner_edges[i] >> k) & 1) != 0) f.SetF(k);
      if (arrays.wedges.empty()) continue;
      const WedgeUv& wedge = arrays.wedges[i][corner];
      f.WT(k).U() = wedge.u;
      f.WT(k).V() = wedge.v;
      f.WT(k).N() = static_cast<short>(wedge.texture);
    }
    if (sources.empty()) continue;
    const auto source = static_cast<std::size_t>(sources[i]);
    if (old.selected[source]) f.SetS();
    if (!old.colours.empty()) f.C() = old.colours[source];
    if (!old.qualities.empty()) f.Q() = old.qualities[source];
  }
}

void finish(bool keep_quads, MeshModel& mesh) {
  if (keep_quads)
    mesh.updateDataMask(MeshModel::MM_POLYGONAL);
  else
    mesh.clearDataMask(MeshModel::MM_POLYGONAL);
  mesh.cm.sfn = static_cast<int>(tri::UpdateSelection<CMeshO>::FaceCount(mesh.cm));
  mesh.cm.svn = static_cast<int>(tri::UpdateSelection<CMeshO>::VertexCount(mesh.cm));
  update_box_and_normals(mesh);
}

}  // namespace

MeshArrays read_mesh(const MeshModel& mesh) {
  const CMeshO& cm = mesh.cm;
  MeshArrays arrays;
  std::vector<int> numbers(cm.vert.size(), -1);
  arrays.positions.reserve(static_cast<std::size_t>(cm.vn));
  for (std::size_t i = 0; i < cm.vert.size(); ++i) {
    if (cm.vert[i].IsD()) continue;
    numbers[i] = static_cast<int>(arrays.positions.size());
    const Point3m& p = cm.vert[i].cP();
    arrays.positions.push_back({p[0], p[1], p[2]});
  }
  for_each_channel(Layout(mesh), [&](std::size_t, Blend blend, const auto& get, const auto&) {
    Channel& channel = arrays.channels.emplace_back();
    channel.blend = blend;
    channel.values.reserve(arrays.positions.size());
    for (const CVertexO& v : cm.vert)
      if (!v.IsD()) channel.values.push_back(get(v));
  });

  const bool polygonal = mesh.hasDataMask(MeshModel::MM_POLYGONAL);
  const bool wedges = tri::HasPerWedgeTexCoord(cm);
  arrays.triangles.reserve(static_cast<std::size_t>(cm.fn));
  for (const CFaceO& f : cm.face) {
    if (f.IsD()) continue;
    Triangle& triangle = arrays.triangles.emplace_back();
    std::uint8_t inner = 0;
    for (int k = 0; k < 3; ++k) {
      triangle[static_cast<std::size_t>(k)] = numbers[tri::Index(cm, f.cV(k))];
      if (f.IsF(k)) inner = static_cast<std::uint8_t>(inner | (1 << k));
    }
    if (polygonal) arrays.inner_edges.push_back(inner);
    if (!wedges) continue;
    auto& corners = arrays.wedges.emplace_back();
    for (int k = 0; k < 3; ++k) {
      const auto& t = f.cWT(k);
      corners[static_cast<std::size_t>(k)] = {static_cast<float>(t.U()), static_cast<float>(t.V()),
                                              t.N()};
    }
  }
  return arrays;
}

void write_refined(const RefinedMesh& refined, bool keep_quads, MeshModel& mesh) {
  const MeshArrays& arrays = refined.arrays;
  CMeshO& cm = mesh.cm;
  const FaceAttributes old(cm);
  const Layout layout(mesh);
  drop_stale_components(mesh);
  resize_elements(cm, arrays.positions.size(), arrays.triangles.size());
  set_vertices(arrays, layout, cm);
  set_faces(arrays, refined.source_triangles, old, keep_quads, cm);
  for (const int v : refined.dropped_vertices)
    tri::Allocator<CMeshO>::DeleteVertex(cm, cm.vert[static_cast<std::size_t>(v)]);
  tri::Allocator<CMeshO>::CompactEveryVector(cm);
  finish(keep_quads, mesh);
}

void write_created(const CreatedMesh& created, bool keep_quads, const MeshModel& source,
                   MeshModel& mesh) {
  const MeshArrays& arrays = created.arrays;
  int kinds = 0;
  if (!arrays.channels.empty())
    kinds |= MeshModel::MM_VERTCOLOR | MeshModel::MM_VERTQUALITY | MeshModel::MM_VERTTEXCOORD |
             MeshModel::MM_VERTRADIUS;
  if (!arrays.wedges.empty()) kinds |= MeshModel::MM_WEDGTEXCOORD;
  if (!created.source_triangles.empty())
    kinds |= MeshModel::MM_FACECOLOR | MeshModel::MM_FACEQUALITY;
  mesh.updateDataMask(source.dataMask() & kinds);
  mesh.cm.Tr = source.cm.Tr;
  copy_textures(source, mesh);
  resize_elements(mesh.cm, arrays.positions.size(), arrays.triangles.size());
  set_vertices(arrays, arrays.channels.empty() ? Layout() : Layout(source), mesh.cm);
  set_faces(arrays, created.source_triangles, FaceAttributes(source.cm), keep_quads, mesh.cm);
  finish(keep_quads, mesh);
}

void write_quality(const std::vector<float>& quality, MeshModel& mesh) {
  mesh.updateDataMask(MeshModel::MM_VERTQUALITY);
  std::size_t i = 0;
  for (CVertexO& v : mesh.cm.vert)
    if (!v.IsD()) v.Q() = quality[i++];
}

void write_moved(const MovedMesh& moved, MeshModel& mesh) {
  CMeshO& cm = mesh.cm;
  std::size_t i = 0;
  for (CVertexO& v : cm.vert)
    if (!v.IsD()) set_point(v.P(), moved.positions[i++]);
  update_box_and_normals(mesh);
  if (moved.normals.empty()) return;
  i = 0;
  for (CVertexO& v : cm.vert) {
    if (v.IsD()) continue;
    const Point3& normal = moved.normals[i++];
    if (normal != Point3{0, 0, 0}) set_point(v.N(), normal);
  }
}

}  // namespace arete::meshlab
