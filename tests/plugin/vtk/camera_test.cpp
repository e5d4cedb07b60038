// SPDX-License-Identifier: MIT
#include "arete/vtk/internal/camera.h"

#include <gtest/gtest.h>
#include <vtkCamera.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>

#include <algorithm>
#include <array>
#include <random>
#include <vector>

namespace arete::vtk {
namespace {

/// Where a point is seen: x and y from -1 to 1 across the picture, z from -1 (near) to 1 (far).
Vector3 seen(const Vector3& point, double aspect, vtkCamera& camera) {
  const std::array<double, 4> in{point[0], point[1], point[2], 1};
  std::array<double, 4> out{};
  camera.GetCompositeProjectionTransformMatrix(aspect, -1, 1)->MultiplyPoint(in.data(), out.data());
  return {out[0] / out[3], out[1] / out[3], out[2] / out[3]};
}

std::vector<Vector3> boulders(const Vector3& size, unsigned seed) {
  std::mt19937 random(seed);
  std::vector<Vector3> points;
  const auto one = [&](double scale) {
    return scale * (static_cast<double>(random() % 2001) / 1000 - 1);
  };
  for (int k = 0; k < 200; ++k) points.push_back({one(size[0]), one(size[1]), one(size[2])});
  return points;
}

class Views : public testing::TestWithParam<bool> {
 protected:
  static void look(std::span<const Vector3> points, double aspect, vtkCamera& camera) {
    GetParam() ? look_from(points, {180, 42}, aspect, 0.9, camera)
               : look_down(points, aspect, 0.9, camera);
  }
};
INSTANTIATE_TEST_SUITE_P(camera, Views, testing::Bool());

TEST_P(Views, every_point_is_seen_and_the_tighter_side_is_filled) {
  unsigned seed = 0;
  for (const Vector3& size : {Vector3{10, 10, 1}, {1000, 10, 1}, {10, 1000, 1}, {1, 1, 50}}) {
    for (const double aspect : {0.5, 1.0, 1.6, 4.0}) {
      const auto points = boulders(size, ++seed);
      vtkNew<vtkCamera> camera;
      look(points, aspect, *camera);
      Vector3 reach{};
      double right = 0;
      for (const Vector3& point : points) {
        const Vector3 at = seen(point, aspect, *camera);
        for (std::size_t k = 0; k < 3; ++k) reach[k] = std::max(reach[k], std::abs(at[k]));
        right = std::max(right, at[0]);
      }
      EXPECT_NEAR(std::max(reach[0], reach[1]), 0.9, 1e-6);
      EXPECT_LT(reach[2], 1) << "nothing is clipped";
      EXPECT_NEAR(reach_right(points, aspect, *camera), right, 1e-9);
    }
  }
}

TEST_P(Views, east_is_right_and_north_is_up) {
  const std::vector<Vector3> points{{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
  vtkNew<vtkCamera> camera;
  look(points, 1.5, *camera);
  EXPECT_GT(seen({1, 0, 0}, 1.5, *camera)[0], seen({-1, 0, 0}, 1.5, *camera)[0]);
  EXPECT_GT(seen({0, 1, 0}, 1.5, *camera)[1], seen({0, -1, 0}, 1.5, *camera)[1]);
  EXPECT_LT(seen({0, 0, 0.5}, 1.5, *camera)[2], seen({0, 0, 0}, 1.5, *camera)[2]) << "from above";
}

TEST(camera, what_lies_towards_the_camera_s_azimuth_is_near_and_what_is_clockwise_of_it_left) {
  const std::vector<Vector3> points{{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
  const std::array<Vector3, 4> around{Vector3{0, 1, 0}, {1, 0, 0}, {0, -1, 0}, {-1, 0, 0}};
  for (std::size_t k = 0; k < 4; ++k) {
    vtkNew<vtkCamera> camera;
    look_from(points, {90.0 * static_cast<double>(k), 30}, 1, 0.9, *camera);
    const Vector3 near = seen(around[k], 1, *camera);
    const Vector3 far = seen(around[(k + 2) % 4], 1, *camera);
    EXPECT_LT(near[2], far[2]);
    EXPECT_LT(near[1], far[1]) << "what is near is lower in the picture";
    EXPECT_NEAR(near[0], 0, 1e-9);
    EXPECT_LT(seen(around[(k + 1) % 4], 1, *camera)[0], -0.1);
  }
}

TEST(camera, an_orbit_keeps_every_point_in_the_picture_and_no_farther_than_needed) {
  const auto points = boulders({30, 10, 2}, 7);
  std::vector<double> azimuths;
  for (int k = 0; k < 12; ++k) azimuths.push_back(30.0 * k);
  const Vector3 middle{1, -2, 0.5};
  const double radius = orbit_radius(points, middle, 35, azimuths, 1.5, 0.9);
  double reach = 0;
  for (const double azimuth : azimuths) {
    vtkNew<vtkCamera> camera;
    look_at(points, middle, {azimuth, 35}, radius, *camera);
    for (const Vector3& point : points) {
      const Vector3 at = seen(point, 1.5, *camera);
      reach = std::max({reach, std::abs(at[0]), std::abs(at[1])});
      EXPECT_LT(std::abs(at[2]), 1) << "nothing is clipped";
    }
    const Vector3 centre = seen(middle, 1.5, *camera);
    EXPECT_NEAR(centre[0], 0, 1e-9) << "the middle stands still";
    EXPECT_NEAR(centre[1], 0, 1e-9);
  }
  EXPECT_NEAR(reach, 0.9, 1e-6);
}

}  // namespace
}  // namespace arete::vtk
