// SPDX-License-Identifier: GPL-3.0-or-later
// Gaps between profiles, on pages where they are known.
#include "bench/page/gaps.hpp"
#include "map/draw_map.hpp"
#include "tests/bench/made_slopes.hpp"
#include "tests/catch.hpp"
#include "tests/support/random.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

using namespace orograph;

namespace {

struct DrawnSlope {
  TerrainData terrain;
  MapSpec spec;
  PlacedView placed;
  PageGround ground;
  Drawing drawing;

  static MapSpec asked(Projection projection) {
    MapSpec spec;
    spec.view.projection = projection;
    spec.view.exaggeration = 1;
    spec.style.plan = PageSpacing{2};
    spec.style.simplify_mm = 0;
    return spec;
  }
  DrawnSlope(Vec2 slope, Projection projection) : DrawnSlope(tilted_plane(slope), projection) {}
  DrawnSlope(TerrainData made, Projection projection)
      : terrain(std::move(made)), spec(asked(projection)), placed(placed_view(terrain, spec)),
        ground(std::get<Grid>(terrain.surface), placed),
        drawing(draw_map(terrain, placed, spec, [](double) {}).drawing) {}
  Layer& layer(const std::string& name) {
    return *std::ranges::find(drawing.layers, name, &Layer::name);
  }
  Vec2 middle_mm() const { return placed.frame_mm.centre(); }
  Gap gap(Vec2 at_mm) const { return gap_at(ground, GapLines(drawing), placed.frame_mm, 2, at_mm); }
};

void draw_line(Layer& layer, Vec2 from_mm, Vec2 to_mm) {
  layer.strokes.push_back({static_cast<std::uint32_t>(layer.page_mm.size()), 2});
  layer.page_mm.push_back(from_mm);
  layer.page_mm.push_back(to_mm);
}

// Of all profiles the nearest one on either side, by distance from straight lines, in mm. Profiles
// of a plane are straight and, in a parallel view, parallel.
double gap_by_definition_mm(const Layer& profiles, Vec2 at_mm) {
  double before = INFINITY, behind = INFINITY;
  for (const Stroke& stroke : profiles.strokes) {
    const auto points = profiles.points(stroke);
    Vec2 along = points.back() - points.front();
    if (along.x < 0) along = -1 * along;
    const double aside = cross(along, at_mm - points.front()) / length(along);
    (aside < 0 ? before : behind) = std::min(aside < 0 ? before : behind, std::abs(aside));
  }
  return before + behind;
}

} // namespace

TEST_CASE("a plane's gaps are the distances of its profiles", "[bench]") {
  for (const Vec2 slope : {Vec2{0, 0.3}, Vec2{0.5, 0.2}, Vec2{-1, 0.1}, Vec2{0.3, -0.2}}) {
    DrawnSlope drawn(slope, Projection::orthographic);
    const Layer& profiles = drawn.layer("profiles");
    CAPTURE(slope.x, slope.y);
    Random random(5);
    int judged = 0;
    for (int i = 0; i < 200; ++i) {
      const Box2& frame = drawn.placed.frame_mm;
      const Vec2 at{random.between(frame.low.x, frame.high.x),
                    random.between(frame.low.y, frame.high.y)};
      if (!drawn.ground.at(at)) continue;
      const Gap gap = drawn.gap(at);
      if (gap.beside != Beside::profiles) continue; // beside the border
      ++judged;
      CHECK(2 * gap.spacings == Approx(gap_by_definition_mm(profiles, at)).margin(1e-3));
    }
    CHECK(judged > 20);
  }
}

TEST_CASE("profiles that are drawn in part are met where they are", "[bench]") {
  DrawnSlope drawn({0, 0.3}, Projection::orthographic);
  Layer& profiles = drawn.layer("profiles");
  const Vec2 middle = drawn.middle_mm();
  profiles.clear();
  for (int i = -4; i <= 4; ++i)
    draw_line(profiles, {middle.x - (i % 2 == 0 ? 30 : 0), middle.y + 2 * i + 0.5},
              {middle.x + 30, middle.y + 2 * i + 0.5});
  CHECK(drawn.gap({middle.x + 10, middle.y}).spacings == Approx(1));
  CHECK(drawn.gap({middle.x - 10, middle.y}).spacings == Approx(2));
  profiles.clear();
  CHECK(drawn.gap(middle).spacings >= 10); // or as far as its ground goes
}

TEST_CASE("what comes between is counted apart", "[bench]") {
  DrawnSlope drawn({0, 0.3}, Projection::perspective);
  const Vec2 middle = drawn.middle_mm();
  const Gap before = drawn.gap(middle);
  REQUIRE(before.beside == Beside::profiles);
  CHECK(before.spacings > 0.5);
  CHECK(before.spacings < 2);
  for (const auto& [layer, beside] : {std::pair{"silhouettes", Beside::silhouette},
                                      {"skyline", Beside::silhouette},
                                      {"border", Beside::border},
                                      {"shores", Beside::border}}) {
    for (const double aside_mm : {-0.05, 0.05}) {
      DrawnSlope with({0, 0.3}, Projection::perspective);
      draw_line(with.layer(layer), {middle.x - 5, middle.y + aside_mm},
                {middle.x + 5, middle.y + aside_mm});
      CHECK(with.gap(middle).beside == beside);
      CHECK(with.gap({middle.x + 6, middle.y}).beside == Beside::profiles);
    }
    DrawnSlope with({0, 0.3}, Projection::perspective); // behind the profile it doesn't matter
    draw_line(with.layer(layer), {middle.x - 5, middle.y + 5}, {middle.x + 5, middle.y + 5});
    CHECK(with.gap(middle).spacings == before.spacings);
  }
}

TEST_CASE("a jump that no line shows is counted apart as well", "[bench]") {
  DrawnSlope drawn(terrace(), Projection::orthographic);
  const Sector& sector = drawn.placed.sectors.front();
  const ProfilePoint brink = to_profile_frame(sector.view, {300, 290, 250});
  const Vec2 below = sector.to_page.at(project_homogeneous(sector.view, brink)) + Vec2{0, 0.05};
  CHECK(drawn.gap(below).beside == Beside::silhouette);
  drawn.layer("silhouettes").clear();
  CHECK(drawn.gap(below).beside == Beside::jump);
  draw_line(drawn.layer("profiles"), below + Vec2{-1, -0.03}, below + Vec2{1, -0.03}); // before it
  CHECK(drawn.gap(below).beside == Beside::profiles);
}

TEST_CASE("random points are on the ground, and the same for a seed", "[bench]") {
  DrawnSlope drawn({0.2, 0.3}, Projection::perspective);
  const GapLines lines(drawn.drawing);
  const auto gaps = [&](std::uint64_t seed) {
    std::vector<double> spacings;
    for (const Gap& gap : gaps_of(drawn.ground, lines, drawn.placed.frame_mm, 2, 300, seed))
      spacings.push_back(gap.spacings);
    return spacings;
  };
  CHECK(gaps(1).size() == 300);
  CHECK(gaps(1) == gaps(1));
  CHECK(gaps(1) != gaps(2));
  DrawnSlope level({0, 0}, Projection::perspective); // water
  CHECK(gaps_of(level.ground, GapLines(level.drawing), level.placed.frame_mm, 2, 10, 1).empty());
}

TEST_CASE("evenness is a share of the points between profiles", "[bench]") {
  std::vector<Gap> gaps{{Beside::silhouette}, {Beside::border}, {Beside::border}, {Beside::jump}};
  for (const double spacings : {0.49, 0.5, 1.0, 1.6, 1.61})
    gaps.push_back({Beside::profiles, spacings});
  const Evenness found = evenness_of(gaps);
  CHECK(found.points == std::array<std::size_t, kBesideKinds>{5, 1, 2, 1});
  CHECK(found.even_share == Approx(0.6));
  CHECK(found.quantiles == std::array<double, 5>{0.49, 0.5, 1.0, 1.6, 1.61});
  CHECK(std::isnan(evenness_of({}).even_share));
  CHECK(std::isnan(evenness_of({}).quantiles[2]));
}

TEST_CASE("the first line is the nearest of all", "[bench]") {
  Random random(3);
  for (int scene = 0; scene < 50; ++scene) {
    PageLines lines(Page{});
    std::vector<std::pair<Vec2, Vec2>> all;
    for (int i = random.whole(1, 300); i > 0; --i) {
      const Vec2 from{random.between(-5, 215), random.between(-5, 300)};
      const double far = random.pick({0.5, 5.0, 100.0});
      const Vec2 to = from + Vec2{random.between(-far, far), random.between(-far, far)};
      lines.add(from, to);
      all.emplace_back(from, to);
    }
    for (int i = 0; i < 50; ++i) {
      const Vec2 from{random.between(0, 210), random.between(0, 297)};
      const double turn = random.between(0, 6.3), reach = random.pick({0.3, 6.0, 50.0});
      const Vec2 direction{std::cos(turn), std::sin(turn)};
      double nearest = INFINITY;
      for (const auto& [a, b] : all) { // each end on another side
        const double of_a = cross(direction, a - from), of_b = cross(direction, b - from);
        if ((of_a < 0) == (of_b < 0)) continue;
        const Vec2 met = a + (of_a / (of_a - of_b)) * (b - a);
        const double along = dot(met - from, direction);
        if (along >= 0 && along <= reach) nearest = std::min(nearest, along);
      }
      const auto found = lines.first_met(from, direction, reach);
      REQUIRE(found.has_value() == std::isfinite(nearest));
      if (found) CHECK(*found == Approx(nearest).margin(1e-9));
    }
  }
}
