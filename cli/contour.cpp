// SPDX-License-Identifier: MIT
// arete contour: a closed contour at fewer and fewer points, with everything needed to come back.
#include <iostream>
#include <memory>

#include "arete/reverse/curve_reverse.h"
#include "cli/error.h"
#include "cli/interruption.h"
#include "cli/output_file.h"
#include "cli/points_csv.h"
#include "cli/scheme_json.h"
#include "cli/verb.h"
#ifdef ARETE_HAVE_VTK
#include "arete/vtk/plot_curve.h"
#endif

namespace arete::cli {
namespace {

struct ContourArguments {
  std::string input;
  std::string output;
  std::string scheme = "chaikin";
  int levels = 1;
  std::string mode;
  std::string pictures;
  bool overwrite = false;
  bool json = false;
};

void check_forms(const ContourArguments& a) {
  if (std::filesystem::path(a.output).extension() != ".csv")
    throw Misuse(a.output + ": a contour is a .csv; name the output so");
  if (!a.pictures.empty() && std::filesystem::path(a.pictures).extension() != ".png")
    throw Misuse(a.pictures + ": a picture is a .png; name it so");
#ifndef ARETE_HAVE_VTK
  if (!a.pictures.empty())
    throw Failure("--pictures: this arete was built without VTK; leave it out");
#endif
}

// Local filters where the scheme has them, as in the paper; otherwise least squares.
ReverseMode mode_for(const ContourArguments& a, const Scheme& scheme) {
  if (!a.mode.empty()) return parse_reverse_mode(a.mode);
  return local_rule(scheme.mask()) == LocalRule::none ? ReverseMode::least_squares
                                                      : ReverseMode::local;
}

// outline.png -> outline-3.png
std::string picture_path(const std::string& pictures, int level) {
  const std::filesystem::path path(pictures);
  return (path.parent_path() /
          (path.stem().string() + "-" + std::to_string(level) + path.extension().string()))
      .string();
}

// One picture a level: the contour given, and over it the polygon of that level.
std::vector<std::unique_ptr<OutputFile>> draw_levels(const ContourArguments& a,
                                                     const Decomposition<double>& parts,
                                                     const Points& contour) {
  std::vector<std::unique_ptr<OutputFile>> files;
  if (a.pictures.empty()) return files;
  if (parts.sizes.back() < 3)
    throw Failure("level " + std::to_string(a.levels) + " has " +
                  std::to_string(parts.sizes.back()) +
                  " points, which make no picture; use fewer levels");
#ifdef ARETE_HAVE_VTK
  constexpr Index most_marked_points = 200;
  for (int level = 0; level <= a.levels; ++level) {
    files.push_back(
        std::make_unique<OutputFile>(picture_path(a.pictures, level), a.input, a.overwrite));
    const Grid<double> polygon = reconstruct(parts, a.levels - level);
    const vtk::Polyline line{polygon.view(), true};
    if (polygon.rows() > most_marked_points)
      vtk::plot_curve(line, std::nullopt, {}, files.back()->temporary());
    else
      vtk::plot_curve({contour.values.view(), true}, line, {}, files.back()->temporary());
    stop_if_interrupted();
  }
#else
  (void)parts;
  (void)contour;
#endif
  return files;
}

double largest_difference(const Grid<double>& a, const Grid<double>& b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.samples().size(); ++i)
    largest = std::max(largest, std::abs(a.samples()[i] - b.samples()[i]));
  return largest;
}

void contour(const ContourArguments& a) {
  check_forms(a);
  const Scheme scheme = read_scheme(a.scheme);
  const Points points = read_points(a.input);
  const ReverseMode mode = mode_for(a, scheme);
  const auto parts =
      decompose<double>(points.values.view(), scheme, {a.levels, mode, true, Boundary::periodic});
  const double error = largest_difference(reconstruct(parts), points.values);
  OutputFile output(a.output, a.input, a.overwrite);
  write_points(output.temporary(), {points.header, parts.coarse});
  const auto pictures = draw_levels(a, parts, points);
  stop_if_interrupted();
  for (const auto& picture : pictures) picture->commit();
  output.commit();
  if (a.json) {
    std::cout << Json{{"input", a.input},        {"output", a.output},
                      {"scheme", scheme.text()}, {"mode", std::string(to_string(mode))},
                      {"levels", a.levels},      {"sizes", parts.sizes},
                      {"max_error", error}}
                     .dump(2)
              << '\n';
    return;
  }
  std::cout << a.input << " -> " << a.output << ": " << scheme.text() << ", " << to_string(mode)
            << ", points";
  for (const Index size : parts.sizes) std::cout << ' ' << size;
  std::cout << "; restored with its details to " << error << '\n';
}

}  // namespace

void add_contour(CLI::App& program, Job& job) {
  CLI::App* verb = program.add_subcommand(
      "contour", "Take a closed contour (.csv) apart, level by level, down to a few points (.csv)");
  auto a = std::make_shared<ContourArguments>();
  verb->add_option("IN", a->input, "Points of a closed contour, one a line, the last not repeated")
      ->required();
  verb->add_option("OUT", a->output, "The coarsest contour, a .csv")->required();
  verb->add_option("--scheme", a->scheme,
                   "Scheme whose refinement is undone ('arete schemes' lists all)")
      ->capture_default_str();
  verb->add_option("--levels", a->levels, "How many steps are undone; each halves the points")
      ->capture_default_str();
  verb->add_option("--mode", a->mode,
                   "local or least-squares (default: local where the scheme has local filters)");
  verb->add_option("--pictures", a->pictures,
                   "NAME.png: draw every level into NAME-0.png, NAME-1.png, ...");
  verb->add_flag("--overwrite", a->overwrite, "Replace the outputs if they exist");
  verb->add_flag("--json", a->json, "Print one JSON object about what was done");
  verb->callback([&job, a] { job = [a] { contour(*a); }; });
}

}  // namespace arete::cli
