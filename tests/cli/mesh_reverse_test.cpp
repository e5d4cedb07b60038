// SPDX-License-Identifier: MIT
// arete coarsen and restore on meshes, by the real program.
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "reverse/meshes.h"
#include "run_program.h"
#include "support/temporary_folder.h"

namespace arete {
namespace {

using test::Arguments;
using test::run_arete;
using test::run_json;

std::string text_of(const std::string& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

// A control mesh refined by the rule, as an OBJ.
void write_fine(const std::string& path, MeshRule rule, MeshFaces faces, int levels) {
  Grid<double> positions = test::random_positions(faces.vertices, 5);
  for (int level = 0; level < levels; ++level) {
    auto step = mesh_step<double>(faces, rule);
    positions = test::subdivided_positions(step, positions);
    faces = std::move(step.fine);
  }
  std::ofstream stream(path);
  stream.precision(17);
  for (Index v = 0; v < faces.vertices; ++v)
    stream << "v " << positions(v, 0) << ' ' << positions(v, 1) << ' ' << positions(v, 2) << '\n';
  for (const auto& face : faces.faces) {
    stream << 'f';
    for (const Index v : face) stream << ' ' << v + 1;
    stream << '\n';
  }
}

// All numbers of the vertices and faces of an OBJ, in order.
std::vector<double> numbers_of(const std::string& path) {
  std::vector<double> numbers;
  std::ifstream stream(path);
  for (std::string line; std::getline(stream, line);) {
    std::istringstream words(line);
    std::string kind;
    words >> kind;
    if (kind != "v" && kind != "f") continue;
    for (double number = 0; words >> number;) numbers.push_back(number);
  }
  return numbers;
}

struct Files {
  explicit Files(const test::TemporaryFolder& folder)
      : fine(folder.file("fine.obj")),
        coarse(folder.file("coarse.obj")),
        details(folder.file("mesh.ard")),
        back(folder.file("back.obj")) {}
  std::string fine, coarse, details, back;

  [[nodiscard]] Arguments coarsening(const Arguments& more) const {
    Arguments all{"coarsen", fine, coarse, "--details", details, "--overwrite"};
    all.insert(all.end(), more.begin(), more.end());
    return all;
  }
  [[nodiscard]] Arguments restoring(const Arguments& more = {}) const {
    Arguments all{"restore", coarse, back, "--details", details, "--overwrite"};
    all.insert(all.end(), more.begin(), more.end());
    return all;
  }
};

Arguments with_json(Arguments all) {
  all.emplace_back("--json");
  return all;
}

TEST(cli_mesh_reverse, a_subdivided_mesh_becomes_its_control_mesh_and_comes_back) {
  const test::TemporaryFolder folder;
  const Files files(folder);
  for (const MeshRule rule : {MeshRule(MeshScheme::catmull_clark),
                              {MeshScheme::catmull_clark, MeshRim::sharp_corners},
                              MeshRule(MeshScheme::loop),
                              MeshRule(MeshScheme::loop_warren),
                              MeshRule(MeshScheme::doo_sabin)}) {
    const MeshFaces control = rule.scheme == MeshScheme::doo_sabin
                                  ? test::prism(5)
                                  : test::open_grid(4, 5, rule.triangles());
    write_fine(files.fine, rule, control, 2);
    const std::string scheme(to_string(rule.scheme));
    for (const char* mode : {"local", "least-squares"}) {
      const auto report = run_json(
          with_json(files.coarsening({"--scheme", scheme, "--levels", "2", "--mode", mode})));
      EXPECT_EQ(report.at("coarse_vertices"), control.vertices) << scheme;
      EXPECT_EQ(report.at("coarse_faces"), control.faces.size());
      EXPECT_EQ(report.at("rim"), std::string(to_string(rule.rim))) << scheme;
      EXPECT_LE(report.at("largest_detail"), 1e-11) << scheme;
      EXPECT_EQ(report.at("max_error"), 0) << scheme;
      const auto restored = run_json(with_json(files.restoring()));
      EXPECT_EQ(restored.at("levels"), 2);
      // The same numbers in the same order; another program wrote the first file.
      ASSERT_EQ(run_json(with_json(files.restoring({"--levels", "1"}))).at("of_levels"), 2);
      ASSERT_EQ(run_arete(files.restoring()).exit_code, 0);
      EXPECT_EQ(numbers_of(files.back), numbers_of(files.fine)) << scheme << ' ' << mode;
    }
  }
}

TEST(cli_mesh_reverse, a_grid_goes_through_any_scheme_of_the_catalogue) {
  const test::TemporaryFolder folder;
  const Files files(folder);
  const std::string control = folder.file("control.obj");
  write_fine(control, MeshScheme::catmull_clark, test::open_grid(5, 6, false), 0);
  for (const char* scheme : {"four-point", "chaikin", "ternary-two-step"}) {
    ASSERT_EQ(run_arete({"refine", control, files.fine, "--scheme", scheme, "--levels", "1",
                         "--overwrite"})
                  .exit_code,
              0);
    const auto report = run_json(with_json(files.coarsening({"--scheme", scheme})));
    EXPECT_EQ(report.at("boundary"), "extrapolate,extrapolate");
    EXPECT_EQ(report.at("coarse_vertices"), 30) << scheme;
    EXPECT_LE(report.at("largest_detail"), 1e-10) << scheme;
    EXPECT_EQ(report.at("max_error"), 0) << scheme;
    ASSERT_EQ(run_arete(files.restoring()).exit_code, 0);
    EXPECT_EQ(numbers_of(files.back), numbers_of(files.fine)) << scheme;
  }
  write_fine(files.fine, MeshScheme::doo_sabin, test::prism(5), 1);
  const auto refused = run_arete(files.coarsening({"--scheme", "chaikin"}));
  EXPECT_NE(refused.exit_code, 0);
  EXPECT_NE(refused.err.find("one regular grid of quads"), std::string::npos) << refused.err;
  for (const Arguments& misuse : {Arguments{"--scheme", "chaikin", "--rim", "thirds"},
                                  Arguments{"--scheme", "loop", "--boundary", "clamp"},
                                  Arguments{"--scheme", "no-such-scheme"}})
    EXPECT_EQ(run_arete(files.coarsening(misuse)).exit_code, 2);
}

TEST(cli_mesh_reverse, a_threshold_thins_and_says_what_it_costs) {
  const test::TemporaryFolder folder;
  const Files files(folder);
  write_fine(files.fine, MeshScheme::loop, test::torus(6, 6, true), 1);
  // Not what Warren's weights would have made, where the valence is 6: it is.
  const auto all =
      run_json(with_json(files.coarsening({"--scheme", "catmull-clark", "--levels", "0"})));
  EXPECT_EQ(all.at("details_all"), 0);
  const auto thinned =
      run_json(with_json(files.coarsening({"--scheme", "loop-warren", "--threshold", "1e-6"})));
  EXPECT_EQ(thinned.at("details_kept"), 0);
  EXPECT_LE(thinned.at("max_error"), 1e-6);
  EXPECT_EQ(run_json(with_json(files.restoring())).at("lossy"), true);
  const auto target =
      run_json(with_json(files.coarsening({"--scheme", "loop", "--target-rmse", "0.001"})));
  EXPECT_LE(target.at("rmse"), 0.001);
}

TEST(cli_mesh_reverse, what_is_wrong_is_named_and_nothing_is_written) {
  const test::TemporaryFolder folder;
  const Files files(folder);
  write_fine(files.fine, MeshScheme::catmull_clark, test::prism(5), 1);
  const auto complaint = [&](const Arguments& arguments, int code) {
    const auto run = run_arete(arguments);
    EXPECT_EQ(run.exit_code, code) << run.err;
    EXPECT_EQ(run.err.rfind("arete: ", 0), 0U) << run.err;
    return run.err;
  };
  const auto holds = [](const std::string& text, const std::string& part) {
    EXPECT_NE(text.find(part), std::string::npos) << text;
  };
  holds(complaint(files.coarsening({"--scheme", "loop"}), 1), "fine.obj: the mesh does not have");
  holds(complaint(files.coarsening({"--scheme", "gentle"}), 1), "one regular grid of quads");
  holds(complaint(files.coarsening({"--scheme", "loop", "--rim", "x"}), 2), "--rim x");
  holds(complaint(files.coarsening({"--scheme", "loop", "--type", "float32"}), 2),
        "--type is for rasters");
  holds(complaint(files.coarsening({"--scheme", "catmull-clark", "--levels", "2"}), 1),
        "only 1 of 2 levels");
  holds(complaint({"coarsen", files.fine, folder.file("a.tif"), "--scheme", "loop"}, 2), ".obj");
  EXPECT_EQ(folder.entries(), 1);

  ASSERT_EQ(run_arete(files.coarsening({"--scheme", "catmull-clark"})).exit_code, 0);
  holds(complaint(files.restoring({"--levels", "2"}), 2), "holds 1");
  holds(complaint(files.restoring({"--type", "float32"}), 2), "--type is for rasters");
  holds(complaint({"restore", files.fine, files.back, "--details", files.details}, 1),
        "not the one");
  // STL rounds to float32: the details would not fit.
  holds(complaint({"coarsen", files.fine, folder.file("a.stl"), "--scheme", "catmull-clark",
                   "--details", folder.file("b.ard")},
                  1),
        "cannot hold");
  EXPECT_EQ(folder.entries(), 3);
  // A changed byte of the details.
  std::string bytes = text_of(files.details);
  bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] ^ 1);
  std::ofstream(files.details, std::ios::binary) << bytes;
  holds(complaint(files.restoring(), 1), "checksum");
  EXPECT_EQ(folder.entries(), 3);
}

TEST(cli_mesh_reverse, a_cube_is_said_to_be_ambiguous) {
  const test::TemporaryFolder folder;
  const Files files(folder);
  write_fine(files.fine, MeshScheme::catmull_clark, test::prism(4), 1);
  const auto run = run_arete(files.coarsening({"--scheme", "catmull-clark"}));
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_NE(run.out.find("does not determine"), std::string::npos) << run.out;
}

}  // namespace
}  // namespace arete
