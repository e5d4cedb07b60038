// SPDX-License-Identifier: MIT
// Minimal surfaces against catenoid, Enneper, Scherk and helicoid, and the law that area never
// rises.
#include "arete/variational/minimal_patch.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "arete/algebra/rational.h"
#include "arete/field/error.h"
#include "arete/variational/harmonic.h"
#include "support/oracle.h"

namespace arete {
namespace {

using nlohmann::json;
using test::exact;
using test::ternary_and_reverse_records;

template <class R>
std::array<R, 3> enneper(const R& u, const R& v) {
  return {u - u * u * u / R(3) + u * v * v, R(0) - v - u * u * v + v * v * v / R(3), u * u - v * v};
}

// A surface with what is known of it.
struct Known {
  PatchBoundary boundary;
  std::function<double(const Point3&)> residual;  // 0 on the surface
  double area = 0;
};

Known known(const std::string& name) {
  if (name == "catenoid")
    return {{[](double u, double v) {
               const double z = v - 0.5, r = std::cosh(z), a = 2 * std::numbers::pi * u;
               return Point3{r * std::cos(a), r * std::sin(a), z};
             },
             /*ring=*/true},
            [](const Point3& p) { return std::hypot(p[0], p[1]) - std::cosh(p[2]); },
            std::numbers::pi * (1 + std::sinh(1.0))};
  if (name == "enneper")
    return {{[](double u, double v) { return enneper(u - 0.5, v - 0.5); }},
            [](const Point3& p) {
              // The nearest parameters by Newton's method on x and y.
              double u = p[0], v = -p[1];
              for (int i = 0; i < 60; ++i) {
                const auto q = enneper(u, v);
                u += p[0] - q[0];
                v -= p[1] - q[1];
              }
              return enneper(u, v)[2] - p[2];
            },
            247.0 / 180};
  if (name == "scherk")
    return {{[](double u, double v) {
              const double x = 1.6 * u - 0.8, y = 1.6 * v - 0.8;
              return Point3{x, y, std::log(std::cos(y) / std::cos(x))};
            }},
            [](const Point3& p) { return p[2] - std::log(std::cos(p[1]) / std::cos(p[0])); },
            3.185307416229088};
  // Half a turn of a helicoid between two helices: r in -1..1, height = angle.
  return {{[](double u, double v) {
            const double a = std::numbers::pi * u, r = 2 * v - 1;
            return Point3{r * std::cos(a), r * std::sin(a), a};
          }},
          [](const Point3& p) { return p[0] * std::sin(p[2]) - p[1] * std::cos(p[2]); },
          std::numbers::pi * (std::numbers::sqrt2 + std::asinh(1.0))};
}

// 4 * 2^levels cells along v; a ring as many along u, as in the records.
MinimalOptions options_for(int levels, bool ring = false) {
  MinimalOptions options;
  options.levels = levels;
  if (ring && levels > 0) {
    options.levels = levels - 1;
    options.start_rows = options.start_cols = 8;
  }
  return options;
}

double max_residual(const MinimalSurface& surface, const Known& k) {
  double largest = 0;
  for (const Point3& p : surface.mesh.points) largest = std::max(largest, std::abs(k.residual(p)));
  return largest;
}

TEST(minimal_surface, records_of_catenoid_enneper_and_scherk) {
  for (const json& record : ternary_and_reverse_records("r.minimal")) {
    const json& expect = record.at("expect");
    const Known k = known(record.at("input").at("surface"));
    EXPECT_NEAR(k.area, expect.at("exact_area").get<double>(), 1e-9);
    for (const auto& [key, levels] : {std::pair{"n=17", 2}, {"n=33", 3}}) {
      const MinimalSurface surface =
          minimal_surface(k.boundary, options_for(levels, k.boundary.ring));
      const std::string id = record.at("id").get<std::string>() + " " + key;
      const MinimalLevel& last = surface.levels.back();
      EXPECT_EQ(last.samples.rows, std::stoi(std::string(key).substr(2))) << id;
      const double error = expect.at(key).at("area_relative_error");
      EXPECT_NEAR(last.area / k.area - 1, error, 0.5 * std::abs(error)) << id;
      // Enneper's record measures another residual than the height above the surface: ours is less.
      const double residual = expect.at(key).at("implicit_residual");
      EXPECT_LT(max_residual(surface, k), 1.5 * residual) << id;
      EXPECT_LT(last.max_mean_curvature,
                expect.at(key).at("max_mean_curvature_below").get<double>())
          << id;
      EXPECT_TRUE(last.converged) << id;
    }
  }
}

TEST(minimal_surface, errors_fall_four_times_a_level) {
  for (const char* name : {"catenoid", "enneper", "scherk", "helicoid"}) {
    const Known k = known(name);
    const MinimalSurface coarse = minimal_surface(k.boundary, options_for(3, k.boundary.ring));
    const MinimalSurface fine = minimal_surface(k.boundary, options_for(4, k.boundary.ring));
    const double area_order =
        std::log2((coarse.levels.back().area - k.area) / (fine.levels.back().area - k.area));
    EXPECT_NEAR(area_order, 2, 0.1) << name;
    EXPECT_NEAR(std::log2(max_residual(coarse, k) / max_residual(fine, k)), 2, 0.4) << name;
  }
}

// The area of Enneper's surface on |u|, |v| <= h is 4h^2 + 16h^4/3 + 112h^6/45; our areas tend to
// it.
TEST(minimal_surface, area_tends_to_enneper_s) {
  for (const json& record : ternary_and_reverse_records("r.enneper_area")) {
    const Rational h = exact(record.at("input").at("h"));
    const Rational area = exact(record.at("expect").at("area_on_|u|,|v|<=h"));
    EXPECT_EQ(4 * power(h, 2) + Rational(16, 3) * power(h, 4) + Rational(112, 45) * power(h, 6),
              area);
    const double size = to_double(h);
    const PatchBoundary boundary{
        [size](double u, double v) { return enneper(size * (2 * u - 1), size * (2 * v - 1)); }};
    const double coarse = minimal_surface(boundary, options_for(3)).levels.back().area;
    const double fine = minimal_surface(boundary, options_for(4)).levels.back().area;
    // Richardson: order 2 leaves an error of order 4.
    EXPECT_NEAR((4 * fine - coarse) / 3, to_double(area), 2e-7 * to_double(area)) << h;
  }
}

TEST(minimal_surface, harmonic_coordinates_reproduce_enneper_exactly) {
  for (const json& record : ternary_and_reverse_records("r.enneper_harmonic")) {
    const int n = record.at("input").at("n");
    const auto u = test::exact_list(record.at("input").at("u_i"));
    const json& interior = record.at("expect").at("interior");
    for (std::size_t k = 0; k < 3; ++k) {
      Matrix<Rational> border(n, n);
      for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j)
          if (i == 0 || j == 0 || i == n - 1 || j == n - 1)
            border(i, j) =
                enneper(u[static_cast<std::size_t>(i)], u[static_cast<std::size_t>(j)])[k];
      const auto patch = harmonic_patch(border);
      for (int i = 1; i + 1 < n; ++i)
        for (int j = 1; j + 1 < n; ++j)
          EXPECT_EQ(
              patch(i, j),
              exact(interior[static_cast<std::size_t>(i - 1)][static_cast<std::size_t>(j - 1)][k]))
              << record.at("id");
    }
  }
}

TEST(harmonic_patch, is_the_mean_of_the_neighbours_on_any_shape) {
  for (const auto& [rows, cols] : {std::pair{5, 9}, {9, 4}, {3, 3}, {2, 6}}) {
    Matrix<double> border(rows, cols);
    for (int i = 0; i < rows; ++i)
      for (int j = 0; j < cols; ++j) border(i, j) = (i * 7 + j * j * 3) % 11;
    const auto patch = harmonic_patch(border);
    for (int i = 1; i + 1 < rows; ++i)
      for (int j = 1; j + 1 < cols; ++j)
        EXPECT_NEAR(4 * patch(i, j),
                    patch(i - 1, j) + patch(i + 1, j) + patch(i, j - 1) + patch(i, j + 1), 1e-12);
  }
  EXPECT_THROW((void)harmonic_patch(Matrix<double>(1, 4)), InvalidField);
}

// A bumpy start over a fixed border, all triangles of different shape.
SurfaceMesh bumpy(unsigned seed) {
  const Known k = known("scherk");
  const Extent samples{14, 11};
  SurfaceMesh mesh{coons_patch(k.boundary, samples), grid_triangles(samples, false), {}};
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> bump(-0.05, 0.05);
  for (Index r = 0; r < samples.rows; ++r)
    for (Index c = 0; c < samples.cols; ++c) {
      const bool border = r == 0 || c == 0 || r == samples.rows - 1 || c == samples.cols - 1;
      mesh.fixed.push_back(border);
      if (border) continue;
      for (double& x : mesh.points[static_cast<std::size_t>(r * samples.cols + c)])
        x += bump(random);
    }
  return mesh;
}

TEST(relax, never_lets_the_area_rise_and_never_moves_the_border) {
  for (unsigned seed : {1U, 2U, 3U})
    for (int spreading : {0, 3}) {
      SurfaceMesh mesh = bumpy(seed);
      const SurfaceMesh start = mesh;
      RelaxOptions options;
      options.spreading_steps = spreading;
      const RelaxReport report = relax(mesh, options);
      EXPECT_TRUE(report.converged);
      EXPECT_LT(report.areas.back(), report.areas.front() - 0.01);
      for (std::size_t i = 1; i < report.areas.size(); ++i)
        EXPECT_LE(report.areas[i], report.areas[i - 1]);
      EXPECT_NEAR(report.areas.back(), surface_area(mesh), 1e-12);
      for (std::size_t i = 0; i < mesh.points.size(); ++i)
        if (mesh.fixed[i]) {
          EXPECT_EQ(mesh.points[i], start.points[i]);
        }
    }
}

TEST(relax, finds_the_plane_of_a_plane_boundary) {
  const PatchBoundary square{[](double u, double v) { return Point3{u, v, 2 * u - v}; }};
  const MinimalSurface surface = minimal_surface(square, options_for(2));
  for (const Point3& p : surface.mesh.points) EXPECT_NEAR(p[2], 2 * p[0] - p[1], 1e-9);
  EXPECT_NEAR(surface.levels.back().area, std::sqrt(6.0), 1e-9);
}

TEST(relax, turns_with_its_boundary) {
  const Known k = known("enneper");
  const double c = std::cos(0.6), s = std::sin(0.6);
  const auto turned = [c, s](const Point3& p) {
    return Point3{p[0] + 5, c * p[1] - s * p[2], s * p[1] + c * p[2]};
  };
  const PatchBoundary other{[&](double u, double v) { return turned(k.boundary.at(u, v)); }};
  const MinimalSurface a = minimal_surface(k.boundary, options_for(2));
  const MinimalSurface b = minimal_surface(other, options_for(2));
  for (std::size_t i = 0; i < a.mesh.points.size(); ++i) {
    const Point3 p = turned(a.mesh.points[i]);
    for (std::size_t j = 0; j < 3; ++j) EXPECT_NEAR(b.mesh.points[i][j], p[j], 1e-9);
  }
}

TEST(relax, says_so_when_two_rings_are_too_far_apart) {
  const PatchBoundary rings{[](double u, double v) {
                              const double a = 2 * std::numbers::pi * u;
                              return Point3{std::cos(a), std::sin(a), 3 * v};
                            },
                            /*ring=*/true};
  MinimalOptions options = options_for(2);
  options.relax.normal_steps = 40;
  const MinimalSurface surface = minimal_surface(rings, options);
  EXPECT_FALSE(surface.levels.back().converged);
  for (const Point3& p : surface.mesh.points)
    for (const double x : p) EXPECT_TRUE(std::isfinite(x));
}

TEST(relax, refuses_what_has_no_solution) {
  const PatchBoundary line{[](double u, double v) { return Point3{u + v, 0, 0}; }};
  EXPECT_THROW((void)minimal_surface(line, options_for(1)), InvalidField);
  const PatchBoundary hole{[](double, double) { return Point3{std::nan(""), 0, 0}; }};
  EXPECT_THROW((void)minimal_surface(hole, options_for(1)), InvalidField);
  const Known k = known("enneper");
  EXPECT_THROW((void)minimal_surface(k.boundary, options_for(-1)), InvalidField);
  EXPECT_THROW((void)minimal_surface(k.boundary, options_for(11)), InvalidField);
  MinimalOptions thin;
  thin.start_rows = 0;
  EXPECT_THROW((void)minimal_surface(k.boundary, thin), InvalidField);
  MinimalOptions vast = options_for(10);
  vast.start_rows = 8;
  EXPECT_THROW((void)minimal_surface(k.boundary, vast), InvalidField);
  SurfaceMesh loose = bumpy(1);
  loose.fixed.assign(loose.points.size(), false);
  EXPECT_THROW((void)relax(loose), InvalidField);
  SurfaceMesh wrong = bumpy(1);
  wrong.triangles.front() = {0, 0, 1};
  EXPECT_THROW((void)relax(wrong), InvalidField);
  // Nothing is free: nothing to do, and no complaint.
  SurfaceMesh rigid = bumpy(1);
  rigid.fixed.assign(rigid.points.size(), true);
  EXPECT_EQ(relax(rigid).areas.size(), 1u);
}

TEST(mean_curvature, of_a_sphere_is_one_over_its_radius) {
  const Extent samples{33, 64};
  SurfaceMesh mesh;
  for (Index r = 0; r < samples.rows; ++r)
    for (Index c = 0; c < samples.cols; ++c) {
      const double latitude = (static_cast<double>(r) / 32 - 0.5) * 2;
      const double angle = 2 * std::numbers::pi * static_cast<double>(c) / 64;
      mesh.points.push_back({3 * std::cos(latitude) * std::cos(angle),
                             3 * std::cos(latitude) * std::sin(angle), 3 * std::sin(latitude)});
      mesh.fixed.push_back(r == 0 || r == 32);
    }
  mesh.triangles = grid_triangles(samples, true);
  const auto h = mean_curvatures(mesh);
  for (std::size_t i = 64; i + 64 < h.size(); ++i) EXPECT_NEAR(std::abs(h[i]), 1.0 / 3, 0.01);
}

}  // namespace
}  // namespace arete
