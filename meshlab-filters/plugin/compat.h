// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The only place that knows how releases of MeshLab differ, apart from the signatures in the two
// plugin classes. CMake finds out which release the headers are from.
#ifdef ARETE_MESHLAB_API_2021
#include <common/plugins/interfaces/filter_plugin.h>
#else
#include <common/interfaces.h>
#endif

namespace arete::meshlab {

#ifdef ARETE_MESHLAB_API_2021
using FilterBase = ::FilterPlugin;
#else
using FilterBase = ::MeshFilterInterface;
#endif

#ifdef ARETE_MESHLAB_RICH_PERCENTAGE
using RichLength = ::RichPercentage;
#else
using RichLength = ::RichAbsPerc;
#endif

inline void update_box_and_normals(MeshModel& mesh) {
#ifdef ARETE_MESHLAB_LOWER_CASE_UPDATE
  mesh.updateBoxAndNormals();
#else
  mesh.UpdateBoxAndNormals();
#endif
}

/// The textures of one mesh for another, too; since 2021.07 they come with their images.
template <class Mesh>
void copy_textures(const Mesh& from, Mesh& to) {
  if constexpr (requires { to.addTexture(std::string(), from.getTexture(std::string())); })
    for (const std::string& name : from.cm.textures) to.addTexture(name, from.getTexture(name));
  else
    to.cm.textures = from.cm.textures;
}

/// Since 2021.10 layers are deleted by their id.
template <class Document, class Mesh>
void remove_layer(Document& document, Mesh* layer) {
  if constexpr (requires { document.delMesh(layer); })
    document.delMesh(layer);
  else
    document.delMesh(layer->id());
}

}  // namespace arete::meshlab
