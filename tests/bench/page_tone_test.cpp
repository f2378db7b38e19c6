// SPDX-License-Identifier: GPL-3.0-or-later
// Tone asked and tone measured, where both are known.
#include "bench/page/page_tone.hpp"
#include "bench/page/view_list.hpp"
#include "geometry/error.hpp"
#include "tests/bench/made_slopes.hpp"
#include "tests/catch.hpp"
#include "tests/dem/temp_folder.hpp"
#include "tests/support/random.hpp"
#include "write/write_drawing.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

using namespace orograph;

namespace {

const AskedTone kFromSouthWest{Angle::degrees(225), Angle::degrees(45), 0.05, 0.65};

// Lines of a width over a part of a page, so far apart.
Drawing hatched(double width_mm, double spacing_mm) {
  Drawing drawing;
  drawing.page = {40, 30, 0};
  Layer& layer = drawing.layers.emplace_back();
  layer.pen_width_mm = width_mm;
  for (double y = 6; y < 24; y += spacing_mm) {
    layer.strokes.push_back({static_cast<std::uint32_t>(layer.page_mm.size()), 2});
    layer.page_mm.insert(layer.page_mm.end(), {{5, y}, {25, y}});
  }
  return drawing;
}

} // namespace

TEST_CASE("a light asks for darkness by the angle between it and the ground", "[bench]") {
  const double diagonal = std::sqrt(0.5), half = 0.5;
  CHECK(kFromSouthWest.darkness({-half, -half, diagonal}) == Approx(0.05).margin(1e-6)); // faces it
  CHECK(kFromSouthWest.darkness({half, half, diagonal}) == Approx(0.65));                // n.l = 0
  CHECK(kFromSouthWest.darkness({diagonal, diagonal, 0}) == Approx(0.65));
  CHECK(kFromSouthWest.darkness({0, 0, 1}) == Approx(0.05 + 0.6 * std::pow(1 - diagonal, 1.2)));
  // A light in the east lights slopes that fall eastward.
  const AskedTone east{Angle::degrees(90), Angle::degrees(30), 0, 1};
  CHECK(east.darkness({half, 0, std::sqrt(0.75)}) < east.darkness({-half, 0, std::sqrt(0.75)}));
}

TEST_CASE("windows lie within the ground that is shown, and ask for what its slope does",
          "[bench]") {
  for (const Vec2 slope : {Vec2{0.3, 0.2}, Vec2{-0.5, 0.1}}) {
    const TerrainData terrain = tilted_plane(slope);
    MapSpec spec;
    spec.view.exaggeration = 1.5;
    const PlacedView placed = placed_view(terrain, spec);
    const PageGround ground(std::get<Grid>(terrain.surface), placed);
    const auto windows = tone_windows(ground, placed.frame_mm, kFromSouthWest);
    CHECK(windows.size() > 100);
    const Vec3 up{-1.5 * slope.x, -1.5 * slope.y, 1};
    for (const ToneWindow& window : windows) {
      REQUIRE(window.asked == Approx(kFromSouthWest.darkness((1 / length(up)) * up)));
      REQUIRE(window.mm.width() == Approx(6));
      REQUIRE(window.mm.height() == Approx(6));
      const auto& [low, high] = window.mm;
      for (const Vec2 corner : {low, high, Vec2{low.x, high.y}, Vec2{high.x, low.y}})
        REQUIRE(ground.at(corner));
    }
    // The windows leave out no more than their margins.
    double covered_mm2 = 36.0 * static_cast<double>(windows.size()), ground_mm2 = 0;
    for (double x = placed.frame_mm.low.x; x < placed.frame_mm.high.x; ++x)
      for (double y = placed.frame_mm.low.y; y < placed.frame_mm.high.y; ++y)
        if (ground.at({x, y})) ++ground_mm2;
    CHECK(covered_mm2 < ground_mm2);
    CHECK(covered_mm2 > 0.7 * ground_mm2);
  }
  const TerrainData water = tilted_plane({0, 0});
  const PlacedView placed = placed_view(water, {});
  CHECK(tone_windows(PageGround(std::get<Grid>(water.surface), placed), placed.frame_mm,
                     kFromSouthWest)
            .empty());
}

TEST_CASE("lines are as dark as their width over their spacing", "[bench]") {
  const TempFolder folder;
  for (const auto& [width_mm, spacing_mm] : {std::pair{0.15, 0.6}, {0.3, 0.6}, {0.1, 1.0}}) {
    const std::string png = folder.file("page.png");
    WriteOptions writing{Format::png, 600, true};
    write_drawing(hatched(width_mm, spacing_mm), png, writing);
    const PagePixels pixels = read_page_pixels(png, 600 / 25.4);
    CHECK(pixels.columns == 945);
    CHECK(pixels.rows == 709);
    CHECK(pixels.mean_darkness({{8, 10}, {14, 16}}) == Approx(width_mm / spacing_mm).margin(0.01));
    CHECK(pixels.mean_darkness({{30, 10}, {36, 16}}) == 0);
  }
  CHECK_THROWS_AS(read_page_pixels(folder.file("nowhere.png"), 1), Error);
}

TEST_CASE("a box's darkness is that of the pixels in it", "[bench]") {
  Random random(8);
  PagePixels pixels{31, 23, 2.5, {}};
  for (std::size_t i = 0; i < pixels.columns * pixels.rows; ++i)
    pixels.levels.push_back(static_cast<std::uint8_t>(random.whole(0, 255)));
  for (int scene = 0; scene < 200; ++scene) {
    Box2 box;
    box.low = {random.between(-0.5, 11), random.between(-0.5, 8)};
    box.high = box.low + Vec2{random.between(1, 5), random.between(1, 5)};
    double sum = 0, count = 0;
    for (std::size_t row = 0; row < pixels.rows; ++row)
      for (std::size_t column = 0; column < pixels.columns; ++column) {
        const double x = (static_cast<double>(column) + 0.5) / 2.5,
                     y = (static_cast<double>(row) + 0.5) / 2.5;
        if (x < box.low.x || x >= box.high.x || y < box.low.y || y >= box.high.y) continue;
        sum += 1 - pixels.levels[row * pixels.columns + column] / 255.0;
        ++count;
      }
    REQUIRE(pixels.mean_darkness(box) == Approx(sum / count));
  }
}

TEST_CASE("ranks correlate whatever the numbers between", "[bench]") {
  const std::vector<double> rising{1, 2, 3, 4, 5}, curved{0.1, 0.2, 9, 90, 91},
      falling{5, 4, 3, 2, 1};
  CHECK(rank_correlation(rising, curved) == Approx(1));
  CHECK(rank_correlation(rising, falling) == Approx(-1));
  // 1 - 6 sum d^2 / (n (n^2 - 1)) where none are equal.
  CHECK(rank_correlation(rising, std::vector<double>{2, 1, 4, 3, 5}) == Approx(0.8));
  // Equal numbers have their mean rank: 1, 2.5, 2.5, 4 beside 1, 2, 3, 4.
  CHECK(rank_correlation(std::vector<double>{1, 7, 7, 9}, std::vector<double>{1, 2, 3, 4}) ==
        Approx(4.5 / std::sqrt(4.5 * 5)));
  CHECK(std::isnan(rank_correlation(rising, std::vector<double>(5, 1))));
}

TEST_CASE("a departure is measured from the mean, to either side", "[bench]") {
  CHECK(greatest_departure(std::vector<double>{0.2, 0.2}) == 0);
  CHECK(greatest_departure(std::vector<double>{0.1, 0.2, 0.3}) == Approx(0.5));
  CHECK(greatest_departure(std::vector<double>{0.1, 0.25, 0.25}) == Approx(0.5));
}

TEST_CASE("listed views are told as to the command", "[bench]") {
  const auto views = view_list("# first\n\nlow  dem.tif --view-from 200/5\n"
                               "wide dem.tif --spacing 2mm --fov 60\n");
  REQUIRE(views.size() == 2);
  CHECK(views[0].name == "low");
  CHECK(views[0].settings.inputs == std::vector<std::string>{"dem.tif"});
  CHECK(views[0].settings.map.view.from_elevation == Angle::degrees(5));
  CHECK(std::get<PageSpacing>(*views[1].settings.map.style.plan).mm == 2);
  CHECK_THROWS_WITH(view_list("\nalone\n"), Catch::Contains("line 2"));
  CHECK_THROWS_WITH(view_list("low dem.tif --no-such-option\n"), Catch::Contains("line 1"));
}
