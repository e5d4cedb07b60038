// SPDX-License-Identifier: GPL-3.0-or-later
#include "arete/meshlab/scheme_fields.h"

#include "arete/scheme/catalogue.h"

namespace arete::meshlab {
namespace {

const std::string custom_family = "four-parameter";

std::vector<std::string> labels() {
  std::vector<std::string> result;
  for (const std::string& name : offered_families())
    result.push_back(name == custom_family ? name + " (the numbers below)"
                                           : make_scheme(name).text());
  return result;
}

}  // namespace

const std::vector<std::string>& offered_families() {
  static const std::vector<std::string> names{"gentle",
                                              "craggy",
                                              "four-point",
                                              "four-parameter",
                                              "four-parameter-c2",
                                              "b-spline",
                                              "dubuc-deslauriers",
                                              "chaikin",
                                              "de-rham",
                                              "corner-cutting",
                                              "two-parameter",
                                              "three-parameter",
                                              "three-point",
                                              "ternary-two-step",
                                              "ternary-two-step-9",
                                              "ternary-four-point"};
  return names;
}

std::vector<Field> scheme_fields() {
  std::vector<Field> fields{choice_field(
      "Scheme", "Scheme",
      "The subdivision scheme. gentle and craggy are the two printed landscapes; four-point and "
      "dubuc-deslauriers keep the given heights; b-spline smooths most. Only four-parameter reads "
      "the numbers below.",
      labels())};
  for (const Parameter& parameter : find_family(custom_family).parameters) {
    Field field = parameter_field(parameter);
    field.label += " (four-parameter)";
    fields.push_back(std::move(field));
  }
  fields.push_back(text_field(
      "SchemeText", "Scheme as text",
      "If not empty it is used instead of all the above: any scheme of the library in its text "
      "form, for example b-spline:degree=5 or four-parameter:lambda=7/32,mu=7/32,nu=1/2,omega=3/64 "
      "or mask:arity=2,first=-1,coefficients=1/2;1;1/2"));
  return fields;
}

Scheme chosen_scheme(const Values& values) {
  const std::string& text = values.text("SchemeText");
  if (text.find_first_not_of(" \t\r\n") != std::string::npos) {
    const auto first = text.find_first_not_of(" \t\r\n");
    const auto last = text.find_last_not_of(" \t\r\n");
    return parse_scheme(text.substr(first, last - first + 1));
  }
  const std::string& name = offered_families()[static_cast<std::size_t>(values.whole("Scheme"))];
  if (name != custom_family) return make_scheme(name);
  ParameterValues chosen;
  for (const Parameter& parameter : find_family(custom_family).parameters)
    chosen.push_back(
        {parameter.name, {exact_number(values.number(parameter_field(parameter).name))}});
  return make_scheme(name, chosen);
}

}  // namespace arete::meshlab
