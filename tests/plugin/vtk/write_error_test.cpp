// SPDX-License-Identifier: MIT
// Files that cannot be written: an exception that names the file, and nothing on stderr.
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <csignal>
#include <fstream>
#include <functional>

#include "arete/vtk/error.h"
#include "arete/vtk/write_image.h"
#include "arete/vtk/write_polydata.h"
#include "arete/vtk/write_polyline.h"
#include "arete/vtk/write_structured_grid.h"
#include "fixtures.h"

namespace arete::vtk {
namespace {

using Write = std::function<void(const std::filesystem::path&)>;

std::string complaint(const Write& write, const std::filesystem::path& path) {
  testing::internal::CaptureStderr();
  std::string message = "(none)";
  try {
    write(path);
  } catch (const WriteError& error) {
    message = error.what();
  }
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  return message;
}

/// No file of this process may grow beyond so many bytes: what a full disk looks like to a writer.
class FileSizeLimit {
 public:
  explicit FileSizeLimit(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    getrlimit(RLIMIT_FSIZE, &before_);
    rlimit limit = before_;
    limit.rlim_cur = bytes;
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FileSizeLimit() {
    setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }
  FileSizeLimit(const FileSizeLimit&) = delete;
  FileSizeLimit& operator=(const FileSizeLimit&) = delete;

 private:
  rlimit before_{};
  void (*handler_)(int);
};

class EveryWriter : public testing::TestWithParam<int> {
 protected:
  [[nodiscard]] Write writer() const {
    switch (GetParam()) {
      case 0:
        return [this](const auto& path) { write_image(surface_, path, raw_); };
      case 1:
        return [this](const auto& path) { write_structured_grid(surface_, path, raw_); };
      case 2:
        return [this](const auto& path) { write_polydata(surface_, path, raw_); };
      default:
        return [this](const auto& path) { write_polyline({line_.view()}, path, raw_); };
    }
  }

 private:
  WriteOptions raw_{Compression::none};
  Grid<float> grid_ = planted<float>({200, 200}, north_up, plane_height);
  Surface surface_ = surface_of(grid_, north_up);
  const Grid<double> line_ = Grid<double>({20000, 2}, 1.0);
};
INSTANTIATE_TEST_SUITE_P(write_error, EveryWriter, testing::Range(0, 4));

TEST_P(EveryWriter, a_folder_that_is_not_there_is_named) {
  const Scratch scratch;
  const std::string path = scratch / "none/a.vtk";
  const std::string message = complaint(writer(), path);
  EXPECT_NE(message.find(path), std::string::npos) << message;
  EXPECT_NE(message.find("No such file"), std::string::npos) << message;
}

TEST_P(EveryWriter, a_file_is_no_folder_and_a_folder_no_file) {
  const Scratch scratch;
  std::ofstream(scratch / "file") << "x";
  const std::string below = complaint(writer(), scratch / "file/a.vtk");
  EXPECT_NE(below.find("Not a directory"), std::string::npos) << below;
  const std::string folder = complaint(writer(), scratch / ".");
  EXPECT_NE(folder.find("Is a directory"), std::string::npos) << folder;
}

TEST_P(EveryWriter, a_full_disk_is_told_wherever_it_strikes) {
  const Scratch scratch;
  const auto path = scratch / "a.vtk";
  writer()(path);
  const auto size = std::filesystem::file_size(path);
  // Within the first buffer, amid the arrays, and in what is only written when the file is closed.
  for (const auto limit : {size / 1000, size / 2, size - 1}) {
    const FileSizeLimit full(limit);
    const std::string message = complaint(writer(), path);
    EXPECT_NE(message.find("disk is full"), std::string::npos) << limit << ": " << message;
    EXPECT_NE(message.find(path.string()), std::string::npos) << message;
  }
  const FileSizeLimit enough(size);
  EXPECT_EQ(complaint(writer(), path), "(none)");
}

TEST_P(EveryWriter, writes_to_exactly_the_path_given) {
  // VTK itself would write the second of these to the first, and the others to who knows where.
  for (const char* name : {"a.vti", "a.vti~", "a.vti.part-7 ü", "_"}) {
    const Scratch scratch;
    writer()(scratch / name);
    EXPECT_GT(std::filesystem::file_size(scratch / name), 1000u);
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(scratch / "."), {}), 1);
  }
}

TEST_P(EveryWriter, replaces_an_older_file_wholly) {
  const Scratch scratch;
  writer()(scratch / "new");
  std::ofstream(scratch / "old") << std::string(5'000'000, 'x');
  writer()(scratch / "old");
  EXPECT_TRUE(contents(scratch / "old") == contents(scratch / "new"));
}

}  // namespace
}  // namespace arete::vtk
