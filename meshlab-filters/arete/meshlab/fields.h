// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

#include "arete/scheme/parameter.h"

namespace arete::meshlab {

/// What a user typed cannot be used; the message says which field and what it takes.
class InvalidValue : public std::invalid_argument {
 public:
  using std::invalid_argument::invalid_argument;
};

enum class FieldKind {
  choice,
  whole,
  number,
  flag,
  text,
  length  ///< a number in the units of the mesh, which a dialog also shows as part of `highest`
};

/// One field of a filter's dialog. `name` is what scripts use: never changed.
struct Field {
  std::string name;  ///< short CamelCase ASCII
  std::string label;
  std::string tooltip;
  FieldKind kind = FieldKind::number;
  double fallback = 0;        ///< choice: the number of the choice; flag: 0 or 1
  std::string text_fallback;  ///< FieldKind::text only
  double lowest = 0;          ///< what is accepted, both ends included; not for flag and text
  double highest = 0;
  std::vector<std::string> choices;  ///< FieldKind::choice only; the order is what scripts use
};

[[nodiscard]] Field choice_field(std::string name, std::string label, std::string tooltip,
                                 std::vector<std::string> choices, int fallback = 0);
[[nodiscard]] Field whole_field(std::string name, std::string label, std::string tooltip,
                                int fallback, int lowest, int highest);
[[nodiscard]] Field number_field(std::string name, std::string label, std::string tooltip,
                                 double fallback, double lowest, double highest);
[[nodiscard]] Field flag_field(std::string name, std::string label, std::string tooltip,
                               bool fallback);
[[nodiscard]] Field text_field(std::string name, std::string label, std::string tooltip);
/// What is accepted is more than 0 up to `scale`, the size of the mesh.
[[nodiscard]] Field length_field(std::string name, std::string label, std::string tooltip,
                                 double fallback, double scale);
/// From a row of the catalogue; the range is what the catalogue accepts, the tooltip tells the
/// usual one, too.
[[nodiscard]] Field parameter_field(const Parameter& parameter);

/// The value of every field of a filter, checked: all ranges hold, whole numbers are whole.
class Values {
 public:
  using Value = std::variant<double, std::string>;

  /// Fields that are not given keep their default.
  /// \throws InvalidValue naming the field and its range.
  Values(const std::vector<Field>& fields, const std::map<std::string, Value>& given);

  [[nodiscard]] double number(const std::string& name) const;
  [[nodiscard]] int whole(const std::string& name) const { return static_cast<int>(number(name)); }
  [[nodiscard]] bool flag(const std::string& name) const { return number(name) != 0; }
  [[nodiscard]] const std::string& text(const std::string& name) const;

 private:
  std::map<std::string, Value> values_;
};

/// The number that a user who saw a float in a dialog meant: 0.1F is 0.1.
[[nodiscard]] double typed_number(float value);
[[nodiscard]] inline double typed_number(double value) { return value; }
/// The exact decimal with the fewest digits that reads back as `value`: 0.1 is 1/10.
[[nodiscard]] Rational exact_number(double value);

}  // namespace arete::meshlab
