// SPDX-License-Identifier: MIT
#include "arete/vtk/light.h"

#include <cmath>
#include <sstream>

#include "arete/vtk/error.h"

namespace arete::vtk {
namespace {

void check_within(const char* what, double value, double low, double high) {
  if (value >= low && value <= high) return;
  std::ostringstream text;
  text << what << " is a number from " << low << " to " << high << ", not " << value;
  throw RenderError(text.str());
}

}  // namespace

void check(const Light& light) {
  if (!std::isfinite(light.azimuth)) throw RenderError("the azimuth of a light is a finite number");
  check_within("the elevation of a light", light.elevation, 0, 90);
  check_within("the intensity of a light", light.intensity, 0, 10);
}

void check(const Material& material) {
  check_within("the ambient share", material.ambient, 0, 1);
  check_within("the diffuse share", material.diffuse, 0, 1);
  check_within("the specular share", material.specular, 0, 1);
  check_within("the specular power", material.specular_power, 1, 128);
}

}  // namespace arete::vtk
