// SPDX-License-Identifier: MIT
#include "arete/vtk/appearance.h"

#include "arete/vtk/colormap.h"
#include "arete/vtk/error.h"

namespace arete::vtk {

void check(const Appearance& appearance) {
  static_cast<void>(find_colormap(appearance.colormap));
  if (appearance.palette) check(*appearance.palette);
  if (appearance.range && !((*appearance.range)[0] < (*appearance.range)[1]))
    throw RenderError("the range of heights to colour runs from a smaller to a larger number");
  if (!appearance.texture) return;
  const auto& [image, opacity] = *appearance.texture;
  if (image.width < 1 || image.height < 1) throw RenderError("the texture has no pixels");
  const auto size = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
  if (image.pixels.size() != size || (!opacity.empty() && opacity.size() != size))
    throw RenderError("the texture has not as many pixels as its width and height say");
}

}  // namespace arete::vtk
