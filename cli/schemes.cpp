// SPDX-License-Identifier: MIT
// arete schemes: the catalogue with parameters, ranges, defaults.
#include <algorithm>
#include <iostream>
#include <memory>

#include "arete/analysis/polynomial.h"
#include "arete/analysis/smoothness.h"
#include "cli/scheme_json.h"
#include "cli/verb.h"

namespace arete::cli {
namespace {

const char* kind_name(ParameterKind kind) {
  switch (kind) {
    case ParameterKind::real:
      return "real";
    case ParameterKind::integer:
      return "integer";
    case ParameterKind::list:
      return "list";
  }
  return "";
}

Json range_json(const ParameterRange& range) {
  return Json::array({to_string(range.lowest), to_string(range.highest)});
}

Json catalogue_json() {
  Json families = Json::array();
  for (const Family& family : catalogue()) {
    Json parameters = Json::array();
    for (const Parameter& p : family.parameters)
      parameters.push_back({{"name", p.name},
                            {"symbol", p.symbol},
                            {"kind", kind_name(p.kind)},
                            {"repeats", p.repeats},
                            {"range", range_json(p.accepted)},
                            {"usual", range_json(p.usual)},
                            {"default", p.fallback ? Json(to_string(*p.fallback)) : Json(nullptr)},
                            {"meaning", p.meaning}});
    families.push_back({{"name", family.name},
                        {"summary", family.summary},
                        {"reference", family.reference},
                        {"parameters", parameters}});
  }
  return {{"schemes", families}};
}

std::string padded(std::string text, std::size_t width) {
  text.resize(std::max(width, text.size() + 1), ' ');
  return text;
}

void print_catalogue() {
  for (const Family& family : catalogue()) {
    std::cout << family.name << "\n    " << family.summary;
    if (!family.reference.empty()) std::cout << "\n    [" << family.reference << "]";
    std::cout << '\n';
    for (const Parameter& p : family.parameters) {
      std::cout << "      " << padded(p.name + (p.repeats ? "0, " + p.name + "1, ..." : ""), 14)
                << padded(p.fallback ? "default " + to_string(*p.fallback) : "must be given", 16)
                << padded(p.kind == ParameterKind::list
                              ? "a;b;c;..."
                              : to_string(p.usual.lowest) + " .. " + to_string(p.usual.highest),
                          16)
                << p.meaning << '\n';
    }
  }
  std::cout
      << "\nWrite a scheme as name or name:key=value,key=value, e.g. "
         "four-parameter:lambda=7/32,mu=7/32,nu=1/2,omega=3/64.\n"
         "The ranges are the useful ones; 'arete schemes --json' also has what is accepted.\n";
}

// The part of a family's documentation page that the catalogue and the default member decide.
void print_markdown(const Family& family) {
  std::cout << "**" << family.name << "**: " << family.summary << ".\n";
  if (!family.reference.empty()) std::cout << "Source: " << family.reference << ".\n";
  if (!family.parameters.empty()) {
    std::cout << "\n| parameter | symbol | default | usual | accepted | meaning |\n"
              << "|---|---|---|---|---|---|\n";
    for (const Parameter& p : family.parameters) {
      const auto range = [](const ParameterRange& r) {
        return to_string(r.lowest) + " .. " + to_string(r.highest);
      };
      std::cout << "| `" << p.name << (p.repeats ? "0`, `" + p.name + "1`, ..." : "`") << " | "
                << p.symbol << " | " << (p.fallback ? to_string(*p.fallback) : "-") << " | "
                << range(p.usual) << " | " << range(p.accepted) << " | " << p.meaning << " |\n";
    }
  }
  const bool has_default = std::all_of(family.parameters.begin(), family.parameters.end(),
                                       [](const Parameter& p) { return p.fallback.has_value(); });
  if (!has_default) return;
  const Scheme scheme = make_scheme(family.name);
  const Mask& mask = scheme.mask();
  const Smoothness truth = analyze_smoothness(mask);
  std::cout << "\n| `" << scheme.text() << "` | |\n|---|---|\n";
  std::cout << "| arity | " << mask.arity() << " |\n| mask on " << mask.first() << " .. "
            << mask.last() << " | ";
  if (mask.coefficients().size() <= 20)
    std::cout << coefficients_text(mask);
  else
    std::cout << mask.coefficients().size() << " coefficients (`arete describe " << scheme.name()
              << "`)";
  std::cout << " |\n| tau | " << to_string(mask.tau()) << " |\n| sum rules | " << sum_rules(mask)
            << " |\n| reproduces polynomials to degree | " << reproduction_degree(mask)
            << " |\n| interpolates | " << (is_interpolatory(mask) ? "yes" : "no")
            << " |\n| certified | C^" << truth.certified << " |\n| refuted | "
            << (truth.refuted_at ? "C^" + std::to_string(*truth.refuted_at) : "-")
            << " |\n| Hoelder exponent | ";
  std::cout.precision(7);
  std::cout << truth.hoelder.lower
            << (truth.hoelder.attained == Attained::no ? ", not attained" : "") << " |\n";
}

}  // namespace

void add_schemes(CLI::App& program, Job& job) {
  CLI::App* verb = program.add_subcommand("schemes", "List the catalogue of schemes");
  auto json = std::make_shared<bool>(false);
  auto markdown = std::make_shared<std::string>();
  verb->add_flag("--json", *json, "Print one JSON object");
  verb->add_option("--markdown", *markdown, "Print the facts of one family as Markdown");
  verb->callback([&job, json, markdown] {
    job = [json, markdown] {
      if (!markdown->empty())
        print_markdown(find_family(*markdown));
      else if (*json)
        std::cout << catalogue_json().dump(2) << '\n';
      else
        print_catalogue();
    };
  });
}

}  // namespace arete::cli
