// SPDX-License-Identifier: MIT
#include "arete/vtk/internal/camera.h"

#include <vtkCamera.h>
#include <vtkMatrix4x4.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace arete::vtk {
namespace {

constexpr double view_angle = 24;  // degrees from bottom to top: little distortion
constexpr double radian = std::numbers::pi / 180;

/// The least and greatest value of a linear form over points.
struct Range {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();

  [[nodiscard]] double middle() const { return (low + high) / 2; }
  [[nodiscard]] double length() const { return high - low; }
};

Range range_of(std::span<const Vector3> points, const Vector3& form) {
  Range range;
  for (const Vector3& p : points) {
    const double value = p[0] * form[0] + p[1] * form[1] + p[2] * form[2];
    range.low = std::min(range.low, value);
    range.high = std::max(range.high, value);
  }
  return range;
}

Vector3 add(const Vector3& a, double factor, const Vector3& b) {
  return {a[0] + factor * b[0], a[1] + factor * b[1], a[2] + factor * b[2]};
}

/// Where, along one axis across the line of sight, the camera has to stand, and how far back, for
/// all points to lie between both sides of the frustum: |along - at| <= t (back - towards).
struct Fit {
  double at;
  double back;
};

Fit fit(std::span<const Vector3> points, const Vector3& axis, const Vector3& towards, double t) {
  const double plus = range_of(points, add(axis, t, towards)).high;
  const double minus = range_of(points, add({-axis[0], -axis[1], -axis[2]}, t, towards)).high;
  return {(plus - minus) / 2, (plus + minus) / (2 * t)};
}

void set_clipping(std::span<const Vector3> points, const Vector3& towards, double back,
                  vtkCamera& camera) {
  const Range depth = range_of(points, towards);
  const double far = back - depth.low;
  const double slack = 0.01 * (far + depth.length());
  camera.SetClippingRange(std::max(back - depth.high - slack, far * 1e-3), far + slack);
}

}  // namespace

void look_from_south(std::span<const Vector3> points, double pitch, double aspect, double fill,
                     vtkCamera& camera) {
  const Vector3 east{1, 0, 0};
  const Vector3 towards{0, -std::cos(pitch * radian), std::sin(pitch * radian)};  // the eye
  const Vector3 up{0, std::sin(pitch * radian), std::cos(pitch * radian)};
  const double t = fill * std::tan(view_angle / 2 * radian);
  const Fit across = fit(points, east, towards, t * aspect);
  const Fit upward = fit(points, up, towards, t);
  const double back = std::max(across.back, upward.back);

  const Vector3 foot = add(add({0, 0, 0}, across.at, east), upward.at, up);
  const Vector3 eye = add(foot, back, towards);
  const Vector3 focus = add(foot, range_of(points, towards).middle(), towards);
  camera.SetPosition(eye.data());
  camera.SetFocalPoint(focus.data());
  camera.SetViewUp(0, 0, 1);
  camera.SetViewAngle(view_angle);
  set_clipping(points, towards, back, camera);
}

void look_down(std::span<const Vector3> points, double aspect, double fill, vtkCamera& camera) {
  const Range x = range_of(points, {1, 0, 0});
  const Range y = range_of(points, {0, 1, 0});
  const Range z = range_of(points, {0, 0, 1});
  const double height = std::max(y.length(), x.length() / aspect) / fill;
  const double eye = z.high + height;
  camera.ParallelProjectionOn();
  camera.SetParallelScale(height / 2);
  camera.SetPosition(x.middle(), y.middle(), eye);
  camera.SetFocalPoint(x.middle(), y.middle(), z.low);
  camera.SetViewUp(0, 1, 0);
  set_clipping(points, {0, 0, 1}, eye, camera);
}

double reach_right(std::span<const Vector3> points, double aspect, vtkCamera& camera) {
  const vtkMatrix4x4* matrix = camera.GetCompositeProjectionTransformMatrix(aspect, -1, 1);
  const auto row = [&](int r, const Vector3& p) {
    const auto& m = matrix->Element[r];
    return m[0] * p[0] + m[1] * p[1] + m[2] * p[2] + m[3];
  };
  double reach = 0;
  for (const Vector3& point : points) reach = std::max(reach, row(0, point) / row(3, point));
  return reach;
}

}  // namespace arete::vtk
