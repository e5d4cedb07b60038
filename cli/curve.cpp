// SPDX-License-Identifier: MIT
// arete curve: refines a polygon of points.
#include <iostream>
#include <memory>

#include "arete/variational/cardinal.h"
#include "cli/cardinal_stencil.h"
#include "cli/curve_output.h"
#include "cli/curve_samples.h"
#include "cli/error.h"
#include "cli/interruption.h"
#include "cli/output_file.h"
#include "cli/scheme_json.h"
#include "cli/verb.h"

namespace arete::cli {
namespace {

struct CurveArguments {
  std::string input;
  std::string output;
  std::string scheme;
  std::string boundary = "extrapolate";
  bool closed = false;
  bool tau = false;
  bool interpolate = false;
  bool overwrite = false;
  bool json = false;
  CurveRequest request;
};

// The control points whose limit passes through the given points.
Grid<double> interpolating(const Grid<double>& points, const Scheme& scheme, Boundary boundary) {
  const CardinalAxis<double> axis(cardinal_stencil(scheme), boundary, points.rows());
  Grid<double> control = points;
  axis.solve_lines(control.row(0), control.cols(), control.cols());
  return control;
}

std::string name_of(const Points& points, Index column) {
  return points.header.empty() ? std::to_string(column)
                               : points.header[static_cast<std::size_t>(column)];
}

std::vector<Column> columns_of(const CurveSamples& curve, const Points& given, bool with_tau) {
  std::vector<Column> columns;
  if (with_tau) columns.push_back({"tau", curve.tau});
  for (Index c = 0; c < curve.tangents.cols(); ++c) {
    Column column{"d" + name_of(given, c), {}};
    for (Index r = 0; r < curve.tangents.rows(); ++r) column.values.push_back(curve.tangents(r, c));
    columns.push_back(std::move(column));
  }
  if (!curve.curvature.empty()) columns.push_back({"curvature", curve.curvature});
  return columns;
}

// Of the refined points; an added end may lie nearer.
double spacing_of(const std::vector<double>& tau) {
  if (tau.size() > 2) return tau[2] - tau[1];
  return tau.size() > 1 ? tau[1] - tau[0] : 0;
}

Json report(const CurveArguments& a, const Scheme& scheme, const CurveSamples& curve) {
  return {{"input", a.input},
          {"output", a.output},
          {"points", curve.points.rows()},
          {"dimension", curve.points.cols()},
          {"closed", a.closed},
          {"levels", a.request.levels},
          {"scheme", scheme.text()},
          {"interpolated", a.interpolate},
          {"first_parameter", curve.tau.front()},
          {"parameter_spacing", spacing_of(curve.tau)}};
}

void refine(const CurveArguments& a) {
  check_curve_form(a.output);
  const Scheme scheme = read_scheme(a.scheme);
  CurveRequest request = a.request;
  request.boundary = a.closed ? Boundary::periodic : parse_boundary(a.boundary);
  const Points given = read_points(a.input);
  const Grid<double> control =
      a.interpolate ? interpolating(given.values, scheme, request.boundary) : given.values;
  const CurveSamples curve = sample_curve(control, scheme, request);
  OutputFile output(a.output, a.input, a.overwrite);
  write_curve({curve.points, given.header, a.closed, curve.tau, columns_of(curve, given, a.tau),
               given.values},
              output.temporary());
  stop_if_interrupted();
  output.commit();
  if (a.json)
    std::cout << report(a, scheme, curve).dump(2) << '\n';
  else
    std::cout << a.input << " (" << given.values.rows() << " points) -> " << a.output << " ("
              << curve.points.rows() << " points): " << scheme.text() << ", " << a.request.levels
              << (a.request.levels == 1 ? " level" : " levels")
              << (a.interpolate ? ", limit through the points" : "") << '\n';
}

}  // namespace

void add_curve(CLI::App& program, Job& job) {
  CLI::App* verb = program.add_subcommand(
      "curve", "Refine a polygon of points (.csv) into points (.csv), a .vtp or a plot (.png)");
  auto a = std::make_shared<CurveArguments>();
  verb->add_option("IN", a->input, "Points, one a line, any number of columns (2 or 3 for VTK)")
      ->required();
  verb->add_option("OUT", a->output, "The format follows the extension: .csv, .vtp, .png")
      ->required();
  verb->add_option("--scheme", a->scheme, "Scheme, e.g. chaikin ('arete schemes' lists all)")
      ->required();
  verb->add_option("--levels", a->request.levels, "How many times the polygon is refined")
      ->capture_default_str();
  verb->add_flag("--closed", a->closed, "The last point joins the first (do not repeat it)");
  verb->add_option("--boundary", a->boundary,
                   "What open ends do: extrapolate, clamp, reflect or none")
      ->capture_default_str();
  verb->add_flag("--interpolate", a->interpolate,
                 "Find the control points whose limit passes through the given points");
  verb->add_flag("--limit", a->request.limit, "Put the points on the limit curve");
  verb->add_flag("--fixed-ends", a->request.fixed_ends,
                 "Begin and end at the first and the last control point");
  verb->add_flag("--tau", a->tau,
                 "Add a column: where each point lies among the control points 0, 1, ...");
  verb->add_flag("--tangents", a->request.tangents,
                 "Points on the limit curve, and columns of its derivatives by tau (.csv)");
  verb->add_flag("--curvature", a->request.curvature,
                 "Points on the limit curve, and a column of its curvature (.csv)");
  verb->add_flag("--overwrite", a->overwrite, "Replace OUT if it exists");
  verb->add_flag("--json", a->json, "Print one JSON object about what was done");
  verb->callback([&job, a] { job = [a] { refine(*a); }; });
}

}  // namespace arete::cli
