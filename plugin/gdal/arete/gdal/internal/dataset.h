// SPDX-License-Identifier: MIT
#pragma once

#include <gdal_priv.h>

#include <memory>

namespace arete::gdal {

struct CloseDataset {
  void operator()(GDALDataset* dataset) const { GDALClose(dataset); }
};

/// A dataset of GDAL's, closed at the end of its scope.
using Dataset = std::unique_ptr<GDALDataset, CloseDataset>;

}  // namespace arete::gdal
