// SPDX-License-Identifier: MIT
#include "arete/vtk/plot_curve.h"

#include <vtkNew.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <limits>
#include <vector>

#include "arete/vtk/error.h"
#include "arete/vtk/internal/canvas.h"
#include "arete/vtk/internal/shapes.h"

namespace arete::vtk {
namespace {

constexpr int supersampling = 4;

struct Range {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();

  void include(const Polyline& line, Index column) {
    for (Index r = 0; r < line.points.rows(); ++r) {
      low = std::min(low, line.points(r, column));
      high = std::max(high, line.points(r, column));
    }
  }
};

/// From the plane to drawn pixels, the middle to the middle.
class Axes {
 public:
  Axes(const Range& x, const Range& y, const PlotOptions& options, int scale)
      : middle_{(x.low + x.high) / 2, (y.low + y.high) / 2},
        centre_{options.width * scale / 2.0, options.height * scale / 2.0} {
    const double margin = std::min(options.width, options.height) / 12.0;
    const double across = (options.width - 2 * margin) * scale;
    const double up = (options.height - 2 * margin) * scale;
    // A curve without width or height still has the other; a single place has neither.
    const double x_length = x.high - x.low;
    const double y_length = y.high - y.low;
    unit_ = {x_length > 0 ? across / x_length : 1, y_length > 0 ? up / y_length : 1};
    if (options.equal_axes && x_length > 0 && y_length > 0) {
      unit_.x = unit_.y = std::min(unit_.x, unit_.y);
    }
  }

  [[nodiscard]] Pixel operator()(const Polyline& line, Index r) const {
    return {centre_.x + (line.points(r, 0) - middle_.x) * unit_.x,
            centre_.y + (line.points(r, 1) - middle_.y) * unit_.y};
  }

 private:
  Pixel middle_;
  Pixel centre_;
  Pixel unit_;
};

std::vector<Pixel> placed(const Polyline& line, const Axes& axes) {
  std::vector<Pixel> points;
  for (Index r = 0; r < line.points.rows(); ++r) points.push_back(axes(line, r));
  return points;
}

}  // namespace

void plot_curve(const Polyline& curve, const std::optional<Polyline>& control,
                const PlotOptions& options, const std::filesystem::path& png) {
  check_polyline(curve);
  if (control) check_polyline(*control);
  if (!(options.line_width > 0)) throw RenderError("the line width has to be positive");

  Range x;
  Range y;
  for (const Polyline* line : {&curve, control ? &*control : nullptr}) {
    if (line == nullptr) continue;
    x.include(*line, 0);
    y.include(*line, 1);
  }
  Canvas canvas(options.width, options.height, supersampling);
  const Axes axes(x, y, options, canvas.supersampling());
  const double width = options.line_width * canvas.supersampling();

  vtkNew<vtkRenderer> renderer;
  renderer->SetBackground(options.background[0] / 255.0, options.background[1] / 255.0,
                          options.background[2] / 255.0);
  canvas.window().AddRenderer(renderer);
  Shapes polygon(0);
  Shapes line(1);
  Shapes points(2);
  if (control) {
    const auto corners = placed(*control, axes);
    polygon.line(corners, control->closed, width / 2);
    for (const Pixel& corner : corners) points.disc(corner, 2 * width);
    polygon.draw(options.control_color, *renderer);
  }
  line.line(placed(curve, axes), curve.closed, width);
  line.draw(options.curve_color, *renderer);
  if (control) points.draw(options.point_color, *renderer);
  set_pixel_camera(options.width * canvas.supersampling(), options.height * canvas.supersampling(),
                   *renderer);
  write_png(canvas.draw(), png);
}

}  // namespace arete::vtk
