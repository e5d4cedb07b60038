// SPDX-License-Identifier: GPL-3.0-or-later
#include "arete/meshlab/fields.h"

#include <charconv>
#include <cmath>
#include <limits>
#include <utility>

namespace arete::meshlab {
namespace {

std::string decimal(double value) {
  char text[64];
  return {text, std::to_chars(text, text + sizeof text, value).ptr};
}

std::string range_text(double lowest, double highest) {
  return decimal(lowest) + " to " + decimal(highest);
}

std::string camel_case(const std::string& name) {
  std::string result = name;
  result.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(result.front())));
  return result;
}

void check(const Field& field, double value) {
  const bool whole = field.kind == FieldKind::choice || field.kind == FieldKind::whole;
  if (field.kind == FieldKind::flag) return;
  if (std::isfinite(value) && value >= field.lowest && value <= field.highest &&
      (!whole || value == std::floor(value)))
    return;
  throw InvalidValue(field.name + " = " + decimal(value) + " cannot be used; choose " +
                     (whole ? "a whole number from " : "a number from ") +
                     range_text(field.lowest, field.highest));
}

Field ranged(FieldKind kind, std::string name, std::string label, std::string tooltip,
             double fallback, double lowest, double highest) {
  return {std::move(name),
          std::move(label),
          std::move(tooltip),
          kind,
          fallback,
          "",
          lowest,
          highest,
          {}};
}

}  // namespace

Field choice_field(std::string name, std::string label, std::string tooltip,
                   std::vector<std::string> choices, int fallback) {
  const double highest = static_cast<double>(choices.size()) - 1;
  Field field = ranged(FieldKind::choice, std::move(name), std::move(label), std::move(tooltip),
                       fallback, 0, highest);
  field.choices = std::move(choices);
  return field;
}

Field whole_field(std::string name, std::string label, std::string tooltip, int fallback,
                  int lowest, int highest) {
  tooltip += " (" + range_text(lowest, highest) + ")";
  return ranged(FieldKind::whole, std::move(name), std::move(label), std::move(tooltip), fallback,
                lowest, highest);
}

Field number_field(std::string name, std::string label, std::string tooltip, double fallback,
                   double lowest, double highest) {
  tooltip += " (" + range_text(lowest, highest) + ")";
  return ranged(FieldKind::number, std::move(name), std::move(label), std::move(tooltip), fallback,
                lowest, highest);
}

Field flag_field(std::string name, std::string label, std::string tooltip, bool fallback) {
  return ranged(FieldKind::flag, std::move(name), std::move(label), std::move(tooltip),
                fallback ? 1.0 : 0.0, 0, 1);
}

Field text_field(std::string name, std::string label, std::string tooltip) {
  return ranged(FieldKind::text, std::move(name), std::move(label), std::move(tooltip), 0, 0, 0);
}

Field length_field(std::string name, std::string label, std::string tooltip, double fallback,
                   double scale) {
  return ranged(FieldKind::length, std::move(name), std::move(label), std::move(tooltip), fallback,
                double(std::numeric_limits<float>::min()), scale);
}

Field parameter_field(const Parameter& parameter) {
  const double lowest = to_double(parameter.accepted.lowest);
  const double highest = to_double(parameter.accepted.highest);
  return ranged(
      parameter.kind == ParameterKind::integer ? FieldKind::whole : FieldKind::number,
      camel_case(parameter.name), parameter.name,
      parameter.meaning + ". Usually " +
          range_text(to_double(parameter.usual.lowest), to_double(parameter.usual.highest)) +
          "; accepted " + range_text(lowest, highest),
      parameter.fallback ? to_double(*parameter.fallback) : lowest, lowest, highest);
}

Values::Values(const std::vector<Field>& fields, const std::map<std::string, Value>& given) {
  for (const Field& field : fields) {
    const auto found = given.find(field.name);
    if (field.kind == FieldKind::text) {
      values_[field.name] =
          found == given.end() ? field.text_fallback : std::get<std::string>(found->second);
      continue;
    }
    const double value = found == given.end() ? field.fallback : std::get<double>(found->second);
    check(field, value);
    values_[field.name] = value;
  }
}

double Values::number(const std::string& name) const { return std::get<double>(values_.at(name)); }

const std::string& Values::text(const std::string& name) const {
  return std::get<std::string>(values_.at(name));
}

double typed_number(float value) {
  if (!std::isfinite(value)) return value;
  char text[64];
  const auto end = std::to_chars(text, text + sizeof text, value).ptr;
  double result = value;
  std::from_chars(text, end, result);
  return result;
}

Rational exact_number(double value) { return parse_rational(decimal(value)); }

}  // namespace arete::meshlab
