// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace arete::cli {

/// Bytes from `800M`, `2G`, `1.5GiB` or a plain number. \throws Misuse
[[nodiscard]] double parse_memory_size(const std::string& text);

/// Half of the machine's memory: what a run may take unless told otherwise.
[[nodiscard]] double default_memory();

/// What is needed, rounded up: `1234 MB`.
[[nodiscard]] std::string memory_text(double bytes);

/// What there is, rounded down: `1234 MB`, `12 kB`, `3 B`.
[[nodiscard]] std::string room_text(double bytes);

/// \throws Failure if `needed` bytes are more than `allowed`, saying what needs them.
void check_memory(const std::string& what, double needed, double allowed);

}  // namespace arete::cli
