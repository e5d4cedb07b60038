// SPDX-License-Identifier: MIT
#include "arete/fit/parameter_space.h"

#include <algorithm>
#include <cstdio>

#include "arete/analysis/polynomial.h"
#include "arete/scheme/catalogue.h"

namespace arete {
namespace {

// Small enough to stay in every accepted range from any usual start.
const Rational& probe() {
  static const Rational step(1, 64);
  return step;
}

Rational decimal(double value) {
  char text[64];
  std::snprintf(text, sizeof text, "%.12f", value);
  return parse_rational(text);
}

// Vectors that span all x with sum_j laws[i][j] x_j = 0, by exact elimination.
std::vector<std::vector<Rational>> null_space(std::vector<std::vector<Rational>> laws,
                                              std::size_t columns) {
  std::vector<std::size_t> pivots;
  std::size_t row = 0;
  // From the last column on, so that the later unknowns are expressed by the earlier ones.
  for (std::size_t c = columns; c-- > 0 && row < laws.size();) {
    std::size_t found = row;
    while (found < laws.size() && laws[found][c] == 0) ++found;
    if (found == laws.size()) continue;
    std::swap(laws[row], laws[found]);
    const Rational pivot = laws[row][c];
    for (Rational& x : laws[row]) x /= pivot;
    for (std::size_t i = 0; i < laws.size(); ++i) {
      const Rational factor = laws[i][c];
      if (i == row || factor == 0) continue;
      for (std::size_t j = 0; j < columns; ++j) laws[i][j] -= factor * laws[row][j];
    }
    pivots.push_back(c);
    ++row;
  }
  std::vector<std::vector<Rational>> basis;
  for (std::size_t c = 0; c < columns; ++c) {
    if (std::count(pivots.begin(), pivots.end(), c) > 0) continue;
    std::vector<Rational> x(columns, Rational(0));
    x[c] = 1;
    for (std::size_t i = 0; i < pivots.size(); ++i) x[pivots[i]] = -laws[i][c];
    basis.push_back(std::move(x));
  }
  return basis;
}

}  // namespace

ParameterSpace::ParameterSpace(const Scheme& start, const std::vector<std::string>& names)
    : start_(start) {
  std::vector<Move> moves;
  if (names.empty()) {
    std::vector<std::string> candidates;
    for (const Parameter& p : find_family(start.name()).parameters)
      if (p.kind != ParameterKind::integer) candidates.push_back(p.name);
    std::reverse(candidates.begin(), candidates.end());
    for (const std::string& name : candidates) {
      std::vector<Move> more = moves_of(name);
      more.insert(more.end(), moves.begin(), moves.end());
      if (!affine_with(more)) continue;
      moves = std::move(more);
      names_.insert(names_.begin(), name);
    }
  } else {
    names_ = names;
    for (const std::string& name : names)
      for (Move& move : moves_of(name)) moves.push_back(std::move(move));
    if (!affine_with(moves))
      throw InvalidScheme(start.name() +
                          ": the mask is not linear in these parameters together; free fewer of "
                          "them");
  }
  keep_laws(moves);
  if (moves_.empty())
    throw InvalidScheme(
        start.text() +
        " has no parameter that can move linearly without moving samples or "
        "breaking planes; take a family with such parameters, e.g. four-parameter or four-point");
}

std::vector<ParameterSpace::Move> ParameterSpace::moves_of(const std::string& name) const {
  const ParameterValues& values = start_.parameters();
  const auto& parameters = find_family(start_.name()).parameters;
  const auto found = std::find_if(parameters.begin(), parameters.end(),
                                  [&](const Parameter& p) { return p.name == name; });
  if (found == parameters.end())
    throw InvalidScheme(start_.name() + " has no parameter '" + name + "' to free");
  if (found->kind == ParameterKind::integer)
    throw InvalidScheme(start_.name() + ": " + name + " is a whole number and cannot be fitted");
  std::vector<Move> moves;
  if (found->repeats) {
    // name0, name1, ... keep their sum, which the family prescribes.
    std::vector<std::size_t> places;
    for (std::size_t i = 0; i < values.size(); ++i)
      if (values[i].name.rfind(name, 0) == 0 &&
          values[i].name.find_first_not_of("0123456789", name.size()) == std::string::npos)
        places.push_back(i);
    for (std::size_t i = 0; i + 1 < places.size(); ++i)
      moves.push_back({{places[i], 0, 1}, {places[i + 1], 0, -1}});
    return moves;
  }
  const auto value = static_cast<std::size_t>(
      std::find_if(values.begin(), values.end(),
                   [&](const ParameterValue& v) { return v.name == name; }) -
      values.begin());
  if (found->kind == ParameterKind::real) return {{{value, 0, 1}}};
  // Coefficients of a mask keep the sum of their phase.
  const auto arity = static_cast<std::size_t>(start_.mask().arity());
  for (std::size_t i = 0; i + arity < values[value].numbers.size(); ++i)
    moves.push_back({{value, i, 1}, {value, i + arity, -1}});
  return moves;
}

Mask ParameterSpace::mask_after(const std::vector<Move>& moves) const {
  ParameterValues values = start_.parameters();
  for (const Move& move : moves)
    for (const Change& change : move)
      values[change.value].numbers[change.number] += probe() * change.by;
  return make_scheme(start_.name(), values).mask();
}

bool ParameterSpace::affine_with(const std::vector<Move>& moves) const {
  const auto& zero = start_.mask().symbol();
  std::vector<LaurentPolynomial<Rational>> once;
  for (const Move& move : moves) once.push_back(mask_after({move}).symbol() - zero);
  for (std::size_t i = 0; i < moves.size(); ++i)
    for (std::size_t j = i; j < moves.size(); ++j)
      if (!(mask_after({moves[i], moves[j]}).symbol() - zero == once[i] + once[j])) return false;
  return true;
}

void ParameterSpace::keep_laws(const std::vector<Move>& moves) {
  const int arity = start_.mask().arity();
  const bool both = sum_rules(start_.mask()) >= 2;
  std::vector<std::vector<Rational>> laws(both ? static_cast<std::size_t>(arity) : 1,
                                          std::vector<Rational>(moves.size(), Rational(0)));
  for (std::size_t j = 0; j < moves.size(); ++j) {
    const auto change = mask_after({moves[j]}).symbol() - start_.mask().symbol();
    for (int k = change.lowest(); k <= change.highest(); ++k) {
      const int phase = ((k % arity) + arity) % arity;
      laws[both ? static_cast<std::size_t>(phase) : 0][j] += k * change[k];
    }
  }
  for (const auto& x : null_space(std::move(laws), moves.size())) {
    Move sum;
    for (std::size_t j = 0; j < moves.size(); ++j)
      for (const Change& change : moves[j])
        if (x[j] != 0) sum.push_back({change.value, change.number, x[j] * change.by});
    moves_.push_back(std::move(sum));
  }
}

Scheme ParameterSpace::at(const std::vector<double>& u) const {
  ParameterValues values = start_.parameters();
  for (std::size_t i = 0; i < moves_.size(); ++i) {
    const Rational step = decimal(u[i]);
    for (const Change& change : moves_[i])
      values[change.value].numbers[change.number] += step * change.by;
  }
  return make_scheme(start_.name(), values);
}

}  // namespace arete
