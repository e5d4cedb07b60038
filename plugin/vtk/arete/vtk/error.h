// SPDX-License-Identifier: MIT
#pragma once

#include <stdexcept>

namespace arete::vtk {

/// A file that could not be written; the message names it, says why, and what to do. What was
/// written so far may lie at the path given: whoever wants all or nothing writes under a temporary
/// name and renames.
class WriteError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// No picture could be drawn (no OpenGL to be had, an option that names nothing).
class RenderError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace arete::vtk
