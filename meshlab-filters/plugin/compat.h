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

inline void update_box_and_normals(MeshModel& mesh) {
#ifdef ARETE_MESHLAB_LOWER_CASE_UPDATE
  mesh.updateBoxAndNormals();
#else
  mesh.UpdateBoxAndNormals();
#endif
}

}  // namespace arete::meshlab
