// SPDX-License-Identifier: MIT
#include "arete/openmesh/mesh_io.h"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <iterator>

#include "arete/openmesh/internal/mesh_text.h"

namespace arete::openmesh {
namespace {

struct Format {
  std::string extension;
  MeshData (*parse)(std::string_view);
  void (*write)(const MeshData&, detail::Output&);
};

const Format formats[]{{"obj", detail::parse_obj, detail::write_obj},
                       {"ply", detail::parse_ply, detail::write_ply},
                       {"off", detail::parse_off, detail::write_off},
                       {"stl", detail::parse_stl, detail::write_stl}};

std::string lower_extension(const std::string& path) {
  const auto dot = path.find_last_of("./\\");
  if (dot == std::string::npos || path[dot] != '.') return "";
  std::string extension = path.substr(dot + 1);
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return extension;
}

const Format& format_of(const std::string& path, const std::string& extension) {
  for (const Format& format : formats)
    if (format.extension == extension) return format;
  throw MeshFileError("'" + path + "' is no mesh file; name it .obj, .ply, .off or .stl");
}

}  // namespace

bool is_mesh_file(const std::string& path) {
  const std::string extension = lower_extension(path);
  for (const Format& format : formats)
    if (format.extension == extension) return true;
  return false;
}

MeshData read_mesh(const std::string& path) {
  const Format& format = format_of(path, lower_extension(path));
  std::ifstream stream(path, std::ios::binary);
  if (!stream) throw MeshFileError("cannot open '" + path + "'; check the path");
  const std::string bytes{std::istreambuf_iterator<char>(stream), {}};
  try {
    MeshData mesh = format.parse(bytes);
    if (mesh.points.empty()) throw MeshFileError("it holds no vertex");
    return mesh;
  } catch (const MeshFileError& error) {
    throw MeshFileError("cannot read '" + path + "' as " + format.extension + ": " + error.what() +
                        "; is it another format, or cut short?");
  }
}

void write_mesh(const std::string& path, const MeshData& mesh, const MeshOutput& output) {
  const Format& format =
      format_of(path, output.format.empty() ? lower_extension(path) : output.format);
  std::ofstream stream(path, std::ios::binary);
  if (!stream) throw MeshFileError("cannot write '" + path + "'; check the folder and its rights");
  const std::size_t records = mesh.points.size() + static_cast<std::size_t>(mesh.faces.count()) +
                              mesh.texcoords.size() + mesh.corner_texcoords.size() +
                              mesh.normals.size();
  detail::Output out(records, output, [&](std::string_view piece, double share) {
    stream.write(piece.data(), static_cast<std::streamsize>(piece.size()));
    if (!stream) throw MeshFileError("cannot write '" + path + "'; is the disk full?");
    if (output.progress) output.progress(std::min(share, 1.0));
  });
  format.write(mesh, out);
  out.flush();
  stream.close();
  if (!stream) throw MeshFileError("cannot write '" + path + "'; is the disk full?");
}

std::vector<std::array<float, 2>> vertex_texcoords(const MeshData& mesh) {
  std::vector<std::array<float, 2>> texcoords(mesh.points.size());
  for (std::size_t i = 0; i < mesh.corner_texcoords.size(); ++i)
    texcoords[static_cast<std::size_t>(mesh.faces.corners[i])] = mesh.corner_texcoords[i];
  return texcoords;
}

bool is_seamless(const MeshData& mesh) {
  const auto texcoords = vertex_texcoords(mesh);
  for (std::size_t i = 0; i < mesh.corner_texcoords.size(); ++i)
    if (texcoords[static_cast<std::size_t>(mesh.faces.corners[i])] != mesh.corner_texcoords[i])
      return false;
  return true;
}

}  // namespace arete::openmesh
