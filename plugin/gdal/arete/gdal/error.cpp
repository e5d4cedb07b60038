// SPDX-License-Identifier: MIT
#include "arete/gdal/error.h"

#include <cpl_error.h>

namespace arete::gdal {
namespace {

void collect(CPLErr level, CPLErrorNum number, const char* message) {
  // GDAL ends the program after this one: out of memory where it has no other way out.
  if (level == CE_Fatal) CPLDefaultErrorHandler(level, number, message);
  if (level >= CE_Failure)
    static_cast<ErrorCollector*>(CPLGetErrorHandlerUserData())->record(message);
}

}  // namespace

ErrorCollector::ErrorCollector() { CPLPushErrorHandlerEx(collect, this); }
ErrorCollector::~ErrorCollector() { CPLPopErrorHandler(); }

void ErrorCollector::record(std::string message) {
  if (failed_) return;
  failed_ = true;
  message_ = std::move(message);
}

}  // namespace arete::gdal
