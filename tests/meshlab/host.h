// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "common/interfaces.h"
#include "common/pluginmanager.h"
#include "meshlab/grid_mesh.h"

namespace arete::meshlab::test {

/// MeshLab without its windows: the distribution's plugin manager and mesh importer, and our plugin
/// as it would be installed.
class Host {
 public:
  static Host& instance();

  [[nodiscard]] MeshFilterInterface& plugin() { return *plugin_; }
  [[nodiscard]] QAction& action(const std::string& filter_name);
  [[nodiscard]] MeshIOInterface& files(const std::string& extension);

 private:
  Host();
  PluginManager manager_;
  MeshFilterInterface* plugin_ = nullptr;
};

/// One document with one mesh, and the dialog of a filter on it.
class Document {
 public:
  /// An empty mesh.
  Document();
  /// The mesh as arrays, made by VCG's allocator: positions, triangles, polygon marks.
  explicit Document(const MeshArrays& arrays);
  /// A file, by MeshLab's own importer.
  explicit Document(const std::string& path);

  [[nodiscard]] MeshModel& mesh() { return *mesh_; }
  [[nodiscard]] CMeshO& cm() { return mesh_->cm; }
  [[nodiscard]] MeshDocument& document() { return document_; }

  struct Result {
    bool ok = false;
    std::string error;
    std::string log;
    int progress_calls = 0;
  };
  /// The default parameters with some replaced: numbers, or text.
  [[nodiscard]] RichParameterList dialog(const std::string& filter_name);
  Result apply(const std::string& filter_name, const std::map<std::string, double>& numbers = {},
               const std::string& scheme_text = "");

  /// Everything about the mesh that a refused filter must leave alone.
  [[nodiscard]] std::string fingerprint() const;

 private:
  MeshDocument document_;
  MeshModel* mesh_;
};

inline const char* const subdivide_filter = "Arete: Subdivide Terrain Grid";
inline const char* const limit_filter = "Arete: Compute Limit Positions And Normals";
inline const char* const smoothness_filter = "Arete: Smoothness To Log";
inline const char* const coarsen_filter = "Arete: Coarsen Terrain Grid (reverse subdivision)";
inline const char* const points_filter = "Arete: Terrain From Points";

}  // namespace arete::meshlab::test
