// SPDX-License-Identifier: MIT
#include "arete/openmesh/internal/mesh_text.h"

namespace arete::openmesh::detail {
namespace {

// Whole numbers are 0..255, others 0..1.
std::uint8_t color_of(const Lines& lines, std::size_t i) {
  const double x = lines.number<double>(i);
  return lines.words()[i].find_first_of(".eE") == std::string_view::npos ? color_byte(x / 255)
                                                                         : color_byte(x);
}

}  // namespace

MeshData parse_off(std::string_view text) {
  Lines lines(text);
  if (!lines.next()) lines.fail("the file is empty");
  const std::string kind(lines.words()[0]);
  const std::size_t end = kind.find("OFF");
  if (end == std::string::npos || end + 3 != kind.size()) lines.fail("OFF is expected here");
  const std::string prefix = kind.substr(0, end);
  if (prefix.find_first_of("4n") != std::string::npos)
    lines.fail(kind + " is not three-dimensional");
  if (lines.size() > 1 && lines.words()[1] == "BINARY")
    lines.fail("binary OFF is not read; save it as text");
  std::size_t first = 1;
  if (lines.size() == 1) {
    if (!lines.next()) lines.fail("the numbers of vertices and faces are missing");
    first = 0;
  }
  const auto vertices = lines.number<unsigned>(first);
  const auto faces = lines.number<unsigned>(first + 1);

  MeshData mesh;
  for (unsigned v = 0; v < vertices; ++v) {
    if (!lines.next())
      lines.fail("the file ends after " + std::to_string(v) + " vertices of " +
                 std::to_string(vertices));
    mesh.points.push_back(
        {lines.number<double>(0), lines.number<double>(1), lines.number<double>(2)});
    std::size_t i = 3;
    if (prefix.find('N') != std::string::npos) {
      mesh.normals.push_back(
          {lines.number<float>(3), lines.number<float>(4), lines.number<float>(5)});
      i = 6;
    }
    const bool textured = prefix.find("ST") != std::string::npos;
    if (prefix.find('C') != std::string::npos) {
      const bool opacity = lines.size() >= i + 4 + (textured ? 2 : 0);
      mesh.colors.push_back({color_of(lines, i), color_of(lines, i + 1), color_of(lines, i + 2),
                             opacity ? color_of(lines, i + 3) : std::uint8_t{255}});
      i += opacity ? 4 : 3;
    }
    if (textured) mesh.texcoords.push_back({lines.number<float>(i), lines.number<float>(i + 1)});
  }
  std::vector<int> face;
  for (unsigned f = 0; f < faces; ++f) {
    if (!lines.next())
      lines.fail("the file ends after " + std::to_string(f) + " faces of " + std::to_string(faces));
    face.clear();
    const auto corners = lines.number<unsigned>(0);
    for (unsigned i = 1; i <= corners; ++i) face.push_back(lines.number<int>(i));
    mesh.faces.add(face);
  }
  return mesh;
}

void write_off(const MeshData& mesh, Output& out) {
  std::string& text = out.text;
  std::vector<std::array<float, 2>> seamless;
  if (mesh.texcoords.empty() && !mesh.corner_texcoords.empty() && is_seamless(mesh))
    seamless = vertex_texcoords(mesh);
  const auto& texcoords = mesh.texcoords.empty() ? seamless : mesh.texcoords;
  text += texcoords.empty() ? "" : "ST";
  text += mesh.colors.empty() ? "" : "C";
  text += mesh.normals.empty() ? "OFF\n" : "NOFF\n";
  out.comments("# ");
  append(text, mesh.points.size());
  append(text += ' ', mesh.faces.count());
  text += " 0\n";
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (k > 0) text += ' ';
      out.coordinate(mesh.points[v][k]);
    }
    if (!mesh.normals.empty())
      for (float x : mesh.normals[v]) append(text += ' ', x);
    if (!mesh.colors.empty())
      for (std::uint8_t c : mesh.colors[v]) append(text += ' ', static_cast<int>(c));
    if (!texcoords.empty())
      for (float t : texcoords[v]) append(text += ' ', t);
    text += '\n';
    out.record_done();
  }
  for (int f = 0; f < mesh.faces.count(); ++f) {
    append(text, mesh.faces[f].size());
    for (int v : mesh.faces[f]) append(text += ' ', v);
    text += '\n';
    out.record_done();
  }
}

}  // namespace arete::openmesh::detail
