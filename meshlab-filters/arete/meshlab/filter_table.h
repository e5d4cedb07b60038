// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "arete/meshlab/fields.h"
#include "arete/meshlab/mesh_arrays.h"
#include "arete/meshlab/progress.h"

namespace arete::meshlab {

/// What is known about the current mesh when a dialog opens; all 0 when there is none.
struct MeshFacts {
  double vertices = 0;
  bool polygonal = false;
  bool faces = false;
  double width = 0;   ///< of the box around it: along x
  double height = 0;  ///< along y
  double diagonal = 0;
};

/// Submenus of MeshLab's Filters menu; several may be or-ed.
enum Menu : unsigned {
  remeshing = 1,
  polygonal = 2,
  normal = 4,
  measure = 8,
  point_set = 16,
  sampling = 32
};

/// What a filter does to the mesh.
enum class Effect {
  replaces,  ///< vertices and faces: Outcome::refined
  moves,     ///< vertices and normals: Outcome::moved
  creates,   ///< nothing, it makes a new layer: Outcome::created (and Outcome::quality on request)
  reports    ///< nothing, it writes to the log
};

struct Outcome {
  std::optional<RefinedMesh> refined;
  std::optional<CreatedMesh> created;
  bool keep_quads = false;  ///< with these two: mark the diagonals as inside polygons
  std::optional<MovedMesh> moved;
  std::vector<float> quality;  ///< for every vertex of the old mesh; empty: it is not touched
};

/// One filter: everything about it that has nothing to do with MeshLab's classes.
struct Filter {
  std::string name;  ///< the menu entry and the name in scripts: never changed
  std::string info;  ///< simple HTML, shown at the top of the dialog
  unsigned menus = 0;
  Effect effect = Effect::reports;
  /// Every field with its default for that mesh. Names, kinds and order never depend on the mesh.
  std::function<std::vector<Field>(const MeshFacts&)> fields;
  /// \throws what has a message for the user: InvalidValue, InvalidScheme, InvalidField, Cancelled.
  std::function<Outcome(const MeshArrays&, const Values&, Report&)> run;
  bool needs_faces = true;  ///< Effect::reports never does
};

/// All filters; the position is the id.
[[nodiscard]] const std::vector<Filter>& filter_table();

}  // namespace arete::meshlab
