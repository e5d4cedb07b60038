// SPDX-License-Identifier: MIT
#include "arete/vtk/plot_functions.h"

#include <vtkNew.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <cmath>

#include "arete/vtk/error.h"
#include "arete/vtk/internal/canvas.h"
#include "arete/vtk/internal/painter.h"
#include "arete/vtk/internal/shapes.h"
#include "arete/vtk/internal/ticks.h"

namespace arete::vtk {
namespace {

constexpr int supersampling = 4;
constexpr std::size_t most_graphs = 8;
constexpr Rgb ink{40, 40, 40};
constexpr Rgb pale{205, 205, 205};
constexpr Rgb blue{31, 92, 153};
constexpr double line_width = 2.2;  // of a graph, in pixels of the picture

struct Range {
  double low = 0;
  double high = 0;
};

Range range_of(const FunctionGraph& graph, Index column) {
  Range range{graph.points(0, column), graph.points(0, column)};
  for (Index r = 0; r < graph.points.rows(); ++r) {
    range.low = std::min(range.low, graph.points(r, column));
    range.high = std::max(range.high, graph.points(r, column));
  }
  return range;
}

void check(const std::vector<FunctionGraph>& graphs, std::array<int, 2> size) {
  if (graphs.empty()) throw InvalidField("there is no function to draw");
  if (graphs.size() > most_graphs) throw RenderError("at most 8 functions fit into one picture");
  for (const FunctionGraph& graph : graphs) {
    if (graph.points.rows() < 2 || graph.points.cols() != 2)
      throw InvalidField("the graph of " + graph.label + " needs at least two points (x, y)");
    for (const double value : graph.points.samples())
      if (!std::isfinite(value))
        throw InvalidField("the graph of " + graph.label + " is not finite");
  }
  if (std::min(size[0], size[1]) < 200 || std::max(size[0], size[1]) > 2048)
    throw RenderError("a plot of functions is 200 to 2048 pixels wide and high");
}

// The place of one graph in the picture, in pixels of the picture, and its axes.
struct Panel {
  double left = 0, bottom = 0, right = 0, top = 0;
  Range x, y;

  [[nodiscard]] double to_x(double value) const {
    return left + (right - left) * (value - x.low) / (x.high - x.low);
  }
  [[nodiscard]] double to_y(double value) const {
    return bottom + (top - bottom) * (value - y.low) / (y.high - y.low);
  }
};

Range with_margin(Range range, double share) {
  const double length = range.high - range.low;
  const double margin = length > 0 ? share * length : std::max(1.0, std::abs(range.high));
  return {range.low - margin, range.high + margin};
}

class Sheet {
 public:
  Sheet(Painter& paint, double font) : paint_(paint), font_(font) {}

  void draw(const FunctionGraph& graph, const Panel& panel, bool lowest) {
    box(frame_, panel.left, panel.bottom, panel.right, panel.bottom, 0.5);
    box(frame_, panel.left, panel.bottom, panel.left, panel.top, 0.5);
    const std::vector<double> xs = ticks(panel.x.low, panel.x.high, 12);
    const std::vector<std::string> x_labels = tick_labels(xs);
    for (std::size_t i = 0; i < xs.size(); ++i) {
      const double x = panel.to_x(xs[i]);
      box(frame_, x, panel.bottom - 0.35 * font_, x, panel.bottom, 0.5);
      if (lowest) paint_.text(x_labels[i], x, panel.bottom - 0.6 * font_, font_, TextPlace::below);
    }
    const std::vector<double> ys = ticks(panel.y.low, panel.y.high, 5);
    const std::vector<std::string> y_labels = tick_labels(ys);
    for (std::size_t i = 0; i < ys.size(); ++i) {
      const double y = panel.to_y(ys[i]);
      box(frame_, panel.left - 0.35 * font_, y, panel.left, y, 0.5);
      paint_.text(y_labels[i], panel.left - 0.6 * font_, y, font_, TextPlace::left_middle);
    }
    if (panel.y.low < 0 && panel.y.high > 0)
      box(guides_, panel.left, panel.to_y(0), panel.right, panel.to_y(0), 0.5);
    std::vector<Pixel> points;
    for (Index r = 0; r < graph.points.rows(); ++r)
      points.push_back({panel.to_x(graph.points(r, 0)) * supersampling,
                        panel.to_y(graph.points(r, 1)) * supersampling});
    lines_.line(points, false, line_width * supersampling);
    paint_.text(graph.label, panel.left + 0.8 * font_, panel.top - 1.2 * font_, 1.15 * font_,
                TextPlace::right);
  }

  void finish(vtkRenderer& renderer) {
    guides_.draw(pale, renderer);
    frame_.draw(ink, renderer);
    lines_.draw(blue, renderer);
  }

 private:
  static void box(Shapes& shapes, double x0, double y0, double x1, double y1, double around) {
    shapes.box({(x0 - around) * supersampling, (y0 - around) * supersampling},
               {(x1 + around) * supersampling, (y1 + around) * supersampling});
  }

  Painter& paint_;
  double font_;
  Shapes guides_{0};
  Shapes frame_{1};
  Shapes lines_{2};
};

}  // namespace

void plot_functions(const std::vector<FunctionGraph>& graphs, const std::string& x_name,
                    std::array<int, 2> size, const std::filesystem::path& png) {
  check(graphs, size);
  const double font = std::clamp(size[1] * 0.02, 12.0, 18.0);
  Canvas canvas(size[0], size[1], supersampling);
  vtkNew<vtkRenderer> renderer;
  renderer->SetBackground(1, 1, 1);
  canvas.window().AddRenderer(renderer);
  Painter paint(*renderer, canvas.supersampling(), ink);
  Sheet sheet(paint, font);
  const double foot = 4 * font;
  const double height = (size[1] - foot - font) / static_cast<double>(graphs.size());
  Range x = range_of(graphs.front(), 0);
  for (const FunctionGraph& graph : graphs) {
    const Range own = range_of(graph, 0);
    x = {std::min(x.low, own.low), std::max(x.high, own.high)};
  }
  if (!(x.high > x.low)) throw InvalidField("the functions have no extent in x");
  for (std::size_t k = 0; k < graphs.size(); ++k) {
    Panel panel;
    panel.left = 5 * font;
    panel.right = size[0] - 1.5 * font;
    panel.top = size[1] - font - height * static_cast<double>(k);
    panel.bottom = panel.top - height + 1.2 * font;
    panel.x = x;
    panel.y = with_margin(range_of(graphs[k], 1), 0.06);
    sheet.draw(graphs[k], panel, k + 1 == graphs.size());
  }
  paint.text(x_name, size[0] / 2.0 + 1.75 * font, 1.9 * font, 1.15 * font, TextPlace::below);
  sheet.finish(*renderer);
  set_pixel_camera(size[0] * supersampling, size[1] * supersampling, *renderer);
  write_png(canvas.draw(), png);
}

}  // namespace arete::vtk
