// SPDX-License-Identifier: MIT
// arete curve: refines a polygon of points.
#include "arete/refine/curve.h"

#include <iostream>
#include <memory>

#include "cli/error.h"
#include "cli/interruption.h"
#include "cli/output_file.h"
#include "cli/points_csv.h"
#include "cli/scheme_json.h"
#include "cli/verb.h"
#ifdef ARETE_HAVE_VTK
#include "arete/vtk/plot_curve.h"
#include "arete/vtk/write_polyline.h"
#endif

namespace arete::cli {
namespace {

struct CurveArguments {
  std::string input;
  std::string output;
  std::string scheme;
  int levels = 1;
  std::string boundary = "extrapolate";
  bool closed = false;
  bool tau = false;
  bool overwrite = false;
  bool json = false;
};

std::vector<double> parameters(const Curve<double>& curve) {
  std::vector<double> tau;
  for (Index i = 0; i < curve.points.rows(); ++i)
    tau.push_back(curve.parameter.first + static_cast<double>(i) * curve.parameter.spacing);
  return tau;
}

// The refined points in the columns of the input, and tau as the last one on request.
Points table_of(const Curve<double>& curve, const Points& control, bool with_tau) {
  Points table{control.header, curve.points};
  if (!with_tau) return table;
  if (!table.header.empty()) table.header.emplace_back("tau");
  table.values = Grid<double>({curve.points.rows(), curve.points.cols() + 1});
  const std::vector<double> tau = parameters(curve);
  for (Index r = 0; r < curve.points.rows(); ++r) {
    std::copy_n(curve.points.row(r), curve.points.cols(), table.values.row(r));
    table.values(r, curve.points.cols()) = tau[static_cast<std::size_t>(r)];
  }
  return table;
}

#ifdef ARETE_HAVE_VTK
// So many control points would hide the curve.
std::optional<vtk::Polyline> polygon_to_draw(const Points& control, bool closed) {
  constexpr Index most_points = 200;
  if (control.values.rows() > most_points) return std::nullopt;
  return vtk::Polyline{control.values.view(), closed};
}
#endif

void write_curve(const CurveArguments& a, const Curve<double>& curve, const Points& control,
                 const std::filesystem::path& path) {
  const std::string form = path.extension().string();
  if (form == ".csv") {
    write_points(path, table_of(curve, control, a.tau));
    return;
  }
#ifdef ARETE_HAVE_VTK
  const std::vector<double> tau = parameters(curve);
  const vtk::Polyline line{curve.points.view(), a.closed, tau};
  if (form == ".vtp")
    vtk::write_polyline(line, path);
  else
    vtk::plot_curve(line, polygon_to_draw(control, a.closed), {}, path);
#endif
}

void check_form(const std::string& output) {
  const std::string form = std::filesystem::path(output).extension().string();
  if (form != ".csv" && form != ".vtp" && form != ".png")
    throw Misuse(output + ": the format '" + form +
                 "' is not one of .csv, .vtp, .png; name the output so");
#ifndef ARETE_HAVE_VTK
  if (form != ".csv") throw Failure(output + ": this arete was built without VTK; write a .csv");
#endif
}

void refine(const CurveArguments& a) {
  check_form(a.output);
  const Scheme scheme = read_scheme(a.scheme);
  const CurveOptions options{a.levels, a.closed, parse_boundary(a.boundary)};
  const Points control = read_points(a.input);
  const Curve<double> curve = refine_curve<double>(control.values.view(), scheme, options);
  OutputFile output(a.output, a.input, a.overwrite);
  write_curve(a, curve, control, output.temporary());
  stop_if_interrupted();
  output.commit();
  if (a.json)
    std::cout << Json{{"input", a.input},
                      {"output", a.output},
                      {"points", curve.points.rows()},
                      {"dimension", curve.points.cols()},
                      {"closed", a.closed},
                      {"levels", a.levels},
                      {"scheme", scheme.text()},
                      {"first_parameter", curve.parameter.first},
                      {"parameter_spacing", curve.parameter.spacing}}
                     .dump(2)
              << '\n';
  else
    std::cout << a.input << " (" << control.values.rows() << " points) -> " << a.output << " ("
              << curve.points.rows() << " points): " << scheme.text() << ", " << a.levels
              << (a.levels == 1 ? " level" : " levels") << '\n';
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
  verb->add_option("--levels", a->levels, "How many times the polygon is refined")
      ->capture_default_str();
  verb->add_flag("--closed", a->closed, "The last point joins the first (do not repeat it)");
  verb->add_option("--boundary", a->boundary,
                   "What open ends do: extrapolate, clamp, reflect or none")
      ->capture_default_str();
  verb->add_flag("--tau", a->tau,
                 "Add a column: where each point lies among the control points 0, 1, ...");
  verb->add_flag("--overwrite", a->overwrite, "Replace OUT if it exists");
  verb->add_flag("--json", a->json, "Print one JSON object about what was done");
  verb->callback([&job, a] { job = [a] { refine(*a); }; });
}

}  // namespace arete::cli
