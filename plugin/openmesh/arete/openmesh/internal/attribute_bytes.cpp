// SPDX-License-Identifier: MIT
#include "arete/openmesh/internal/attribute_bytes.h"

#include <algorithm>
#include <cstring>
#include <type_traits>

#include "arete/reverse/mesh_attributes.h"

namespace arete::openmesh::detail {
namespace {

// Calls visit(name, values, per_corner) for every attribute there may be.
template <class Mesh, class Visit>
void for_attributes(Mesh& mesh, Visit&& visit) {
  visit("normals", mesh.normals, false);
  visit("colors", mesh.colors, false);
  visit("texcoords", mesh.texcoords, false);
  visit("corner_texcoords", mesh.corner_texcoords, true);
}

template <class T>
Bytes raw(const T* values, std::size_t count) {
  static_assert(std::is_trivially_copyable_v<T>);
  Bytes bytes(count * sizeof(T));
  if (count > 0) std::memcpy(bytes.data(), values, bytes.size());
  return bytes;
}

}  // namespace

AttributeSplit attribute_split(const RecoveredMesh& mesh, MeshScheme scheme) {
  std::size_t corners = 0;
  for (const auto& face : mesh.coarse.faces) corners += face.size();
  return {vertex_order(mesh, scheme), static_cast<std::size_t>(mesh.coarse.vertices),
          corner_order(mesh, scheme), corners};
}

std::vector<std::string> attribute_names(const MeshData& mesh) {
  std::vector<std::string> names;
  for_attributes(mesh, [&](const char* name, const auto& values, bool) {
    if (!values.empty()) names.emplace_back(name);
  });
  return names;
}

void foreign(const std::string& what) {
  throw InvalidDetails("the coarse mesh is not the one that the details were written with (" +
                       what + "); give that one");
}

void split_attributes(MeshData& mesh, const AttributeSplit& split, MeshLevelDetails& level) {
  for_attributes(mesh, [&]<class T>(const char*, std::vector<T>& values, bool per_corner) {
    if (values.empty()) return;
    const auto& order = per_corner ? split.corners : split.vertices;
    const std::size_t kept = per_corner ? split.kept_corners : split.kept_vertices;
    std::vector<T> ordered;
    for (const Index i : order) ordered.push_back(values[static_cast<std::size_t>(i)]);
    level.attributes.push_back(raw(ordered.data() + kept, ordered.size() - kept));
    ordered.resize(kept);
    values = std::move(ordered);
  });
}

void join_attributes(MeshData& mesh, const AttributeSplit& split,
                     const std::vector<std::string>& names, const MeshLevelDetails& level) {
  for_attributes(mesh, [&]<class T>(const char* name, std::vector<T>& values, bool per_corner) {
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end()) {
      values.clear();
      return;
    }
    const Bytes& rest = level.attributes.at(static_cast<std::size_t>(found - names.begin()));
    const auto& order = per_corner ? split.corners : split.vertices;
    const std::size_t kept = values.size();
    if (kept > order.size() || rest.size() != (order.size() - kept) * sizeof(T))
      foreign(std::string("it has other ") + name);
    values.resize(order.size());
    if (!rest.empty()) std::memcpy(values.data() + kept, rest.data(), rest.size());
    std::vector<T> placed(order.size());
    for (std::size_t i = 0; i < order.size(); ++i)
      placed[static_cast<std::size_t>(order[i])] = values[i];
    values = std::move(placed);
  });
}

}  // namespace arete::openmesh::detail
