// SPDX-License-Identifier: MIT
#include "cli/map_plane.h"

#include <algorithm>

#include "cli/error.h"

namespace arete::cli {

MapRange parse_range(const std::string& text, const char* option) {
  const std::string form = std::string(option) + " '" + text +
                           "' is not of the form KEY=LOW:HIGH:COUNT, e.g. omega=0:1/2:101";
  const auto equals = text.find('=');
  const auto first = text.find(':');
  const auto second = first == std::string::npos ? first : text.find(':', first + 1);
  if (equals == std::string::npos || equals == 0 || second == std::string::npos || first < equals)
    throw Misuse(form);
  MapRange range{text.substr(0, equals), {}, {}};
  std::string keys = range.name + ",";
  for (auto comma = keys.find(','); comma != std::string::npos; comma = keys.find(',')) {
    range.keys.push_back(keys.substr(0, comma));
    keys.erase(0, comma + 1);
  }
  Rational low, high;
  Rational count;
  try {
    low = parse_rational(text.substr(equals + 1, first - equals - 1));
    high = parse_rational(text.substr(first + 1, second - first - 1));
    count = parse_rational(text.substr(second + 1));
  } catch (const std::invalid_argument&) {
    throw Misuse(form);
  }
  if (!is_integer(count) || count < 1 || count > 2000)
    throw Misuse(std::string(option) + ": the count must be an integer from 1 to 2000");
  const int n = static_cast<int>(boost::multiprecision::numerator(count));
  for (int i = 0; i < n; ++i)
    range.values.push_back(n == 1 ? low : Rational(low + (high - low) * i / (n - 1)));
  return range;
}

MapPlane::MapPlane(const std::string& text, const MapRange& x, const MapRange& y)
    : x_(x.keys), y_(y.keys) {
  family_ = text.substr(0, text.find(':'));
  // Keys of the map get a value here, so that a parameter without default may be left to it. The
  // ends of a range may lie outside what is accepted; those points have no scheme.
  const auto with = [&](std::size_t percent) {
    std::string all = text;
    for (const MapRange* range : {&x, &y})
      for (const std::string& key : range->keys)
        all += (all.find(':') == std::string::npos ? ":" : ",") + key + "=" +
               to_string(range->values[(range->values.size() - 1) * percent / 100]);
    return parse_scheme(all).parameters();
  };
  for (const std::size_t percent : {50U, 25U, 75U, 0U}) {
    try {
      values_ = with(percent);
      return;
    } catch (const InvalidScheme&) {
      continue;
    }
  }
  values_ = with(100);
}

std::optional<Scheme> MapPlane::scheme(const Rational& x, const Rational& y) const {
  ParameterValues values = values_;
  for (ParameterValue& value : values) {
    if (std::find(x_.begin(), x_.end(), value.name) != x_.end()) value.numbers = {x};
    if (std::find(y_.begin(), y_.end(), value.name) != y_.end()) value.numbers = {y};
  }
  try {
    return make_scheme(family_, values);
  } catch (const InvalidScheme&) {
    return std::nullopt;
  }
}

}  // namespace arete::cli
