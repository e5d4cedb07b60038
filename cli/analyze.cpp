// SPDX-License-Identifier: MIT
// arete analyze: what a scheme is worth, with proof.
#include <iomanip>
#include <iostream>
#include <memory>
#include <sstream>

#include "arete/analysis/theorem.h"
#include "cli/error.h"
#include "cli/interruption.h"
#include "cli/output_file.h"
#include "cli/scheme_json.h"
#include "cli/verb.h"
#ifdef ARETE_HAVE_VTK
#include "arete/refine/curve.h"
#include "arete/vtk/plot_curve.h"
#endif

namespace arete::cli {
namespace {

struct AnalyzeArguments {
  std::string scheme;
  int max_power = 8;
  std::string plot;
  bool overwrite = false;
  bool json = false;
};

const char* verdict_name(Verdict verdict) {
  switch (verdict) {
    case Verdict::certified:
      return "certified";
    case Verdict::refuted:
      return "refuted";
    case Verdict::undecided:
      return "undecided";
  }
  return "";
}

const char* comparison_text(Comparison comparison) {
  switch (comparison) {
    case Comparison::confirmed:
      return "confirmed by the certificate";
    case Comparison::contradicted:
      return "CONTRADICTED: this is a counterexample";
    case Comparison::too_weak:
      return "does not apply, although the order is certified";
    case Comparison::silent:
      return "does not apply";
    case Comparison::open:
      return "holds, not decided independently";
  }
  return "";
}

Json three_valued(bool known, bool value) { return known ? Json(value) : Json(nullptr); }

Json theorem_json(const TheoremResult& theorem, const Smoothness& truth) {
  Json values = Json::array();
  for (const Rational& value : theorem.values) values.push_back(to_string(value));
  Json residuals = Json::array();
  for (const Rational& residual : theorem.residuals) residuals.push_back(to_string(residual));
  const auto largest = std::max_element(theorem.values.begin(), theorem.values.end());
  return {{"name", theorem.name},
          {"statement", theorem.statement},
          {"claims", theorem.claims},
          {"holds", theorem.holds},
          {"value", largest == theorem.values.end() ? Json(nullptr) : Json(to_string(*largest))},
          {"values", values},
          {"residuals", residuals},
          {"sound", theorem.sound},
          {"verdict", comparison_text(compare(theorem, truth))},
          {"remark", theorem.remark}};
}

Json analysis_json(const Scheme& scheme, const Smoothness& truth) {
  Json object = describe(scheme);
  object["smoothness"] = {{"certified", truth.certified},
                          {"power", truth.certificate.power},
                          {"norm", to_string(truth.certificate.norm)}};
  object["refuted_at"] = truth.refuted_at ? Json(*truth.refuted_at) : Json(nullptr);
  const HoelderBounds& hoelder = truth.hoelder;
  object["hoelder"] = {{"lower", hoelder.lower},
                       {"upper", hoelder.upper},
                       {"attained", three_valued(hoelder.attained != Attained::unknown,
                                                 hoelder.attained == Attained::yes)},
                       {"word", to_text(hoelder.jsr.word)}};
  object["stable"] =
      three_valued(hoelder.stability != Stability::unknown, hoelder.stability == Stability::stable);
  Json orders = Json::array();
  for (const OrderVerdict& order : truth.orders)
    orders.push_back({{"order", order.order},
                      {"verdict", verdict_name(order.verdict)},
                      {"proof", explanation(order)}});
  object["orders"] = orders;
  Json theorems = Json::array();
  for (const TheoremResult& theorem : theorems_for(scheme))
    theorems.push_back(theorem_json(theorem, truth));
  object["theorems"] = theorems;
  return object;
}

void print_analysis(const Scheme& scheme, const Smoothness& truth) {
  const HoelderBounds& hoelder = truth.hoelder;
  std::cout << "scheme             " << scheme.text() << "\nmask               "
            << coefficients_text(scheme.mask()) << "\nsmoothness         "
            << (truth.certified < 0 ? "no order certified"
                                    : "C^" + std::to_string(truth.certified) + " certified")
            << (truth.refuted_at ? ", not C^" + std::to_string(*truth.refuted_at) : "") << '\n';
  for (const OrderVerdict& order : truth.orders)
    std::cout << "    C^" << order.order << "  " << std::left << std::setw(11)
              << verdict_name(order.verdict) << explanation(order) << '\n';
  std::cout << std::setprecision(10) << "Hoelder exponent   ";
  if (hoelder.jsr.closed())
    std::cout << hoelder.lower;
  else
    std::cout << hoelder.lower << " .. " << hoelder.upper;
  if (hoelder.stability != Stability::stable) std::cout << " (a lower bound: shifts not stable)";
  if (hoelder.attained == Attained::yes) std::cout << ", attained";
  if (hoelder.attained == Attained::no) std::cout << ", not attained";
  if (!hoelder.jsr.word.empty())
    std::cout << "\n    decided by the word " << to_text(hoelder.jsr.word);
  std::cout << "\nshifts             "
            << (hoelder.stability == Stability::stable     ? "stable"
                : hoelder.stability == Stability::unstable ? "not stable"
                                                           : "stability not decided")
            << '\n';
  const std::vector<TheoremResult> theorems = theorems_for(scheme);
  if (!theorems.empty()) std::cout << "published statements\n";
  for (const TheoremResult& theorem : theorems) {
    std::cout << "    " << theorem.name << (theorem.sound ? "" : " (false as printed)") << ": "
              << theorem.statement << "\n        ";
    for (const Rational& value : theorem.values) std::cout << "value " << to_string(value) << "  ";
    for (const Rational& residual : theorem.residuals)
      std::cout << "residual " << to_string(residual) << "  ";
    std::cout << (theorem.holds ? "holds" : "does not hold") << "; "
              << comparison_text(compare(theorem, truth)) << '\n';
    if (!theorem.remark.empty()) std::cout << "        " << theorem.remark << '\n';
  }
}

// The basic limit function: an impulse refined until its polygon looks like its limit.
void plot_basis_function(const Scheme& scheme, const AnalyzeArguments& a) {
#ifdef ARETE_HAVE_VTK
  const Mask& mask = scheme.mask();
  const Index reach =
      2 + std::max(std::abs(mask.first()), std::abs(mask.last())) / (mask.arity() - 1);
  Grid<double> impulse({2 * reach + 1, 2});
  for (Index i = 0; i <= 2 * reach; ++i) impulse(i, 0) = static_cast<double>(i - reach);
  impulse(reach, 1) = 1;
  int levels = 0;
  for (Index count = impulse.rows(); count < 4000; count *= mask.arity()) ++levels;
  Curve<double> curve =
      refine_curve<double>(impulse.view(), scheme, {levels, false, Boundary::clamp});
  for (Index i = 0; i < curve.points.rows(); ++i)
    curve.points(i, 0) = curve.parameter.first + static_cast<double>(i) * curve.parameter.spacing -
                         static_cast<double>(reach);
  vtk::PlotOptions options;
  options.equal_axes = false;
  OutputFile output(a.plot, "", a.overwrite);
  vtk::plot_curve({curve.points.view()}, vtk::Polyline{impulse.view()}, options,
                  output.temporary());
  stop_if_interrupted();
  output.commit();
#else
  (void)scheme;
  throw Failure(a.plot + ": this arete was built without VTK, which --plot needs");
#endif
}

void analyze(const AnalyzeArguments& a) {
  const Scheme scheme = read_scheme(a.scheme);
  SmoothnessOptions options;
  options.max_power = a.max_power;
  const Smoothness truth = analyze_smoothness(scheme.mask(), options);
  stop_if_interrupted();
  if (!a.plot.empty()) plot_basis_function(scheme, a);
  if (a.json)
    std::cout << analysis_json(scheme, truth).dump(2) << '\n';
  else
    print_analysis(scheme, truth);
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
  verb->add_option("--plot", a->plot, "Draw the basic limit function into this .png");
  verb->add_flag("--overwrite", a->overwrite, "Replace the plot if it exists");
  verb->add_flag("--json", a->json, "Print one JSON object");
  verb->callback([&job, a] { job = [a] { analyze(*a); }; });
}

}  // namespace arete::cli
