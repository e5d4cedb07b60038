// SPDX-License-Identifier: MIT
#include "arete/vtk/internal/camera.h"

#include <vtkCamera.h>
#include <vtkMatrix4x4.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

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

double dot(const Vector3& a, const Vector3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Range range_of(std::span<const Vector3> points, const Vector3& form) {
  Range range;
  for (const Vector3& p : points) {
    const double value = dot(p, form);
    range.low = std::min(range.low, value);
    range.high = std::max(range.high, value);
  }
  return range;
}

Vector3 add(const Vector3& a, double factor, const Vector3& b) {
  return {a[0] + factor * b[0], a[1] + factor * b[1], a[2] + factor * b[2]};
}

/// What is right, up and towards the eye in the picture.
struct Frame {
  Vector3 right;
  Vector3 up;
  Vector3 towards;

  explicit Frame(const Viewpoint& from) {
    const double ca = std::cos(from.azimuth * radian);
    const double sa = std::sin(from.azimuth * radian);
    const double cp = std::cos(from.pitch * radian);
    const double sp = std::sin(from.pitch * radian);
    towards = {sa * cp, ca * cp, sp};
    right = {-ca, sa, 0};
    up = {-sa * sp, -ca * sp, cp};
  }
};

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

void set_perspective(std::span<const Vector3> points, const Vector3& eye, const Vector3& focus,
                     const Frame& frame, vtkCamera& camera) {
  camera.SetPosition(eye.data());
  camera.SetFocalPoint(focus.data());
  camera.SetViewUp(frame.up.data());
  camera.SetViewAngle(view_angle);
  set_clipping(points, frame.towards, dot(eye, frame.towards), camera);
}

}  // namespace

void look_from(std::span<const Vector3> points, const Viewpoint& from, double aspect, double fill,
               vtkCamera& camera) {
  const Frame frame(from);
  const double t = fill * std::tan(view_angle / 2 * radian);
  const Fit across = fit(points, frame.right, frame.towards, t * aspect);
  const Fit upward = fit(points, frame.up, frame.towards, t);
  const Vector3 foot = add(add({0, 0, 0}, across.at, frame.right), upward.at, frame.up);
  const Vector3 focus = add(foot, range_of(points, frame.towards).middle(), frame.towards);
  set_perspective(points, add(foot, std::max(across.back, upward.back), frame.towards), focus,
                  frame, camera);
}

double orbit_radius(std::span<const Vector3> points, const Vector3& middle, double pitch,
                    std::span<const double> azimuths, double aspect, double fill) {
  const double t = fill * std::tan(view_angle / 2 * radian);
  double radius = 0;
  for (const double azimuth : azimuths) {
    const Frame frame({azimuth, pitch});
    for (const auto& [axis, tangent] : {std::pair{frame.right, t * aspect}, {frame.up, t}}) {
      for (const double side : {-1.0, 1.0}) {
        // side * (p - m).axis <= tangent * (radius - (p - m).towards)
        const Vector3 form = add(add({0, 0, 0}, side / tangent, axis), 1, frame.towards);
        radius = std::max(radius, range_of(points, form).high - dot(middle, form));
      }
    }
  }
  return radius;
}

void look_at(std::span<const Vector3> points, const Vector3& middle, const Viewpoint& from,
             double radius, vtkCamera& camera) {
  const Frame frame(from);
  set_perspective(points, add(middle, radius, frame.towards), middle, frame, camera);
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
