// SPDX-License-Identifier: MIT
#pragma once

namespace arete::cli {

/// From now on the first SIGINT, SIGTERM or SIGHUP only sets a flag, so that work ends in order; a
/// second one, and an abort, remove partial files and end the program.
void catch_interruptions();

[[nodiscard]] bool is_interrupted();

/// \throws Interrupted if a signal has come. Long work calls it often.
void stop_if_interrupted();

}  // namespace arete::cli
