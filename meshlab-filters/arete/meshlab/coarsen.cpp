// SPDX-License-Identifier: GPL-3.0-or-later
#include "arete/meshlab/coarsen.h"

#include <cmath>

#include "arete/field/at.h"
#include "arete/meshlab/coarse_patch.h"
#include "arete/meshlab/memory.h"
#include "arete/meshlab/plane_refiner.h"
#include "arete/meshlab/surface_patch.h"
#include "arete/reverse/grid_reverse.h"

namespace arete::meshlab {
namespace {

std::string size_text(Extent extent) {
  return std::to_string(extent.rows) + " x " + std::to_string(extent.cols);
}

GridReverseOptions reverse_options(const GridPatch& patch, const CoarsenOptions& options) {
  return {options.levels,
          options.mode,
          {patch.wraps_cols ? Boundary::periodic : options.boundary,
           patch.wraps_rows ? Boundary::periodic : options.boundary},
          0};
}

GridPyramid checked_pyramid(const GridPatch& patch, const Scheme& scheme,
                            const CoarsenOptions& options) {
  GridPyramid pyramid(scheme.mask(), patch.extent, reverse_options(patch, options));
  const auto refuse = [&](const std::string& why) {
    throw InvalidField("a grid of " + size_text(patch.extent) + " vertices cannot be coarsened " +
                       std::to_string(options.levels) +
                       (options.levels == 1 ? " time: " : " times: ") + why);
  };
  for (int step = 0; step < options.levels; ++step) {
    const Extent coarse = pyramid.extent(step + 1);
    if (coarse.rows < (patch.wraps_rows ? 3 : 2) || coarse.cols < (patch.wraps_cols ? 3 : 2))
      refuse("level " + std::to_string(step + 1) + " would leave " + size_text(coarse) +
             "; use fewer levels, or a finer mesh");
    if (pyramid.rows(step).padding != 0 || pyramid.cols(step).padding != 0)
      refuse("it is closed, and the vertices around it do not divide by " +
             std::to_string(scheme.mask().arity()) + " that often; use fewer levels");
  }
  return pyramid;
}

class Coarsening {
 public:
  Coarsening(const MeshArrays& mesh, const Scheme& scheme, const CoarsenOptions& options,
             const Report& report)
      : mesh_(mesh), scheme_(scheme), options_(options), report_(report) {
    result_.mesh.label = "Coarse terrain";
    result_.details.assign(mesh.positions.size(), 0.F);
    for (const Channel& channel : mesh.channels)
      result_.mesh.arrays.channels.push_back({{}, channel.blend});
  }

  void add(const GridPatch& patch, const GridPyramid& pyramid, int begin, int end) {
    const CoarsePatch coarse(patch, pyramid.row_placement(options_.levels),
                             pyramid.col_placement(options_.levels), next_vertex_);
    MeshArrays& arrays = result_.mesh.arrays;
    arrays.positions.resize(at(next_vertex_));
    const std::size_t first = options_.coordinates == Coordinates::all ? 0 : 2;
    for (std::size_t k = 0; k < first; ++k) {
      const auto old = [&](int v) { return mesh_.positions[at(v)][k]; };
      for_each(coarse, [&](Index r, Index c) {
        arrays.positions[at(coarse.vertex(r, c))][k] = blended(patch, old, coarse.place(r, c));
      });
    }
    std::vector<double> squares(patch.vertices.size(), 0);
    for (std::size_t k = first; k < 3; ++k) {
      report_.progress(begin + (end - begin) * static_cast<int>(k - first) / 4, "Coarsening");
      take_apart(coarse, k, squares);
    }
    keep_details(patch, squares);

    for (std::size_t k = 0; k < mesh_.channels.size(); ++k) {
      Channel& channel = arrays.channels[k];
      channel.values.resize(at(next_vertex_));
      for_each(coarse, [&](Index r, Index c) {
        channel.values[at(coarse.vertex(r, c))] =
            carried(patch, mesh_.channels[k], coarse.place(r, c));
      });
    }
    report_.progress(end, "Making faces");
    coarse.append_faces(mesh_, result_.mesh);
  }

  [[nodiscard]] double rms() const { return std::sqrt(sum_ / std::max(count_, 1.0)); }
  [[nodiscard]] double largest() const { return largest_; }
  [[nodiscard]] Coarsened take() { return std::move(result_); }

 private:
  static void for_each(const CoarsePatch& coarse, const auto& action) {
    for (Index r = 0; r < coarse.extent().rows; ++r)
      for (Index c = 0; c < coarse.extent().cols; ++c) action(r, c);
  }

  // One coordinate: coarse samples into the result, signed details into `details` while there is
  // only one coordinate, their squares otherwise.
  void take_apart(const CoarsePatch& coarse, std::size_t k, std::vector<double>& details) {
    const GridPatch& patch = coarse.fine();
    const GridReverseOptions options = reverse_options(patch, options_);
    auto parts = decompose_grid<double>(coordinate_plane(mesh_, patch, k).view(), scheme_, options);
    for_each(coarse, [&](Index r, Index c) {
      result_.mesh.arrays.positions[at(coarse.vertex(r, c))][k] = parts.coarse(r, c);
    });
    // Linear: the part of the details alone is what the coarse grid misses.
    std::fill(parts.coarse.samples().begin(), parts.coarse.samples().end(), 0.0);
    const Grid<double> missed =
        reconstruct_grid(parts, patch.extent, scheme_, options, options_.levels);
    const bool heights = options_.coordinates == Coordinates::heights;
    for (std::size_t i = 0; i < details.size(); ++i) {
      const double d = missed.samples()[i];
      details[i] += heights ? d : d * d;
    }
  }

  void keep_details(const GridPatch& patch, const std::vector<double>& values) {
    const bool heights = options_.coordinates == Coordinates::heights;
    for (std::size_t i = 0; i < values.size(); ++i) {
      const double detail = heights ? values[i] : std::sqrt(values[i]);
      result_.details[at(patch.vertices[i])] = static_cast<float>(detail);
      largest_ = std::max(largest_, std::abs(detail));
      sum_ += detail * detail;
    }
    count_ += static_cast<double>(values.size());
  }

  const MeshArrays& mesh_;
  const Scheme& scheme_;
  const CoarsenOptions& options_;
  const Report& report_;
  int next_vertex_ = 0;
  double sum_ = 0;
  double count_ = 0;
  double largest_ = 0;
  Coarsened result_;
};

// Where a coarse grid does not reach the rim of the fine one.
std::string shortfall_text(const GridPatch& patch, const GridPyramid& pyramid, int levels) {
  const auto missing = [](const AxisPlacement& axis, Index count) {
    const double last = axis.first + static_cast<double>(axis.count - 1) * axis.spacing;
    return std::max(0.0, axis.first) + std::max(0.0, static_cast<double>(count - 1) - last);
  };
  const double rows =
      patch.wraps_rows ? 0 : missing(pyramid.row_placement(levels), patch.extent.rows);
  const double cols =
      patch.wraps_cols ? 0 : missing(pyramid.col_placement(levels), patch.extent.cols);
  if (rows == 0 && cols == 0) return "";
  return "; it ends " + std::to_string(std::lround(rows)) + " rows and " +
         std::to_string(std::lround(cols)) + " columns before the old rim";
}

}  // namespace

Coarsened coarsened(const MeshArrays& mesh, const Scheme& scheme, const CoarsenOptions& options,
                    Report& report) {
  report.progress(0, "Finding the rows and columns of the mesh");
  const std::vector<GridPatch> patches = surface_patches(mesh, report);
  for (const GridPatch& patch : patches)
    if (options.boundary == Boundary::periodic && !(patch.wraps_rows && patch.wraps_cols))
      throw InvalidField("boundary periodic is not for open rims; choose another boundary");
  std::vector<GridPyramid> pyramids;
  double vertices = 0;
  for (const GridPatch& patch : patches) {
    pyramids.push_back(checked_pyramid(patch, scheme, options));
    const Extent coarse = pyramids.back().extent(options.levels);
    vertices += static_cast<double>(coarse.rows * coarse.cols);
  }
  // The planes under work, the details, and MeshLab's own copy.
  check_memory(40 * static_cast<double>(mesh.positions.size()) + 500 * vertices, vertices);

  Coarsening coarsening(mesh, scheme, options, report);
  const auto percent = [&](std::size_t patch) {
    return 20 + static_cast<int>(60 * patch / patches.size());
  };
  for (std::size_t i = 0; i < patches.size(); ++i)
    coarsening.add(patches[i], pyramids[i], percent(i), percent(i + 1));

  report.log("Scheme " + scheme.text() + ", " + std::string(to_string(options.mode)));
  for (std::size_t i = 0; i < patches.size(); ++i) {
    report.log("A grid of " + size_text(patches[i].extent) + " vertices became one of " +
               size_text(pyramids[i].extent(options.levels)) +
               shortfall_text(patches[i], pyramids[i], options.levels));
    if (i == 9 && patches.size() > 10) {
      report.log("... and so did " + std::to_string(patches.size() - 10) + " more");
      break;
    }
  }
  report.log("Refined again without details, it misses the fine terrain by " +
             std::to_string(coarsening.rms()) + " (root mean square), at most " +
             std::to_string(coarsening.largest()));
  return coarsening.take();
}

}  // namespace arete::meshlab
