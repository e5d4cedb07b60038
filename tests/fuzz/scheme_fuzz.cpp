// SPDX-License-Identifier: MIT
// Any text as a scheme: it is refused, or its own text form gives the same scheme again.
#include <cstdint>
#include <cstdlib>

#include "arete/scheme/catalogue.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    const arete::Scheme scheme = arete::parse_scheme({reinterpret_cast<const char*>(data), size});
    if (!(arete::parse_scheme(scheme.text()) == scheme)) std::abort();
  } catch (const arete::InvalidScheme&) {
  }
  return 0;
}
