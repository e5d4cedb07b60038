// SPDX-License-Identifier: MIT
#include "cli/progress.h"

#include <unistd.h>

#include <algorithm>
#include <cstdio>

#include "cli/interruption.h"

namespace arete::cli {
namespace {

constexpr int bar_width = 40;
constexpr std::chrono::milliseconds a_moment{300};

}  // namespace

ProgressBar::ProgressBar(std::string what)
    : what_(std::move(what)),
      terminal_(isatty(STDERR_FILENO) == 1),
      start_(std::chrono::steady_clock::now()) {}

ProgressBar::~ProgressBar() {
  // Leaves an empty line behind, as if nothing had been there.
  if (shown_) std::fputs("\r\033[K", stderr);
}

void ProgressBar::show(double share) {
  stop_if_interrupted();
  if (!terminal_ || std::chrono::steady_clock::now() - start_ < a_moment) return;
  const int percent = static_cast<int>(100 * std::clamp(share, 0.0, 1.0));
  if (percent == last_percent_) return;
  last_percent_ = percent;
  shown_ = true;
  const int filled = percent * bar_width / 100;
  std::fprintf(stderr, "\r%s [%s%s] %3d %%", what_.c_str(),
               std::string(static_cast<std::size_t>(filled), '#').c_str(),
               std::string(static_cast<std::size_t>(bar_width - filled), '.').c_str(), percent);
  std::fflush(stderr);
}

}  // namespace arete::cli
