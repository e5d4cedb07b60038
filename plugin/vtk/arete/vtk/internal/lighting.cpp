// SPDX-License-Identifier: MIT
#include "arete/vtk/internal/lighting.h"

#include <vtkDataArray.h>
#include <vtkLight.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "arete/vtk/internal/sky_view.h"
#include "arete/vtk/internal/sun_view.h"

namespace arete::vtk {
namespace {

constexpr double sky_share = 0.5;  // of a colour's brightness that sky view decides

Vector3 direction(const Light& light) {
  constexpr double radian = std::numbers::pi / 180;
  const double azimuth = light.azimuth * radian;
  const double elevation = light.elevation * radian;
  return {std::sin(azimuth) * std::cos(elevation), std::cos(azimuth) * std::cos(elevation),
          std::sin(elevation)};
}

}  // namespace

Lighting::Lighting(std::vector<Light> lights, const Material& material, bool shadows)
    : lights_(std::move(lights)), material_(material), shadows_(shadows) {
  for (const Light& light : lights_) check(light);
  check(material_);
  const double azimuth = lights_.empty() ? 0 : lights_.front().azimuth;
  lights_.push_back({azimuth + 180, 60, 0.2, {217, 235, 255}});
}

void Lighting::set(vtkRenderer& renderer) const {
  renderer.AutomaticLightCreationOff();
  for (const Light& light : lights_) {
    vtkNew<vtkLight> lamp;
    lamp->SetLightTypeToSceneLight();
    lamp->SetPosition(direction(light).data());
    lamp->SetFocalPoint(0, 0, 0);
    lamp->SetColor(light.color[0] / 255.0, light.color[1] / 255.0, light.color[2] / 255.0);
    lamp->SetIntensity(light.intensity);
    renderer.AddLight(lamp);
  }
}

void Lighting::set(vtkProperty& property, bool flat) const {
  property.SetAmbient(material_.ambient);
  property.SetDiffuse(material_.diffuse);
  property.SetSpecular(flat ? 0 : material_.specular);
  property.SetSpecularPower(material_.specular_power);
}

std::vector<std::array<float, 3>> Lighting::dimming(const Stage& stage,
                                                    const TerrainMesh& mesh) const {
  const Grid<float> sky = sky_view(stage.surface(), stage.plane(), stage.exaggeration());
  std::vector<Grid<float>> seen;
  if (shadows_) {
    for (std::size_t k = 0; k + 1 < lights_.size(); ++k)
      seen.push_back(sun_view(stage.surface(), stage.plane(), stage.exaggeration(), lights_[k]));
  }
  vtkDataArray& normals = *mesh.data->GetPointData()->GetNormals();
  std::vector<std::array<float, 3>> result(mesh.samples.size());
  for (std::size_t point = 0; point < result.size(); ++point) {
    const auto [row, col] = mesh.samples[point];
    const double dim = 1 - sky_share * (1 - sky(row, col));
    result[point].fill(static_cast<float>(dim));
    if (!shadows_) continue;
    Vector3 normal;
    normals.GetTuple(static_cast<Index>(point), normal.data());
    for (std::size_t c = 0; c < 3; ++c) {
      double with = material_.ambient;
      double without = material_.ambient;
      for (std::size_t k = 0; k < lights_.size(); ++k) {
        const Vector3 to = direction(lights_[k]);
        const double facing =
            std::max(0.0, normal[0] * to[0] + normal[1] * to[1] + normal[2] * to[2]);
        const double arriving =
            material_.diffuse * facing * lights_[k].intensity * lights_[k].color[c] / 255;
        without += arriving;
        with += arriving * (k < seen.size() ? seen[k](row, col) : 1);
      }
      if (without > 0) result[point][c] *= static_cast<float>(with / without);
    }
  }
  return result;
}

}  // namespace arete::vtk
