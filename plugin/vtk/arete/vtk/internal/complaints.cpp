// SPDX-License-Identifier: MIT
#include "arete/vtk/internal/complaints.h"

#include <vtkCallbackCommand.h>
#include <vtkCommand.h>
#include <vtkNew.h>

namespace arete::vtk {
namespace {

/// VTK's text begins with "ERROR: In file, line n" and the object, on lines of their own.
std::string last_line(std::string text) {
  while (!text.empty() && text.back() == '\n') text.pop_back();
  const auto start = text.rfind('\n');
  return start == std::string::npos ? text : text.substr(start + 1);
}

void remember(vtkObject*, unsigned long, void* first, void* text) {
  auto& complaint = *static_cast<std::string*>(first);
  if (!complaint.empty()) return;
  complaint = text == nullptr ? "" : last_line(static_cast<const char*>(text));
  if (complaint.empty()) complaint = "unnamed error";
}

}  // namespace

void Complaints::watch(vtkObject& object) {
  vtkNew<vtkCallbackCommand> observer;
  observer->SetCallback(remember);
  observer->SetClientData(first_.get());
  object.AddObserver(vtkCommand::ErrorEvent, observer);
  object.AddObserver(vtkCommand::WarningEvent, observer);
}

}  // namespace arete::vtk
