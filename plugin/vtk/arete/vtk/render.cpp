// SPDX-License-Identifier: MIT
#include "arete/vtk/render.h"

#include <vtkActor.h>
#include <vtkBMPReader.h>
#include <vtkCamera.h>
#include <vtkExecutive.h>
#include <vtkImageData.h>
#include <vtkImageReader2.h>
#include <vtkJPEGReader.h>
#include <vtkLight.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>
#include <vtkPNMReader.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>
#include <vtkTIFFReader.h>
#include <vtkTexture.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "arete/vtk/error.h"
#include "arete/vtk/internal/block_walls.h"
#include "arete/vtk/internal/camera.h"
#include "arete/vtk/internal/canvas.h"
#include "arete/vtk/internal/color_bar.h"
#include "arete/vtk/internal/complaints.h"
#include "arete/vtk/internal/exaggeration.h"
#include "arete/vtk/internal/reduce.h"
#include "arete/vtk/internal/terrain_actor.h"

namespace arete::vtk {
namespace {

constexpr Index most_samples = 2000;  // a side; more cost seconds and show nothing
constexpr double pitch = 42;          // degrees the oblique view looks down
constexpr double fill = 0.95;         // of the picture's width or height that the terrain takes
constexpr double wall_depth = 0.02;   // of the plan's diagonal, from the lowest height down

void check(const RenderOptions& options) {
  if (!(options.light_elevation >= 0 && options.light_elevation <= 90) ||
      !std::isfinite(options.light_azimuth)) {
    throw RenderError("the light stands 0 to 90 degrees above the horizon, at a finite azimuth");
  }
  if (!(options.exaggeration >= 0) || !std::isfinite(options.exaggeration)) {
    throw RenderError("the exaggeration is a positive number, or 0 for a chosen one");
  }
  if (options.range && !((*options.range)[0] < (*options.range)[1])) {
    throw RenderError("the range of heights to colour runs from a smaller to a larger number");
  }
}

std::array<double, 2> height_range(const Surface& surface) {
  std::array<double, 2> range{std::numeric_limits<double>::infinity(),
                              -std::numeric_limits<double>::infinity()};
  const Extent extent = surface.extent();
  for (Index r = 0; r < extent.rows; ++r) {
    for (Index c = 0; c < extent.cols; ++c) {
      if (!surface.valid(r, c)) continue;
      range[0] = std::min(range[0], surface.height(r, c));
      range[1] = std::max(range[1], surface.height(r, c));
    }
  }
  return range;
}

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

void set_background(const Rgb& color, vtkRenderer& renderer) {
  renderer.SetBackground(color[0] / 255.0, color[1] / 255.0, color[2] / 255.0);
}

void add_light(double azimuth, double elevation, double intensity, const Vector3& color,
               vtkRenderer& renderer) {
  constexpr double radian = std::numbers::pi / 180;
  vtkNew<vtkLight> light;
  light->SetLightTypeToSceneLight();
  light->SetPosition(std::sin(azimuth * radian) * std::cos(elevation * radian),
                     std::cos(azimuth * radian) * std::cos(elevation * radian),
                     std::sin(elevation * radian));
  light->SetFocalPoint(0, 0, 0);
  light->SetColor(color[0], color[1], color[2]);
  light->SetIntensity(intensity);
  renderer.AddLight(light);
}

/// The first reader that knows the file. VTK's own factory asks readers of other formats as well,
/// some of which complain on stderr.
vtkSmartPointer<vtkImageReader2> reader_of(const std::filesystem::path& path) {
  const std::array<vtkSmartPointer<vtkImageReader2>, 5> readers{
      vtkSmartPointer<vtkPNGReader>::New(), vtkSmartPointer<vtkJPEGReader>::New(),
      vtkSmartPointer<vtkTIFFReader>::New(), vtkSmartPointer<vtkBMPReader>::New(),
      vtkSmartPointer<vtkPNMReader>::New()};
  for (const auto& reader : readers) {
    if (reader->CanReadFile(path.string().c_str()) != 0) return reader;
  }
  return nullptr;
}

void set_texture(const std::filesystem::path& path, vtkActor& actor) {
  const auto fail = [&](const std::string& why) {
    throw RenderError("cannot read the texture '" + path.string() + "': " + why);
  };
  if (!std::filesystem::is_regular_file(path)) fail("there is no such file");
  const auto reader = reader_of(path);
  if (reader == nullptr) fail("not a picture that VTK reads; give PNG, JPEG, TIFF, BMP or PNM");
  Complaints complaints;
  complaints.watch(*reader);
  complaints.watch(*reader->GetExecutive());
  reader->SetFileName(path.string().c_str());
  reader->Update();
  if (complaints.any()) fail(complaints.first());
  vtkNew<vtkTexture> texture;
  texture->SetInputData(reader->GetOutput());
  texture->InterpolateOn();
  texture->MipmapOn();
  texture->EdgeClampOn();
  actor.SetTexture(texture);
}

}  // namespace

RenderReport render(const Surface& surface, const RenderOptions& options,
                    const std::filesystem::path& png) {
  check(options);
  const Colormap& colors = find_colormap(options.colormap);
  check_geometry(surface);
  const ReducedSurface reduced = reduce(surface, most_samples);
  const LocalPlane plane = local_plane(reduced.surface);
  const auto heights = height_range(reduced.surface);
  const auto range = options.range.value_or(heights);
  const double exaggeration =
      options.exaggeration > 0 ? options.exaggeration : choose_exaggeration(reduced.surface, plane);
  const Stage stage(reduced.surface, plane, (heights[0] + heights[1]) / 2, exaggeration);

  Canvas canvas(options.width, options.height, 2);
  vtkNew<vtkRenderer> backdrop;
  set_background(options.background, *backdrop);
  canvas.window().SetNumberOfLayers(2);
  canvas.window().AddRenderer(backdrop);

  // The terrain, and right of it the colour bar.
  const bool with_bar = options.color_bar && !options.texture;
  const ColorBar bar{range[0], range[1], options.units, ink_on(options.background),
                     canvas.supersampling()};
  const int strip =
      with_bar ? std::min(color_bar_width(bar, options.height), options.width / 2) : 0;
  const double split = 1 - static_cast<double>(strip) / options.width;
  const double aspect = static_cast<double>(options.width - strip) / options.height;

  vtkNew<vtkRenderer> scene;
  scene->SetLayer(1);
  scene->SetViewport(0, 0, split, 1);
  canvas.window().AddRenderer(scene);
  scene->AutomaticLightCreationOff();
  add_light(options.light_azimuth, options.light_elevation, 1, {1, 0.98, 0.94}, *scene);
  add_light(options.light_azimuth + 180, 60, 0.2, {0.85, 0.92, 1}, *scene);

  vtkNew<vtkActor> terrain;
  scene->AddActor(terrain);
  const HeightColors height_colors{options.texture ? nullptr : &colors, range[0], range[1]};
  std::vector<Vector3> points = set_terrain(stage, height_colors, *terrain);
  if (options.texture) set_texture(*options.texture, *terrain);
  if (options.view == View::oblique) {
    vtkNew<vtkActor> walls;
    scene->AddActor(walls);
    const double depth = wall_depth * diagonal(points) / exaggeration;
    const auto wall_points = set_block_walls(stage, heights[0] - depth, *walls);
    points.insert(points.end(), wall_points.begin(), wall_points.end());
    look_from_south(points, pitch, aspect, fill, *scene->GetActiveCamera());
  } else {
    // A map is seen from everywhere straight above: no part of it may shine more than another.
    terrain->GetProperty()->SetSpecular(0);
    look_down(points, aspect, fill, *scene->GetActiveCamera());
  }

  vtkNew<vtkRenderer> legend;
  if (with_bar) {
    legend->SetLayer(1);
    // Beside the terrain, however narrow that is.
    const double reach = reach_right(points, aspect, *scene->GetActiveCamera());
    const double left = std::min(split, split * (1 + reach + 2 * (1 - fill)) / 2);
    legend->SetViewport(left, 0, left + 1 - split, 1);
    draw_color_bar(bar, colors, strip, options.height, *legend);
    canvas.window().AddRenderer(legend);
  }
  write_png(canvas.draw(), png);
  return {exaggeration, reduced.factor, reduced.surface.extent(),
          range[0],     range[1],       canvas.platform()};
}

}  // namespace arete::vtk
