// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

namespace arete::cli {

/// What `arete coarsen` says about a mesh.
struct CoarsenMeshArguments {
  std::string input;
  std::string output;
  std::string details;
  std::string scheme;
  std::string rim;
  std::string boundary;  ///< empty: not given
  std::string mode;
  int levels = 1;
  std::optional<double> threshold;
  std::optional<double> target_rmse;
  bool overwrite = false;
  bool json = false;
};

/// Takes a mesh apart. \throws Misuse, Failure
void coarsen_mesh(const CoarsenMeshArguments& arguments);

/// What `arete restore` says about a mesh.
struct RestoreMeshArguments {
  std::string coarse;
  std::string output;
  std::string details;
  std::optional<int> levels;
  bool edited = false;
  bool overwrite = false;
  bool json = false;
};

/// Gives a mesh back. \throws Misuse, Failure
void restore_mesh(const RestoreMeshArguments& arguments);

}  // namespace arete::cli
