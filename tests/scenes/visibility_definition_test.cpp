// SPDX-License-Identifier: GPL-3.0-or-later
// The pipeline's profiles, clipped, against their definition: with profiles as occluders, ink is
// what stands above all nearer profiles.
#include "dem/read/read_raster.hpp"
#include "placing/placed_view.hpp"
#include "placing/sector.hpp"
#include "profiles/cut_surface.hpp"
#include "profiles/profile.hpp"
#include "tests/catch.hpp"
#include "tests/horizon/check_clip.hpp"
#include "tests/scenes/random_scene.hpp"
#include "tests/support/random.hpp"
#include "tests/support/sample_names.hpp"

namespace orograph::visibility_definition_test {
namespace {

FlatScene cut_all(const TerrainData& terrain, const PlacedView& scene) {
  const SurfaceCutter cutter(terrain.surface, scene.view, scene.level.triangles, scene.for_cutters);
  FlatScene flat;
  Profile profile;
  std::vector<Segment> uprights;
  for (const double depth : scene.depths_m) {
    cutter.cut(depth, profile);
    project_profile(profile, static_cast<std::uint32_t>(flat.size()), scene.view,
                    flat.emplace_back(), uprights);
  }
  return flat;
}

Tally check(const TerrainData& terrain, MapSpec spec, std::uint64_t seed) {
  spec.style.light.reset(); // tone takes most of the time, whichever profiles there are
  spec.style.spread = Spread::planes;
  const PlacedView scene = placed_view(terrain, spec);
  const TieTolerance tolerance =
      tie_tolerance(scene.sectors.front(), spec.style.visibility_tolerance_mm);
  return check_clip(cut_all(terrain, scene), tolerance.mm, tolerance.page, tolerance.greatest_y,
                    seed);
}

} // namespace

TEST_CASE("every piece of 400 made scenes is above all nearer profiles, or is not, as it claims",
          "[slow]") {
  Tally sum;
  for (std::uint64_t seed = 1; seed <= last_seed(400); ++seed) {
    const RandomScene scene = random_scene(seed);
    CAPTURE(seed, scene.what);
    const Tally tally = check(scene.terrain, scene.spec, seed);
    REQUIRE(tally.wrong == 0);
    REQUIRE(tally.asked > 0);
    sum.asked += tally.asked;
    sum.ties += tally.ties;
    sum.visible += tally.visible;
    sum.hidden += tally.hidden;
  }
  WARN(sum.asked << " asked, " << sum.ties << " ties; pieces visible " << sum.visible << ", hidden "
                 << sum.hidden);
  // The check must have had something to check.
  CHECK(sum.hidden > sum.visible / 50);
  CHECK(sum.ties < sum.asked / 20);
}

TEST_CASE("and of the samples, from eight sides", "[slow]") {
  for (const char* name : sample_names()) {
    const TerrainData terrain =
        read_raster(std::string(OROGRAPH_SOURCE_DIR "/data_samples/") + name + ".tif");
    for (int side = 0; side < static_cast<int>(last_seed(8)); ++side) {
      CAPTURE(name, side);
      MapSpec spec;
      spec.view.from_azimuth = Angle::degrees(45.0 * side + (side % 2 ? 3.7 : 0));
      spec.view.from_elevation = Angle::degrees(5 + 7 * side);
      if (side >= 5) spec.view.projection = Projection::orthographic;
      spec.style.plan = ProfileCount{14};
      const Tally tally = check(terrain, spec, static_cast<std::uint64_t>(side));
      REQUIRE(tally.wrong == 0);
      REQUIRE(tally.asked > enough(1000));
    }
  }
}

} // namespace orograph::visibility_definition_test
