// SPDX-License-Identifier: MIT
// arete describe: what a scheme is, exactly.
#include <cmath>
#include <cstdio>
#include <iostream>
#include <memory>

#include "cli/reverse_condition.h"
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

std::string share_text(const Json& share) {
  const Rational value = parse_rational(share.get<std::string>());
  if (value == 0) return "0";
  char text[32];
  // Rounded up: it is a bound.
  std::snprintf(text, sizeof text, "%.4f %%", std::ceil(to_double(value) * 1e6) / 1e4);
  return text;
}

// How far results can leave the range of the input, as shares of that range.
std::string overshoot_text(const Json& description) {
  if (description["overshoot"] == "0")
    return "none: limits and levels stay within the data's range";
  const std::string level = share_text(description["overshoot_of_level"]) + " a level";
  if (description["overshoot"].is_null()) return level + "; no bound for the limit was found";
  return share_text(description["overshoot"]) +
         " of the range of the input, at most, for limits (" + level +
         "; surfaces: " + share_text(description["overshoot_of_surface"]) + ")";
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
            << overshoot_text(d) << '\n'
            << "limit at sample 0    " << stencil_text(d["limit_stencil"])
            << "\nderivative there     " << stencil_text(d["derivative_stencil"])
            << "\nreverse, a level      " << reverse_condition_text(scheme.mask()) << '\n';
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
      if (!options->json) return print_description(scheme);
      Json object = describe(scheme);
      object["reverse"] = reverse_condition_json(scheme.mask());
      std::cout << object.dump(2) << '\n';
    };
  });
}

}  // namespace arete::cli
