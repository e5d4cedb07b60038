// SPDX-License-Identifier: MIT
#include "arete/vtk/plot_map.h"

#include <vtkNew.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "arete/vtk/error.h"
#include "arete/vtk/internal/canvas.h"
#include "arete/vtk/internal/contour_lines.h"
#include "arete/vtk/internal/painter.h"
#include "arete/vtk/internal/shapes.h"
#include "arete/vtk/internal/ticks.h"

namespace arete::vtk {
namespace {

constexpr int supersampling = 2;
constexpr Rgb ink{40, 40, 40};
constexpr double outline_width = 0.16;  // of the font's size

using Box = std::array<double, 4>;

Pixel drawn(double x, double y) {
  return {std::round(x * supersampling), std::round(y * supersampling)};
}

void check(const ClassMap& map, std::array<int, 2> size) {
  if (map.cells.rows() < 1 || map.cells.cols() < 1) throw InvalidField("a map needs cells");
  for (const int cell : map.cells.samples())
    if (cell < 0 || cell >= static_cast<int>(map.classes.size()))
      throw InvalidField("a cell of the map has no class");
  for (const MapOutline& outline : map.outlines) {
    if (outline.field.rows() < 2 || outline.field.cols() < 2)
      throw InvalidField("the outline " + outline.label + " needs at least 2 x 2 samples");
    const bool clipped = outline.within.rows() > 0;
    if (clipped && (outline.within.rows() != outline.field.rows() ||
                    outline.within.cols() != outline.field.cols()))
      throw InvalidField("the outline " + outline.label + " is clipped by a field of another size");
    for (const double value : outline.field.samples())
      if (std::isnan(value)) throw InvalidField("the outline " + outline.label + " has NaN");
  }
  if (std::min(size[0], size[1]) < 200) throw RenderError("a map needs at least 200 x 200 pixels");
}

// Four lines around a box, outside it: which of two overlapping 2-D boxes is on top is not to be
// relied on.
std::vector<Box> outline(const Box& b) {
  return {{b[0] - 1, b[1] - 1, b[2] + 1, b[1]},
          {b[0] - 1, b[3], b[2] + 1, b[3] + 1},
          {b[0] - 1, b[1], b[0], b[3]},
          {b[2], b[1], b[2] + 1, b[3]}};
}

double legend_width(const ClassMap& map, double font) {
  std::size_t longest = 0;
  const std::set<int> present(map.cells.samples().begin(), map.cells.samples().end());
  for (const int kind : present)
    longest = std::max(longest, map.classes[static_cast<std::size_t>(kind)].label.size());
  for (const MapOutline& outline : map.outlines) longest = std::max(longest, outline.label.size());
  return (3.5 + 0.53 * static_cast<double>(longest)) * font;
}

// The plot's place in the picture, and where the values of its axes fall.
class Frame {
 public:
  Frame(const ClassMap& map, std::array<int, 2> size, double font)
      : box_{5.5 * font, 4.5 * font, size[0] - legend_width(map, font), size[1] - 1.5 * font},
        map_(map) {}

  [[nodiscard]] const Box& box() const { return box_; }
  [[nodiscard]] double cell_width() const {
    return (box_[2] - box_[0]) / static_cast<double>(map_.cells.cols());
  }
  [[nodiscard]] double cell_height() const {
    return (box_[3] - box_[1]) / static_cast<double>(map_.cells.rows());
  }
  [[nodiscard]] double x(double value) const { return x_at(share(map_.x, value)); }
  [[nodiscard]] double y(double value) const { return y_at(share(map_.y, value)); }
  /// A share of the way from the first to the last value: from centre to centre of the outermost
  /// cells, or from edge to edge of a single one.
  [[nodiscard]] double x_at(double share) const {
    return place(share, box_[0], box_[2], map_.cells.cols());
  }
  [[nodiscard]] double y_at(double share) const {
    return place(share, box_[1], box_[3], map_.cells.rows());
  }

 private:
  static double place(double share, double low, double high, Index cells) {
    const double cell = (high - low) / static_cast<double>(cells);
    return cells == 1 ? low + share * (high - low)
                      : low + (share * static_cast<double>(cells - 1) + 0.5) * cell;
  }
  static double share(const MapAxis& axis, double value) {
    return axis.last == axis.first ? 0.5 : (value - axis.first) / (axis.last - axis.first);
  }

  Box box_;
  const ClassMap& map_;
};

std::vector<double> axis_ticks(const MapAxis& axis) {
  if (axis.first == axis.last) return {axis.first};
  return ticks(std::min(axis.first, axis.last), std::max(axis.first, axis.last), 8);
}

// Runs of equal cells of a row become one box.
void draw_cells(const ClassMap& map, const Frame& frame, vtkRenderer& renderer) {
  std::map<int, Shapes> shapes;
  const Box& place = frame.box();
  for (Index r = 0; r < map.cells.rows(); ++r) {
    Index begin = 0;
    for (Index c = 1; c <= map.cells.cols(); ++c) {
      if (c < map.cells.cols() && map.cells(r, c) == map.cells(r, begin)) continue;
      shapes.try_emplace(map.cells(r, begin), 0)
          .first->second.box(drawn(place[0] + static_cast<double>(begin) * frame.cell_width(),
                                   place[1] + static_cast<double>(r) * frame.cell_height()),
                             drawn(place[0] + static_cast<double>(c) * frame.cell_width(),
                                   place[1] + static_cast<double>(r + 1) * frame.cell_height()));
      begin = c;
    }
  }
  for (const auto& [kind, boxes] : shapes)
    boxes.draw(map.classes[static_cast<std::size_t>(kind)].color, renderer);
}

// Each on a white casing, so that it stands out from light and dark cells. Gives back the outlines
// that are in the picture.
std::vector<const MapOutline*> draw_outlines(const ClassMap& map, const Frame& frame, double font,
                                             vtkRenderer& renderer) {
  std::vector<const MapOutline*> visible;
  const double width = outline_width * font * supersampling;
  Shapes casing(1);
  for (const MapOutline& outline : map.outlines) {
    const auto pieces = zero_lines(outline.field, outline.within);
    if (pieces.empty()) continue;
    visible.push_back(&outline);
    Shapes line(2);
    const auto place = [&](const std::array<double, 2>& at) {
      return Pixel{
          frame.x_at(at[0] / static_cast<double>(outline.field.cols() - 1)) * supersampling,
          frame.y_at(at[1] / static_cast<double>(outline.field.rows() - 1)) * supersampling};
    };
    for (const auto& [a, b] : pieces) {
      casing.line({place(a), place(b)}, false, 2.2 * width);
      line.line({place(a), place(b)}, false, width);
    }
    line.draw(outline.color, renderer);
  }
  casing.draw({255, 255, 255}, renderer);
  return visible;
}

void draw_axes(const ClassMap& map, const Frame& frame, double font, Painter& paint) {
  const Box& place = frame.box();
  std::vector<Box> lines = outline(place);
  const double length = 0.4 * font;
  const std::vector<double> xs = axis_ticks(map.x);
  const std::vector<std::string> x_labels = tick_labels(xs);
  for (std::size_t i = 0; i < xs.size(); ++i) {
    const double x = frame.x(xs[i]);
    lines.push_back({x - 0.5, place[1] - 1 - length, x + 0.5, place[1] - 1});
    paint.text(x_labels[i], x, place[1] - 1.5 * length - 1, font, TextPlace::below);
  }
  const std::vector<double> ys = map.y.name.empty() ? std::vector<double>() : axis_ticks(map.y);
  const std::vector<std::string> y_labels = tick_labels(ys);
  for (std::size_t i = 0; i < ys.size(); ++i) {
    const double y = frame.y(ys[i]);
    lines.push_back({place[0] - 1 - length, y - 0.5, place[0] - 1, y + 0.5});
    paint.text(y_labels[i], place[0] - 1.5 * length - 1, y, font, TextPlace::left_middle);
  }
  paint.boxes(lines, std::vector<Rgb>(lines.size(), ink));
  paint.text(map.x.name, (place[0] + place[2]) / 2, 2.4 * font, 1.15 * font, TextPlace::below);
  if (!map.y.name.empty())
    paint.text(map.y.name, 1.6 * font, (place[1] + place[3]) / 2, 1.15 * font,
               TextPlace::above_turned);
}

void draw_legend(const ClassMap& map, const Frame& frame,
                 const std::vector<const MapOutline*>& outlines, double font, Painter& paint) {
  const std::set<int> present(map.cells.samples().begin(), map.cells.samples().end());
  const double left = frame.box()[2] + font;
  double top = frame.box()[3];
  std::vector<Box> boxes;
  std::vector<Rgb> colors;
  for (const int number : present) {
    const MapClass& kind = map.classes[static_cast<std::size_t>(number)];
    boxes.push_back({left, top - font, left + 1.4 * font, top});
    colors.push_back(kind.color);
    for (const Box& line : outline(boxes.back())) {
      boxes.push_back(line);
      colors.push_back(ink);
    }
    paint.text(kind.label, left + 1.9 * font, top - font / 2, font, TextPlace::right_middle);
    top -= 1.6 * font;
  }
  if (!outlines.empty()) top -= 0.8 * font;
  for (const MapOutline* outline : outlines) {
    const double half = outline_width * font / 2;
    boxes.push_back({left, top - font / 2 - half, left + 1.4 * font, top - font / 2 + half});
    colors.push_back(outline->color);
    paint.text(outline->label, left + 1.9 * font, top - font / 2, font, TextPlace::right_middle);
    top -= 1.6 * font;
  }
  paint.boxes(boxes, colors);
}

}  // namespace

void plot_map(const ClassMap& map, std::array<int, 2> size, const std::filesystem::path& png) {
  check(map, size);
  const double font = std::clamp(size[1] * 0.022, 11.0, 40.0);
  Canvas canvas(size[0], size[1], supersampling);
  vtkNew<vtkRenderer> renderer;
  renderer->SetBackground(1, 1, 1);
  canvas.window().AddRenderer(renderer);
  Painter paint(*renderer, canvas.supersampling(), ink);
  const Frame frame(map, size, font);
  draw_cells(map, frame, *renderer);
  const auto outlines = draw_outlines(map, frame, font, *renderer);
  draw_axes(map, frame, font, paint);
  draw_legend(map, frame, outlines, font, paint);
  set_pixel_camera(size[0] * supersampling, size[1] * supersampling, *renderer);
  write_png(canvas.draw(), png);
}

}  // namespace arete::vtk
