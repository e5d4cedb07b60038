// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <algorithm>

#include "run_program.h"

namespace arete::test {

/// Runs `arete` and expects this exit code, nothing on stdout, and one line on stderr that begins
/// with `arete: ` and holds `part`.
inline void expect_error(const Arguments& arguments, int code, const std::string& part) {
  const Run run = run_arete(arguments);
  EXPECT_EQ(run.exit_code, code) << run.err;
  EXPECT_EQ(run.out, "");
  EXPECT_EQ(run.err.rfind("arete: ", 0), 0u) << run.err;
  EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
  EXPECT_NE(run.err.find(part), std::string::npos) << run.err;
}

}  // namespace arete::test
