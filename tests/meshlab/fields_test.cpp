// SPDX-License-Identifier: GPL-3.0-or-later
#include "arete/meshlab/fields.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "arete/scheme/catalogue.h"

namespace arete::meshlab {
namespace {

TEST(fields, a_typed_decimal_means_that_decimal) {
  EXPECT_EQ(typed_number(0.1F), 0.1);
  EXPECT_EQ(exact_number(typed_number(0.1F)), Rational(1, 10));
  EXPECT_EQ(exact_number(typed_number(0.21875F)), Rational(7, 32));
  EXPECT_EQ(exact_number(typed_number(-0.045F)), Rational(-9, 200));
}

TEST(fields, ranges_and_wholeness_are_checked_and_named) {
  const std::vector<Field> fields{whole_field("Levels", "Levels", "", 2, 1, 10),
                                  choice_field("Boundary", "", "", {"a", "b"})};
  const auto refusal = [&](const char* name, double value) -> std::string {
    try {
      const Values values(fields, {{name, value}});
    } catch (const InvalidValue& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(refusal("Levels", 10), "");
  EXPECT_EQ(refusal("Levels", 11),
            "Levels = 11 cannot be used; choose a whole number from 1 to 10");
  EXPECT_NE(refusal("Levels", 1.5), "");
  EXPECT_NE(refusal("Levels", 0), "");
  EXPECT_NE(refusal("Levels", std::numeric_limits<double>::quiet_NaN()), "");
  EXPECT_NE(refusal("Boundary", 2), "");
  EXPECT_NE(refusal("Boundary", -1), "");
}

TEST(fields, what_is_not_given_keeps_its_default) {
  const std::vector<Field> fields{whole_field("Levels", "Levels", "", 2, 1, 10),
                                  flag_field("KeepQuads", "", "", true), text_field("T", "", "")};
  const Values values(fields, {{"Levels", 3.0}});
  EXPECT_EQ(values.whole("Levels"), 3);
  EXPECT_TRUE(values.flag("KeepQuads"));
  EXPECT_EQ(values.text("T"), "");
}

TEST(fields, a_parameter_record_becomes_a_field) {
  for (const Parameter& parameter : find_family("four-parameter").parameters) {
    const Field field = parameter_field(parameter);
    EXPECT_EQ(field.kind, FieldKind::number);
    EXPECT_EQ(field.lowest, to_double(parameter.accepted.lowest));
    EXPECT_EQ(field.highest, to_double(parameter.accepted.highest));
    EXPECT_EQ(field.fallback, to_double(*parameter.fallback));
    EXPECT_NE(field.tooltip.find(parameter.meaning), std::string::npos);
  }
  EXPECT_EQ(parameter_field(find_family("b-spline").parameters[0]).kind, FieldKind::whole);
}

}  // namespace
}  // namespace arete::meshlab
