// SPDX-License-Identifier: MIT
#include "arete/openmesh/mesh_io.h"

#include <cctype>
#include <fstream>
#include <iterator>

#include "arete/openmesh/internal/mesh_text.h"

namespace arete::openmesh {
namespace {

struct Format {
  std::string extension;
  MeshData (*parse)(std::string_view);
  std::string (*print)(const MeshData&);
};

const Format formats[]{{"obj", detail::parse_obj, detail::obj_text},
                       {"ply", detail::parse_ply, detail::ply_bytes},
                       {"off", detail::parse_off, detail::off_text},
                       {"stl", detail::parse_stl, detail::stl_bytes}};

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

void write_mesh(const std::string& path, const MeshData& mesh, const std::string& extension) {
  const Format& format = format_of(path, extension.empty() ? lower_extension(path) : extension);
  const std::string bytes = format.print(mesh);
  std::ofstream stream(path, std::ios::binary);
  if (!stream) throw MeshFileError("cannot write '" + path + "'; check the folder and its rights");
  stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  stream.close();
  if (!stream) throw MeshFileError("cannot write '" + path + "'; is the disk full?");
}

}  // namespace arete::openmesh
