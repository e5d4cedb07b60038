// SPDX-License-Identifier: MIT
// Schemes nobody should type: a clear verdict or a clear refusal, in bounded time.
#include <gtest/gtest.h>

#include <chrono>

#include "run_program.h"
#include "support/temporary_folder.h"

namespace arete {
namespace {

using test::run_arete;
using test::run_json;

std::string joined(const std::vector<std::string>& numbers) {
  std::string text;
  for (const std::string& number : numbers) text += (text.empty() ? "" : ";") + number;
  return text;
}

// Binary, any number of taps: the first two make both phases sum to 1. Numbers over one
// denominator.
std::string binary_mask(int taps, const std::string& denominator) {
  std::vector<long long> numerators(static_cast<std::size_t>(taps), 0);
  long long sums[2] = {0, 0};
  for (int i = 2; i < taps; ++i) {
    numerators[static_cast<std::size_t>(i)] = (i * 7919LL) % 41 - 20;
    sums[i % 2] += numerators[static_cast<std::size_t>(i)];
  }
  std::vector<std::string> numbers;
  for (int i = 2; i < taps; ++i)
    numbers.push_back(std::to_string(numerators[static_cast<std::size_t>(i)]) + "/" + denominator);
  // 1 - s/d as a decimal would be long; d is a power of ten, so d - s is written digit by digit.
  const auto rest = [&](long long sum) {
    const auto digits = denominator.size() - 1;
    std::string value = denominator;  // 10...0 - sum
    if (sum > 0) {
      value = std::string(digits, '9');
      long long borrow = sum - 1;
      for (std::size_t at = digits; at-- > 0 && borrow > 0; borrow /= 10)
        value[at] = static_cast<char>('9' - borrow % 10);
    } else {
      long long add = -sum;
      for (std::size_t at = value.size(); at-- > 0 && add > 0; add /= 10)
        value[at] = static_cast<char>('0' + add % 10);
    }
    return value + "/" + denominator;
  };
  numbers.insert(numbers.begin(), {rest(sums[0]), rest(sums[1])});
  return "mask:arity=2,first=-3,coefficients=" + joined(numbers);
}

TEST(cli_hostile_scheme, impossible_masks_are_refused_with_the_reason) {
  const struct {
    const char* scheme;
    const char* reason;
  } cases[] = {
      {"mask:arity=2,first=0,coefficients=1", "sum to 1, 0"},
      {"mask:arity=2,first=0,coefficients=0", "non-zero"},
      {"mask:arity=3,first=0,coefficients=0;0;0", "non-zero"},
      {"mask:arity=1,first=0,coefficients=1", "out of range"},
      {"mask:arity=0,first=0,coefficients=1", "out of range"},
      {"mask:arity=65,first=0,coefficients=1", "out of range"},
      {"mask:arity=2,first=0,coefficients=1;1/0", "coefficients"},
      {"mask:arity=2,first=0,coefficients=1;nan", "coefficients"},
      {"mask:arity=2,first=0,coefficients=1e999999999;1", "coefficients"},
      {"mask:arity=2,first=0,coefficients=", "coefficients"},
      {"mask:arity=2,first=99999999999999999999,coefficients=1;1", "out of range"},
      {"four-point:omega=1e400", "out of range"},
      {"difference:a0=1,m=1", "sum"},
      {"", "scheme"},
  };
  for (const auto& [scheme, reason] : cases)
    for (const char* verb : {"analyze", "describe"}) {
      const auto run = run_arete({verb, scheme});
      EXPECT_EQ(run.exit_code, 2) << verb << " " << scheme << run.out;
      EXPECT_NE(run.err.find(reason), std::string::npos) << scheme << ": " << run.err;
      EXPECT_TRUE(run.out.empty()) << scheme;
    }
}

TEST(cli_hostile_scheme, schemes_that_do_not_converge_are_called_so) {
  for (const char* scheme :
       {"four-point:omega=1/2", "four-point:omega=4", "four-parameter:lambda=1,mu=0,omega=0",
        "mask:arity=2,first=0,coefficients=1;1", "mask:arity=2,first=0,coefficients=1;0;0;1",
        "corner-cutting:u=2,v=2", "mask:arity=2,first=0,coefficients=1000000;1;-999999"}) {
    const auto a = run_json({"analyze", scheme, "--json"});
    EXPECT_EQ(a.at("smoothness").at("certified"), -1) << scheme;
    EXPECT_EQ(a.at("refuted_at"), 0) << scheme;
    EXPECT_TRUE(a.at("overshoot").is_null()) << scheme;
    const auto text = run_arete({"analyze", scheme});
    EXPECT_NE(text.out.find("does not converge"), std::string::npos) << text.out;
  }
}

// 64-bit overflow must not exist: next to the 4-point scheme by 10^-300, on either side.
TEST(cli_hostile_scheme, numbers_of_hundreds_of_digits_are_exact) {
  const std::string tiny = "1/1" + std::string(300, '0');
  const auto near =
      run_json({"analyze", "four-parameter:lambda=0,mu=0,nu=1/2,omega=" + tiny, "--json"});
  EXPECT_EQ(near.at("smoothness").at("certified"), 1);
  const auto beyond =
      run_json({"analyze", "four-parameter:lambda=0,mu=0,nu=1/2,omega=-" + tiny, "--json"});
  EXPECT_EQ(beyond.at("smoothness").at("certified"), 0);
  EXPECT_EQ(beyond.at("refuted_at"), 1);
}

// The limit is a promise about time: twice the limit and five seconds, whatever the mask. The factor
// here is room for a busy machine.
TEST(cli_hostile_scheme, an_answer_or_a_refusal_comes_within_the_time_limit) {
  const std::string dense = "1" + std::string(60, '0');
  for (const std::string& scheme :
       {binary_mask(64, "1000"), binary_mask(64, dense), binary_mask(1000, "1000"),
        binary_mask(1000, dense), binary_mask(40, dense)}) {
    const auto start = std::chrono::steady_clock::now();
    const auto run = run_arete({"analyze", scheme, "--json", "--timeout", "1"});
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    EXPECT_LT(seconds.count(), 30);
    if (run.exit_code == 0) {
      const auto a = nlohmann::json::parse(run.out);
      EXPECT_TRUE(a.contains("complete"));
    } else {
      EXPECT_EQ(run.exit_code, 1) << run.err;
      EXPECT_NE(run.err.find("--timeout"), std::string::npos) << run.err;
      EXPECT_TRUE(run.out.empty());
    }
  }
}

TEST(cli_hostile_scheme, without_time_everything_is_undecided_and_said_to_be) {
  const auto a = run_json({"analyze", "ternary-two-step:b=6/5", "--json", "--timeout", "1e-9"});
  EXPECT_EQ(a.at("complete"), false);
  EXPECT_TRUE(a.at("stable").is_null());
  const auto text = run_arete({"analyze", "ternary-two-step:b=6/5", "--timeout", "1e-9"});
  EXPECT_NE(text.out.find("--timeout"), std::string::npos);
  EXPECT_EQ(run_arete({"analyze", "gentle", "--timeout", "-1"}).exit_code, 2);
}

TEST(cli_hostile_scheme, a_map_over_values_without_schemes_is_drawn) {
  const test::TemporaryFolder folder;
  const auto run = run_arete({"map", "two-parameter", folder.file("m.csv"), "--x", "a=-9:9:7"});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_NE(run.out.find("without scheme"), std::string::npos) << run.out;
}

}  // namespace
}  // namespace arete
