// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "arete/meshlab/progress.h"
#include "arete/scheme/scheme.h"

namespace arete::meshlab {

/// What is known about a scheme, one fact a line: mask, place of new samples, sum rules, polynomial
/// reproduction, proved and refuted smoothness, Hoelder exponent, theorems, limit stencil.
/// \throws Cancelled
void report_smoothness(const Scheme& scheme, int max_power, Report& report);

}  // namespace arete::meshlab
