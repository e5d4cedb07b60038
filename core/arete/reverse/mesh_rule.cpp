// SPDX-License-Identifier: MIT
#include <array>
#include <utility>

#include "arete/reverse/mesh_step.h"

namespace arete {
namespace {

template <class T, std::size_t N>
using Names = std::array<std::pair<T, std::string_view>, N>;

constexpr Names<MeshScheme, 4> schemes{{{MeshScheme::catmull_clark, "catmull-clark"},
                                        {MeshScheme::loop, "loop"},
                                        {MeshScheme::loop_warren, "loop-warren"},
                                        {MeshScheme::doo_sabin, "doo-sabin"}}};
constexpr Names<MeshRim, 3> rims{{{MeshRim::smooth, "smooth"},
                                  {MeshRim::sharp_corners, "sharp-corners"},
                                  {MeshRim::thirds, "thirds"}}};

template <class T, std::size_t N>
std::optional<T> parsed(const Names<T, N>& names, std::string_view text) {
  for (const auto& [value, name] : names)
    if (name == text) return value;
  return std::nullopt;
}

template <class T, std::size_t N>
std::string_view name_of(const Names<T, N>& names, T wanted) {
  for (const auto& [value, name] : names)
    if (value == wanted) return name;
  return {};
}

}  // namespace

std::optional<MeshScheme> parse_mesh_scheme(std::string_view text) { return parsed(schemes, text); }
std::string_view to_string(MeshScheme scheme) { return name_of(schemes, scheme); }
std::optional<MeshRim> parse_mesh_rim(std::string_view text) { return parsed(rims, text); }
std::string_view to_string(MeshRim rim) { return name_of(rims, rim); }

}  // namespace arete
