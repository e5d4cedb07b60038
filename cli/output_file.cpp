// SPDX-License-Identifier: MIT
#include "cli/output_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <system_error>

#include "cli/error.h"

namespace arete::cli {
namespace fs = std::filesystem;
namespace {

fs::path side_file(const fs::path& path) { return path.string() + ".aux.xml"; }

}  // namespace

OutputFile::OutputFile(const std::string& path, const std::string& input, bool overwrite)
    : place_(path) {
  std::error_code ignored;
  if (fs::exists(fs::symlink_status(place_, ignored))) {
    if (!input.empty() && fs::equivalent(place_, input, ignored))
      throw Failure(path + " is the input itself; name another output");
    if (fs::is_directory(place_, ignored)) throw Failure(path + " is a folder; name a file in it");
    if (!overwrite) throw Failure(path + " exists; give --overwrite to replace it");
  }
  // A symbolic link at the place is replaced by the file itself: nothing is ever written elsewhere.
  temporary_ = place_.parent_path() / ("." + place_.stem().string() + ".partial-" +
                                       std::to_string(getpid()) + place_.extension().string());
  const int file = open(temporary_.c_str(), O_CREAT | O_EXCL | O_WRONLY, 0666);
  if (file < 0) {
    const std::string why = std::strerror(errno);
    temporary_.clear();
    throw Failure(path + " cannot be written (" + why + "); choose another folder");
  }
  close(file);
}

OutputFile::~OutputFile() {
  if (temporary_.empty()) return;
  std::error_code ignored;
  fs::remove(temporary_, ignored);
  fs::remove(side_file(temporary_), ignored);
}

void OutputFile::commit() {
  std::error_code error;
  // A side file of the file that is replaced would describe the wrong samples.
  fs::remove(side_file(place_), error);
  fs::rename(temporary_, place_, error);
  if (error) throw Failure(place_.string() + " cannot be replaced (" + error.message() + ")");
  if (fs::exists(side_file(temporary_), error))
    fs::rename(side_file(temporary_), side_file(place_), error);
  temporary_.clear();
}

}  // namespace arete::cli
