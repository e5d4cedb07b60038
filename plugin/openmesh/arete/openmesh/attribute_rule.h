// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>

namespace arete::openmesh {

/// How the values of a vertex property reach new vertices.
enum class AttributeRule {
  scheme,  ///< the weights of the subdivision scheme, as for positions
  linear,  ///< bilinear between the four old vertices around: never beyond their values
  nearest  ///< the value of the nearest old vertex (labels, identifiers)
};

/// The rules by kind of property, and by name where one property shall differ.
///
/// Integers are rounded to the nearest and held within their type, so an overshoot never wraps
/// round; colours are held within 0..255 or 0..1. Values that are no numbers (bool, std::string,
/// your own struct) are always `nearest`.
struct AttributeRules {
  AttributeRule points = AttributeRule::scheme;
  AttributeRule texcoords = AttributeRule::linear;
  AttributeRule colors = AttributeRule::linear;
  AttributeRule custom = AttributeRule::linear;
  /// By the property's name in the mesh, such as "v:colors" or that given to add_property.
  std::map<std::string, AttributeRule> by_name;
};

}  // namespace arete::openmesh
