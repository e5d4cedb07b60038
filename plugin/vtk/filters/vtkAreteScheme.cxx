// SPDX-License-Identifier: MIT
#include "vtkAreteScheme.h"

#include <cmath>

#include "arete/algebra/simplest_rational.h"
#include "arete/scheme/catalogue.h"
#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkAreteScheme);

vtkAreteScheme::vtkAreteScheme() : Family("gentle") {}
vtkAreteScheme::~vtkAreteScheme() = default;

void vtkAreteScheme::SetFamily(const char* name) {
  const std::string family = name ? name : "";
  if (family == this->Family) return;
  this->Family = family;
  this->Parameters.clear();
  this->Modified();
}

void vtkAreteScheme::SetParameter(const char* name, double value) {
  // Whatever is not a number is passed on, so that the filter says what is wrong.
  const std::string text = std::isfinite(value) ? arete::to_string(arete::simplest_rational(value))
                                                : std::to_string(value);
  this->SetParameterText(name, text.c_str());
}

void vtkAreteScheme::SetParameterText(const char* name, const char* value) {
  if (!name) return;
  const auto found = this->Parameters.find(name);
  if (!value || !*value) {
    if (found == this->Parameters.end()) return;
    this->Parameters.erase(found);
  } else {
    if (found != this->Parameters.end() && found->second == value) return;
    this->Parameters[name] = value;
  }
  this->Modified();
}

void vtkAreteScheme::SetText(const char* text) {
  if (this->GetText() == std::string(text ? text : "")) return;
  const std::string whole = text ? text : "";
  const auto colon = whole.find(':');
  this->Family = whole.substr(0, colon);
  this->Parameters.clear();
  // Read by the filter; kept as one piece of text until a parameter is set.
  if (colon != std::string::npos) {
    std::size_t begin = colon + 1;
    while (begin <= whole.size()) {
      const std::size_t end = std::min(whole.find(',', begin), whole.size());
      const std::string pair = whole.substr(begin, end - begin);
      const auto equals = pair.find('=');
      this->Parameters[pair.substr(0, equals)] =
          equals == std::string::npos ? "" : pair.substr(equals + 1);
      begin = end + 1;
    }
  }
  this->Modified();
}

const char* vtkAreteScheme::GetText() {
  this->Text = this->Family;
  char separator = ':';
  for (const auto& [name, value] : this->Parameters) {
    this->Text += separator + name + '=' + value;
    separator = ',';
  }
  return this->Text.c_str();
}

int vtkAreteScheme::GetNumberOfFamilies() { return static_cast<int>(arete::catalogue().size()); }

const char* vtkAreteScheme::GetFamilyName(int index) {
  if (index < 0 || index >= vtkAreteScheme::GetNumberOfFamilies()) return nullptr;
  return arete::catalogue()[static_cast<std::size_t>(index)].name.c_str();
}

const char* vtkAreteScheme::GetFamilySummary(int index) {
  if (index < 0 || index >= vtkAreteScheme::GetNumberOfFamilies()) return nullptr;
  return arete::catalogue()[static_cast<std::size_t>(index)].summary.c_str();
}

void vtkAreteScheme::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Text: " << this->GetText() << "\n";
}
