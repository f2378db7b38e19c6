// SPDX-License-Identifier: GPL-3.0-or-later
// Names on the page: nothing on anything else, all within their room; and lines that end for them.
#include "draw/break_lines.hpp"
#include "tests/catch.hpp"
#include "tests/support/random.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "naming/line_labels.hpp"
#include "naming/names_above.hpp"
#include "naming/names_beside.hpp"
#include "naming/place_names.hpp"

namespace orograph::names_on_page_test {
namespace {

constexpr Box2 kRoom{{10, 10}, {200, 140}};

std::vector<NameToPlace> random_names(Random& random, const Box2& within) {
  std::vector<NameToPlace> names(static_cast<std::size_t>(random.whole(1, 120)));
  for (std::size_t i = 0; i < names.size(); ++i) {
    names[i].summit_mm = {random.between(within.low.x, within.high.x),
                          random.between(within.low.y, within.high.y)};
    names[i].weight = {random.whole(0, 50), static_cast<std::int64_t>(names.size() - i)};
    const double share = random.chance(0.2) ? 0.75 : 1; // long ones are set smaller
    names[i].text.extent = {random.between(3, 45), 2.3 * share, 0.6 * share};
  }
  return names;
}

TurnedBox box_of(const Leader& leader) {
  return orograph::box_of(leader.from_mm, leader.to_mm, 0.05);
}

// How many pairs touch, and how many names are beyond the room.
int faults(const std::vector<PlacedName>& placed, const Box2& room) {
  int count = 0;
  for (std::size_t a = 0; a < placed.size(); ++a) {
    count += is_inside(placed[a].text.box_mm(), room) ? 0 : 1;
    const TurnedBox text = orograph::box_of(placed[a].text);
    for (std::size_t b = 0; b < placed.size(); ++b) {
      count += b < a && overlap(text, orograph::box_of(placed[b].text)) ? 1 : 0;
      if (!placed[b].leader) continue;
      count += overlap(text, box_of(*placed[b].leader)) ? 1 : 0;
      count += b < a && overlap(box_of(*placed[a].leader), box_of(*placed[b].leader)) ? 1 : 0;
    }
  }
  return count;
}

} // namespace

TEST_CASE("names above panoramas touch nothing") {
  const Box2 frame{{10, 70}, {180, 140}};
  for (std::uint64_t seed = 1; seed <= last_seed(250); ++seed) {
    Random random(seed);
    const auto names = random_names(random, frame);
    const double skyline_mm = random.between(71, 100);
    const StripRoom strip{kRoom, [&](double, double) { return skyline_mm; }};
    const Angle angle = Angle::degrees(random.between(20, 90));
    const auto slanted = names_slanted(names, {&strip, 1}, angle, std::nullopt);
    const auto in_rows = names_in_rows(names, {&strip, 1}, random.whole(1, 6), std::nullopt);
    CAPTURE(seed);
    CHECK(faults(slanted, kRoom) == 0);
    CHECK(faults(in_rows, kRoom) == 0);
    for (const PlacedName& name : slanted) CHECK(name.text.box_mm().high.y < skyline_mm);
    CHECK(names_slanted(names, {&strip, 1}, angle, 3).size() ==
          std::min<std::size_t>(slanted.size(), 3));
  }
}

TEST_CASE("names beside summits touch nothing, and the one that counts most has its place") {
  for (std::uint64_t seed = 1; seed <= last_seed(250); ++seed) {
    Random random(seed);
    const auto names = random_names(random, {{11, 11}, {199, 139}});
    Layer ink;
    for (int i = 0; i < 40; ++i) {
      Stroke stroke;
      stroke.first_point = static_cast<std::uint32_t>(ink.page_mm.size());
      stroke.point_count = 2;
      ink.strokes.push_back(stroke);
      for (int k = 0; k < 2; ++k)
        ink.page_mm.push_back({random.between(10, 200), random.between(10, 140)});
    }
    TakenRoom taken;
    const auto placed =
        names_beside(names, kRoom, InkMap({210, 150, 10}, {&ink, 1}), std::nullopt, taken);
    const auto first = std::ranges::max_element(names, {}, &NameToPlace::weight);
    CAPTURE(seed);
    CHECK(faults(placed, kRoom) == 0);
    CHECK(std::ranges::count(placed, static_cast<std::size_t>(first - names.begin()),
                             &PlacedName::name) == 1);
  }
}

TEST_CASE("lines end where a text stands on them") {
  Layer layer;
  layer.page_mm = {{0, 0}, {10, 0}, {20, 0}, {0, 5}, {20, 5}};
  layer.strokes.resize(2);
  layer.strokes[0].point_count = 3;
  layer.strokes[1].first_point = 3;
  layer.strokes[1].point_count = 2;
  const std::array<Vec2, 4> box{{{4, -1}, {12, -1}, {12, 1}, {4, 1}}};
  break_lines(layer, {&box, 1}, 0.5);
  REQUIRE(layer.strokes.size() == 3);
  CHECK(layer.points(layer.strokes[0]).back() == Vec2{4, 0});
  CHECK(layer.points(layer.strokes[1]).front() == Vec2{12, 0});
  CHECK(layer.points(layer.strokes[2]).size() == 2);
  const std::array<Vec2, 4> all_but_a_crumb{{{-1, -1}, {3.8, -1}, {3.8, 1}, {-1, 1}}};
  break_lines(layer, {&all_but_a_crumb, 1}, 0.5);
  CHECK(layer.strokes.size() == 2);
}

TEST_CASE("longitudes and latitudes are printed as maps have them") {
  CHECK(angle_label(7.5, true) == "7°30′E");
  CHECK(angle_label(-71, true) == "71°W");
  CHECK(angle_label(-33.5125, false) == "33°30′45″S");
  CHECK(angle_label(0, false) == "0°");
}

TEST_CASE("places have names, heights and prominences as files spell them") {
  Overlay overlay;
  overlay.source = "peaks.csv";
  overlay.fields = {"Name", "Elevation_ft", "prominence"};
  const auto add = [&](Vec2 at, const Attributes& attributes) {
    overlay.features.push_back({attributes, overlay.lines.size(), 1});
    overlay.lines.push_back({overlay.places.size(), 1});
    overlay.places.push_back(at);
  };
  add({1, 2}, {{"Name", std::string(" \"A\" & <B> ")}, {"Elevation_ft", std::string("6286")}});
  add({3, 4}, {{"Name", std::string("")}});
  add({5, 6}, {{"Name", std::int64_t{17}}, {"prominence", std::string("120 m")}});
  add({5, 6}, {{"Name", std::int64_t{17}}});
  const PlaceNames names = place_names(overlay, {});
  CHECK(names.unnamed == 1);
  REQUIRE(names.places.size() == 2);
  CHECK(names.places[1].text == "\"A\" & <B>");
  CHECK(*names.places[1].height_m == Approx(6286 * 0.3048));
  CHECK(names.places[0].text == "17");
  CHECK(names.places[0].prominence_m == 120.0);
  LabelSpec spec;
  spec.field = "title";
  CHECK_THROWS_WITH(place_names(overlay, spec), Catch::Contains("no field title"));
}

} // namespace orograph::names_on_page_test
