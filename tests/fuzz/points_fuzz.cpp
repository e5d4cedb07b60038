// SPDX-License-Identifier: MIT
// Any bytes as a table of points and as a survey: they are refused, or every row is whole. The
// first two bytes say how a survey is read.
#include <cmath>
#include <cstdint>
#include <cstdlib>

#include "cli/error.h"
#include "cli/points_csv.h"
#include "cli/survey_points.h"
#include "memory_file.h"

namespace {

using namespace arete;

void read_table(const std::string& path) {
  try {
    const cli::Points points = cli::read_points(path);
    if (points.values.rows() < 1 || points.values.cols() < 1) std::abort();
    for (const double value : points.values.samples())
      if (!std::isfinite(value)) std::abort();
  } catch (const cli::Failure&) {
  }
}

void read_survey(const std::string& path, std::uint8_t columns, std::uint8_t separator) {
  cli::SurveyFormat format;
  if (columns % 4 == 1) format.columns = {"3", "1", "2"};
  if (columns % 4 == 2) format.columns = {"x", "north", "18446744073709551615"};
  if (columns % 4 == 3) format.columns = {"z", "", "x"};
  if (separator % 2 == 1) format.separator = std::string(1, static_cast<char>(separator));
  try {
    const cli::SurveyPoints points = cli::read_survey(path, format);
    if (points.x.empty() || points.x.size() != points.y.size() ||
        points.x.size() != points.z.size())
      std::abort();
  } catch (const cli::Failure&) {
  } catch (const cli::Misuse&) {
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size < 2) return 0;
  const MemoryFile file(data + 2, size - 2);
  read_table(file.path());
  read_survey(file.path(), data[0], data[1]);
  return 0;
}
