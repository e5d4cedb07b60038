// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace arete::cli {

/// The separators a line of a table may have when none is named: the first of semicolon, tab, bar
/// and comma that it has outside of quotes, otherwise blanks. A comma comes last: with another sign
/// it may be a decimal point.
inline constexpr std::string_view any_separator = ";\t|,";

/// The cells of a line, without the blanks and quotes around them. Runs of blanks are one
/// separator; any other separator stands between two cells, empty ones too. What stands in double
/// quotes is one cell.
[[nodiscard]] std::vector<std::string> cells_of(std::string_view line,
                                                std::string_view separators = any_separator);

/// The number that a cell holds; nothing if it holds anything else. NaN and infinity count as
/// numbers.
[[nodiscard]] std::optional<double> number_in(std::string_view cell);

}  // namespace arete::cli
