// SPDX-License-Identifier: MIT
#include <algorithm>
#include <bit>
#include <cstring>
#include <limits>
#include <map>

#include "arete/openmesh/internal/mesh_text.h"

namespace arete::openmesh::detail {
namespace {

static_assert(std::endian::native == std::endian::little, "STL is read and written as it lies");

constexpr std::size_t header_size = 84;
constexpr std::size_t facet_size = 50;

// Corners at the same place are the same vertex.
class Welder {
 public:
  explicit Welder(MeshData& mesh) : mesh_(mesh) {}
  void add(Point3 p) {
    for (double& x : p) x += 0.0;  // -0 and 0 are one place
    const auto [place, fresh] = vertices_.try_emplace(p, static_cast<int>(mesh_.points.size()));
    if (fresh) mesh_.points.push_back(p);
    triangle_.push_back(place->second);
    if (triangle_.size() < 3) return;
    mesh_.faces.add(triangle_);
    triangle_.clear();
  }
  [[nodiscard]] bool between_triangles() const { return triangle_.empty(); }

 private:
  MeshData& mesh_;
  std::map<Point3, int> vertices_;
  std::vector<int> triangle_;
};

}  // namespace

MeshData parse_stl(std::string_view bytes) {
  MeshData mesh;
  Welder welder(mesh);
  std::uint32_t facets = 0;
  if (bytes.size() >= header_size) std::memcpy(&facets, bytes.data() + 80, 4);
  if (bytes.size() >= header_size && bytes.size() == header_size + facet_size * facets) {
    for (std::uint32_t f = 0; f < facets; ++f) {
      for (std::size_t k = 0; k < 3; ++k) {
        float p[3];
        std::memcpy(p, bytes.data() + header_size + facet_size * f + 12 * (k + 1), sizeof p);
        welder.add({p[0], p[1], p[2]});
      }
    }
    return mesh;
  }
  Lines lines(bytes);
  if (!lines.next() || lines.words()[0] != "solid")
    throw MeshFileError("neither text nor of the length its count of triangles asks for");
  while (lines.next())
    if (lines.words()[0] == "vertex")
      welder.add({lines.number<double>(1), lines.number<double>(2), lines.number<double>(3)});
  if (!welder.between_triangles()) lines.fail("the file ends within a triangle");
  return mesh;
}

void write_stl(const MeshData& mesh, Output& out) {
  std::size_t facets = 0;
  for (int f = 0; f < mesh.faces.count(); ++f)
    facets += std::max<std::size_t>(mesh.faces[f].size(), 2) - 2;
  if (facets > std::numeric_limits<std::uint32_t>::max())
    throw MeshFileError("more triangles than STL can count; write a .ply");
  const auto count = static_cast<std::uint32_t>(facets);
  out.text.append(header_size, '\0');
  std::memcpy(out.text.data() + 80, &count, 4);
  for (int f = 0; f < mesh.faces.count(); ++f) {
    const auto face = mesh.faces[f];
    for (std::size_t i = 2; i < face.size(); ++i) {
      const int corners[]{face[0], face[i - 1], face[i]};
      float values[12]{};  // normal (0, 0, 0): to be computed by the reader
      for (std::size_t k = 0; k < 9; ++k)
        values[3 + k] =
            static_cast<float>(mesh.points[static_cast<std::size_t>(corners[k / 3])][k % 3]);
      out.text.append(reinterpret_cast<const char*>(values), sizeof values);
      out.text.append(2, '\0');
    }
    out.record_done();
  }
}

}  // namespace arete::openmesh::detail
