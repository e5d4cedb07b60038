// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <utility>

#include "arete/scheme/mask.h"
#include "arete/scheme/parameter.h"

namespace arete {

/// A member of the catalogue with all its parameters chosen: a value made of a name and numbers
/// that has never met a grid or a mesh. Made by `make_scheme` or `parse_scheme` (catalogue.h).
class Scheme {
 public:
  Scheme(std::string name, ParameterValues parameters, Mask mask)
      : name_(std::move(name)), parameters_(std::move(parameters)), mask_(std::move(mask)) {}

  [[nodiscard]] const std::string& name() const { return name_; }
  /// Every parameter of the family in the family's order, defaults filled in.
  [[nodiscard]] const ParameterValues& parameters() const { return parameters_; }
  [[nodiscard]] const Mask& mask() const { return mask_; }

  /// `four-point:omega=1/16`: parse_scheme(text()) gives an equal scheme.
  [[nodiscard]] std::string text() const;

  [[nodiscard]] friend bool operator==(const Scheme&, const Scheme&) = default;

 private:
  std::string name_;
  ParameterValues parameters_;
  Mask mask_;
};

}  // namespace arete
