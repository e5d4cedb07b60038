// SPDX-License-Identifier: MIT
#include "cli/analysis_report.h"

#include <algorithm>
#include <iomanip>
#include <iostream>

#include "arete/algebra/characteristic_polynomial.h"
#include "arete/analysis/local_matrices.h"

namespace arete::cli {
namespace {

const char* verdict_name(Verdict verdict) {
  switch (verdict) {
    case Verdict::certified:
      return "certified";
    case Verdict::refuted:
      return "refuted";
    case Verdict::undecided:
      return "undecided";
  }
  return "";
}

const char* comparison_text(const TheoremResult& theorem, const Smoothness& truth) {
  if (theorem.claims < 0) return theorem.holds ? "checked exactly" : "FALSE here";
  switch (compare(theorem, truth)) {
    case Comparison::confirmed:
      return "confirmed by the certificate";
    case Comparison::contradicted:
      return "CONTRADICTED: this is a counterexample";
    case Comparison::too_weak:
      return "does not apply, although the order is certified";
    case Comparison::silent:
      return "does not apply";
    case Comparison::open:
      return "holds, not decided independently";
  }
  return "";
}

// The statements about the family, and those that this very scheme refutes.
std::vector<TheoremResult> statements(const Scheme& scheme, const Smoothness& truth) {
  std::vector<TheoremResult> all = theorems_for(scheme);
  if (truth.complete && truth.refuted_at)
    if (auto refuted = property_1_refuted_by(scheme)) all.push_back(*std::move(refuted));
  return all;
}

// What a reader needs to check a refutation: the characteristic polynomial of the word's product,
// whose roots the exact test finds too large. Empty where it is too long to read.
std::string word_polynomial(const Scheme& scheme, const OrderVerdict& verdict) {
  constexpr std::size_t readable = 300;
  if (verdict.reason != Reason::word) return {};
  const Mask& mask = scheme.mask();
  const LocalMatrices local = local_matrices(mask.arity(), factored(mask).rest);
  const auto polynomial = characteristic_polynomial(word_product(local, verdict.word));
  std::string text;
  for (std::size_t k = polynomial.size(); k-- > 0;) {
    const Rational& c = polynomial[k];
    if (c == 0) continue;
    const std::string sign = c < 0 ? "-" : "+";
    text += text.empty() ? (c < 0 ? "-" : "") : " " + sign + " ";
    if (abs(c) != 1 || k == 0) text += to_string(Rational(abs(c))) + (k == 0 ? "" : " ");
    if (k > 0) text += k == 1 ? "x" : "x^" + std::to_string(k);
    if (text.size() > readable) return {};
  }
  return text;
}

Json three_valued(bool known, bool value) { return known ? Json(value) : Json(nullptr); }

Json theorem_json(const TheoremResult& theorem, const Smoothness& truth) {
  Json values = Json::array();
  for (const Rational& value : theorem.values) values.push_back(to_string(value));
  Json residuals = Json::array();
  for (const Rational& residual : theorem.residuals) residuals.push_back(to_string(residual));
  Json nonnegative = Json::array();
  for (const Rational& number : theorem.nonnegative) nonnegative.push_back(to_string(number));
  const auto largest = std::max_element(theorem.values.begin(), theorem.values.end());
  return {{"name", theorem.name},
          {"statement", theorem.statement},
          {"claims", theorem.claims},
          {"holds", theorem.holds},
          {"value", largest == theorem.values.end() ? Json(nullptr) : Json(to_string(*largest))},
          {"values", values},
          {"residuals", residuals},
          {"nonnegative", nonnegative},
          {"sound", theorem.sound},
          {"verdict", comparison_text(theorem, truth)},
          {"remark", theorem.remark}};
}

std::string smoothness_text(const Smoothness& truth) {
  std::string text = truth.certified < 0 ? "no order certified"
                                         : "C^" + std::to_string(truth.certified) + " certified";
  if (truth.refuted_at)
    text += *truth.refuted_at == 0 ? "; the scheme does not converge"
                                   : ", not C^" + std::to_string(*truth.refuted_at);
  return text;
}

void print_hoelder(const HoelderBounds& hoelder, bool diverges) {
  std::cout << std::setprecision(10) << "Hoelder exponent   ";
  const bool lower_bound_only = hoelder.stability != Stability::stable;
  if (diverges)
    std::cout << "none: the scheme does not converge";
  else if (hoelder.lower <= 0)
    std::cout << "none proved; at most " << hoelder.upper;
  else if (hoelder.jsr.closed())
    std::cout << (lower_bound_only ? "at least " : "") << hoelder.lower;
  else
    std::cout << hoelder.lower << " .. "
              << (lower_bound_only ? "?" : std::to_string(hoelder.upper));
  if (lower_bound_only && hoelder.lower > 0)
    std::cout << " (a lower bound: the shifts are not "
              << (hoelder.stability == Stability::unstable ? "stable)" : "known to be stable)");
  if (hoelder.attained == Attained::yes) std::cout << ", attained";
  if (hoelder.attained == Attained::no) {
    std::cout << ", not attained";
    if (hoelder.lower == hoelder.upper)
      std::cout << ": C^" << hoelder.lower - 1 << " with every exponent " << hoelder.lower
                << " - eps, not C^" << hoelder.lower;
  }
  if (!hoelder.jsr.word.empty())
    std::cout << "\n    decided by the word " << to_text(hoelder.jsr.word);
  std::cout << "\nshifts             "
            << (hoelder.stability == Stability::stable     ? "stable"
                : hoelder.stability == Stability::unstable ? "not stable"
                                                           : "stability not decided")
            << '\n';
}

void print_statement(const TheoremResult& theorem, const Smoothness& truth) {
  std::cout << "    " << theorem.name << (theorem.sound ? "" : " (false as printed)") << ": "
            << theorem.statement << "\n        ";
  for (const Rational& value : theorem.values) std::cout << "value " << to_string(value) << "  ";
  for (const Rational& residual : theorem.residuals)
    std::cout << "residual " << to_string(residual) << "  ";
  if (theorem.claims >= 0)
    std::cout << (theorem.holds ? "holds" : "does not hold") << ", for C^" << theorem.claims
              << "; ";
  std::cout << comparison_text(theorem, truth) << '\n';
  if (!theorem.remark.empty()) std::cout << "        " << theorem.remark << '\n';
}

}  // namespace

Json analysis_json(const Scheme& scheme, const Smoothness& truth) {
  Json object = describe(scheme);
  object["smoothness"] = {{"certified", truth.certified},
                          {"power", truth.certificate.power},
                          {"norm", to_string(truth.certificate.norm)}};
  object["refuted_at"] = truth.refuted_at ? Json(*truth.refuted_at) : Json(nullptr);
  const HoelderBounds& hoelder = truth.hoelder;
  object["hoelder"] = {{"lower", hoelder.lower},
                       {"upper", hoelder.upper},
                       {"attained", three_valued(hoelder.attained != Attained::unknown,
                                                 hoelder.attained == Attained::yes)},
                       {"word", to_text(hoelder.jsr.word)}};
  object["stable"] =
      three_valued(hoelder.stability != Stability::unknown, hoelder.stability == Stability::stable);
  Json orders = Json::array();
  // The mask of the undivided differences of order k + 1, by which C^k is decided.
  auto differences = scheme.mask().symbol().divided_by_smoothing_factor(scheme.mask().arity());
  for (const OrderVerdict& order : truth.orders) {
    Json entry = {{"order", order.order},
                  {"verdict", verdict_name(order.verdict)},
                  {"proof", explanation(order)},
                  {"difference_mask", nullptr}};
    if (order.reason == Reason::norm) {
      entry["power"] = order.power;
      entry["norm"] = to_string(order.norm);
    }
    if (order.reason == Reason::word) {
      entry["word"] = to_text(order.word);
      entry["word_value"] = order.value;
      entry["word_polynomial"] = word_polynomial(scheme, order);
    }
    if (differences) {
      entry["difference_mask"] = Json::array();
      for (const Rational& c : differences->coefficients())
        entry["difference_mask"].push_back(to_string(c));
      differences = differences->divided_by_smoothing_factor(scheme.mask().arity());
    }
    orders.push_back(std::move(entry));
  }
  object["orders"] = orders;
  Json theorems = Json::array();
  for (const TheoremResult& theorem : statements(scheme, truth))
    theorems.push_back(theorem_json(theorem, truth));
  object["theorems"] = theorems;
  object["complete"] = truth.complete;
  return object;
}

void print_analysis(const Scheme& scheme, const Smoothness& truth) {
  std::cout << "scheme             " << scheme.text() << "\nmask               "
            << coefficients_text(scheme.mask()) << "\nsmoothness         " << smoothness_text(truth)
            << '\n';
  for (const OrderVerdict& order : truth.orders) {
    std::cout << "    C^" << std::left << std::setw(3) << order.order << std::setw(11)
              << verdict_name(order.verdict) << explanation(order) << '\n';
    if (const std::string polynomial = word_polynomial(scheme, order); !polynomial.empty())
      std::cout << "                     its product has the characteristic polynomial "
                << polynomial << '\n';
  }
  print_hoelder(truth.hoelder, truth.refuted_at == 0);
  const std::vector<TheoremResult> theorems = statements(scheme, truth);
  if (!theorems.empty()) std::cout << "published statements\n";
  for (const TheoremResult& theorem : theorems) print_statement(theorem, truth);
  if (!truth.complete)
    std::cout << "stopped by the time limit; more may be decided with a larger --timeout\n";
}

}  // namespace arete::cli
