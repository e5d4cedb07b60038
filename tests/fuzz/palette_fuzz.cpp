// SPDX-License-Identifier: MIT
// Any text as a palette (JSON): it is refused, or colours any ground.
#include <cstdint>

#include "arete/vtk/error.h"
#include "cli/error.h"
#include "cli/palette_json.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace arete;
  try {
    const vtk::Palette palette =
        cli::palette_from_json({reinterpret_cast<const char*>(data), size}, "it");
    check(palette);
    for (const double height : {-1e300, -1.0, 0.0, 0.5, 1.0, 8848.0, 1e300})
      for (const double slope : {0.0, 8.0, 45.0, 90.0}) (void)palette({height, slope, 4 * slope});
  } catch (const cli::Failure&) {
  } catch (const vtk::RenderError&) {
  }
  return 0;
}
