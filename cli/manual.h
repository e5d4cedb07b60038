// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace arete::cli {

/// A page of the manual: its file's name (`arete-refine.1`) and its text in roff's man macros.
struct ManualPage {
  std::string file;
  std::string text;
};

/// One page for the program and one for each of its visible verbs, made from what the command line
/// itself knows, so that manual and program cannot disagree.
[[nodiscard]] std::vector<ManualPage> manual_pages(const CLI::App& program,
                                                   const std::string& version);

/// A completion for bash: verbs, the options of each, and the words an option takes; scheme names
/// where a scheme is wanted, files elsewhere.
[[nodiscard]] std::string bash_completion(const CLI::App& program);

}  // namespace arete::cli
