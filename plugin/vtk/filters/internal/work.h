// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include "vtkAlgorithm.h"
#include "vtkVersionMacros.h"

namespace arete::vtk_filters {

/// Progress and abort of one request whose work is counted in steps of any kind.
class Work {
 public:
  Work(vtkAlgorithm* filter, double steps) : filter_(filter), steps_(std::max(steps, 1.0)) {}

  /// Tells what has been done. False: the user wants no more.
  bool done(double steps) {
    done_ += steps;
    // Observers may be slow (they draw), so they are not told of every row.
    const double share = std::min(1.0, done_ / steps_);
    if (share == 1 || share > told_ + 0.005) {
      told_ = share;
      filter_->UpdateProgress(share);
    }
    return !aborted();
  }

  [[nodiscard]] bool aborted() const {
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 2, 20220901)
    return filter_->CheckAbort();
#else
    return filter_->GetAbortExecute() != 0;
#endif
  }

 private:
  vtkAlgorithm* filter_;
  double steps_;
  double done_ = 0;
  double told_ = 0;
};

}  // namespace arete::vtk_filters
