// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "arete/openmesh/mesh_io.h"

namespace arete::cli {

/// What `arete refine` was told about a mesh.
struct MeshJob {
  std::string input;
  std::string output;
  Scheme x;
  Scheme y;
  openmesh::MeshRefineOptions options{};
  bool single_precision = false;
  double max_memory = 0;
  bool overwrite = false;
  bool json = false;
};

/// Refines a mesh file into another, or into a .vtp, and reports on stdout.
/// \throws Misuse if the output is neither. \throws Failure
void refine_mesh_file(const MeshJob& job);

}  // namespace arete::cli
