// SPDX-License-Identifier: GPL-3.0-or-later
// The plugin inside the distribution's own MeshLab library, without windows.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <set>

#include "arete/refine/refiner.h"
#include "arete/scheme/catalogue.h"
#include "meshlab/host.h"
#include "support/temporary_folder.h"

namespace arete::meshlab::test {
namespace {

using vcg::tri::Allocator;

std::vector<MeshForm> forms() {
  return {{MeshForm::Diagonals::main, false, false},
          {MeshForm::Diagonals::random, false, true},
          {MeshForm::Diagonals::random, true, true},
          {MeshForm::Diagonals::alternating, true, false, true}};
}

TEST(plugin, shows_itself_as_meshlab_wants_it) {
  Host& host = Host::instance();
#ifdef ARETE_MESHLAB_WITH_CGAL
  EXPECT_EQ(host.plugin().actions().size(), 5);
#else
  EXPECT_EQ(host.plugin().actions().size(), 4);
#endif
  for (QAction* action : host.plugin().actions()) {
    EXPECT_EQ(action->parent(), dynamic_cast<QObject*>(&host.plugin()));
    EXPECT_EQ(action->text(), host.plugin().filterName(action));
    EXPECT_NE(host.plugin().getClass(action), MeshFilterInterface::Generic);
    EXPECT_EQ(host.plugin().filterArity(action), MeshFilterInterface::SINGLE_MESH);
    EXPECT_NE(host.plugin().postCondition(action), int(MeshModel::MM_UNKNOWN));
    EXPECT_NE(host.plugin().postCondition(action), int(MeshModel::MM_ALL));
  }
  // MeshLab's windows switch on whatever attribute is named here.
  EXPECT_EQ(host.plugin().postCondition(&host.action(subdivide_filter)) &
                (MeshModel::MM_VERTCOLOR | MeshModel::MM_VERTQUALITY | MeshModel::MM_VERTTEXCOORD |
                 MeshModel::MM_FACECOLOR | MeshModel::MM_FACEQUALITY | MeshModel::MM_WEDGTEXCOORD),
            0);
  QStringList missing;
  Document empty;
  EXPECT_FALSE(
      host.plugin().isFilterApplicable(&host.action(subdivide_filter), empty.mesh(), missing));
  EXPECT_TRUE(
      host.plugin().isFilterApplicable(&host.action(smoothness_filter), empty.mesh(), missing));
}

TEST(plugin, dialogs_open_without_a_mesh) {
  Host& host = Host::instance();
  for (QAction* action : host.plugin().actions()) {
    MeshDocument nothing;
    RichParameterList list;
    host.plugin().initParameterSet(action, nothing, list);
    EXPECT_GE(list.size(), 5u);
    const bool reports = action->text() == smoothness_filter;
    host.plugin().setLog(&nothing.Log);
    EXPECT_EQ(host.plugin().applyFilter(action, nothing, list, nullptr), reports);
    EXPECT_EQ(host.plugin().errorMsg().isEmpty(), reports);
  }
}

TEST(plugin, heights_equal_the_library_rounded_once) {
  for (const char* text : {"gentle", "four-point", "chaikin", "ternary-four-point", "three-point",
                           "four-parameter:lambda=1/10,mu=1/5,nu=1/4,omega=1/20"}) {
    const Scheme scheme = parse_scheme(text);
    for (const MeshForm& form : forms()) {
      const GridMesh mesh = grid_mesh({6, 9}, form);
      Document document(mesh.arrays);
      // What MeshLab holds are floats.
      Grid<double> heights = heights_of(mesh);
      for (double& z : heights.samples()) z = static_cast<float>(z);
      RefineOptions options;
      options.levels = 2;
      const Grid<double> fine = refine(heights, scheme, options);
      const auto result = document.apply(subdivide_filter, {{"Levels", 2}}, text);
      ASSERT_TRUE(result.ok) << result.error;
      EXPECT_GT(result.progress_calls, 3);
      EXPECT_LT(result.progress_calls, 300);
      std::multiset<float> expected, found;
      for (double z : fine.samples()) expected.insert(static_cast<float>(z));
      for (const CVertexO& v : document.cm().vert) found.insert(v.cP()[2]);
      EXPECT_EQ(found, expected) << text;
    }
  }
}

TEST(plugin, the_dialogs_numbers_are_the_exact_decimals) {
  const GridMesh mesh = grid_mesh({6, 7});
  Document by_numbers(mesh.arrays), by_text(mesh.arrays);
  ASSERT_TRUE(
      by_numbers
          .apply(subdivide_filter,
                 {{"Scheme", 3}, {"Lambda", 0.1}, {"Mu", 0.2}, {"Nu", 0.25}, {"Omega", 0.05}})
          .ok);
  ASSERT_TRUE(
      by_text.apply(subdivide_filter, {}, "four-parameter:lambda=1/10,mu=1/5,nu=1/4,omega=1/20")
          .ok);
  EXPECT_EQ(by_numbers.fingerprint(), by_text.fingerprint());
}

TEST(plugin, detail_is_off_by_default_and_a_matter_of_its_seed) {
  const GridMesh mesh = grid_mesh({6, 7}, {MeshForm::Diagonals::random, true, true});
  const auto heights = [&](const std::map<std::string, double>& numbers) {
    Document document(mesh.arrays);
    const auto result = document.apply(subdivide_filter, numbers, "four-point");
    EXPECT_TRUE(result.ok) << result.error;
    std::vector<float> z;
    for (const CVertexO& v : document.cm().vert) z.push_back(v.cP()[2]);
    return z;
  };
  const auto smooth = heights({});
  EXPECT_EQ(heights({{"DetailAmount", 0}, {"Seed", 5}}), smooth);
  const auto rough = heights({{"DetailAmount", 0.2}, {"Seed", 5}});
  EXPECT_EQ(heights({{"DetailAmount", 0.2}, {"Seed", 5}}), rough);
  EXPECT_NE(heights({{"DetailAmount", 0.2}, {"Seed", 6}}), rough);
  EXPECT_NE(heights({{"DetailAmount", 0.2}, {"Seed", 5}, {"DetailRoughness", 1}}), rough);
  // An interpolating scheme keeps the old vertices.
  for (std::size_t v = 0; v < mesh.arrays.positions.size(); ++v) EXPECT_EQ(rough[v], smooth[v]);
  EXPECT_NE(rough, smooth);
}

TEST(plugin, every_scheme_boundary_and_choice_runs) {
  for (int scheme = 0; scheme < 16; ++scheme)
    for (int boundary = 0; boundary < 5; ++boundary)
      for (int coordinates = 0; coordinates < 2; ++coordinates)
        for (int quads = 0; quads < 2; ++quads) {
          Document document(grid_mesh({9, 10}, {MeshForm::Diagonals::random, true, true}).arrays);
          const auto result = document.apply(subdivide_filter, {{"Scheme", scheme},
                                                                {"Boundary", boundary},
                                                                {"Levels", 1},
                                                                {"Coordinates", coordinates},
                                                                {"KeepQuads", quads}});
          // The one combination that makes no sense.
          EXPECT_EQ(result.ok, !(boundary == 3 && coordinates == 1)) << result.error;
          if (!result.ok) continue;
          EXPECT_EQ(document.mesh().hasDataMask(MeshModel::MM_POLYGONAL), quads == 1);
          for (const CFaceO& f : document.cm().face)
            EXPECT_EQ(int(f.IsF(0)) + int(f.IsF(1)) + int(f.IsF(2)), quads);
          for (const CVertexO& v : document.cm().vert)
            for (int k = 0; k < 3; ++k) EXPECT_TRUE(std::isfinite(v.cP()[k]));
        }
}

TEST(plugin, polygon_marks_are_fit_for_meshlabs_own_code) {
  Document document(grid_mesh({6, 9}, {MeshForm::Diagonals::random, false, true}).arrays);
  ASSERT_TRUE(document.apply(subdivide_filter, {{"KeepQuads", 1}, {"Levels", 1}}).ok);
  document.mesh().updateDataMask(MeshModel::MM_FACEFACETOPO);
  for (CFaceO& f : document.cm().face)
    for (int k = 0; k < 3; ++k) {
      EXPECT_TRUE(!f.IsF(k) || f.FFp(k)->IsF(f.FFi(k))) << "a one-sided mark";
    }
  // MeshLab's own polygon count.
  EXPECT_EQ(vcg::tri::Clean<CMeshO>::CountBitQuads(document.cm()), 10 * 16);
}

TEST(plugin, attributes_of_every_kind_are_carried) {
  const GridMesh mesh = grid_mesh({6, 7}, {MeshForm::Diagonals::random, true, true});
  Document document(mesh.arrays);
  document.mesh().updateDataMask(
      MeshModel::MM_VERTCOLOR | MeshModel::MM_VERTQUALITY | MeshModel::MM_VERTTEXCOORD |
      MeshModel::MM_VERTRADIUS | MeshModel::MM_FACECOLOR | MeshModel::MM_FACEQUALITY |
      MeshModel::MM_WEDGTEXCOORD | MeshModel::MM_VERTCURV | MeshModel::MM_VERTCURVDIR |
      MeshModel::MM_FACEMARK | MeshModel::MM_VERTMARK);
  CMeshO& cm = document.cm();
  const auto linear = [](const Point3m& p) { return 10 + p[0] + p[1] / 4; };
  for (CVertexO& v : cm.vert) {
    v.Q() = linear(v.P());
    v.R() = 2 * linear(v.P());
    v.T().U() = linear(v.P()) / 100;
    v.T().V() = linear(v.P()) / 200;
    v.T().N() = 3;
    v.C() = vcg::Color4b(static_cast<unsigned char>(linear(v.P())), 7, 200, 255);
  }
  int number = 0;
  for (CFaceO& f : cm.face) {
    f.C() = vcg::Color4b(static_cast<unsigned char>(number % 251), 1, 2, 255);
    f.Q() = float(number++);
    const float sheet = f.cP(0)[0] + f.cP(1)[0] + f.cP(2)[0] > 90 ? 1 : 0;
    for (int k = 0; k < 3; ++k) {
      f.WT(k).U() = linear(f.cP(k)) / 100 + 5 * sheet;
      f.WT(k).V() = 0.5F;
      f.WT(k).N() = short(sheet);
    }
  }
  cm.face[5].SetS();
  cm.vert[3].SetS();
  const std::vector<CVertexO> old(cm.vert.begin(), cm.vert.end());
  const CFaceO old_face = cm.face[5];
  const Point3m a = old_face.cP(0), b = old_face.cP(1), c = old_face.cP(2);

  ASSERT_TRUE(document.apply(subdivide_filter, {{"Levels", 2}}, "four-point").ok);
  for (std::size_t v = 0; v < old.size(); ++v) {
    EXPECT_EQ(cm.vert[v].P(), old[v].cP()) << "an old vertex moved";
    EXPECT_EQ(cm.vert[v].IsS(), v == 3);
  }
  for (const CVertexO& v : cm.vert) {
    const float x = linear(v.cP());
    EXPECT_NEAR(v.cQ(), x, 1e-4);
    EXPECT_NEAR(v.cR(), 2 * x, 1e-4);
    EXPECT_NEAR(v.cT().U(), x / 100, 1e-5);
    EXPECT_NEAR(v.cT().V(), x / 200, 1e-5);
    EXPECT_EQ(v.cT().N(), 3);
    EXPECT_NEAR(v.cC()[0], x, 1.01);
    EXPECT_EQ(v.cC()[1], 7);
    EXPECT_EQ(v.cC()[2], 200);
    EXPECT_EQ(v.cC()[3], 255);
  }
  int selected = 0;
  double area = 0;
  for (const CFaceO& f : cm.face) {
    EXPECT_EQ(f.cC()[0], int(f.cQ()) % 251) << "colour and quality from different faces";
    const float sheet = f.cWT(0).N();
    for (int k = 0; k < 3; ++k) {
      EXPECT_EQ(f.cWT(k).N(), sheet);
      EXPECT_NEAR(f.cWT(k).U(), linear(f.cP(k)) / 100 + 5 * sheet, 1e-4);
      EXPECT_NEAR(f.cWT(k).V(), 0.5, 1e-6);
    }
    if (!f.IsS()) continue;
    ++selected;
    EXPECT_EQ(f.cQ(), 5);
    const Point3m e = f.cP(1) - f.cP(0), g = f.cP(2) - f.cP(0);
    area += std::abs(e[0] * g[1] - e[1] * g[0]) / 2;
  }
  EXPECT_EQ(selected, 16);
  EXPECT_EQ(cm.sfn, 16);
  EXPECT_NEAR(area, std::abs((b - a)[0] * (c - a)[1] - (b - a)[1] * (c - a)[0]) / 2, 1e-2);
  EXPECT_FALSE(document.mesh().hasDataMask(MeshModel::MM_VERTCURV));
}

TEST(plugin, nothing_is_made_up_that_was_not_there) {
  Document document(grid_mesh({5, 5}).arrays);
  const int before = document.mesh().dataMask();
  ASSERT_TRUE(document.apply(subdivide_filter, {{"KeepQuads", 0}}).ok);
  EXPECT_EQ(document.mesh().dataMask(), before);
  for (const CVertexO& v : document.cm().vert) EXPECT_EQ(v.cC(), vcg::Color4b(vcg::Color4b::White));
}

TEST(plugin, deleted_elements_and_stale_adjacency_do_no_harm) {
  const GridMesh mesh = grid_mesh({6, 7}, {MeshForm::Diagonals::random, false, true});
  Document plain(mesh.arrays);
  MeshArrays padded = mesh.arrays;
  padded.positions.insert(padded.positions.begin(), {1, 2, 3});
  for (Triangle& t : padded.triangles)
    for (int& v : t) ++v;
  padded.triangles.insert(padded.triangles.begin() + 4, Triangle{0, 1, 2});
  Document document(padded);
  document.mesh().updateDataMask(MeshModel::MM_FACEFACETOPO | MeshModel::MM_VERTFACETOPO);
  Allocator<CMeshO>::DeleteFace(document.cm(), document.cm().face[4]);
  Allocator<CMeshO>::DeleteVertex(document.cm(), document.cm().vert[0]);
  ASSERT_TRUE(plain.apply(subdivide_filter).ok);
  ASSERT_TRUE(document.apply(subdivide_filter).ok);
  EXPECT_EQ(document.fingerprint(), plain.fingerprint());
  EXPECT_FALSE(document.mesh().hasDataMask(MeshModel::MM_FACEFACETOPO));
}

TEST(plugin, can_be_applied_again_and_again_and_after_other_filters_marks) {
  Document document(grid_mesh({4, 5}, {MeshForm::Diagonals::random, true, true}).arrays);
  for (int i = 0; i < 4; ++i) {
    ASSERT_TRUE(document.apply(subdivide_filter, {{"Levels", 1}}).ok);
    if (i == 1) document.cm().face[17].ClearAllF();
    if (i == 2) document.cm().face[3].SetF(0);
  }
  EXPECT_EQ(document.cm().vn, (16 * 3 + 1) * (16 * 4 + 1));
  for (const CFaceO& f : document.cm().face) EXPECT_GT(f.cN()[2], 0);
}

TEST(plugin, the_layers_matrix_is_left_alone_and_told) {
  Document document(grid_mesh({4, 5}).arrays);
  document.cm().Tr.SetTranslate(1, 2, 3);
  const Matrix44m matrix = document.cm().Tr;
  const auto result = document.apply(subdivide_filter);
  ASSERT_TRUE(result.ok);
  EXPECT_TRUE(document.cm().Tr == matrix);
  EXPECT_NE(result.log.find("matrix"), std::string::npos);
}

TEST(plugin, limit_moves_only_heights_and_keeps_its_normals) {
  const GridMesh mesh = grid_mesh({6, 7}, {MeshForm::Diagonals::random, true, true});
  Document document(mesh.arrays);
  const std::vector<CVertexO> old(document.cm().vert.begin(), document.cm().vert.end());
  const auto result = document.apply(limit_filter, {}, "b-spline:degree=3");
  ASSERT_TRUE(result.ok) << result.error;
  bool moved = false;
  for (std::size_t v = 0; v < old.size(); ++v) {
    const CVertexO& now = document.cm().vert[v];
    EXPECT_EQ(now.cP()[0], old[v].cP()[0]);
    EXPECT_EQ(now.cP()[1], old[v].cP()[1]);
    moved = moved || now.cP()[2] != old[v].cP()[2];
    EXPECT_NEAR(now.cN().Norm(), 1, 1e-5);
    EXPECT_GT(now.cN()[2], 0);
  }
  EXPECT_TRUE(moved);
  // The cubic B-spline's limit at an inner vertex: (1, 4, 1)/6 along both axes.
  double expected = 0;
  const double w[] = {1.0 / 6, 4.0 / 6, 1.0 / 6};
  for (Index r = 1; r <= 3; ++r)
    for (Index c = 2; c <= 4; ++c) expected += w[r - 1] * w[c - 2] * float(heights_of(mesh)(r, c));
  EXPECT_NEAR(document.cm().vert[std::size_t(mesh.vertex(2, 3))].cP()[2], expected, 1e-4);
  EXPECT_TRUE(document.mesh().hasDataMask(MeshModel::MM_POLYGONAL));
  EXPECT_EQ(document.cm().fn, int(mesh.arrays.triangles.size()));
}

TEST(plugin, limit_runs_with_every_choice_or_says_why_not) {
  int done = 0;
  for (int scheme = 0; scheme < 16; ++scheme)
    for (int boundary = 0; boundary < 4; ++boundary)
      for (int coordinates = 0; coordinates < 2; ++coordinates) {
        Document document(grid_mesh({7, 8}, {MeshForm::Diagonals::random, true, true}).arrays);
        const std::string before = document.fingerprint();
        const auto result = document.apply(
            limit_filter,
            {{"Scheme", scheme}, {"Boundary", boundary}, {"Coordinates", coordinates}});
        if (!result.ok) {
          EXPECT_FALSE(result.error.empty());
          EXPECT_EQ(document.fingerprint(), before);
          continue;
        }
        ++done;
        for (const CVertexO& v : document.cm().vert) {
          EXPECT_TRUE(std::isfinite(v.cP()[2]));
          // Where x and y are reflected, too, asymmetric schemes fold over at the rim.
          if (coordinates == 0 || boundary != 2) {
            EXPECT_GT(v.cN()[2], 0) << scheme << ' ' << boundary << ' ' << coordinates;
          }
        }
      }
  // All but what bends x and y to the other side, and schemes without certified limits.
  EXPECT_GE(done, 14 * 7);
}

TEST(plugin, smoothness_leaves_the_mesh_and_fills_the_log) {
  Document document(grid_mesh({6, 7}).arrays);
  const std::string before = document.fingerprint();
  for (int scheme = 0; scheme < 16; ++scheme) {
    const auto result = document.apply(smoothness_filter, {{"Scheme", scheme}});
    ASSERT_TRUE(result.ok) << result.error;
    EXPECT_NE(result.log.find("C^0: "), std::string::npos);
    EXPECT_NE(result.log.find("Hoelder exponent"), std::string::npos);
  }
  EXPECT_EQ(document.fingerprint(), before);
}

TEST(plugin, refusals_leave_the_mesh_untouched_and_say_why) {
  const auto expect_refused = [](Document& document, const std::map<std::string, double>& numbers,
                                 const std::string& text, const char* reason) {
    for (const char* filter : {subdivide_filter, limit_filter, coarsen_filter}) {
      std::map<std::string, double> known;
      for (const auto& [name, value] : numbers)
        if (document.dialog(filter).hasParameter(QString::fromStdString(name))) known[name] = value;
      if (known.size() != numbers.size()) continue;
      const std::string before = document.fingerprint();
      const auto result = document.apply(filter, known, text);
      EXPECT_FALSE(result.ok) << filter;
      EXPECT_NE(result.error.find(reason), std::string::npos) << result.error;
      EXPECT_FALSE(result.log.empty()) << "meshlabserver shows only the log";
      EXPECT_EQ(document.fingerprint(), before) << filter;
      EXPECT_EQ(document.document().meshList.size(), 1);
    }
  };
  Document empty;
  expect_refused(empty, {}, "", "empty");
  MeshArrays points;
  points.positions.assign(9, {1, 2, 3});
  Document cloud(points);
  expect_refused(cloud, {}, "", "9 points but no faces");

  const GridMesh good = grid_mesh({6, 6});
  const auto cut = [&](const std::function<bool(std::size_t)>& missing) {
    MeshArrays arrays = good.arrays;
    arrays.triangles.clear();
    for (std::size_t f = 0; f < good.arrays.triangles.size(); ++f)
      if (!missing(f / 2)) arrays.triangles.push_back(good.arrays.triangles[f]);
    return arrays;
  };
  Document hole(cut([](std::size_t cell) { return cell == 12; }));
  expect_refused(hole, {}, "", "not a terrain grid");
  Document l_shape(cut([](std::size_t cell) { return cell / 5 > 2 && cell % 5 > 2; }));
  expect_refused(l_shape, {}, "", "not a terrain grid");
  MeshArrays fins = good.arrays;
  fins.positions.push_back({0, 0, 9});
  fins.triangles.push_back({fins.triangles[9][0], fins.triangles[9][1], 36});
  Document non_manifold(fins);
  expect_refused(non_manifold, {}, "", "not a terrain grid");
  MeshArrays tetrahedron;
  tetrahedron.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  tetrahedron.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  Document closed(tetrahedron);
  expect_refused(closed, {}, "", "not a terrain grid");
  MeshArrays degenerate = good.arrays;
  degenerate.triangles[3] = {4, 4, 5};
  Document repeated(degenerate);
  expect_refused(repeated, {}, "", "not a terrain grid");
  MeshArrays nan = good.arrays;
  nan.positions[8][1] = std::nan("");
  Document not_finite(nan);
  expect_refused(not_finite, {}, "", "vertex 8");

  Document fine(good.arrays);
  expect_refused(fine, {{"Levels", 0}}, "", "Levels = 0");
  Document large(grid_mesh({60, 60}).arrays);
  expect_refused(large, {{"Levels", 10}}, "", "fewer levels");
  expect_refused(fine, {{"Scheme", 16}}, "", "Scheme = 16");
  expect_refused(fine, {{"DetailAmount", -0.1}}, "", "DetailAmount");
  expect_refused(fine, {{"DetailRoughness", 2.5}}, "", "DetailRoughness");
  expect_refused(fine, {{"Seed", -1}}, "", "Seed");
  expect_refused(fine, {{"Boundary", -1}}, "", "Boundary = -1");
  expect_refused(fine, {{"Scheme", 3}, {"Omega", 1e9}}, "", "Omega");
  expect_refused(fine, {}, "four-pointt", "did you mean");
  expect_refused(fine, {}, "mask:arity=2,first=0,coefficients=1;2", "sum");
  expect_refused(fine, {{"Boundary", 4}, {"Levels", 3}}, "b-spline:degree=9", "oundary");
}

TEST(plugin, small_and_thin_meshes_work) {
  for (Extent extent : {Extent{2, 2}, Extent{2, 9}, Extent{9, 2}, Extent{2, 3}}) {
    for (int scheme = 0; scheme < 16; ++scheme) {
      Document document(grid_mesh(extent, {MeshForm::Diagonals::random, true, true}).arrays);
      const auto result = document.apply(subdivide_filter, {{"Scheme", scheme}, {"Levels", 1}});
      EXPECT_TRUE(result.ok) << result.error;
    }
  }
}

// Files by MeshLab's own importers; OBJ is left out because Debian's importer aborts on it.
TEST(plugin, meshes_read_by_meshlab_are_grids) {
  const arete::test::TemporaryFolder folder;
  const Index rows = 6, cols = 9;
  const auto vertices = [&](std::ostream& out) {
    for (Index r = 0; r < rows; ++r)
      for (Index c = 0; c < cols; ++c)
        out << 10 * c << ' ' << -20 * r << ' ' << float(test_height(r, c)) << '\n';
  };
  const auto quads = [&](std::ostream& out) {
    for (Index r = 0; r + 1 < rows; ++r)
      for (Index c = 0; c + 1 < cols; ++c) {
        const Index i = r * cols + c;
        out << "4 " << i << ' ' << i + cols << ' ' << i + cols + 1 << ' ' << i + 1 << '\n';
      }
  };
  {
    std::ofstream off(folder.path() / "a.off");
    off << "OFF\n54 40 0\n";
    vertices(off);
    quads(off);
    std::ofstream ply(folder.path() / "a.ply");
    ply << "ply\nformat ascii 1.0\nelement vertex 54\nproperty float x\nproperty float y\n"
           "property float z\nelement face 40\nproperty list uchar int "
           "vertex_indices\nend_header\n";
    vertices(ply);
    quads(ply);
  }
  std::string first;
  for (const char* name : {"a.ply", "a.off"}) {
    Document document((folder.path() / name).string());
    EXPECT_TRUE(document.mesh().hasDataMask(MeshModel::MM_POLYGONAL)) << name;
    const auto result = document.apply(subdivide_filter, {{"Levels", 2}});
    ASSERT_TRUE(result.ok) << result.error;
    EXPECT_EQ(document.cm().vn, 21 * 33) << name;
    std::multiset<float> z;
    for (const CVertexO& v : document.cm().vert) z.insert(v.cP()[2]);
    std::string heights;
    for (float h : z) heights += std::to_string(h) + " ";
    if (first.empty()) first = heights;
    EXPECT_EQ(heights, first) << "PLY and OFF differ";
  }
}

}  // namespace
}  // namespace arete::meshlab::test
