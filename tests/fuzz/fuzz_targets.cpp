// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fuzz/fuzz_targets.hpp"

#include <algorithm>
#include <iterator>
#include <vector>

namespace orograph {
namespace {

constexpr FuzzTarget kTargets[] = {
    {"raster", fuzz_raster},   {"off", fuzz_off},           {"ply", fuzz_ply},
    {"obj", fuzz_obj},         {"stl", fuzz_stl},           {"landxml", fuzz_landxml},
    {"points", fuzz_points},   {"vector", fuzz_vector},     {"overlay", fuzz_overlay},
    {"places", fuzz_places},   {"levels", fuzz_levels},     {"view", fuzz_view},
    {"views", fuzz_view_list}, {"scene", fuzz_scene},       {"pens", fuzz_pens},
    {"device", fuzz_device},   {"settings", fuzz_settings}, {"report", fuzz_report},
    {"plan", fuzz_plan},       {"rows", fuzz_rows},         {"options", fuzz_options},
    {"values", fuzz_values},   {"clip", fuzz_clip},         {"pass", fuzz_pass},
    {"svg", fuzz_svg},         {"hpgl", fuzz_hpgl},         {"gcode", fuzz_gcode},
};

} // namespace

std::span<const FuzzTarget> fuzz_targets() {
  static const std::vector<FuzzTarget> there = [] {
    std::vector<FuzzTarget> found;
    std::ranges::copy_if(kTargets, std::back_inserter(found),
                         [](const FuzzTarget& target) { return target.run != nullptr; });
    return found;
  }();
  return there;
}

} // namespace orograph
