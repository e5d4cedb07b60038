// SPDX-License-Identifier: MIT
// The include matrix of docs/design.md: who may include whom, and where third parties may appear.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "support/source_dir.h"

namespace {

namespace fs = std::filesystem;
using Names = std::set<std::string>;

const std::map<std::string, Names> core_may_include{
    {"parallel", {"parallel"}},
    {"algebra", {"algebra"}},
    {"scheme", {"algebra", "scheme"}},
    {"analysis", {"algebra", "scheme", "analysis", "parallel"}},
    {"field", {"field"}},
    {"topology", {"field", "topology"}},
    {"refine", {"algebra", "scheme", "field", "parallel", "refine"}},
    {"reverse", {"algebra", "scheme", "field", "parallel", "refine", "topology", "reverse"}},
    {"fractal", {"algebra", "scheme", "field", "fractal"}},
    {"variational", {"algebra", "scheme", "field", "variational"}},
    {"metrics", {"field", "metrics"}},
    {"fit", {"algebra", "scheme", "analysis", "field", "refine", "variational", "metrics", "fit"}},
};
const Names adapters{"openmesh", "gdal", "cgal", "vtk", "paraview", "opensubdiv"};

// Third parties by the beginning of their headers' names, and the rooms that may see them.
const std::map<std::string, Names> third_parties{{"boost/multiprecision/", {"core"}},
                                                 {"Eigen/", {"core"}},
                                                 {"unsupported/Eigen/", {"core"}},
                                                 {"tbb/", {"core"}},
                                                 {"gdal", {"gdal"}},
                                                 {"ogr", {"gdal"}},
                                                 {"cpl_", {"gdal"}},
                                                 {"vtk", {"vtk", "paraview"}},
                                                 {"EGL/", {"vtk"}},
                                                 {"OpenMesh/", {"openmesh"}},
                                                 {"CGAL/", {"cgal"}},
                                                 {"opensubdiv/", {"opensubdiv"}},
                                                 {"CLI/", {"cli"}},
                                                 {"nlohmann/", {"cli"}}};

struct Include {
  fs::path file;
  int line;
  std::string target;
  bool quoted;
};

bool is_source(const fs::path& path) {
  return path.extension() == ".h" || path.extension() == ".cpp" || path.extension() == ".cxx" ||
         path.extension() == ".hh";
}

std::vector<Include> includes_below(const fs::path& folder) {
  std::vector<Include> found;
  if (!fs::exists(folder)) return found;
  const std::regex pattern(R"(^\s*#\s*include\s*([<"])([^>"]+)[>"])");
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (!entry.is_regular_file() || !is_source(entry.path())) continue;
    std::ifstream stream(entry.path());
    std::string line;
    for (int number = 1; std::getline(stream, line); ++number) {
      std::smatch match;
      if (std::regex_search(line, match, pattern))
        found.push_back({entry.path(), number, match[2], match[1] == "\""});
    }
  }
  return found;
}

// arete/<room>/... -> room, otherwise empty.
std::string arete_room(const std::string& target) {
  if (target.rfind("arete/", 0) != 0) return "";
  const auto end = target.find('/', 6);
  return end == std::string::npos ? "" : target.substr(6, end - 6);
}

std::string where(const Include& include) {
  return include.file.string() + ":" + std::to_string(include.line) + " includes " + include.target;
}

const fs::path root = arete::test::source_dir();

TEST(layering, core_rooms_include_only_the_rooms_below_them) {
  int checked = 0;
  for (const auto& include : includes_below(root / "core" / "arete")) {
    const std::string room = fs::relative(include.file, root / "core" / "arete").begin()->string();
    ASSERT_EQ(core_may_include.count(room), 1u) << room << " is not in the matrix";
    const std::string target = arete_room(include.target);
    if (target.empty()) {
      EXPECT_FALSE(include.quoted) << where(include) << " without its full path";
      continue;
    }
    EXPECT_EQ(core_may_include.at(room).count(target), 1u) << where(include);
    ++checked;
  }
  EXPECT_GT(checked, 20);
}

TEST(layering, an_adapter_never_includes_another_adapter_or_the_program) {
  for (const std::string& adapter : adapters) {
    for (const auto& include : includes_below(root / "plugin" / adapter)) {
      const std::string target = arete_room(include.target);
      EXPECT_TRUE(target.empty() || target == adapter || core_may_include.count(target) == 1)
          << where(include);
      EXPECT_EQ(include.target.rfind("cli/", 0), std::string::npos) << where(include);
    }
  }
}

// They are a program's plugin and not an adapter: GPL as the cgal adapter is, so they may use it.
TEST(layering, meshlab_filters_include_core_and_cgal_and_keep_meshlab_in_one_folder) {
  int checked = 0;
  for (const auto& include : includes_below(root / "meshlab-filters")) {
    const std::string target = arete_room(include.target);
    EXPECT_TRUE(target.empty() || target == "meshlab" || target == "cgal" ||
                core_may_include.count(target) == 1)
        << where(include);
    const std::string file = fs::relative(include.file, root / "meshlab-filters").string();
    if (file.rfind("arete/", 0) != 0) continue;
    EXPECT_TRUE(include.target.rfind("vcg/", 0) != 0 && include.target.rfind("wrap/", 0) != 0 &&
                include.target.rfind("common/", 0) != 0 && include.target.rfind("Q", 0) != 0)
        << where(include);
    ++checked;
  }
  EXPECT_GT(checked, 50);
}

TEST(layering, third_party_headers_appear_only_where_they_belong) {
  const auto check = [](const fs::path& folder, const std::string& room) {
    for (const auto& include : includes_below(folder)) {
      if (include.target.rfind("arete/", 0) == 0) continue;
      for (const auto& [prefix, rooms] : third_parties) {
        if (include.target.rfind(prefix, 0) != 0) continue;
        EXPECT_EQ(rooms.count(room), 1u) << where(include);
      }
    }
  };
  check(root / "core", "core");
  check(root / "cli", "cli");
  for (const std::string& adapter : adapters) check(root / "plugin" / adapter, adapter);
}

TEST(layering, core_opens_no_file_prints_nothing_and_never_exits) {
  const std::regex forbidden(
      R"(std::(cout|cerr|clog|ofstream|ifstream|fstream|exit|abort)\b|(^|[^n])printf\()");
  for (const auto& entry : fs::recursive_directory_iterator(root / "core")) {
    if (!entry.is_regular_file() || !is_source(entry.path())) continue;
    std::ifstream stream(entry.path());
    std::string line;
    for (int number = 1; std::getline(stream, line); ++number)
      EXPECT_FALSE(std::regex_search(line, forbidden)) << entry.path() << ":" << number;
  }
}

// ThreadSanitizer is told there what passes between threads; of those begun elsewhere it knew
// nothing.
TEST(layering, the_threads_of_core_begin_in_one_place) {
  const Names begins_threads{"tbb/parallel_for.h",
                             "tbb/parallel_reduce.h",
                             "tbb/parallel_sort.h",
                             "tbb/task_arena.h",
                             "tbb/task_group.h",
                             "tbb/tbb.h",
                             "thread",
                             "future"};
  Names rooms;
  for (const auto& include : includes_below(root / "core" / "arete")) {
    if (begins_threads.count(include.target) == 0) continue;
    rooms.insert(fs::relative(include.file, root / "core" / "arete").begin()->string());
    EXPECT_EQ(rooms, Names{"parallel"}) << where(include);
  }
  EXPECT_EQ(rooms.size(), 1u);
}

TEST(layering, every_source_names_its_licence_and_none_is_longer_than_600_lines) {
  for (const char* folder :
       {"core", "plugin", "meshlab-filters", "cli", "tests", "examples", "bench"}) {
    if (!fs::exists(root / folder)) continue;
    for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
      if (!entry.is_regular_file() || !is_source(entry.path())) continue;
      std::ifstream stream(entry.path());
      std::string line;
      ASSERT_TRUE(std::getline(stream, line));
      const std::string path = fs::relative(entry.path(), root).string();
      const bool gpl = path.rfind("plugin/cgal", 0) == 0 || path.rfind("meshlab-filters", 0) == 0 ||
                       path.rfind("tests/meshlab", 0) == 0;
      EXPECT_NE(line.find(gpl ? "SPDX-License-Identifier: GPL-3.0-or-later"
                              : "SPDX-License-Identifier: MIT"),
                std::string::npos)
          << entry.path();
      int lines = 1;
      while (std::getline(stream, line)) ++lines;
      EXPECT_LE(lines, 600) << entry.path();
    }
  }
}

}  // namespace
