// SPDX-License-Identifier: MIT
// arete spline: the natural cubic spline through points, by subdivision.
#include <iostream>
#include <memory>

#include "arete/variational/natural_spline.h"
#include "cli/curve_output.h"
#include "cli/curve_samples.h"
#include "cli/error.h"
#include "cli/interruption.h"
#include "cli/output_file.h"
#include "cli/scheme_json.h"
#include "cli/verb.h"

namespace arete::cli {
namespace {

struct SplineArguments {
  std::string input;
  std::string output;
  int levels = 4;
  bool closed = false;
  bool polygon = false;
  bool tau = false;
  bool tangents = false;
  bool curvature = false;
  bool overwrite = false;
  bool json = false;
};

Grid<double> grid_of(const Matrix<double>& matrix) {
  Grid<double> grid({matrix.rows(), matrix.cols()});
  for (int r = 0; r < matrix.rows(); ++r)
    for (int c = 0; c < matrix.cols(); ++c) grid(r, c) = matrix(r, c);
  return grid;
}

NaturalSpline<double> spline_through(const Points& given, const SplineArguments& a) {
  constexpr Index most = 1LL << 30;
  if (a.levels < 0 || a.levels > 30 || (given.values.rows() << a.levels) > most)
    throw Misuse("--levels " + std::to_string(a.levels) + " of " +
                 std::to_string(given.values.rows()) +
                 " points: give 0 or more, up to 2^30 points in all");
  Matrix<double> points(static_cast<int>(given.values.rows()),
                        static_cast<int>(given.values.cols()));
  for (int r = 0; r < points.rows(); ++r)
    for (int c = 0; c < points.cols(); ++c) points(r, c) = given.values(r, c);
  return NaturalSpline<double>(points, a.closed ? SplineEnds::closed : SplineEnds::natural);
}

std::vector<Column> columns_of(const NaturalSpline<double>& spline, const Points& given,
                               const SplineArguments& a, const std::vector<double>& tau) {
  std::vector<Column> columns;
  if (a.tau) columns.push_back({"tau", tau});
  if (!a.tangents && !a.curvature) return columns;
  const Grid<double> first = grid_of(spline.derivatives(a.levels));
  for (Index c = 0; a.tangents && c < first.cols(); ++c) {
    Column column{"d" + (given.header.empty() ? "" : given.header[static_cast<std::size_t>(c)]),
                  {}};
    for (Index r = 0; r < first.rows(); ++r) column.values.push_back(first(r, c));
    columns.push_back(std::move(column));
  }
  if (a.curvature)
    columns.push_back(
        {"curvature", curvature_of(first, grid_of(spline.second_derivatives(a.levels)))});
  return columns;
}

void run_spline(const SplineArguments& a) {
  check_curve_form(a.output);
  const Points given = read_points(a.input);
  if (a.polygon && (a.tangents || a.curvature))
    throw Misuse("--polygon: control points have no tangents or curvature; leave one of them out");
  if (a.curvature && given.values.cols() < 2)
    throw Misuse("--curvature: points of one coordinate are not a curve in space");
  const NaturalSpline<double> spline = spline_through(given, a);
  CurveFile curve{grid_of(a.polygon ? spline.refined(a.levels) : spline.points(a.levels)),
                  given.header,
                  a.closed,
                  {},
                  {},
                  given.values};
  for (Index r = 0; r < curve.points.rows(); ++r)
    curve.tau.push_back(static_cast<double>(r) / static_cast<double>(1LL << a.levels));
  curve.columns = columns_of(spline, given, a, curve.tau);
  OutputFile output(a.output, a.input, a.overwrite);
  write_curve(curve, output.temporary());
  stop_if_interrupted();
  output.commit();
  if (a.json)
    std::cout << Json{{"input", a.input},
                      {"output", a.output},
                      {"points", curve.points.rows()},
                      {"dimension", curve.points.cols()},
                      {"closed", a.closed},
                      {"levels", a.levels},
                      {"bending_energy", spline.bending_energy()}}
                     .dump(2)
              << '\n';
  else
    std::cout << a.input << " (" << given.values.rows() << " points) -> " << a.output << " ("
              << curve.points.rows() << " points): " << (a.closed ? "closed" : "natural")
              << " cubic spline, bending energy " << spline.bending_energy() << '\n';
}

}  // namespace

void add_spline(CLI::App& program, Job& job) {
  CLI::App* verb = program.add_subcommand(
      "spline", "The natural cubic spline through points (.csv), as .csv, .vtp or a plot (.png)");
  auto a = std::make_shared<SplineArguments>();
  verb->add_option("IN", a->input, "Points, one a line, any number of columns (2 or 3 for VTK)")
      ->required();
  verb->add_option("OUT", a->output, "The format follows the extension: .csv, .vtp, .png")
      ->required();
  verb->add_option("--levels", a->levels, "2^levels points from one given point to the next")
      ->capture_default_str();
  verb->add_flag("--closed", a->closed, "The last point joins the first (do not repeat it)");
  verb->add_flag("--polygon", a->polygon,
                 "The control polygon refined so often, rather than points of the spline");
  verb->add_flag("--tau", a->tau, "Add a column: the parameter, 0, 1, ... at the given points");
  verb->add_flag("--tangents", a->tangents, "Add columns: the derivatives by tau (.csv)");
  verb->add_flag("--curvature", a->curvature, "Add a column: the curvature (.csv)");
  verb->add_flag("--overwrite", a->overwrite, "Replace OUT if it exists");
  verb->add_flag("--json", a->json, "Print one JSON object about what was done");
  verb->callback([&job, a] { job = [a] { run_spline(*a); }; });
}

}  // namespace arete::cli
