// SPDX-License-Identifier: GPL-3.0-or-later
// Filters that make a new layer, inside the distribution's own MeshLab library.
#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "meshlab/host.h"

namespace arete::meshlab::test {
namespace {

const MeshForm wild{MeshForm::Diagonals::random, true, true};

// The mesh that is current after a filter has made a layer.
MeshModel& layer_of(Document& document) { return *document.document().mm(); }

TEST(layer, coarsening_makes_a_current_layer_and_leaves_the_old_one) {
  Document document(grid_mesh({9, 13}, wild).arrays);
  document.cm().Tr.SetTranslate(1, 2, 3);
  const std::string before = document.fingerprint();
  const auto result = document.apply(coarsen_filter, {{"Levels", 2}});
  ASSERT_TRUE(result.ok) << result.error;
  EXPECT_GT(result.progress_calls, 3);
  EXPECT_EQ(document.document().meshList.size(), 2);
  MeshModel& layer = layer_of(document);
  EXPECT_NE(&layer, &document.mesh());
  EXPECT_EQ(layer.label().toStdString(), "Coarse terrain");
  EXPECT_EQ(layer.cm.vn, 3 * 4);
  EXPECT_EQ(layer.cm.fn, 2 * 2 * 3);
  EXPECT_TRUE(layer.hasDataMask(MeshModel::MM_POLYGONAL));
  EXPECT_TRUE(layer.cm.Tr == document.cm().Tr);
  EXPECT_EQ(document.fingerprint(), before);
  EXPECT_FALSE(document.mesh().hasDataMask(MeshModel::MM_VERTQUALITY));
  for (const CFaceO& f : layer.cm.face) {
    EXPECT_EQ(int(f.IsF(0)) + int(f.IsF(1)) + int(f.IsF(2)), 1);
    EXPECT_GT(f.cN()[2], 0);
  }
}

TEST(layer, coarsening_undoes_the_subdivision_filter) {
  const GridMesh mesh = grid_mesh({5, 6}, wild);
  for (int scheme = 0; scheme < 16; ++scheme) {
    Document document(mesh.arrays);
    std::map<std::pair<long, long>, float> old;
    const auto key = [](const Point3m& p) {
      return std::pair(std::lround(100 * p[0]), std::lround(100 * p[1]));
    };
    for (const CVertexO& v : document.cm().vert) old[key(v.cP())] = v.cP()[2];
    ASSERT_TRUE(document.apply(subdivide_filter, {{"Levels", 1}, {"Scheme", scheme}}).ok);
    const auto result = document.apply(coarsen_filter, {{"Levels", 1}, {"Scheme", scheme}});
    ASSERT_TRUE(result.ok) << scheme << ' ' << result.error;
    MeshModel& layer = layer_of(document);
    ASSERT_EQ(layer.cm.vn, int(old.size())) << scheme;
    for (const CVertexO& v : layer.cm.vert) {
      ASSERT_EQ(old.count(key(v.cP())), 1u) << scheme;
      EXPECT_NEAR(v.cP()[2], old[key(v.cP())], 0.01) << scheme;
    }
  }
}

TEST(layer, coarsening_runs_with_every_choice_or_says_why_not) {
  int done = 0;
  for (int scheme = 0; scheme < 16; ++scheme)
    for (int choice = 0; choice < 24; ++choice) {
      Document document(grid_mesh({19, 20}, wild).arrays);
      const std::string before = document.fingerprint();
      const auto result = document.apply(coarsen_filter, {{"Scheme", scheme},
                                                          {"Boundary", choice % 3},
                                                          {"Coordinates", choice / 3 % 2},
                                                          {"Mode", choice / 6 % 2},
                                                          {"KeepQuads", choice / 12}});
      EXPECT_EQ(document.fingerprint(), before);
      if (!result.ok) {
        EXPECT_FALSE(result.error.empty());
        EXPECT_EQ(document.document().meshList.size(), 1);
        continue;
      }
      ++done;
      EXPECT_EQ(layer_of(document).hasDataMask(MeshModel::MM_POLYGONAL), choice / 12 == 1);
      for (const CVertexO& v : layer_of(document).cm.vert)
        for (int k = 0; k < 3; ++k) EXPECT_TRUE(std::isfinite(v.cP()[k]));
    }
  EXPECT_GE(done, 16 * 12) << "least squares serves every scheme";
}

TEST(layer, details_go_to_the_quality_of_the_old_layer_on_request) {
  Document document(grid_mesh({9, 9}, wild).arrays);
  std::vector<float> z;
  for (const CVertexO& v : document.cm().vert) z.push_back(v.cP()[2]);
  ASSERT_TRUE(document.apply(coarsen_filter, {{"DetailsToQuality", 1}}).ok);
  EXPECT_TRUE(document.mesh().hasDataMask(MeshModel::MM_VERTQUALITY));
  EXPECT_FALSE(layer_of(document).hasDataMask(MeshModel::MM_VERTQUALITY));
  // The coarse layer refined again, plus the details, is the old terrain.
  ASSERT_TRUE(document.apply(subdivide_filter, {{"Levels", 1}}).ok);
  std::map<std::pair<float, float>, float> again;
  for (const CVertexO& v : layer_of(document).cm.vert) again[{v.cP()[0], v.cP()[1]}] = v.cP()[2];
  bool any = false;
  for (std::size_t i = 0; i < z.size(); ++i) {
    const CVertexO& v = document.cm().vert[i];
    ASSERT_EQ(again.count({v.cP()[0], v.cP()[1]}), 1u);
    EXPECT_NEAR(again.at({v.cP()[0], v.cP()[1]}) + v.cQ(), z[i], 1e-3);
    any = any || std::abs(v.cQ()) > 1;
  }
  EXPECT_TRUE(any);
}

TEST(layer, attributes_and_textures_are_taken_over) {
  Document document(grid_mesh({9, 9}, wild).arrays);
  document.mesh().updateDataMask(MeshModel::MM_VERTCOLOR | MeshModel::MM_VERTTEXCOORD |
                                 MeshModel::MM_FACECOLOR | MeshModel::MM_WEDGTEXCOORD);
  document.cm().textures = {"sheet.png"};
  for (CVertexO& v : document.cm().vert) {
    v.C() = vcg::Color4b(static_cast<unsigned char>(v.cP()[0]), 9, 8, 255);
    v.T().U() = v.cP()[0] / 100;
    v.T().V() = v.cP()[1] / 100;
  }
  for (CFaceO& f : document.cm().face) {
    const bool east = f.cP(0)[0] + f.cP(1)[0] + f.cP(2)[0] > 120;
    f.C() = east ? vcg::Color4b::Red : vcg::Color4b::Blue;
    for (int k = 0; k < 3; ++k) f.WT(k).U() = f.cP(k)[0] / 50;
  }
  ASSERT_TRUE(document.apply(coarsen_filter, {}, "four-point").ok);
  MeshModel& layer = layer_of(document);
  EXPECT_EQ(layer.cm.textures, document.cm().textures);
  for (const CVertexO& v : layer.cm.vert) {
    EXPECT_NEAR(v.cC()[0], v.cP()[0], 1);
    EXPECT_EQ(v.cC()[1], 9);
    EXPECT_NEAR(v.cT().U(), v.cP()[0] / 100, 1e-6);
    EXPECT_NEAR(v.cT().V(), v.cP()[1] / 100, 1e-6);
  }
  for (const CFaceO& f : layer.cm.face) {
    const bool east = f.cP(0)[0] + f.cP(1)[0] + f.cP(2)[0] > 120;
    EXPECT_EQ(f.cC(), vcg::Color4b(east ? vcg::Color4b::Red : vcg::Color4b::Blue));
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(f.cWT(k).U(), f.cP(k)[0] / 50, 1e-6);
  }
}

TEST(layer, a_refusal_leaves_no_layer) {
  Document document(grid_mesh({3, 9}).arrays);
  const std::string before = document.fingerprint();
  const auto result = document.apply(coarsen_filter, {{"Levels", 3}, {"DetailsToQuality", 1}});
  EXPECT_FALSE(result.ok);
  EXPECT_NE(result.error.find("fewer levels"), std::string::npos) << result.error;
  EXPECT_EQ(document.document().meshList.size(), 1);
  EXPECT_EQ(document.document().mm(), &document.mesh());
  EXPECT_EQ(document.fingerprint(), before);
}

#ifdef ARETE_MESHLAB_WITH_CGAL
MeshArrays scattered_points() {
  MeshArrays points;
  points.positions = {{0, 0, 0}, {90, 0, 0}, {0, 60, 0}, {90, 60, 0}};
  for (int i = 0; i < 300; ++i)  // a lattice of irrational steps: no two points on one line
    points.positions.push_back(
        {90 * std::fmod(0.618034 * i, 1.0), 60 * std::fmod(0.754878 * i, 1.0), 0});
  for (Point3& p : points.positions) p[2] = 5 + p[0] / 3 - p[1] / 5;
  return points;
}

TEST(layer, a_terrain_from_points_can_be_subdivided_at_once) {
  Document document(scattered_points());
  document.cm().Tr.SetTranslate(1, 2, 3);
  document.mesh().updateDataMask(MeshModel::MM_VERTCOLOR | MeshModel::MM_VERTQUALITY);
  for (CVertexO& v : document.cm().vert) {
    v.C() = vcg::Color4b(static_cast<unsigned char>(v.cP()[0]), 9, 8, 255);
    v.Q() = 2 * v.cP()[1];
  }
  const std::string before = document.fingerprint();
  QStringList missing;
  EXPECT_TRUE(Host::instance().plugin().isFilterApplicable(&Host::instance().action(points_filter),
                                                           document.mesh(), missing));
  const auto result = document.apply(points_filter, {{"Spacing", 10}});
  ASSERT_TRUE(result.ok) << result.error;
  EXPECT_EQ(document.fingerprint(), before);
  EXPECT_EQ(layer_of(document).label().toStdString(), "Terrain from points");
  EXPECT_EQ(layer_of(document).cm.vn, 10 * 7);
  EXPECT_TRUE(layer_of(document).cm.Tr == document.cm().Tr);
  ASSERT_TRUE(document.apply(subdivide_filter, {{"Levels", 1}}, "b-spline:degree=3").ok);
  EXPECT_EQ(document.document().meshList.size(), 2);
  EXPECT_EQ(layer_of(document).cm.vn, 19 * 13);
  for (const CVertexO& v : layer_of(document).cm.vert) {
    EXPECT_NEAR(v.cP()[2], 5 + v.cP()[0] / 3 - v.cP()[1] / 5, 1e-4);
    EXPECT_NEAR(v.cC()[0], v.cP()[0], 1.01);
    EXPECT_NEAR(v.cQ(), 2 * v.cP()[1], 1e-3);
    EXPECT_GT(v.cN()[2], 0);
  }
}

TEST(layer, a_terrain_from_points_runs_with_every_choice) {
  for (bool faces : {false, true})
    for (int choice = 0; choice < 24; ++choice) {
      Document document(faces ? grid_mesh({6, 9}, wild).arrays : scattered_points());
      const std::string before = document.fingerprint();
      const int method = choice % 4;
      const auto result = document.apply(points_filter, {{"Spacing", 7},
                                                         {"Method", method},
                                                         {"Outside", choice / 4 % 3},
                                                         {"DropOutliers", method < 3 ? 50 : 0},
                                                         {"KeepQuads", choice / 12}});
      EXPECT_EQ(document.fingerprint(), before);
      EXPECT_EQ(result.ok, faces || method != 3) << result.error;
      EXPECT_EQ(document.document().meshList.size(), result.ok ? 2 : 1);
      if (!result.ok) continue;
      EXPECT_GT(layer_of(document).cm.vn, 20);
      EXPECT_EQ(layer_of(document).hasDataMask(MeshModel::MM_POLYGONAL), choice / 12 == 1);
      for (const CVertexO& v : layer_of(document).cm.vert) EXPECT_TRUE(std::isfinite(v.cP()[2]));
    }
}

TEST(layer, the_points_dialog_suits_the_mesh) {
  Document points(scattered_points()), mesh(grid_mesh({6, 9}).arrays), empty;
  EXPECT_NEAR(points.dialog(points_filter).getAbsPerc("Spacing"), std::sqrt(90 * 60 / 304.0), 1e-3);
  EXPECT_EQ(points.dialog(points_filter).getEnum("Method"), 1);
  EXPECT_EQ(mesh.dialog(points_filter).getEnum("Method"), 3);
  const RichParameterList dialog = mesh.dialog(points_filter);
  const auto& spacing = dynamic_cast<const RichAbsPerc&>(dialog.getParameterByName("Spacing"));
  EXPECT_NEAR(spacing.max, mesh.cm().bbox.Diag(), 1e-3);
  EXPECT_GT(empty.dialog(points_filter).getAbsPerc("Spacing"), 0);
}

TEST(layer, points_that_make_no_terrain_are_refused) {
  const auto refusal = [](const MeshArrays& arrays, const std::map<std::string, double>& numbers) {
    Document document(arrays);
    const std::string before = document.fingerprint();
    const auto result = document.apply(points_filter, numbers);
    EXPECT_FALSE(result.ok);
    EXPECT_FALSE(result.log.empty());
    EXPECT_EQ(document.fingerprint(), before);
    EXPECT_EQ(document.document().meshList.size(), 1);
    return result.error;
  };
  const auto says = [](const std::string& text, const char* part) {
    EXPECT_NE(text.find(part), std::string::npos) << text;
  };
  says(refusal({}, {}), "empty");
  MeshArrays line;
  for (int i = 0; i < 9; ++i) line.positions.push_back({double(i), 3, 1});
  says(refusal(line, {}), "line");
  says(refusal(scattered_points(), {{"Spacing", 0}}), "Spacing");
  says(refusal(scattered_points(), {{"Spacing", -1}}), "Spacing");
  says(refusal(scattered_points(), {{"Spacing", 80}}), "choose at most 60");
  says(refusal(scattered_points(), {{"Spacing", 1e-4}}), "larger");
  says(refusal(scattered_points(), {{"DropOutliers", -1}}), "DropOutliers");
}
#endif

}  // namespace
}  // namespace arete::meshlab::test
