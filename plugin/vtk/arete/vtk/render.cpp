// SPDX-License-Identifier: MIT
#include "arete/vtk/render.h"

#include "arete/vtk/error.h"
#include "arete/vtk/internal/scene.h"

namespace arete::vtk {

RenderReport render(const Surface& surface, const RenderOptions& options,
                    const std::filesystem::path& picture) {
  Scene scene(surface, options);
  write_picture(options.view == View::map ? scene.draw_map() : scene.draw_oblique(), picture);
  return scene.report();
}

RenderReport render_turntable(const Surface& surface, const RenderOptions& options, int frames,
                              const std::function<std::filesystem::path(int frame)>& path_of) {
  if (frames < 1) throw RenderError("a turntable has at least one frame");
  if (options.view == View::map)
    throw RenderError("a map is seen from above alone; a turntable needs the oblique view");
  Scene scene(surface, options);
  std::vector<double> azimuths;
  for (int k = 0; k < frames; ++k) azimuths.push_back(options.azimuth + 360.0 * k / frames);
  const double radius = scene.radius(azimuths);
  for (int k = 0; k < frames; ++k) {
    const std::filesystem::path path = path_of(k);
    write_picture(scene.draw_from(azimuths[static_cast<std::size_t>(k)], radius), path);
  }
  return scene.report();
}

}  // namespace arete::vtk
