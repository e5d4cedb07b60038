// SPDX-License-Identifier: MIT
#include "arete/vtk/internal/model.h"

#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <utility>

#include "arete/vtk/error.h"
#include "arete/vtk/internal/ground_colors.h"
#include "arete/vtk/internal/reduce.h"

namespace arete::vtk {

Model make_model(const Surface& surface, const ModelOptions& options) {
  check(options.appearance);
  if (!(options.exaggeration > 0) || !std::isfinite(options.exaggeration))
    throw RenderError("the exaggeration of a model is a positive number");
  if (options.most_samples < 2)
    throw RenderError("at least two samples a side are needed for a model");
  check_geometry(surface);
  const ReducedSurface reduced = reduce(surface, options.most_samples);
  const auto heights = height_range(reduced.surface);
  const auto range = options.appearance.range.value_or(heights);
  const LocalPlane plane = local_plane(reduced.surface);
  const double middle = (heights[0] + heights[1]) / 2;
  const Stage stage(reduced.surface, plane, middle, options.exaggeration);
  const Extent extent = reduced.surface.extent();

  Model model;
  Image ground = ground_colors(stage, options.appearance, range);
  if (options.appearance.texture) {
    model.mesh = terrain_mesh(stage, {surface.extent(), reduced.rows, reduced.cols});
    model.texture = textured(*options.appearance.texture, ground, reduced, surface.extent());
  } else {
    model.mesh = terrain_mesh(stage, {extent, {extent.rows, 0, 1}, {extent.cols, 0, 1}});
    model.texture = std::move(ground);
  }
  // For a geographic surface the place of the raster's centre in degrees.
  const WorldPoint centre = reduced.surface.georeference.position(
      static_cast<double>(extent.rows - 1) / 2, static_cast<double>(extent.cols - 1) / 2);
  model.report = {static_cast<Index>(model.mesh.samples.size()),
                  model.mesh.data->GetNumberOfPolys(),
                  reduced.factor,
                  extent,
                  model.texture.width,
                  model.texture.height,
                  {centre.x, centre.y, middle},
                  range[0],
                  range[1]};
  return model;
}

ModelFile::ModelFile(const std::filesystem::path& path)
    : path_(path), file_(std::fopen(path.c_str(), "wb")) {
  if (file_ == nullptr) fail();
}

ModelFile::~ModelFile() {
  if (file_ != nullptr) std::fclose(file_);
}

void ModelFile::write(const void* bytes, std::size_t count) {
  if (std::fwrite(bytes, 1, count, file_) != count) fail();
}

void ModelFile::close() {
  if (std::fclose(std::exchange(file_, nullptr)) != 0) fail();
}

void ModelFile::fail() const {
  throw WriteError("cannot write '" + path_.string() + "': " + std::strerror(errno) +
                   "; see to the folder and the room on the disk");
}

}  // namespace arete::vtk
