// SPDX-License-Identifier: MIT
#include "arete/analysis/certificate.h"

#include <gtest/gtest.h>

#include "analysis/oracle_scheme.h"

namespace arete {
namespace {

using test::exact;

TEST(Certificate, MeetsTheSmoothnessOracle) {
  for (const auto& record : test::parametric_records("smoothness")) {
    SCOPED_TRACE(record.at("id").get<std::string>());
    const Certificate certificate = certify(test::mask_of(record.at("input")), 8);
    const auto& expect = record.at("expect");
    EXPECT_EQ(certificate.order, expect.at("certified").get<int>());
    EXPECT_EQ(certificate.proofs.size(), expect.at("L_used").size());
    for (const OrderProof& proof : certificate.proofs) {
      EXPECT_EQ(proof.power, expect.at("L_used").at(std::to_string(proof.order)).get<int>());
      EXPECT_LT(proof.norm, 1);
    }
    EXPECT_FALSE(certificate.exhausted);
  }
}

TEST(ContractivityNorm, MeetsTheOracleOfNorms) {
  for (const auto& record : test::parametric_records("norms")) {
    SCOPED_TRACE(record.at("id").get<std::string>());
    const Mask mask = test::mask_of(record.at("input"));
    const auto norms = test::exact_list(record.at("expect"));
    for (std::size_t i = 0; i < norms.size(); ++i)
      EXPECT_EQ(
          contractivity_norm(mask, record.at("input").at("k").get<int>(), static_cast<int>(i) + 1),
          norms[i]);
  }
}

TEST(ContractivityNorm, MeetsTheTernaryOracle) {
  for (const auto& record : test::ternary_and_reverse_records("t.norm_L2")) {
    SCOPED_TRACE(record.at("id").get<std::string>());
    const Mask mask = test::ternary_mask(record.at("input"));
    for (int n = 1; n <= 3; ++n)
      EXPECT_EQ(contractivity_norm(mask, n - 1, 2),
                exact(record.at("expect").at("S" + std::to_string(n))));
  }
  for (const auto& record : test::ternary_and_reverse_records("t.norm_L")) {
    SCOPED_TRACE(record.at("id").get<std::string>());
    const auto& input = record.at("input");
    EXPECT_EQ(contractivity_norm(test::ternary_mask(input), input.at("n").get<int>() - 1,
                                 input.at("L").get<int>()),
              exact(record.at("expect").at("norm")));
  }
}

TEST(ContractivityNorm, NeedsTheSumRules) {
  EXPECT_EQ(contractivity_norm(make_scheme("craggy").mask(), 2, 1), std::nullopt);
}

// A step of the squared scheme is two steps, so its powers are the even ones.
TEST(Certificate, TwoStepsProveWhatEvenPowersProve) {
  for (const char* name : {"four-point", "gentle", "chaikin", "ternary-two-step"}) {
    const Mask mask = make_scheme(name).mask();
    const Mask twice = iterated(mask, 2);
    for (int order = 0; order < 2; ++order)
      for (int power = 1; power <= 3; ++power)
        EXPECT_EQ(contractivity_norm(twice, order, power),
                  contractivity_norm(mask, order, 2 * power))
            << name << " order " << order << " power " << power;
  }
}

TEST(Certificate, OfSplinesIsSharp) {
  for (int degree = 1; degree <= 12; ++degree) {
    const Certificate certificate = certify(make_scheme("b-spline", {{"degree", {degree}}}).mask());
    EXPECT_EQ(certificate.order, degree - 1);
    EXPECT_EQ(certificate.power, 1);
    EXPECT_EQ(certificate.norm, Rational(1, 2));
  }
}

TEST(Certificate, EndsOnBigMasks) {
  const Certificate nine = certify(make_scheme("ternary-two-step-9", {{"b", {2}}}).mask(), 8);
  EXPECT_EQ(nine.order, 1);  // C^1 for -3.147 < b < 4.205, C^2 only up to 0.619
  EXPECT_TRUE(nine.exhausted);
  std::vector<Rational> taps(600, Rational(0));
  for (int i = 0; i < 600; ++i) taps[static_cast<std::size_t>(i)] = Rational(i % 7 - 3, 97 + i);
  Rational even = 0;
  Rational odd = 0;
  for (std::size_t i = 2; i < taps.size(); ++i) (i % 2 == 0 ? even : odd) += taps[i];
  taps[0] = 1 - even;
  taps[1] = 1 - odd;
  const Certificate wild = certify(Mask(2, 0, taps), 8);
  EXPECT_EQ(wild.order, -1);
}

}  // namespace
}  // namespace arete
