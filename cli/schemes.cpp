// SPDX-License-Identifier: MIT
// arete schemes: the catalogue with parameters, ranges, defaults.
#include <algorithm>
#include <iostream>
#include <memory>

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

}  // namespace

void add_schemes(CLI::App& program, Job& job) {
  CLI::App* verb = program.add_subcommand("schemes", "List the catalogue of schemes");
  auto json = std::make_shared<bool>(false);
  verb->add_flag("--json", *json, "Print one JSON object");
  verb->callback([&job, json] {
    job = [json] {
      if (*json)
        std::cout << catalogue_json().dump(2) << '\n';
      else
        print_catalogue();
    };
  });
}

}  // namespace arete::cli
