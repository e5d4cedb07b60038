// SPDX-License-Identifier: MIT
#include "arete/openmesh/internal/mesh_text.h"

namespace arete::openmesh::detail {
namespace {

// 1 is the first, -1 the last so far.
int resolved(const Lines& lines, std::string_view word, std::size_t count, const char* kind) {
  const int index = lines.parsed<int>(word);
  const auto n = static_cast<long long>(count);
  const long long number = index > 0 ? index - 1LL : n + index;
  if (index == 0 || number < 0 || number >= n)
    lines.fail("a face names " + std::string(kind) + " " + std::string(word) + " of " +
               std::to_string(count));
  return static_cast<int>(number);
}

}  // namespace

MeshData parse_obj(std::string_view source) {
  // A backslash at the end of a line continues it.
  std::string text(source);
  for (std::size_t i = text.find('\\'); i != std::string::npos; i = text.find('\\', i + 1)) {
    std::size_t end = i + 1;
    if (end < text.size() && text[end] == '\r') ++end;
    if (end >= text.size() || text[end] != '\n') continue;
    for (std::size_t k = i; k <= end; ++k) text[k] = ' ';
  }
  MeshData mesh;
  std::vector<std::array<float, 2>> texcoords;
  std::vector<std::array<float, 3>> normals;
  bool any_texcoord = false;
  std::vector<int> face;
  Lines lines(text);
  while (lines.next()) {
    const auto& words = lines.words();
    if (words[0] == "v") {
      mesh.points.push_back(
          {lines.number<double>(1), lines.number<double>(2), lines.number<double>(3)});
      if (lines.size() >= 7) {
        mesh.colors.resize(mesh.points.size() - 1, {0, 0, 0, 255});
        mesh.colors.push_back({color_byte(lines.number<double>(4)),
                               color_byte(lines.number<double>(5)),
                               color_byte(lines.number<double>(6)), 255});
      }
    } else if (words[0] == "vt") {
      texcoords.push_back(
          {lines.number<float>(1), lines.size() > 2 ? lines.number<float>(2) : 0.0f});
    } else if (words[0] == "vn") {
      normals.push_back({lines.number<float>(1), lines.number<float>(2), lines.number<float>(3)});
    } else if (words[0] == "f") {
      face.clear();
      for (std::size_t i = 1; i < words.size(); ++i) {
        const std::size_t slash = words[i].find('/');
        face.push_back(resolved(lines, words[i].substr(0, slash), mesh.points.size(), "vertex"));
        std::array<float, 2> texcoord{};
        if (slash != std::string_view::npos) {
          const std::string_view rest = words[i].substr(slash + 1);
          const std::size_t second = rest.find('/');
          const std::string_view word = rest.substr(0, second);
          if (!word.empty()) {
            texcoord = texcoords[static_cast<std::size_t>(
                resolved(lines, word, texcoords.size(), "texture coordinate"))];
            any_texcoord = true;
          }
          if (second != std::string_view::npos && second + 1 < rest.size()) {
            mesh.normals.resize(mesh.points.size());
            mesh.normals[static_cast<std::size_t>(face.back())] = normals[static_cast<std::size_t>(
                resolved(lines, rest.substr(second + 1), normals.size(), "normal"))];
          }
        }
        mesh.corner_texcoords.push_back(texcoord);
      }
      mesh.faces.add(face);
    }
  }
  if (!any_texcoord) mesh.corner_texcoords.clear();
  if (!mesh.colors.empty()) mesh.colors.resize(mesh.points.size(), {0, 0, 0, 255});
  if (!mesh.normals.empty()) mesh.normals.resize(mesh.points.size());
  return mesh;
}

void write_obj(const MeshData& mesh, Output& out) {
  std::string& text = out.text;
  out.comments("# ");
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    text += 'v';
    for (double x : mesh.points[v]) {
      text += ' ';
      out.coordinate(x);
    }
    for (std::size_t k = 0; k < 3 && !mesh.colors.empty(); ++k)
      append(text += ' ', static_cast<float>(mesh.colors[v][k]) / 255.0f);
    text += '\n';
    out.record_done();
  }
  const auto list = [&](const char* word, const auto& vectors) {
    for (const auto& vector : vectors) {
      text += word;
      for (float x : vector) append(text += ' ', x);
      text += '\n';
      out.record_done();
    }
  };
  const bool at_corners = !mesh.corner_texcoords.empty();
  list("vt", at_corners ? mesh.corner_texcoords : mesh.texcoords);
  list("vn", mesh.normals);
  const bool textured = at_corners || !mesh.texcoords.empty();
  for (int f = 0; f < mesh.faces.count(); ++f) {
    text += 'f';
    int corner = mesh.faces.starts[static_cast<std::size_t>(f)];
    for (int v : mesh.faces[f]) {
      append(text += ' ', v + 1);
      ++corner;
      if (textured) append(text += '/', at_corners ? corner : v + 1);
      if (!mesh.normals.empty()) append(text += textured ? "/" : "//", v + 1);
    }
    text += '\n';
    out.record_done();
  }
}

}  // namespace arete::openmesh::detail
