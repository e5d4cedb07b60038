// SPDX-License-Identifier: MIT
// Meshes through `arete refine`: from file to file, and what comes of a raster.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <map>
#include <set>

#include "arete/gdal/band_source.h"
#include "arete/openmesh/mesh_io.h"
#include "arete/refine/refiner.h"
#include "arete/topology/orient.h"
#include "arete/topology/recover.h"
#include "expect_error.h"
#include "run_program.h"
#include "support/schemes.h"
#include "support/temporary_folder.h"
#include "topology/meshes.h"

namespace arete {
namespace {

using openmesh::MeshData;
using test::dem;
using test::expect_error;
using test::run_arete;
using test::run_json;

// A shuffled terrain in UTM, whose digits float would lose.
MeshData utm_terrain(Index rows, Index cols) {
  const test::Mesh mesh = test::shuffled(test::terrain_mesh(rows, cols), 4);
  MeshData data{mesh.points, mesh.faces};
  for (Point3& p : data.points) p = {500000.25 + 30 * p[0], 5400000.5 + 30 * p[1], 100 * p[2]};
  return data;
}

std::array<Grid<double>, 3> planes_of(const MeshData& mesh) {
  const GridPatch patch =
      oriented(recover_grids(mesh.faces, static_cast<int>(mesh.points.size()), mesh.points).at(0),
               mesh.points);
  std::array<Grid<double>, 3> planes;
  for (std::size_t k = 0; k < 3; ++k) {
    planes[k] = Grid<double>(patch.extent);
    for (std::size_t i = 0; i < patch.vertices.size(); ++i)
      planes[k].samples()[i] = mesh.points[static_cast<std::size_t>(patch.vertices[i])][k];
  }
  return planes;
}

void expect_refined(const MeshData& coarse, const MeshData& fine, const Scheme& x, const Scheme& y,
                    const RefineOptions& options, double tolerance) {
  const auto before = planes_of(coarse);
  const auto after = planes_of(fine);
  for (std::size_t k = 0; k < 3; ++k) {
    const Grid<double> expected =
        Refiner<double>(x, y, before[k].extent(), options)(before[k].view());
    ASSERT_EQ(after[k].extent(), expected.extent());
    for (std::size_t i = 0; i < expected.samples().size(); ++i)
      ASSERT_NEAR(after[k].samples()[i], expected.samples()[i], tolerance) << k;
  }
}

TEST(cli_refine_mesh, every_format_into_every_format) {
  const test::TemporaryFolder folder;
  const MeshData coarse = utm_terrain(5, 7);
  const Scheme scheme = parse_scheme("gentle");
  RefineOptions options;
  options.levels = 2;
  for (const char* from : {"obj", "ply", "off", "stl"}) {
    const std::string in = folder.file(std::string("in.") + from);
    openmesh::write_mesh(in, coarse);
    for (const char* to : {"obj", "ply", "off", "stl"}) {
      const std::string out = folder.file(std::string("out.") + to);
      const auto run =
          run_arete({"refine", in, out, "--scheme", "gentle", "--levels", "2", "--overwrite"});
      ASSERT_EQ(run.exit_code, 0) << run.err;
      EXPECT_NE(run.out.find("grid of 7 x 5 -> 25 x 17"), std::string::npos) << run.out;
      const MeshData fine = openmesh::read_mesh(out);
      const bool stl = std::string(from) == "stl" || std::string(to) == "stl";
      EXPECT_EQ(fine.faces.count(), stl ? 2 * 16 * 24 : 16 * 24) << "quads stay quads";
      // The ways round the triangles of an STL may differ, its numbers are floats.
      if (std::string(to) != "stl")
        expect_refined(openmesh::read_mesh(in), fine, scheme, scheme, options, 1e-8);
    }
  }
  EXPECT_EQ(folder.entries(), 8);
}

TEST(cli_refine_mesh, options_are_those_of_rasters) {
  const test::TemporaryFolder folder;
  const MeshData coarse = utm_terrain(6, 8);
  openmesh::write_mesh(folder.file("in.ply"), coarse);
  const auto report = run_json({"refine", folder.file("in.ply"), folder.file("out.ply"), "--scheme",
                                "b-spline:degree=3", "--scheme-y", "four-point", "--boundary",
                                "clamp,reflect", "--levels", "2", "--threads", "2", "--json"});
  EXPECT_EQ(report.at("rows"), 21);
  EXPECT_EQ(report.at("cols"), 29);
  EXPECT_EQ(report.at("vertices"), 21 * 29);
  EXPECT_EQ(report.at("faces"), 20 * 28);
  EXPECT_EQ(report.at("grids").at(0).at("input_rows"), 6);
  EXPECT_EQ(report.at("scheme_y"), "four-point:omega=1/16");
  for (const char* key :
       {"input", "output", "levels", "scheme", "seconds", "samples_per_second", "threads"})
    EXPECT_TRUE(report.contains(key)) << key;
  RefineOptions options;
  options.levels = 2;
  options.boundaries = {Boundary::clamp, Boundary::reflect};
  expect_refined(coarse, openmesh::read_mesh(folder.file("out.ply")),
                 parse_scheme("b-spline:degree=3"), parse_scheme("four-point"), options, 1e-9);

  // Points on the limit surface are where many levels lead.
  ASSERT_EQ(run_arete({"refine", folder.file("in.ply"), folder.file("limit.ply"), "--scheme",
                       "b-spline:degree=3", "--limit"})
                .exit_code,
            0);
  ASSERT_EQ(run_arete({"refine", folder.file("in.ply"), folder.file("deep.ply"), "--scheme",
                       "b-spline:degree=3", "--levels", "6"})
                .exit_code,
            0);
  const MeshData limit = openmesh::read_mesh(folder.file("limit.ply"));
  const MeshData deep = openmesh::read_mesh(folder.file("deep.ply"));
  for (std::size_t v = 0; v < coarse.points.size(); ++v)
    EXPECT_NEAR(limit.points[v][2], deep.points[v][2], 0.05);
}

TEST(cli_refine_mesh, attributes_come_along_and_what_has_no_place_is_said) {
  const test::TemporaryFolder folder;
  MeshData coarse = utm_terrain(4, 5);
  for (const Point3& p : coarse.points)
    coarse.colors.push_back({static_cast<std::uint8_t>((p[0] - 500000.25) / 30 * 60), 5, 250, 255});
  for (int v : coarse.faces.corners)
    coarse.corner_texcoords.push_back(
        {static_cast<float>(coarse.points[static_cast<std::size_t>(v)][0] - 500000), 0.5f});
  openmesh::write_mesh(folder.file("in.ply"), coarse);
  ASSERT_EQ(
      run_arete({"refine", folder.file("in.ply"), folder.file("out.ply"), "--scheme", "four-point"})
          .exit_code,
      0);
  const MeshData fine = openmesh::read_mesh(folder.file("out.ply"));
  ASSERT_EQ(fine.colors.size(), fine.points.size());
  for (std::size_t v = 0; v < fine.points.size(); ++v)
    EXPECT_EQ(fine.colors[v][0], std::lround((fine.points[v][0] - 500000.25) / 30 * 60));
  ASSERT_EQ(fine.texcoords.size(), fine.points.size()) << "without seams a vertex has one";
  for (std::size_t v = 0; v < fine.points.size(); ++v)
    EXPECT_NEAR(fine.texcoords[v][0], fine.points[v][0] - 500000, 1e-4);
  coarse.corner_texcoords[0] = {7, 7};
  openmesh::write_mesh(folder.file("seam.ply"), coarse);
  ASSERT_EQ(run_arete({"refine", folder.file("seam.ply"), folder.file("out.obj"), "--scheme",
                       "four-point"})
                .exit_code,
            0);
  const MeshData seam = openmesh::read_mesh(folder.file("out.obj"));
  EXPECT_EQ(seam.corner_texcoords.size(), seam.faces.corners.size());
  auto run = run_arete(
      {"refine", folder.file("seam.ply"), folder.file("out.vtp"), "--scheme", "four-point"});
  EXPECT_NE(run.out.find("note: texture coordinates with seams"), std::string::npos) << run.out;
  run = run_arete(
      {"refine", folder.file("in.ply"), folder.file("out.stl"), "--scheme", "four-point"});
  EXPECT_NE(run.out.find("note: an .stl has no colours"), std::string::npos) << run.out;
}

TEST(cli_refine_mesh, what_is_no_grid_is_named_and_nothing_is_written) {
  const test::TemporaryFolder folder;
  const test::Mesh holed = test::without_faces(test::terrain_mesh(5, 5), {5});
  openmesh::write_mesh(folder.file("holed.obj"), {holed.points, holed.faces});
  const auto refuse = [&](test::Arguments arguments, int code, const std::string& text) {
    const auto run = run_arete(arguments);
    EXPECT_EQ(run.exit_code, code) << run.err;
    EXPECT_NE(run.err.find(text), std::string::npos) << run.err;
    EXPECT_EQ(run.out, "");
  };
  const std::string in = folder.file("holed.obj");
  refuse({"refine", in, folder.file("o.ply"), "--scheme", "gentle"}, 1,
         "holed.obj: vertex 6 on the rim has 3 faces");
  refuse({"refine", in, folder.file("o.tif"), "--scheme", "gentle"}, 2, ".obj, .ply, .off, .stl");
  refuse({"refine", in, folder.file("o.ply"), "--scheme", "gentle", "--align", "cells"}, 2,
         "--align cells is for rasters");
  refuse({"refine", in, in, "--scheme", "gentle", "--overwrite"}, 1, "is the input itself");
  std::ofstream(folder.file("empty.obj")) << "# nothing\n";
  refuse({"refine", folder.file("empty.obj"), folder.file("o.ply"), "--scheme", "gentle"}, 1,
         "it holds no vertex");
  const test::Mesh grid = test::terrain_mesh(30, 30);
  openmesh::write_mesh(folder.file("grid.obj"), {grid.points, grid.faces});
  refuse({"refine", folder.file("grid.obj"), folder.file("o.ply"), "--scheme", "gentle", "--levels",
          "8", "--max-memory", "50M"},
         1, "a mesh of");
  refuse({"refine", folder.file("grid.obj"), folder.file("o.ply"), "--scheme", "gentle", "--levels",
          "14"},
         1, "use fewer levels");
  EXPECT_EQ(folder.entries(), 3);
}

TEST(cli_refine_mesh, a_vtp_holds_the_quads_with_normals) {
  const test::TemporaryFolder folder;
  openmesh::write_mesh(folder.file("in.obj"), utm_terrain(4, 5));
  ASSERT_EQ(
      run_arete({"refine", folder.file("in.obj"), folder.file("out.vtp"), "--scheme", "gentle"})
          .exit_code,
      0);
  std::ifstream stream(folder.file("out.vtp"), std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(stream), {}};
  EXPECT_NE(bytes.find("NumberOfPoints=\"63\""), std::string::npos);
  EXPECT_NE(bytes.find("NumberOfPolys=\"48\""), std::string::npos);
  EXPECT_NE(bytes.find("Name=\"Normals\""), std::string::npos);
}

TEST(cli_refine_mesh, a_raster_becomes_the_quads_between_its_refined_samples) {
  const test::TemporaryFolder folder;
  ASSERT_EQ(run_arete({"refine", dem, folder.file("fine.tif"), "--scheme", "gentle"}).exit_code, 0);
  const gdal::Raster raster(folder.file("fine.tif"));
  const Grid<double> heights = gdal::read_band<double>(raster, raster.bands().front());
  for (const char* name : {"out.obj", "out.ply", "out.off"}) {
    ASSERT_EQ(run_arete({"refine", dem, folder.file(name), "--scheme", "gentle"}).exit_code, 0);
    const MeshData mesh = openmesh::read_mesh(folder.file(name));
    ASSERT_EQ(mesh.points.size(), heights.samples().size());
    EXPECT_EQ(mesh.faces.count(), (heights.rows() - 1) * (heights.cols() - 1));
    EXPECT_EQ(mesh.faces[0].size(), 4u);
    for (std::size_t i = 0; i < mesh.points.size(); i += 97)
      EXPECT_NEAR(mesh.points[i][2], heights.samples()[i], 1e-4);
    // Metres: 3 arc seconds are 92.66 m from north to south, and faces look up.
    const auto a = mesh.points[0];
    const auto below = mesh.points[static_cast<std::size_t>(heights.cols())];
    EXPECT_NEAR(a[1] - below[1], 92.66 / 2, 0.1);
    const auto face = mesh.faces[0];
    const auto at = [&](std::size_t i) { return mesh.points[static_cast<std::size_t>(face[i])]; };
    EXPECT_GT((at(1)[0] - at(0)[0]) * (at(2)[1] - at(0)[1]) -
                  (at(1)[1] - at(0)[1]) * (at(2)[0] - at(0)[0]),
              0);
    const auto& t = mesh.texcoords.empty() ? mesh.corner_texcoords : mesh.texcoords;
    ASSERT_FALSE(t.empty()) << name;
    for (const auto& uv : t) {
      EXPECT_GT(uv[0], 0);
      EXPECT_LT(uv[1], 1);
    }
  }
  ASSERT_EQ(run_arete({"refine", dem, folder.file("out.stl"), "--scheme", "gentle"}).exit_code, 0);
  EXPECT_GT(std::filesystem::file_size(folder.file("out.stl")), 50u * 2 * 686 * 804);
}

// The largest vertical distance of a sample from the triangles, and the samples they hold, by a
// plain look at every sample of every triangle's bounding box. `full` has every sample as a point,
// in order.
std::pair<double, std::size_t> measured_plainly(const MeshData& mesh, const MeshData& full,
                                                Index cols) {
  std::map<std::pair<double, double>, Index> sample_at;
  for (std::size_t i = 0; i < full.points.size(); ++i)
    sample_at[{full.points[i][0], full.points[i][1]}] = static_cast<Index>(i);
  double largest = 0;
  std::set<Index> held;
  for (int f = 0; f < mesh.faces.count(); ++f) {
    std::array<double, 3> x{}, y{}, z{};
    for (std::size_t k = 0; k < 3; ++k) {
      const auto& p = mesh.points[static_cast<std::size_t>(mesh.faces[f][k])];
      const Index sample = sample_at.at({p[0], p[1]});
      x[k] = static_cast<double>(sample % cols);
      y[k] = static_cast<double>(sample / cols);
      z[k] = p[2];
    }
    const double area = (x[1] - x[0]) * (y[2] - y[0]) - (x[2] - x[0]) * (y[1] - y[0]);
    EXPECT_NE(area, 0);
    const auto [left, right] = std::minmax({x[0], x[1], x[2]});
    const auto [top, bottom] = std::minmax({y[0], y[1], y[2]});
    for (double r = top; r <= bottom; ++r) {
      for (double c = left; c <= right; ++c) {
        const double u = ((c - x[0]) * (y[2] - y[0]) - (x[2] - x[0]) * (r - y[0])) / area;
        const double v = ((x[1] - x[0]) * (r - y[0]) - (c - x[0]) * (y[1] - y[0])) / area;
        if (u < -1e-12 || v < -1e-12 || u + v > 1 + 1e-12) continue;
        const auto sample = static_cast<Index>(r) * cols + static_cast<Index>(c);
        held.insert(sample);
        largest = std::max(largest, std::abs(z[0] + u * (z[1] - z[0]) + v * (z[2] - z[0]) -
                                             full.points[static_cast<std::size_t>(sample)][2]));
      }
    }
  }
  return {largest, held.size()};
}

TEST(cli_refine_mesh, a_budget_of_triangles_is_kept_and_the_error_told_is_the_error) {
  const test::TemporaryFolder folder;
  const auto refine = [&](const std::string& name, const test::Arguments& more) {
    test::Arguments all{"refine", dem, folder.file(name), "--scheme", "gentle", "--json"};
    all.insert(all.end(), more.begin(), more.end());
    return run_json(all);
  };
  const auto whole = refine("full.ply", {});
  const MeshData full = openmesh::read_mesh(folder.file("full.ply"));
  const Index cols = whole.at("cols");
  double before = std::numeric_limits<double>::infinity();
  for (const Index most : {300, 3000, 30000}) {
    const std::string name = std::to_string(most) + ".ply";
    const auto report = refine(name, {"--max-triangles", std::to_string(most)}).at("mesh");
    const MeshData mesh = openmesh::read_mesh(folder.file(name));
    ASSERT_EQ(report.at("triangles"), mesh.faces.count());
    EXPECT_LE(mesh.faces.count(), most);
    EXPECT_GE(mesh.faces.count(), most - 1);
    const auto [largest, held] = measured_plainly(mesh, full, cols);
    EXPECT_NEAR(report.at("largest_error"), largest, 1e-3);  // float heights
    EXPECT_EQ(held, full.points.size()) << "the whole terrain is covered";
    EXPECT_EQ(report.at("left_out"), 0);
    EXPECT_LT(largest, before);
    before = largest;
    // Faces look up.
    const auto at = [&](std::size_t k) {
      return mesh.points[static_cast<std::size_t>(mesh.faces[0][k])];
    };
    EXPECT_GT((at(1)[0] - at(0)[0]) * (at(2)[1] - at(0)[1]) -
                  (at(1)[1] - at(0)[1]) * (at(2)[0] - at(0)[0]),
              0);
  }
  const auto enough = refine("enough.obj", {"--max-triangles", "10000000"}).at("mesh");
  EXPECT_EQ(enough.at("triangles"), 0);
  EXPECT_EQ(enough.at("quads"), full.faces.count());
  EXPECT_EQ(enough.at("largest_error"), 0);
}

TEST(cli_refine_mesh, a_budget_of_triangles_is_the_same_in_a_vtp) {
  const test::TemporaryFolder folder;
  const auto refine = [&](const std::string& name) {
    return run_json({"refine", dem, folder.file(name), "--scheme", "gentle", "--max-triangles",
                     "3000", "--json"})
        .at("mesh");
  };
  const auto mesh = refine("out.vtp");
  EXPECT_EQ(mesh, refine("out.ply"));
  std::ifstream stream(folder.file("out.vtp"), std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  const auto said = [&](const std::string& name) {
    return std::stoi(text.substr(text.find(name + "=\"") + name.size() + 2, 12));
  };
  EXPECT_EQ(said("NumberOfPoints"), mesh.at("vertices"));
  EXPECT_EQ(said("NumberOfPolys"), mesh.at("triangles"));
}

TEST(cli_refine_mesh, a_budget_of_triangles_is_seen_in_a_picture) {
  const test::TemporaryFolder folder;
  const auto mesh = run_json({"refine", dem, folder.file("out.png"), "--scheme", "gentle",
                              "--max-triangles", "500", "--json"})
                        .at("mesh");
  EXPECT_LE(mesh.at("triangles"), 500);
  const gdal::Raster picture(folder.file("out.png"));
  EXPECT_EQ(std::max(picture.extent().rows, picture.extent().cols), 1200);
  // White around, and on the map three quarters ground, the rest the ink of edges.
  const Grid<double> red = gdal::read_band<double>(picture, picture.bands().front());
  EXPECT_EQ(red(2, 2), 255);
  Index ink = 0;
  for (const double value : red.samples()) ink += value < 90 ? 1 : 0;
  const double share = static_cast<double>(ink) / static_cast<double>(red.samples().size());
  EXPECT_GT(share, 0.005);
  EXPECT_LT(share, 0.25);
  expect_error(test::Arguments{"refine", dem, folder.file("o.png"), "--scheme", "gentle"}, 2,
               "--max-triangles");
}

TEST(cli_refine_mesh, detail_is_told_alike_whatever_is_written) {
  const test::TemporaryFolder folder;
  const std::string part = folder.file("part.tif");
  const std::string cut = "gdal_translate -q -srcwin 100 100 70 60 " + dem + " " + part;
  ASSERT_EQ(std::system(cut.c_str()), 0);
  const auto slopes = [&](const std::string& name, const std::string& levels,
                          const test::Arguments& more = {}) {
    test::Arguments all{"refine",   part,     folder.file(name), "--scheme", "four-point",
                        "--levels", levels,   "--detail",        "0.7",      "--type",
                        "float32",  "--json", "--overwrite"};
    all.insert(all.end(), more.begin(), more.end());
    return run_json(all).at("detail").at("spectral_slope");
  };
  const auto expected = slopes("out.tif", "3");
  for (const char* name :
       {"out.vti", "out.vts", "out.vtp", "out.glb", "out.obj", "out.ply", "out.off", "out.stl"}) {
    const auto told = slopes(name, "3");
    for (const char* when : {"before", "after"})
      EXPECT_NEAR(told.at(when), expected.at(when).get<double>(), 1e-6) << name << " " << when;
  }
  EXPECT_EQ(slopes("few.vtp", "3", {"--max-triangles", "1000"}), slopes("few.ply", "3"));
  // Two levels make no octave between the first and the last.
  EXPECT_TRUE(slopes("out.tif", "2").at("after").is_null());
}

TEST(cli_refine_mesh, detail_upon_terrain_is_as_rough_as_asked) {
  const test::TemporaryFolder folder;
  for (const double roughness : {0.3, 0.6, 0.9})
    for (const char* seed : {"1", "2"}) {
      const double slope =
          run_json({"refine", dem, folder.file("out.tif"), "--scheme", "four-point", "--levels",
                    "4", "--detail", std::to_string(roughness), "--seed", seed, "--json",
                    "--overwrite", "--creation-option", "COMPRESS=NONE"})
              .at("detail")
              .at("spectral_slope")
              .at("after");
      EXPECT_NEAR(slope, -(2 * roughness + 1), 0.1) << "seed " << seed;
    }
}

TEST(cli_refine_mesh, a_budget_of_triangles_is_refused_where_it_makes_no_sense) {
  const test::TemporaryFolder folder;
  const auto refine = [&](const std::string& in, const std::string& out, const std::string& most) {
    return test::Arguments{"refine",          in,  folder.file(out), "--scheme", "gentle",
                           "--max-triangles", most};
  };
  expect_error(refine(dem, "out.tif", "100"), 2, "--max-triangles is for meshes");
  expect_error(refine(dem, "out.vti", "100"), 2, "--max-triangles is for meshes");
  expect_error(refine(dem, "out.glb", "100"), 2, "--max-triangles is for meshes");
  expect_error(refine(dem, "out.obj", "1"), 2, "--max-triangles");
  openmesh::write_mesh(folder.file("in.obj"), utm_terrain(4, 5));
  expect_error(refine(folder.file("in.obj"), "out.obj", "100"), 2, "keeps all its quads");
  std::ofstream(folder.file("row.asc"))
      << "ncols 5\nnrows 1\nxllcorner 0\nyllcorner 0\ncellsize 1\n1 2 3 2 1\n";
  expect_error(refine(folder.file("row.asc"), "out.png", "100"), 1, "there is no triangle to draw");
  EXPECT_FALSE(std::filesystem::exists(folder.file("out.png")));
}

}  // namespace
}  // namespace arete
