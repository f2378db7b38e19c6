// SPDX-License-Identifier: GPL-3.0-or-later
// Whole scenes, drawn and asked of the ray walk.
#pragma once

#include "map/draw_map.hpp"
#include "tests/catch.hpp"

#include <cstdint>

namespace orograph {

struct Asked {
  std::uint64_t scenes = 0, asked = 0, ties = 0, hidden = 0, missing = 0;

  void add(const CheckCounts& check) {
    ++scenes;
    asked += check.asked;
    ties += check.ties;
    hidden += check.hidden;
    missing += check.missing;
  }
};

/// Draws with every fold and the outlines of voids, and nothing simplified; checks that nothing
/// drawn is hidden and nothing visible is missing, and that the drawing has no fault. Throws what
/// placed_view throws.
inline CheckCounts ask(const TerrainData& terrain, MapSpec spec, std::uint64_t probes) {
  spec.style.occluder = Occluder::surface;
  spec.style.simplify_mm = 0;
  spec.style.silhouette_jump = 0;
  spec.style.layers.push_back("voids");
  spec.check = probes;
  const PlacedView scene = placed_view(terrain, spec);
  const Map drawn = draw_map(terrain, scene, spec, [](double) {}, {.order_always = true});
  const auto fault = find_fault(drawn.drawing);
  INFO(fault.value_or(""));
  REQUIRE(!fault);
  REQUIRE(drawn.facts.check);
  CHECK(drawn.facts.check->hidden == 0);
  CHECK(drawn.facts.check->missing == 0);
  return *drawn.facts.check;
}

inline void report(const char* what, const Asked& sum) {
  WARN(what << ": " << sum.scenes << " scenes, " << sum.asked << " asked, " << sum.ties << " ties, "
            << sum.hidden << " hidden but drawn, " << sum.missing << " missing");
}

} // namespace orograph
