// SPDX-License-Identifier: MIT
#include "vtkAreteFilter.h"

#include <algorithm>

#include "arete/field/boundary.h"
#include "vtkAreteScheme.h"

vtkCxxSetObjectMacro(vtkAreteFilter, SchemeObject, vtkAreteScheme);

static_assert(vtkAreteFilter::EXTRAPOLATE == static_cast<int>(arete::Boundary::extrapolate) &&
              vtkAreteFilter::CLAMP == static_cast<int>(arete::Boundary::clamp) &&
              vtkAreteFilter::REFLECT == static_cast<int>(arete::Boundary::reflect) &&
              vtkAreteFilter::PERIODIC == static_cast<int>(arete::Boundary::periodic) &&
              vtkAreteFilter::NONE == static_cast<int>(arete::Boundary::none));

vtkAreteFilter::vtkAreteFilter() { this->SetScheme("gentle"); }

vtkAreteFilter::~vtkAreteFilter() {
  this->SetScheme(nullptr);
  this->SetSchemeY(nullptr);
  this->SetSchemeObject(nullptr);
}

void vtkAreteFilter::SetBoundary(int rule) {
  this->SetBoundaryX(rule);
  this->SetBoundaryY(rule);
}

const char* vtkAreteFilter::GetSchemeInUse() {
  if (this->SchemeObject) return this->SchemeObject->GetText();
  return this->Scheme ? this->Scheme : "";
}

vtkMTimeType vtkAreteFilter::GetMTime() {
  const vtkMTimeType own = this->Superclass::GetMTime();
  return this->SchemeObject ? std::max(own, this->SchemeObject->GetMTime()) : own;
}

void vtkAreteFilter::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Scheme: " << (this->Scheme ? this->Scheme : "(none)") << "\n";
  os << indent << "SchemeY: " << (this->SchemeY ? this->SchemeY : "(as Scheme)") << "\n";
  os << indent << "SchemeObject: ";
  if (this->SchemeObject)
    this->SchemeObject->PrintSelf(os << "\n", indent.GetNextIndent());
  else
    os << "(none)\n";
  const auto name = [](int rule) { return arete::to_string(static_cast<arete::Boundary>(rule)); };
  os << indent << "BoundaryX: " << name(this->BoundaryX) << "\n";
  os << indent << "BoundaryY: " << name(this->BoundaryY) << "\n";
  os << indent << "NumberOfThreads: " << this->NumberOfThreads << "\n";
}
