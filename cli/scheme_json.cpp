// SPDX-License-Identifier: MIT
#include "cli/scheme_json.h"

#include <fstream>
#include <iterator>

#include "arete/analysis/limit_norm.h"
#include "arete/analysis/limit_stencil.h"
#include "arete/analysis/polynomial.h"
#include "cli/error.h"

namespace arete::cli {

Json stencil_json(const Stencil& stencil) {
  Json object = Json::object();
  for (std::size_t i = 0; i < stencil.weights.size(); ++i)
    if (stencil.weights[i] != 0)
      object[std::to_string(stencil.first + static_cast<int>(i))] = to_string(stencil.weights[i]);
  return object;
}

Json describe(const Scheme& scheme) {
  const Mask& mask = scheme.mask();
  Json coefficients = Json::array();
  for (const Rational& c : mask.coefficients()) coefficients.push_back(to_string(c));
  const auto stencil_or_null = [](const std::optional<Stencil>& stencil) {
    return stencil ? stencil_json(*stencil) : Json(nullptr);
  };
  const auto norm = limit_norm(mask);
  return {{"scheme", scheme.text()},
          {"arity", mask.arity()},
          {"first", mask.first()},
          {"mask", coefficients},
          {"tau", to_string(mask.tau())},
          {"sum_rules", sum_rules(mask)},
          {"reproduction_degree", reproduction_degree(mask)},
          {"interpolatory", is_interpolatory(mask)},
          {"overshoot", norm ? Json(to_string(norm->overshoot())) : Json(nullptr)},
          {"overshoot_of_surface",
           norm ? Json(to_string(norm->surface_overshoot(*norm))) : Json(nullptr)},
          {"overshoot_of_level", to_string(overshoot(mask))},
          {"limit_stencil", stencil_or_null(limit_stencil(mask))},
          {"derivative_stencil", stencil_or_null(derivative_stencil(mask))}};
}

Scheme scheme_from_json(const std::string& text, const std::string& where) {
  const auto object = nlohmann::json::parse(text, nullptr, false);
  if (object.is_discarded()) throw InvalidScheme(where + " is not JSON");
  if (!object.is_object() || !object.contains("scheme") || !object["scheme"].is_string())
    throw InvalidScheme(where +
                        " has no text under the key \"scheme\"; write it with "
                        "'arete describe SCHEME --json'");
  return parse_scheme(object["scheme"].get<std::string>());
}

Scheme read_scheme(const std::string& argument) {
  if (argument.empty() || argument.front() != '@') return parse_scheme(argument);
  const std::string path = argument.substr(1);
  std::ifstream stream(path);
  if (!stream) throw Failure("the scheme file " + path + " cannot be read; check the path");
  const std::string text(std::istreambuf_iterator<char>(stream), {});
  return scheme_from_json(text, path);
}

}  // namespace arete::cli
