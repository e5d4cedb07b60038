// SPDX-License-Identifier: MIT
// arete minimal: a surface of least area with a given boundary.
#include <cmath>
#include <iostream>
#include <memory>

#include "arete/variational/boundary_loop.h"
#include "cli/error.h"
#include "cli/interruption.h"
#include "cli/output_file.h"
#include "cli/points_csv.h"
#include "cli/progress.h"
#include "cli/scheme_json.h"
#include "cli/surface_file.h"
#include "cli/verb.h"

namespace arete::cli {
namespace {

struct MinimalArguments {
  std::string boundary;
  std::string other;
  std::string output;
  int levels = 4;
  std::vector<int> corners;
  bool smooth = false;
  double tolerance = 1e-7;
  int steps = 60;
  std::vector<double> view{30, 30};
  std::vector<int> size{1000, 800};
  bool overwrite = false;
  bool json = false;
};

std::vector<Point3> read_loop(const std::string& path) {
  const Points points = read_points(path);
  if (points.values.cols() != 3)
    throw Failure(path + " has " + std::to_string(points.values.cols()) +
                  " columns; a boundary in space needs x, y and z");
  std::vector<Point3> loop;
  for (Index r = 0; r < points.values.rows(); ++r)
    loop.push_back({points.values(r, 0), points.values(r, 1), points.values(r, 2)});
  // A loop whose last point repeats the first is meant as closed all the same.
  if (loop.size() > 1 && loop.front() == loop.back()) loop.pop_back();
  return loop;
}

PatchBoundary boundary_of(const MinimalArguments& a, const std::vector<Point3>& loop) {
  const std::vector<Point3> other = a.other.empty() ? std::vector<Point3>() : read_loop(a.other);
  try {
    return a.other.empty() ? patch_boundary(loop, a.corners, a.smooth)
                           : ring_boundary(loop, other, a.smooth);
  } catch (const InvalidField& error) {
    if (!a.corners.empty()) throw Misuse(std::string("--corners: ") + error.what());
    throw Failure(a.boundary + ": " + error.what());
  }
}

MinimalSurface solve(const MinimalArguments& a, const PatchBoundary& boundary) {
  MinimalOptions options;
  options.levels = a.levels;
  options.relax.tolerance = a.tolerance;
  options.relax.normal_steps = a.steps;
  ProgressBar progress("relaxing");
  // Every level costs about five times what the one before did, whatever the steps it takes.
  const double all = std::pow(5.0, a.levels + 1) - 1;
  int level = -1;
  options.relax.progress = [&](int step, double) {
    if (step == 1) ++level;
    const double done = std::pow(5.0, level) - 1 + 4 * std::pow(5.0, level) * step / (step + 6.0);
    progress.show(std::min(1.0, done / all));
  };
  return minimal_surface(boundary, options);
}

void report(const MinimalArguments& a, const MinimalSurface& surface) {
  const MinimalLevel& last = surface.levels.back();
  if (a.json) {
    Json levels = Json::array();
    for (const MinimalLevel& level : surface.levels)
      levels.push_back({{"rows", level.samples.rows},
                        {"cols", level.samples.cols},
                        {"start_area", level.start_area},
                        {"area", level.area},
                        {"max_mean_curvature", level.max_mean_curvature},
                        {"steps", level.steps},
                        {"converged", level.converged}});
    std::cout << Json{{"boundary", a.boundary},
                      {"output", a.output},
                      {"area", last.area},
                      {"max_mean_curvature", last.max_mean_curvature},
                      {"converged", last.converged},
                      {"levels", levels}}
                     .dump(2)
              << '\n';
    return;
  }
  for (const MinimalLevel& level : surface.levels)
    std::cout << level.samples.rows << " x " << level.samples.cols << ": area " << level.start_area
              << " -> " << level.area << " in " << level.steps << " steps, max |H| "
              << level.max_mean_curvature << '\n';
  std::cout << a.boundary << " -> " << a.output << '\n';
  if (!last.converged)
    std::cout << "note: it is not a minimal surface yet (max |H| above the tolerance); give more "
                 "--steps, or move the rings nearer together: there may be no surface between "
                 "them\n";
}

void run_minimal(const MinimalArguments& a) {
  check_surface_form(a.output);
  const std::vector<Point3> loop = read_loop(a.boundary);
  if (!a.other.empty() && !a.corners.empty())
    throw Misuse("--corners: a ring between two loops has none; leave it out");
  const PatchBoundary boundary = boundary_of(a, loop);
  OutputFile output(a.output, a.boundary, a.overwrite);
  const MinimalSurface surface = solve(a, boundary);
  write_surface(surface, {a.view[0], a.view[1], a.size[0], a.size[1]}, output.temporary());
  stop_if_interrupted();
  output.commit();
  report(a, surface);
}

}  // namespace

void add_minimal(CLI::App& program, Job& job) {
  CLI::App* verb = program.add_subcommand(
      "minimal", "The surface of least area with a given boundary: .vtp, .obj, .csv or .png");
  auto a = std::make_shared<MinimalArguments>();
  verb->add_option("BOUNDARY", a->boundary, "A closed loop of points x,y,z, one a line")
      ->required();
  verb->add_option("OUT", a->output,
                   "The format follows the extension: .vtp, .obj (triangles), .csv (points), .png")
      ->required();
  verb->add_option("--levels", a->levels, "How often the coarsest grid (4 x 4 cells) is refined")
      ->capture_default_str();
  verb->add_option("--ring", a->other, "A second loop: the surface between the two");
  verb->add_option("--corners", a->corners,
                   "Numbers of the four points where sides meet (default: quarters of the length)")
      ->delimiter(',');
  verb->add_flag("--smooth", a->smooth, "Cubic splines through the points, not straight edges");
  verb->add_option("--tolerance", a->tolerance, "Ends when max |H| sqrt(area) is below it")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  verb->add_option("--steps", a->steps, "Normal steps a level at most")
      ->check(CLI::Range(0, 100000))
      ->capture_default_str();
  verb->add_option("--view", a->view, "Of a .png: degrees AZIMUTH,ELEVATION")
      ->delimiter(',')
      ->expected(2)
      ->capture_default_str();
  verb->add_option("--size", a->size, "Of a .png: WIDTHxHEIGHT in pixels")
      ->delimiter('x')
      ->expected(2)
      ->check(CLI::Range(16, 8192))
      ->capture_default_str();
  verb->add_flag("--overwrite", a->overwrite, "Replace OUT if it exists");
  verb->add_flag("--json", a->json, "Print one JSON object about what was done");
  verb->callback([&job, a] { job = [a] { run_minimal(*a); }; });
}

}  // namespace arete::cli
