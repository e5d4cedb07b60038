// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>

class vtkObject;

namespace arete::vtk {

/// Hears what watched VTK objects complain about. VTK prints an error only if nobody listens, so
/// that watching keeps stderr clean. Outlives what it watches, or its watching.
class Complaints {
 public:
  Complaints() : first_(std::make_unique<std::string>()) {}

  /// Errors and warnings from now on.
  void watch(vtkObject& object);
  [[nodiscard]] bool any() const { return !first_->empty(); }
  /// The first complaint, on one line; empty if there is none.
  [[nodiscard]] const std::string& first() const { return *first_; }

 private:
  std::unique_ptr<std::string> first_;  // where it is must not change: observers write there
};

}  // namespace arete::vtk
