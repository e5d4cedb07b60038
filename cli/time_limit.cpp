// SPDX-License-Identifier: MIT
#include "cli/time_limit.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>

#include "cli/interruption.h"

namespace arete::cli {
namespace {

constexpr double longest = 1e7;  // seconds; beyond it clocks overflow

std::chrono::steady_clock::duration duration_of(double seconds) {
  return std::chrono::duration_cast<std::chrono::steady_clock::duration>(
      std::chrono::duration<double>(seconds));
}

}  // namespace

TimeLimit::TimeLimit(double seconds, std::string what) : limited_(seconds > 0) {
  if (!limited_) return;
  seconds = std::min(seconds, longest);
  end_ = std::chrono::steady_clock::now() + duration_of(seconds);
  guard_ = std::thread([this, seconds, text = std::move(what)] { guard(seconds, text); });
}

TimeLimit::~TimeLimit() {
  if (!limited_) return;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    done_ = true;
  }
  finished_.notify_one();
  guard_.join();
}

Stop TimeLimit::stop() const {
  return [this] { return is_interrupted() || passed(); };
}

bool TimeLimit::passed() const { return limited_ && std::chrono::steady_clock::now() >= end_; }

void TimeLimit::guard(double seconds, const std::string& what) {
  std::unique_lock<std::mutex> lock(mutex_);
  if (finished_.wait_until(lock, end_ + duration_of(seconds + 5), [this] { return done_; })) return;
  std::fprintf(stderr,
               "arete: no verdict on %s within the time limit of %g s: its exact numbers are too "
               "large; raise --timeout, or round the mask\n",
               what.c_str(), seconds);
  std::_Exit(1);
}

}  // namespace arete::cli
