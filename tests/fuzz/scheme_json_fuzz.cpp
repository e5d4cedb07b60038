// SPDX-License-Identifier: MIT
// Any text as a scheme file (JSON): it is refused, or what is written of it gives the same scheme.
#include <cstdint>
#include <cstdlib>

#include "cli/scheme_json.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace arete;
  try {
    const Scheme scheme = cli::scheme_from_json({reinterpret_cast<const char*>(data), size}, "it");
    const cli::Json written{{"scheme", scheme.text()}};
    if (!(cli::scheme_from_json(written.dump(), "it") == scheme)) std::abort();
  } catch (const InvalidScheme&) {
  }
  return 0;
}
