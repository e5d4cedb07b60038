// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "support/source_dir.h"

namespace arete::test {

/// How a run of the program ended.
struct Run {
  int exit_code = 0;  ///< 128 + number for a signal
  std::string out;
  std::string err;
};

using Arguments = std::vector<std::string>;

/// The program under test.
std::string program_path();

/// Runs `arete` with these arguments, no display, nothing on stdin. `while_running` is called with
/// its process id once it has started.
[[nodiscard]] Run run_arete(const Arguments& arguments,
                            const std::function<void(int)>& while_running = {});

/// Runs it and expects exit code 0 and one JSON object on stdout, nothing else.
[[nodiscard]] nlohmann::json run_json(const Arguments& arguments);

/// The bundled terrain.
inline const std::string dem = arete::test::source_dir() + "/data/jacksboro_srtm3.tif";

}  // namespace arete::test
