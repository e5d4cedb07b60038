// SPDX-License-Identifier: MIT
#include "cli/palette_json.h"

#include <algorithm>
#include <fstream>
#include <initializer_list>
#include <iterator>

#include "arete/vtk/error.h"
#include "cli/color.h"
#include "cli/error.h"
#include "cli/scheme_json.h"

namespace arete::cli {
namespace {

/// A JSON object and its place, for messages.
class Node {
 public:
  Node(const Json& json, std::string where, std::string place)
      : json_(json), where_(std::move(where)), place_(std::move(place)) {
    if (!json_.is_object()) fail("", "must be an object, {...}");
  }

  void allow_only(std::initializer_list<const char*> keys) const {
    std::string known;
    for (const char* key : keys) known += (known.empty() ? "" : ", ") + std::string(key);
    for (const auto& item : json_.items()) {
      if (std::find(keys.begin(), keys.end(), item.key()) == keys.end())
        fail(item.key(), "is no key here; there may be: " + known);
    }
  }

  [[nodiscard]] bool has(const char* key) const { return json_.contains(key); }

  [[nodiscard]] std::string text(const char* key, const std::string& otherwise) const {
    if (!has(key)) return otherwise;
    if (!json_[key].is_string()) fail(key, "must be a text");
    return json_[key].get<std::string>();
  }
  [[nodiscard]] double number(const char* key, double otherwise) const {
    if (!has(key)) return otherwise;
    if (!json_[key].is_number()) fail(key, "must be a number");
    return json_[key].get<double>();
  }
  /// Whether the text is the first of two words; the first when there is none.
  [[nodiscard]] bool first_of(const char* key, const char* first, const char* second) const {
    const std::string word = text(key, first);
    if (word != first && word != second)
      fail(key, "must be \"" + std::string(first) + "\" or \"" + second + "\"");
    return word == first;
  }
  [[nodiscard]] vtk::Rgb color(const char* key) const {
    if (!has(key)) fail(key, "is missing");
    const Json& value = json_[key];
    if (value.is_string()) {
      if (const auto color = parse_color(value.get<std::string>())) return *color;
    } else if (value.is_array() && value.size() == 3) {
      vtk::Rgb color{};
      bool good = true;
      for (std::size_t c = 0; c < 3; ++c) {
        good = good && value[c].is_number_integer() && value[c] >= 0 && value[c] <= 255;
        if (good) color[c] = value[c].get<std::uint8_t>();
      }
      if (good) return color;
    }
    fail(key, "must be \"#rrggbb\" or [red, green, blue] with whole numbers from 0 to 255");
  }
  [[nodiscard]] Node at(const char* key) const { return {json_[key], where_, inner(key)}; }
  [[nodiscard]] const Json& list(const char* key) const {
    if (!has(key) || !json_[key].is_array() || json_[key].empty())
      fail(key, "must be a list with at least one entry");
    return json_[key];
  }
  [[noreturn]] void fail(const std::string& key, const std::string& what) const {
    const std::string place = key.empty() ? place_ : inner(key);
    throw Failure("the palette " + where_ + ": " + (place.empty() ? "the file" : place) + " " +
                  what);
  }

 private:
  [[nodiscard]] std::string inner(const std::string& key) const {
    return place_.empty() ? key : place_ + "." + key;
  }

  const Json& json_;
  std::string where_;
  std::string place_;
};

std::optional<vtk::Window> window(const Node& layer, const char* key, double lowest,
                                  double highest) {
  if (!layer.has(key)) return std::nullopt;
  const Node node = layer.at(key);
  node.allow_only({"from", "to", "fade"});
  if (!node.has("from") && !node.has("to")) node.fail("", "needs \"from\" or \"to\"");
  const vtk::Window result{node.number("from", lowest), node.number("to", highest),
                           node.number("fade", 0)};
  if (result.fade < 0) node.fail("fade", "must not be negative");
  return result;
}

std::optional<vtk::Window> ordered_window(const Node& layer, const char* key, double lowest,
                                          double highest) {
  const auto result = window(layer, key, lowest, highest);
  if (result && result->from > result->to) layer.at(key).fail("from", "must not be above \"to\"");
  return result;
}

vtk::PaletteLayer read_layer(const Node& node) {
  node.allow_only({"name", "color", "opacity", "height", "slope", "aspect"});
  vtk::PaletteLayer layer;
  layer.name = node.text("name", "");
  layer.color = node.color("color");
  layer.opacity = node.number("opacity", 1);
  if (!(layer.opacity >= 0 && layer.opacity <= 1)) node.fail("opacity", "must be from 0 to 1");
  constexpr double far = 1e9;
  layer.height = ordered_window(node, "height", -far, far);
  layer.slope = ordered_window(node, "slope", 0, 90);
  if (node.has("aspect") && !(node.at("aspect").has("from") && node.at("aspect").has("to")))
    node.at("aspect").fail("", "needs \"from\" and \"to\", degrees clockwise from north");
  layer.aspect = window(node, "aspect", 0, 360);
  return layer;
}

}  // namespace

vtk::Palette palette_from_json(const std::string& text, const std::string& where) {
  Json json;
  try {
    json = Json::parse(text);
  } catch (const Json::exception& error) {
    throw Failure("the palette " + where + " is not JSON: " + error.what());
  }
  const Node root(json, where, "");
  root.allow_only({"name", "heights", "slopes", "layers"});
  vtk::Palette palette;
  palette.name = root.text("name", where);
  palette.relative_heights = root.first_of("heights", "relative", "absolute");
  palette.drawn_slopes = root.first_of("slopes", "drawn", "true");
  const Json& layers = root.list("layers");
  for (std::size_t k = 0; k < layers.size(); ++k)
    palette.layers.push_back(
        read_layer(Node(layers[k], where, "layers[" + std::to_string(k) + "]")));
  return palette;
}

vtk::Palette read_palette(const std::string& argument) {
  if (!argument.ends_with(".json")) {
    try {
      return vtk::find_palette(argument);
    } catch (const vtk::RenderError& error) {
      throw Misuse(std::string("--palette: ") + error.what());
    }
  }
  std::ifstream stream(argument);
  if (!stream) throw Failure("the palette " + argument + " cannot be read; check the path");
  return palette_from_json({std::istreambuf_iterator<char>(stream), {}}, argument);
}

}  // namespace arete::cli
