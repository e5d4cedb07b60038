// SPDX-License-Identifier: MIT
// Told to stop, the analysis gives what it has proved by then: never more than the whole, and never
// something else.
#include "arete/analysis/stop.h"

#include <gtest/gtest.h>

#include <memory>

#include "arete/analysis/smoothness.h"
#include "arete/scheme/catalogue.h"

namespace arete {
namespace {

// Says stop when asked for the n-th time.
Stop after(int questions) {
  return [count = std::make_shared<int>(0), questions] { return ++*count > questions; };
}

TEST(Stop, LeavesWhatIsProvedTrueAndTheRestUndecided) {
  for (const char* text : {"gentle", "ternary-two-step:b=6/5", "craggy", "four-point:omega=1/2"}) {
    const Mask mask = parse_scheme(text).mask();
    const Smoothness whole = analyze_smoothness(mask);
    EXPECT_TRUE(whole.complete);
    for (const int questions : {0, 1, 2, 5, 10, 30, 100, 1000}) {
      SmoothnessOptions options;
      options.jsr.stop = after(questions);
      const Smoothness part = analyze_smoothness(mask, options);
      EXPECT_LE(part.certified, whole.certified) << text << " " << questions;
      if (part.refuted_at) {
        // A lower order may still be open, so the smallest refuted one may be larger.
        ASSERT_TRUE(whole.refuted_at);
        EXPECT_GE(*part.refuted_at, *whole.refuted_at) << text << " " << questions;
      }
      EXPECT_LE(part.hoelder.lower, whole.hoelder.upper + 1e-12);
      EXPECT_GE(part.hoelder.upper, whole.hoelder.lower - 1e-12);
      if (questions == 0) {
        EXPECT_FALSE(part.complete) << text;
        EXPECT_EQ(part.hoelder.stability, Stability::unknown);
      }
    }
  }
}

TEST(Stop, EndsHardMasksAtOnce) {
  // 400 taps with numbers of many digits take long; stopped at once they hardly take any time.
  std::vector<Rational> taps(400, Rational(0));
  for (std::size_t i = 0; i < taps.size(); ++i)
    taps[i] = Rational(static_cast<int>(i % 13) - 6, 100003 + 17 * static_cast<int>(i));
  Rational even = 0, odd = 0;
  for (std::size_t i = 2; i < taps.size(); ++i) (i % 2 == 0 ? even : odd) += taps[i];
  taps[0] = 1 - even;
  taps[1] = 1 - odd;
  SmoothnessOptions options;
  options.jsr.stop = [] { return true; };
  const Smoothness found = analyze_smoothness(Mask(2, 0, taps), options);
  EXPECT_FALSE(found.complete);
  EXPECT_EQ(found.refuted_at, std::nullopt);
}

}  // namespace
}  // namespace arete
