// SPDX-License-Identifier: MIT
#include "arete/reverse/axis_reverse.h"

namespace arete {

ReverseMode parse_reverse_mode(std::string_view text) {
  for (const ReverseMode mode : {ReverseMode::local, ReverseMode::least_squares})
    if (to_string(mode) == text) return mode;
  throw InvalidField("there is no reverse mode '" + std::string(text.substr(0, 64)) +
                     "'; choose local or least-squares");
}

std::string_view to_string(ReverseMode mode) {
  return mode == ReverseMode::local ? "local" : "least-squares";
}

void refuse_local(const Mask& mask, const ReverseLevel& level) {
  const std::string which = "the scheme with the mask " + coefficients_text(mask);
  if (local_rule(mask) == LocalRule::none)
    throw InvalidScheme(which +
                        " has no reverse by local filters (interpolatory schemes, corner "
                        "cutting and the cubic B-spline have one); use the mode least-squares");
  throw InvalidScheme(which + " leaves a coarse sample at an end of " +
                      std::to_string(level.fine_count) +
                      " samples without its local filter; use the mode least-squares or a "
                      "periodic boundary");
}

void refuse_least_squares(const Mask& mask, const ReverseLevel& level) {
  throw InvalidScheme("the scheme with the mask " + coefficients_text(mask) +
                      " cannot be reversed: " + std::to_string(level.fine_count) +
                      " fine samples do not determine " + std::to_string(level.coarse_count) +
                      " coarse ones; choose another scheme");
}

}  // namespace arete
