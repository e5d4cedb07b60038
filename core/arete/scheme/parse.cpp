// SPDX-License-Identifier: MIT
// From names and text to members of the catalogue: look-up, checks of values, the text form.
#include <algorithm>
#include <numeric>

#include "arete/scheme/catalogue.h"

namespace arete {
namespace {

std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t substituted = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({row[j] + 1, row[j + 1] + 1, substituted});
    }
  }
  return row.back();
}

std::string nearest_family(std::string_view name) {
  const Family* best = nullptr;
  std::size_t best_distance = 4;
  for (const Family& family : catalogue()) {
    const std::size_t distance = edit_distance(name.substr(0, 64), family.name);
    if (distance < best_distance) {
      best = &family;
      best_distance = distance;
    }
  }
  return best == nullptr ? "" : "; did you mean '" + best->name + "'?";
}

// The record that governs `key`: its own name, or a repeating one with a number behind it.
const Parameter* find_parameter(const Family& family, std::string_view key) {
  for (const Parameter& parameter : family.parameters) {
    if (!parameter.repeats && parameter.name == key) return &parameter;
    if (parameter.repeats && key.size() > parameter.name.size() && key.size() < 8 &&
        key.substr(0, parameter.name.size()) == parameter.name &&
        key.substr(parameter.name.size()).find_first_not_of("0123456789") == std::string_view::npos)
      return &parameter;
  }
  return nullptr;
}

std::string keys_of(const Family& family) {
  if (family.parameters.empty()) return "it takes no parameters";
  std::string keys = "its parameters are ";
  for (const Parameter& p : family.parameters)
    keys += (&p == &family.parameters.front() ? "" : ", ") + p.name + (p.repeats ? "0.." : "");
  return keys;
}

void check_value(const Family& family, const Parameter& parameter, const ParameterValue& value) {
  const std::string where = family.name + ": " + value.name;
  if (value.numbers.empty()) throw InvalidScheme(where + " has no value");
  if (parameter.kind != ParameterKind::list && value.numbers.size() != 1)
    throw InvalidScheme(where + " takes one number, not a list");
  for (const Rational& number : value.numbers) {
    if (number < parameter.accepted.lowest || number > parameter.accepted.highest)
      throw InvalidScheme(where + " = " + to_string(number) + " is out of range; choose from " +
                          to_string(parameter.accepted.lowest) + " to " +
                          to_string(parameter.accepted.highest));
    if (parameter.kind == ParameterKind::integer &&
        !is_integer(Rational((number - parameter.accepted.lowest) / parameter.step)))
      throw InvalidScheme(where + " = " + to_string(number) + " must be an integer" +
                          (parameter.step == 1
                               ? ""
                               : " in steps of " + std::to_string(parameter.step) + " from " +
                                     to_string(parameter.accepted.lowest)));
  }
}

// All values of a repeating parameter in order: name0, name1, ... without gaps.
ParameterValues repeated_values(const Family& family, const Parameter& parameter,
                                const ParameterValues& given) {
  ParameterValues found;
  for (std::size_t i = 0;; ++i) {
    const std::string key = parameter.name + std::to_string(i);
    const auto value =
        std::find_if(given.begin(), given.end(), [&](const auto& v) { return v.name == key; });
    if (value == given.end()) break;
    found.push_back(*value);
  }
  const auto wanted = std::count_if(given.begin(), given.end(), [&](const auto& v) {
    return find_parameter(family, v.name) == &parameter;
  });
  if (found.empty() || static_cast<std::size_t>(wanted) != found.size())
    throw InvalidScheme(family.name + ": give " + parameter.name + "0, " + parameter.name +
                        "1, ... without gaps");
  return found;
}

std::vector<std::string_view> split(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  for (;;) {
    const auto end = text.find(separator);
    parts.push_back(text.substr(0, end));
    if (end == std::string_view::npos) return parts;
    text.remove_prefix(end + 1);
  }
}

}  // namespace

const Family& find_family(std::string_view name) {
  for (const Family& family : catalogue())
    if (family.name == name) return family;
  throw InvalidScheme("there is no scheme '" + std::string(name.substr(0, 64)) + "'" +
                      nearest_family(name) + " ('arete schemes' lists all)");
}

Scheme make_scheme(std::string_view name, const ParameterValues& given) {
  const Family& family = find_family(name);
  for (auto value = given.begin(); value != given.end(); ++value) {
    const Parameter* parameter = find_parameter(family, value->name);
    if (parameter == nullptr)
      throw InvalidScheme(family.name + " has no parameter '" + value->name + "'; " +
                          keys_of(family));
    const bool twice =
        std::any_of(given.begin(), value, [&](const auto& v) { return v.name == value->name; });
    if (twice) throw InvalidScheme(family.name + ": " + value->name + " is given twice");
    check_value(family, *parameter, *value);
  }
  ParameterValues chosen;
  for (const Parameter& parameter : family.parameters) {
    if (parameter.repeats) {
      const ParameterValues values = repeated_values(family, parameter, given);
      chosen.insert(chosen.end(), values.begin(), values.end());
      continue;
    }
    const auto value = std::find_if(given.begin(), given.end(),
                                    [&](const auto& v) { return v.name == parameter.name; });
    if (value != given.end())
      chosen.push_back(*value);
    else if (parameter.fallback)
      chosen.push_back({parameter.name, {*parameter.fallback}});
    else
      throw InvalidScheme(family.name + ": " + parameter.name + " is missing (" +
                          parameter.meaning + ")");
  }
  Mask mask = family.build(chosen);
  return {family.name, std::move(chosen), std::move(mask)};
}

Scheme parse_scheme(std::string_view text) {
  constexpr std::size_t longest_text = 1 << 20;
  if (text.size() > longest_text) throw InvalidScheme("the scheme's text is longer than 1 MiB");
  const auto colon = text.find(':');
  const std::string_view name = text.substr(0, colon);
  ParameterValues values;
  if (colon != std::string_view::npos) {
    for (const std::string_view pair : split(text.substr(colon + 1), ',')) {
      const auto equals = pair.find('=');
      if (equals == std::string_view::npos || equals == 0)
        throw InvalidScheme("'" + std::string(pair.substr(0, 64)) + "' in the scheme '" +
                            std::string(name.substr(0, 64)) +
                            "' is not key=value; write e.g. four-point:omega=1/16");
      ParameterValue value{std::string(pair.substr(0, equals)), {}};
      for (const std::string_view number : split(pair.substr(equals + 1), ';')) {
        try {
          value.numbers.push_back(parse_rational(number));
        } catch (const std::invalid_argument& error) {
          throw InvalidScheme(std::string(name.substr(0, 64)) + ": " + value.name + ": " +
                              error.what());
        }
      }
      values.push_back(std::move(value));
    }
  }
  return make_scheme(name, values);
}

}  // namespace arete
