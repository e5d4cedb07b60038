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

}  // namespace
}  // namespace arete::meshlab::test
