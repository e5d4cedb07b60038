// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <vtkAreteScheme.h>
#include <vtkNew.h>

#include <set>

#include "arete/scheme/catalogue.h"
#include "support/schemes.h"

namespace arete {
namespace {

TEST(scheme_object, knows_the_families_of_the_catalogue) {
  ASSERT_EQ(vtkAreteScheme::GetNumberOfFamilies(), static_cast<int>(catalogue().size()));
  std::set<std::string> names;
  for (int i = 0; i < vtkAreteScheme::GetNumberOfFamilies(); ++i) {
    names.insert(vtkAreteScheme::GetFamilyName(i));
    EXPECT_FALSE(std::string(vtkAreteScheme::GetFamilySummary(i)).empty());
  }
  for (const Family& family : catalogue()) EXPECT_EQ(names.count(family.name), 1u) << family.name;
  EXPECT_EQ(vtkAreteScheme::GetFamilyName(-1), nullptr);
  EXPECT_EQ(vtkAreteScheme::GetFamilyName(1000), nullptr);
}

TEST(scheme_object, text_set_is_the_same_scheme_when_read_again) {
  for (const Scheme& scheme : test::sample_schemes()) {
    const vtkNew<vtkAreteScheme> object;
    object->SetText(scheme.text().c_str());
    EXPECT_EQ(parse_scheme(object->GetText()), scheme) << object->GetText();
  }
}

TEST(scheme_object, defaults_and_doubles_give_the_exact_members_of_the_catalogue) {
  for (const Family& family : catalogue()) {
    const vtkNew<vtkAreteScheme> object;
    object->SetFamily(family.name.c_str());
    bool complete = true;
    for (const Parameter& parameter : family.parameters) {
      if (parameter.fallback)
        object->SetParameter(parameter.name.c_str(), to_double(*parameter.fallback));
      else
        complete = false;
    }
    if (!complete) continue;
    EXPECT_EQ(parse_scheme(object->GetText()), make_scheme(family.name));
  }
}

TEST(scheme_object, another_family_forgets_parameters_and_changes_count_as_such) {
  const vtkNew<vtkAreteScheme> object;
  object->SetFamily("four-point");
  object->SetParameter("omega", 0.1);
  EXPECT_STREQ(object->GetText(), "four-point:omega=1/10");
  auto time = object->GetMTime();
  object->SetParameter("omega", 0.1);
  object->SetFamily("four-point");
  EXPECT_EQ(object->GetMTime(), time);
  object->SetParameterText("omega", "3/32");
  EXPECT_GT(object->GetMTime(), time);
  EXPECT_STREQ(object->GetText(), "four-point:omega=3/32");
  object->SetParameterText("omega", "");
  EXPECT_STREQ(object->GetText(), "four-point");
  object->SetParameter("omega", 0.1);
  object->SetFamily("chaikin");
  EXPECT_STREQ(object->GetText(), "chaikin");
  object->SetText(nullptr);
  EXPECT_STREQ(object->GetText(), "");
}

}  // namespace
}  // namespace arete
