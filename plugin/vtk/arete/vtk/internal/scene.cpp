// SPDX-License-Identifier: MIT
#include "arete/vtk/internal/scene.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkImageData.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkRenderWindow.h>
#include <vtkTexture.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>

#include "arete/vtk/colormap.h"
#include "arete/vtk/error.h"
#include "arete/vtk/internal/block_walls.h"
#include "arete/vtk/internal/camera.h"
#include "arete/vtk/internal/color_bar.h"
#include "arete/vtk/internal/exaggeration.h"
#include "arete/vtk/internal/ground_colors.h"
#include "arete/vtk/internal/lighting.h"
#include "arete/vtk/internal/palette_legend.h"
#include "arete/vtk/internal/vtk_image.h"

namespace arete::vtk {
namespace {

constexpr double fill = 0.95;        // of the picture's width or height that the terrain takes
constexpr double wall_depth = 0.02;  // of the plan's diagonal, from the lowest height down

/// Across the plan of some points.
double diagonal(const std::vector<Vector3>& points) {
  std::array<double, 2> low = {points.front()[0], points.front()[1]};
  std::array<double, 2> high = low;
  for (const Vector3& point : points) {
    for (std::size_t k = 0; k < 2; ++k) {
      low[k] = std::min(low[k], point[k]);
      high[k] = std::max(high[k], point[k]);
    }
  }
  return std::hypot(high[0] - low[0], high[1] - low[1]);
}

/// Dark letters on light ground, light ones on dark.
Rgb ink_on(const Rgb& background) {
  const double luma = 0.3 * background[0] + 0.59 * background[1] + 0.11 * background[2];
  return luma > 128 ? Rgb{55, 55, 60} : Rgb{225, 225, 225};
}

ReducedSurface checked_and_reduced(const Surface& surface, const RenderOptions& options) {
  check(options.appearance);
  if (!(options.exaggeration >= 0) || !std::isfinite(options.exaggeration))
    throw RenderError("the exaggeration is a positive number, or 0 for a chosen one");
  if (!std::isfinite(options.azimuth) || !(options.pitch >= 1 && options.pitch <= 89))
    throw RenderError("the camera stands at a finite azimuth, 1 to 89 degrees above the horizon");
  if (options.most_samples < 2)
    throw RenderError("at least two samples a side are needed for a picture");
  check_geometry(surface);
  return reduce(surface, options.most_samples);
}

vtkNew<vtkTexture> texture_of(const Image& image) {
  vtkNew<vtkTexture> texture;
  texture->SetInputData(to_vtk(image));
  texture->InterpolateOn();
  texture->MipmapOn();
  texture->SetMaximumAnisotropicFiltering(8);
  texture->SetWrap(vtkTexture::ClampToEdge);
  return texture;
}

}  // namespace

Scene::Scene(const Surface& surface, const RenderOptions& options)
    : options_(options),
      original_(surface.extent()),
      reduced_(checked_and_reduced(surface, options)),
      heights_(height_range(reduced_.surface)),
      range_(options.appearance.range.value_or(heights_)),
      exaggeration_(options.exaggeration > 0
                        ? options.exaggeration
                        : choose_exaggeration(reduced_.surface, local_plane(reduced_.surface))),
      stage_(reduced_.surface, local_plane(reduced_.surface), (heights_[0] + heights_[1]) / 2,
             exaggeration_),
      canvas_(options.width, options.height, 2) {
  const auto& background = options.background;
  backdrop_->SetBackground(background[0] / 255.0, background[1] / 255.0, background[2] / 255.0);
  canvas_.window().SetNumberOfLayers(2);
  canvas_.window().AddRenderer(backdrop_);

  // The terrain, and right of it what colours mean.
  const Rgb ink = ink_on(background);
  const Appearance& look = options.appearance;
  int strip = 0;
  if (options.color_bar && !look.texture) {
    legend_->SetLayer(1);
    if (look.palette) {
      const PaletteLegend legend{*look.palette, ink, canvas_.supersampling()};
      strip = std::min(palette_legend_width(legend, options.height), options.width / 2);
      draw_palette_legend(legend, options.height, *legend_);
    } else {
      const ColorBar bar{range_[0], range_[1], options.units, ink, canvas_.supersampling()};
      strip = std::min(color_bar_width(bar, options.height), options.width / 2);
      draw_color_bar(bar, find_colormap(look.colormap), strip, options.height, *legend_);
    }
    canvas_.window().AddRenderer(legend_);
  }
  split_ = 1 - static_cast<double>(strip) / options.width;
  aspect_ = static_cast<double>(options.width - strip) / options.height;

  scene_->SetLayer(1);
  scene_->SetViewport(0, 0, split_, 1);
  canvas_.window().AddRenderer(scene_);
  add_terrain();
  if (options.view == View::oblique) add_walls();
}

void Scene::add_terrain() {
  const Appearance& look = options_.appearance;
  const TerrainMesh mesh = terrain_mesh(stage_, {original_, reduced_.rows, reduced_.cols});
  points_ = mesh.points();
  const Lighting lighting(options_.lights, options_.material, options_.shadows);
  const auto dimming = lighting.dimming(stage_, mesh);
  const Image ground = ground_colors(stage_, look, range_);
  vtkNew<vtkUnsignedCharArray> colored;
  colored->SetNumberOfComponents(3);
  colored->SetNumberOfTuples(static_cast<Index>(mesh.samples.size()));
  for (std::size_t point = 0; point < mesh.samples.size(); ++point) {
    const auto [row, col] = mesh.samples[point];
    Rgb color =
        look.texture ? Rgb{255, 255, 255} : ground(static_cast<int>(col), static_cast<int>(row));
    for (std::size_t c = 0; c < 3; ++c)
      color[c] = static_cast<std::uint8_t>(std::lround(color[c] * dimming[point][c]));
    colored->SetTypedTuple(static_cast<Index>(point), color.data());
  }
  mesh.data->GetPointData()->SetScalars(colored);

  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(mesh.data);
  mapper->SetColorModeToDirectScalars();
  vtkNew<vtkActor> terrain;
  terrain->SetMapper(mapper);
  if (look.texture)
    terrain->SetTexture(texture_of(textured(*look.texture, ground, reduced_, original_)));
  lighting.set(*terrain->GetProperty(), options_.view == View::map);
  lighting.set(*scene_);
  scene_->AddActor(terrain);
}

void Scene::add_walls() {
  vtkNew<vtkActor> walls;
  const double depth = wall_depth * diagonal(points_) / exaggeration_;
  const auto wall_points = set_block_walls(stage_, heights_[0] - depth, *walls);
  points_.insert(points_.end(), wall_points.begin(), wall_points.end());
  scene_->AddActor(walls);
}

double Scene::beside_terrain() {
  const double reach = reach_right(points_, aspect_, *scene_->GetActiveCamera());
  return std::min(split_, split_ * (1 + reach + 2 * (1 - fill)) / 2);
}

Image Scene::draw(double legend_left) {
  legend_->SetViewport(legend_left, 0, legend_left + 1 - split_, 1);
  return canvas_.draw();
}

Image Scene::draw_oblique() {
  look_from(points_, {options_.azimuth, options_.pitch}, aspect_, fill, *scene_->GetActiveCamera());
  return draw(beside_terrain());
}

Image Scene::draw_map() {
  look_down(points_, aspect_, fill, *scene_->GetActiveCamera());
  return draw(beside_terrain());
}

double Scene::radius(std::span<const double> azimuths) const {
  return orbit_radius(points_, {0, 0, 0}, options_.pitch, azimuths, aspect_, fill);
}

Image Scene::draw_from(double azimuth, double radius) {
  look_at(points_, {0, 0, 0}, {azimuth, options_.pitch}, radius, *scene_->GetActiveCamera());
  return draw(split_);
}

RenderReport Scene::report() const {
  return {exaggeration_, reduced_.factor, reduced_.surface.extent(),
          range_[0],     range_[1],       canvas_.platform()};
}

}  // namespace arete::vtk
