// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>
#include <functional>

namespace arete::cli {

/// What main() runs after the command line is read. Set by the verb that was named.
using Job = std::function<void()>;

/// Each verb adds itself to the program with its options and, when named, sets the job.
void add_schemes(CLI::App& program, Job& job);
void add_describe(CLI::App& program, Job& job);
void add_analyze(CLI::App& program, Job& job);
void add_map(CLI::App& program, Job& job);
void add_curve(CLI::App& program, Job& job);
void add_ifs(CLI::App& program, Job& job);
void add_spline(CLI::App& program, Job& job);
void add_minimal(CLI::App& program, Job& job);
void add_grid(CLI::App& program, Job& job);
void add_refine(CLI::App& program, Job& job);
void add_coarsen(CLI::App& program, Job& job);
void add_restore(CLI::App& program, Job& job);
void add_contour(CLI::App& program, Job& job);
void add_compare(CLI::App& program, Job& job);
void add_fit(CLI::App& program, Job& job);
void add_render(CLI::App& program, Job& job);
void add_generate(CLI::App& program, Job& job);
void add_validate(CLI::App& program, Job& job);

}  // namespace arete::cli
