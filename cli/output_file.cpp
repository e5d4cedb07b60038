// SPDX-License-Identifier: MIT
#include "cli/output_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <cstring>
#include <system_error>

#include "cli/error.h"

namespace arete::cli {
namespace fs = std::filesystem;
namespace {

fs::path side_file(const fs::path& path) { return path.string() + ".aux.xml"; }

// The temporary files that there are, for a signal's handler, which may not allocate nor lock. More
// at a time, or longer names, only stay behind.
struct Unfinished {
  std::atomic<bool> taken = false;
  std::atomic<bool> there = false;
  char file[4096] = {};
  char side[4096] = {};
};
std::array<Unfinished, 8> unfinished;

void note(const fs::path& file) {
  const std::string side = side_file(file).string();
  for (Unfinished& place : unfinished) {
    if (side.size() >= sizeof place.side || place.taken.exchange(true)) continue;
    std::strcpy(place.file, file.c_str());
    std::strcpy(place.side, side.c_str());
    place.there = true;
    return;
  }
}

void forget(const fs::path& file) {
  for (Unfinished& place : unfinished) {
    if (!place.there || file != place.file) continue;
    place.there = false;
    place.taken = false;
  }
}

}  // namespace

void remove_unfinished_outputs() noexcept {
  for (const Unfinished& place : unfinished) {
    if (!place.there) continue;
    unlink(place.file);
    unlink(place.side);
  }
}

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
  note(temporary_);
}

OutputFile::~OutputFile() {
  if (temporary_.empty()) return;
  std::error_code ignored;
  fs::remove(temporary_, ignored);
  fs::remove(side_file(temporary_), ignored);
  forget(temporary_);
}

void OutputFile::commit() {
  std::error_code error;
  // A side file of the file that is replaced would describe the wrong samples.
  fs::remove(side_file(place_), error);
  fs::rename(temporary_, place_, error);
  if (error) throw Failure(place_.string() + " cannot be replaced (" + error.message() + ")");
  if (fs::exists(side_file(temporary_), error))
    fs::rename(side_file(temporary_), side_file(place_), error);
  forget(temporary_);
  temporary_.clear();
}

}  // namespace arete::cli
