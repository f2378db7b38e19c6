// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/options/named_fields.hpp"

#include <array>
#include <string_view>
#include <utility>

namespace orograph {
namespace {

// Fields that messages of the library name, with what sets them on the command line.
constexpr std::array<std::pair<std::string_view, std::string_view>, 46> kOptions{{
    {"terrain", "INPUT"},
    {"solids", "--scene"},
    // ReadOptions
    {"allow_network", "--allow-network"},
    {"bbox", "--bbox"},
    {"bbox_lonlat", "--bbox-lonlat"},
    {"overview", "--overview"},
    {"height_unit", "--height-unit"},
    {"fill_voids", "--fill-voids"},
    {"max_memory", "--max-memory"},
    {"layer", "--input-layer"},
    {"repair", "--repair"},
    {"columns", "--columns"},
    {"height_field", "--height-field"},
    {"breaklines", "--breaklines"},
    {"boundary", "--boundary"},
    {"max_edge_m", "--max-edge"},
    // ViewSpec
    {"from_azimuth", "--view-from AZ/EL"},
    {"distance_m", "--distance"},
    {"field_of_view", "--fov"},
    {"azimuth_range", "--azimuth-range"},
    {"altitude_range", "--altitude-range"},
    {"eye_map", "--eye"},
    {"eye_lonlat", "--eye-lonlat"},
    {"eye_summit_m", "--eye-summit"},
    {"look_at_map", "--look-at"},
    {"look_at_lonlat", "--look-at-lonlat"},
    {"curvature", "--curvature"},
    {"projection", "--projection"},
    {"step_m", "--eye-step"},
    // LabelSpec
    {"labels.field", "--label-field"},
    {"labels.weight_field", "--label-weight"},
    // Style
    {"plan", "--spacing"},
    {"block", "--block"},
    {"check", "--check"},
    {"check_of_file", "--check file"},
    {"underside", "--underside draw"},
    {"from_elevation", "the elevation of --view-from"},
    // PageRequest
    {"page", "--page"},
    {"scale", "--scale"},
    {"margin_mm", "--margin"},
    {"pens", "--pens"},
    {"furniture", "--furniture"},
    {"overlap_mm", "--overlap"},
    // WriteOptions
    {"format", "--of"},
    {"overwrite", "--overwrite"},
    {"device", "--device"},
}};

} // namespace

std::string with_options(std::string message) {
  for (const auto& [field, option] : kOptions) {
    const std::string named = "`" + std::string(field) + "`";
    for (std::size_t at = message.find(named); at != std::string::npos;
         at = message.find(named, at + option.size()))
      message.replace(at, named.size(), option);
  }
  return message;
}

} // namespace orograph
