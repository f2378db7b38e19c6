// SPDX-License-Identifier: GPL-3.0-or-later
// The options of panoramas.
#include "tests/cli/given_options.hpp"

#include <vector>

namespace orograph::panorama_options_test {
namespace {

using namespace given_options;

Arguments panorama(Arguments more) {
  more.insert(more.begin(), {"--projection", "cylindrical", "--eye", "1,2"});
  return more;
}

} // namespace

TEST_CASE("options of panoramas") {
  CHECK(given(panorama({})).map.view.projection == Projection::cylindrical);
  CHECK(!given(panorama({})).map.view.field_of_view);
  CHECK(given(panorama({"--fov", "360"})).map.view.field_of_view == Angle::degrees(360));
  const auto range = given(panorama({"--azimuth-range", "350:370"})).map.view.azimuth_range;
  REQUIRE(range);
  CHECK(range->from == Angle::degrees(350));
  CHECK(range->to == Angle::degrees(370));
  const auto altitudes = given(panorama({"--altitude-range", "-12:8.5"})).map.view.altitude_range;
  REQUIRE(altitudes);
  CHECK(altitudes->low == Angle::degrees(-12));
  CHECK(altitudes->high == Angle::degrees(8.5));
  CHECK(given(panorama({"--strips", "4"})).map.page.strips == 4);
}

TEST_CASE("options that make no panorama") {
  check_refused({"--projection", "panorama"}, "cylindrical");
  check_refused({"--projection", "cylindrical"}, "--eye");
  check_refused(panorama({"--fov", "0"}), "--fov");
  check_refused(panorama({"--fov", "361"}), "360");
  check_refused({"--eye", "1,2", "--fov", "200"}, "--projection cylindrical");
  check_refused(panorama({"--azimuth-range", "350:10"}), "350:370");
  check_refused(panorama({"--azimuth-range", "30:30"}), "30:390");
  check_refused(panorama({"--azimuth-range", "0:361"}), "0:360");
  check_refused(panorama({"--azimuth-range", "30"}), "A less than B");
  check_refused(panorama({"--azimuth-range", "0:90", "--fov", "30"}), "one of the two");
  check_refused(panorama({"--azimuth-range", "0:90", "--look-azimuth", "30"}), "direction");
  check_refused(panorama({"--altitude-range", "10:-10"}), "-10:10");
  check_refused(panorama({"--altitude-range", "-90:10"}), "-80");
  check_refused(panorama({"--strips", "0"}), "1");
  check_refused(panorama({"--look-azimuth", "10", "--pitch", "3"}), "--altitude-range");
  check_refused(panorama({"--roll", "3"}), "--roll");
  check_refused(panorama({"--distance", "3000"}), "--distance");
  check_refused(panorama({"--scale", "1:25000"}), "--scale");
  check_refused(panorama({"--oblique", "cabinet"}), "--oblique");
  check_refused(panorama({"--view", "view.toml"}), "--view");
  check_refused(panorama({"--report", "view.toml"}), ".json");
  for (const char* option : {"--azimuth-range", "--altitude-range"})
    check_refused({"--eye", "1,2", option, "0:20"}, "--projection cylindrical");
  check_refused({"--strips", "2"}, "--projection cylindrical");
}

} // namespace orograph::panorama_options_test
