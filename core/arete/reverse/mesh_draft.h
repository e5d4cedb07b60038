// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "arete/reverse/mesh_recover.h"

namespace arete::recovery {

// What the recoveries of the three schemes share: labels spread from one face, the coarse mesh is
// read off, and then checked by subdividing it.

using Labels = std::vector<int>;
constexpr int unknown = -1;

/// A coarse mesh as read off, on the fine mesh's vertex numbers.
struct Draft {
  std::vector<Index> vertices;                        ///< the fine vertices of the coarse ones
  std::vector<std::vector<Index>> faces;              ///< over those
  std::vector<Index> face_points;                     ///< Catmull-Clark: one for each face
  std::map<MeshNeighbours::Edge, Index> edge_points;  ///< by the ends' fine vertices
};

/// Why there is no coarse mesh: the obstacle of the candidate that came furthest.
class Obstacle {
 public:
  void met(std::size_t progress, std::string text) {
    if (!text_.empty() && progress <= progress_) return;
    progress_ = progress;
    text_ = std::move(text);
  }
  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  std::size_t progress_ = 0;
  std::string text_;
};

/// Sets faces and returns whether subdividing mesh.coarse gives the fine mesh, with fine vertex i
/// at place[i].
[[nodiscard]] bool fits(const MeshFaces& fine, RecoveredMesh& mesh, MeshScheme scheme);

/// The draft with coarse vertices numbered; nothing if it is no mesh or does not fit.
[[nodiscard]] std::optional<RecoveredMesh> finished(const MeshFaces& fine, const Draft& draft,
                                                    MeshScheme scheme, Obstacle& obstacle);

using Recovered = std::vector<RecoveredMesh>;
[[nodiscard]] Recovered catmull_clark(const MeshFaces& fine, const MeshNeighbours& mesh,
                                      Obstacle& obstacle);
[[nodiscard]] Recovered loop(const MeshFaces& fine, const MeshNeighbours& mesh, Obstacle& obstacle);
[[nodiscard]] Recovered doo_sabin(const MeshFaces& fine, const MeshNeighbours& mesh,
                                  Obstacle& obstacle);

/// Sets what the coarse positions of `parts` miss of the given ones, and what rounding misses then.
void set_details(MeshDecomposition<double>& parts, GridView<const double> positions);

}  // namespace arete::recovery
