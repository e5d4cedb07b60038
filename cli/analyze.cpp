// SPDX-License-Identifier: MIT
// arete analyze: what a scheme is worth, with proof.
#include <iostream>
#include <memory>

#include "arete/analysis/basis_function.h"
#include "cli/analysis_report.h"
#include "cli/error.h"
#include "cli/interruption.h"
#include "cli/output_file.h"
#include "cli/time_limit.h"
#include "cli/verb.h"
#ifdef ARETE_HAVE_VTK
#include "arete/vtk/plot_functions.h"
#endif

namespace arete::cli {
namespace {

struct AnalyzeArguments {
  std::string scheme;
  int max_power = 8;
  double timeout = 60;
  std::string plot;
  bool overwrite = false;
  bool json = false;
};

#ifdef ARETE_HAVE_VTK
std::string derivative_name(const Scheme& scheme, int order) {
  if (order == 0) return "phi of " + (scheme.text().size() <= 80 ? scheme.text() : scheme.name());
  if (order <= 3) return "phi" + std::string(static_cast<std::size_t>(order), '\'');
  return "phi^(" + std::to_string(order) + ")";
}
#endif

// The basic limit function and its certified derivatives.
void plot_basis_function(const Scheme& scheme, int certified, const AnalyzeArguments& a) {
#ifdef ARETE_HAVE_VTK
  constexpr int most_derivatives = 5;
  std::vector<vtk::FunctionGraph> graphs;
  // Where linear data are reproduced, so that phi belongs to the sample at 0.
  const double shift = to_double(scheme.mask().tau()) / (scheme.mask().arity() - 1);
  for (int order = 0; order <= std::clamp(certified, 0, most_derivatives); ++order) {
    const BasisSamples samples = basis_function(scheme.mask(), order);
    vtk::FunctionGraph graph{derivative_name(scheme, order),
                             Grid<double>({static_cast<Index>(samples.values.size()), 2})};
    for (Index i = 0; i < graph.points.rows(); ++i) {
      graph.points(i, 0) = samples.first + samples.spacing * static_cast<double>(i) - shift;
      graph.points(i, 1) = samples.values[static_cast<std::size_t>(i)];
    }
    graphs.push_back(std::move(graph));
  }
  OutputFile output(a.plot, "", a.overwrite);
  const int height = graphs.size() == 1 ? 520 : 300 + 220 * static_cast<int>(graphs.size());
  vtk::plot_functions(graphs, "x", {900, height}, output.temporary());
  stop_if_interrupted();
  output.commit();
  if (certified < 0)
    std::cerr << "arete: no order is certified, so the plot shows what finitely many levels give\n";
#else
  (void)scheme;
  (void)certified;
  throw Failure(a.plot + ": this arete was built without VTK, which --plot needs");
#endif
}

void analyze(const AnalyzeArguments& a) {
  const Scheme scheme = read_scheme(a.scheme);
  if (!a.plot.empty() && std::filesystem::path(a.plot).extension() != ".png")
    throw Misuse(a.plot + ": a plot is a .png");
  Smoothness truth;
  {
    const TimeLimit limit(a.timeout, "'" + scheme.text().substr(0, 80) + "'");
    SmoothnessOptions options;
    options.max_power = a.max_power;
    options.jsr.stop = limit.stop();
    truth = analyze_smoothness(scheme.mask(), options);
    stop_if_interrupted();
    if (a.json)
      std::cout << analysis_json(scheme, truth).dump(2) << '\n';
    else
      print_analysis(scheme, truth);
  }
  if (!a.plot.empty()) plot_basis_function(scheme, truth.certified, a);
}

}  // namespace

void add_analyze(CLI::App& program, Job& job) {
  CLI::App* verb = program.add_subcommand(
      "analyze", "Say with proof how smooth a scheme is, beside what its paper claims");
  auto a = std::make_shared<AnalyzeArguments>();
  verb->add_option("SCHEME", a->scheme, "Text form, e.g. gentle, or @FILE.json")->required();
  verb->add_option("--max-power", a->max_power, "Highest power of the norms that are tried")
      ->check(CLI::Range(1, 16))
      ->capture_default_str();
  verb->add_option("--timeout", a->timeout,
                   "Seconds after which what is proved so far is printed and the rest is called "
                   "undecided; 0: no limit")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  verb->add_option("--plot", a->plot,
                   "Draw the basic limit function and its certified derivatives into this .png");
  verb->add_flag("--overwrite", a->overwrite, "Replace the plot if it exists");
  verb->add_flag("--json", a->json, "Print one JSON object");
  verb->callback([&job, a] { job = [a] { analyze(*a); }; });
}

}  // namespace arete::cli
