// SPDX-License-Identifier: MIT
#pragma once

namespace arete::cli {

/// From now on SIGINT, SIGTERM and SIGHUP only set a flag, so that partial files can be removed.
void catch_interruptions();

[[nodiscard]] bool is_interrupted();

/// \throws Interrupted if a signal has come. Long work calls it often.
void stop_if_interrupted();

}  // namespace arete::cli
