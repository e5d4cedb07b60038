// SPDX-License-Identifier: MIT
#include "cli/reverse_condition.h"

#include <cstdio>

#include "arete/reverse/condition.h"

namespace arete::cli {
namespace {

Json json_of(const std::optional<ReverseCondition>& condition) {
  if (!condition) return nullptr;
  return {{"noise_gain", condition->noise_gain}, {"condition", condition->condition}};
}

std::string text_of(const std::optional<ReverseCondition>& condition) {
  if (!condition) return "none";
  char text[80];
  std::snprintf(text, sizeof text, "noise x %.3f, condition %.3g", condition->noise_gain,
                condition->condition);
  return text;
}

}  // namespace

Json reverse_condition_json(const Mask& mask) {
  return {{"least_squares", json_of(reverse_condition(mask, ReverseMode::least_squares))},
          {"local", json_of(reverse_condition(mask, ReverseMode::local))}};
}

std::string reverse_condition_text(const Mask& mask) {
  return "least squares: " + text_of(reverse_condition(mask, ReverseMode::least_squares)) +
         "; local: " + text_of(reverse_condition(mask, ReverseMode::local));
}

}  // namespace arete::cli
