// SPDX-License-Identifier: MIT
// arete describe: what a scheme is, exactly.
#include <iostream>
#include <memory>

#include "cli/scheme_json.h"
#include "cli/verb.h"

namespace arete::cli {
namespace {

std::string stencil_text(const Json& stencil) {
  if (stencil.is_null()) return "none";
  std::string text;
  for (const auto& [offset, weight] : stencil.items())
    text += (text.empty() ? "" : ", ") + std::string("p[") + offset + "] * " +
            weight.get<std::string>();
  return text;
}

void print_description(const Scheme& scheme) {
  const Json d = describe(scheme);
  const int arity = d["arity"];
  std::cout << "scheme               " << scheme.text() << "\narity                " << arity
            << "\nmask                 " << coefficients_text(scheme.mask()) << "\n"
            << "                     on the indices " << scheme.mask().first() << " .. "
            << scheme.mask().last() << "\ntau                  " << d["tau"].get<std::string>()
            << "  (a new sample i lies at (i - tau)/" << arity << ")\n"
            << "sum rules            " << d["sum_rules"] << "\nreproduction degree  "
            << d["reproduction_degree"] << "\ninterpolatory        "
            << (d["interpolatory"].get<bool>() ? "yes" : "no") << "\novershoot            "
            << d["overshoot"].get<std::string>()
            << "  of the range of the input, at most, a level\n"
            << "limit at sample 0    " << stencil_text(d["limit_stencil"])
            << "\nderivative there     " << stencil_text(d["derivative_stencil"]) << '\n';
}

}  // namespace

void add_describe(CLI::App& program, Job& job) {
  CLI::App* verb = program.add_subcommand("describe", "Say what a scheme is, exactly");
  struct Options {
    std::string scheme;
    bool json = false;
  };
  auto options = std::make_shared<Options>();
  verb->add_option("SCHEME", options->scheme,
                   "Text form, e.g. four-point:omega=1/16, or @FILE.json")
      ->required();
  verb->add_flag("--json", options->json, "Print one JSON object");
  verb->callback([&job, options] {
    job = [options] {
      const Scheme scheme = read_scheme(options->scheme);
      if (options->json)
        std::cout << describe(scheme).dump(2) << '\n';
      else
        print_description(scheme);
    };
  });
}

}  // namespace arete::cli
