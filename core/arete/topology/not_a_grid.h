// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "arete/field/error.h"

namespace arete {

/// A mesh that is no regular grid. The message names the first offending vertex or face, says what
/// is wrong there and what to do; the numbers are there for a program that wants to point at it.
class NotAGrid : public InvalidField {
 public:
  [[nodiscard]] static NotAGrid at_vertex(int vertex, const std::string& what) {
    return {"vertex " + std::to_string(vertex) + " " + what, vertex, -1};
  }
  [[nodiscard]] static NotAGrid at_face(int face, const std::string& what) {
    return {"face " + std::to_string(face) + " " + what, -1, face};
  }

  /// -1 when it is a face that offends.
  [[nodiscard]] int vertex() const { return vertex_; }
  /// -1 when it is a vertex that offends.
  [[nodiscard]] int face() const { return face_; }

 private:
  NotAGrid(const std::string& message, int vertex, int face)
      : InvalidField(message), vertex_(vertex), face_(face) {}

  int vertex_;
  int face_;
};

}  // namespace arete
