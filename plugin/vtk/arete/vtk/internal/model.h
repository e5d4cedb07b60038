// SPDX-License-Identifier: MIT
#pragma once

#include "arete/vtk/internal/terrain_mesh.h"
#include "arete/vtk/write_model.h"

namespace arete::vtk {

/// What the formats of models have in common.
struct Model {
  TerrainMesh mesh;
  Image texture;
  ModelReport report;
};

/// \throws as write_glb does, but for writing.
[[nodiscard]] Model make_model(const Surface& surface, const ModelOptions& options);

/// A file that is complete or complained about. \throws WriteError naming the file, from close()
/// and whenever a write fails.
class ModelFile {
 public:
  explicit ModelFile(const std::filesystem::path& path);
  ~ModelFile();
  ModelFile(const ModelFile&) = delete;
  ModelFile& operator=(const ModelFile&) = delete;

  void write(const void* bytes, std::size_t count);
  void close();

 private:
  [[noreturn]] void fail() const;

  std::filesystem::path path_;
  std::FILE* file_;
};

}  // namespace arete::vtk
