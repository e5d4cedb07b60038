// SPDX-License-Identifier: MIT
// The records about meshes: exactly over rationals, to 1e-12 in double.
#include <gtest/gtest.h>

#include <set>

#include "arete/algebra/linear_solve.h"
#include "arete/reverse/mesh_recover.h"
#include "meshes.h"
#include "rational_grid.h"

namespace arete {
namespace {

using nlohmann::json;
using test::exact_grid;
using test::expect_exact;
using test::expect_near;
using test::mesh_of;

std::multiset<std::vector<Index>> turned_faces(const MeshFaces& mesh) {
  std::multiset<std::vector<Index>> faces;
  for (auto face : mesh.faces) {
    std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
    faces.insert(face);
  }
  return faces;
}

void check_forward(const json& record, MeshScheme scheme) {
  const std::string id = record.at("id");
  const MeshFaces coarse = mesh_of(record.at("input").at("faces"));
  const Grid<Rational> vertices = exact_grid(record.at("input").at("vertices"));
  const auto step = mesh_step<Rational>(coarse, scheme);
  const Grid<Rational> fine = test::subdivided_positions(step, vertices);
  expect_exact(fine, exact_grid(record.at("expect").at("fine")), id);
  EXPECT_EQ(turned_faces(step.fine), turned_faces(mesh_of(record.at("expect").at("fine_faces"))))
      << id;
  expect_near(
      test::subdivided_positions(mesh_step<double>(coarse, scheme), test::to_double(vertices)),
      exact_grid(record.at("expect").at("fine")), id);
  // And back: positions exactly, connectivity up to the numbering.
  for (const ReverseMode mode : {ReverseMode::local, ReverseMode::least_squares}) {
    const bool unique = invisible_patterns(coarse, scheme).empty();
    const auto back = reverse_mesh_step<Rational>(coarse, scheme, fine.view(), mode);
    EXPECT_EQ(back.unique, unique) << id;
    expect_exact(back.positions, vertices, id);
    const auto parts = decompose_mesh<Rational>(step.fine, fine.view(), scheme, mode);
    for (const Rational& detail : parts.details.samples()) EXPECT_EQ(detail, 0) << id;
    expect_exact(reconstruct_mesh(parts), fine, id);
    if (scheme == MeshScheme::doo_sabin) continue;  // its coarse vertices are numbered by faces
    expect_exact(parts.coarse, vertices, id);
    EXPECT_EQ(turned_faces(parts.mesh.coarse), turned_faces(coarse)) << id;
  }
}

TEST(mesh_oracle, catmull_clark) {
  for (const json& record : test::ternary_and_reverse_records("r.cc"))
    check_forward(record, MeshScheme::catmull_clark);
}
TEST(mesh_oracle, loop) {
  for (const json& record : test::ternary_and_reverse_records("r.loop"))
    check_forward(record, MeshScheme::loop_warren);
}
TEST(mesh_oracle, doo_sabin) {
  for (const json& record : test::ternary_and_reverse_records("r.doo_sabin"))
    check_forward(record, MeshScheme::doo_sabin);
}

void check_reverse(const json& record, MeshScheme scheme, const char* local_key) {
  const std::string id = record.at("id");
  const MeshFaces coarse = mesh_of(record.at("input").at("coarse_faces"));
  const Grid<Rational> fine = exact_grid(record.at("input").at("fine"));
  const Grid<double> rounded = test::to_double(fine);
  for (const auto& [mode, key] :
       {std::pair{ReverseMode::local, local_key}, {ReverseMode::least_squares, "coarse_ls"}}) {
    const Grid<Rational> expected = exact_grid(record.at("expect").at(key));
    const auto exact = reverse_mesh_step<Rational>(coarse, scheme, fine.view(), mode);
    expect_near(reverse_mesh_step<double>(coarse, scheme, rounded.view(), mode).positions,
                exact.positions, id);
    // The cube's even relatives apart, both answers are the only ones.
    if (exact.unique) expect_exact(exact.positions, expected, id + " " + key);
  }
}

TEST(mesh_oracle, catmull_clark_reverse_of_any_data) {
  for (const json& record : test::ternary_and_reverse_records("r.cc_reverse"))
    check_reverse(record, MeshScheme::catmull_clark, "coarse_local");
}
TEST(mesh_oracle, loop_reverse_of_any_data) {
  for (const json& record : test::ternary_and_reverse_records("r.loop_reverse"))
    check_reverse(record, MeshScheme::loop_warren, "coarse_local");
}
TEST(mesh_oracle, doo_sabin_reverse_of_any_data) {
  for (const json& record : test::ternary_and_reverse_records("r.doo_sabin_reverse"))
    check_reverse(record, MeshScheme::doo_sabin, "coarse_average");
}

TEST(mesh_oracle, where_catmull_clark_is_reversible) {
  for (const json& record : test::ternary_and_reverse_records("r.cc_rank")) {
    const std::string id = record.at("id");
    const MeshFaces coarse = mesh_of(record.at("input").at("faces"));
    const auto step = mesh_step<Rational>(coarse, MeshScheme::catmull_clark);
    Matrix<Rational> dense(static_cast<int>(step.s.rows()), static_cast<int>(step.s.cols()));
    for (Index i = 0; i < step.s.rows(); ++i)
      for (const auto& entry : step.s.row(i))
        dense(static_cast<int>(i), static_cast<int>(entry.col)) = entry.weight;
    EXPECT_EQ(exact_rank(dense), record.at("expect").at("rank").get<int>()) << id;
    const auto patterns = invisible_patterns(coarse, MeshScheme::catmull_clark);
    EXPECT_EQ(patterns.empty(), record.at("expect").at("reversible").get<bool>()) << id;
    const json& kernel = record.at("expect").at("kernel");
    ASSERT_EQ(patterns.size(), kernel.size()) << id;
    for (std::size_t i = 0; i < patterns.size(); ++i)
      EXPECT_EQ(std::vector<Rational>(patterns[i].begin(), patterns[i].end()),
                test::exact_list(kernel[i]))
          << id;
  }
}

TEST(mesh_oracle, weights_by_valence) {
  for (const json& record : test::ternary_and_reverse_records("r.reverse_weights")) {
    const Index n = record.at("input").at("valence");
    const json& expect = record.at("expect");
    const auto check = [&](const char* key, const Rational& value) {
      if (!expect.contains(key) || expect.at(key).is_null()) return;
      EXPECT_EQ(value, test::exact(expect.at(key))) << key << " at valence " << n;
    };
    if (n != 3) {
      const auto cc = catmull_clark_reverse<Rational>(n);
      check("cc_vertex", cc.vertex);
      check("cc_edge", cc.edge);
      check("cc_face", cc.face);
    }
    const auto warren = loop_reverse<Rational>(n, loop_beta<Rational>(MeshScheme::loop_warren, n));
    check("loop_warren_vertex", warren.vertex);
    check("loop_warren_edge", warren.edge);
    if (expect.contains("loop_vertex")) {
      const auto own = loop_reverse<Rational>(n, loop_beta<Rational>(MeshScheme::loop, n));
      check("loop_vertex", own.vertex);
      check("loop_edge", own.edge);
    }
    if (expect.contains("doo_sabin_face_inverse")) {
      const auto inverse = test::exact_list(expect.at("doo_sabin_face_inverse"));
      for (Index k = 0; k < n; ++k)
        EXPECT_EQ(doo_sabin_inverse<Rational>(k, n), inverse[static_cast<std::size_t>(k)]);
    }
  }
}

}  // namespace
}  // namespace arete
