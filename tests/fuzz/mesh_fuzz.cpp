// SPDX-License-Identifier: MIT
// Any bytes as a mesh file, OBJ, OFF, PLY or STL as the first byte says: they are refused, or every
// attribute is whole, and the mesh is planned for refinement or refused in its turn.
#include <unistd.h>

#include <array>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <string>

#include "arete/field/error.h"
#include "arete/openmesh/mesh_io.h"
#include "arete/scheme/catalogue.h"

namespace {

using namespace arete;

// A file of this process alone.
std::string path_of(const char* extension) {
  const char* folder = std::getenv("TMPDIR");
  return std::string(folder != nullptr ? folder : "/tmp") + "/arete-mesh-fuzz-" +
         std::to_string(getpid()) + extension;
}

void require(bool law) {
  if (!law) std::abort();
}

void read(const std::string& path) {
  static const Scheme scheme = parse_scheme("gentle");
  try {
    const openmesh::MeshData mesh = openmesh::read_mesh(path);
    for (const std::size_t size : {mesh.normals.size(), mesh.colors.size(), mesh.texcoords.size()})
      require(size == 0 || size == mesh.points.size());
    require(mesh.corner_texcoords.empty() ||
            mesh.corner_texcoords.size() == mesh.faces.corners.size());
    (void)openmesh::refined_size(mesh, scheme, scheme, {});
  } catch (const openmesh::MeshFileError&) {
  } catch (const InvalidField&) {  // no grid among them
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  constexpr std::array extensions{".obj", ".off", ".ply", ".stl"};
  const std::string path = path_of(extensions[data[0] % extensions.size()]);
  std::ofstream(path, std::ios::binary)
      .write(reinterpret_cast<const char*>(data + 1), static_cast<std::streamsize>(size - 1));
  read(path);
  unlink(path.c_str());
  return 0;
}
