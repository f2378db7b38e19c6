// SPDX-License-Identifier: GPL-3.0-or-later
// Whole drawings with even tone and light: every stroke is a part of what the same profile shows
// without, none is drawn twice, and planes are as dark all over as they should be.
#include "geometry/on_all_cores.hpp"
#include "map/draw_map.hpp"
#include "placing/placed_view.hpp"
#include "tests/catch.hpp"
#include "tests/scenes/put_eye.hpp"
#include "tests/scenes/random_scene.hpp"
#include "tests/scenes/same_drawing.hpp"
#include "tests/scenes/vary_view.hpp"
#include "tests/support/grid_of.hpp"
#include "tests/support/random.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <vector>

namespace orograph::tone_scenes_test {
namespace {

const std::uint64_t kScenes = last_seed(400);

Map drawn(const TerrainData& terrain, const PlacedView& placed, const MapSpec& spec) {
  return draw_map(terrain, placed, spec, [](double) {});
}

double distance_to_segment(Vec2 p, Vec2 a, Vec2 b) {
  const Vec2 along = b - a;
  const double square = dot(along, along);
  const double t = square > 0 ? std::clamp(dot(p - a, along) / square, 0.0, 1.0) : 0;
  return plain_length(p - (a + t * along));
}

using Segments = std::vector<std::pair<Vec2, Vec2>>;

std::map<std::int32_t, Segments> segments_by_profile(const Layer& layer) {
  std::map<std::int32_t, Segments> out;
  for (const Stroke& stroke : layer.strokes) {
    const auto points = layer.points(stroke);
    for (std::size_t i = 1; i < points.size(); ++i)
      out[stroke.profile].push_back({points[i - 1], points[i]});
  }
  return out;
}

bool lies_on(Vec2 p, const Segments& segments, double within_mm) {
  return std::any_of(segments.begin(), segments.end(), [&](const auto& segment) {
    return distance_to_segment(p, segment.first, segment.second) <= within_mm;
  });
}

double ink_mm(const Layer& layer) {
  double sum = 0;
  for (const Stroke& stroke : layer.strokes) {
    const auto points = layer.points(stroke);
    for (std::size_t i = 1; i < points.size(); ++i) sum += plain_length(points[i] - points[i - 1]);
  }
  return sum;
}

} // namespace

TEST_CASE("what tone draws is a part of what the same profiles show") {
  std::size_t strokes = 0, widened = 0, refused = 0, toned_views = 0;
  std::size_t points_count = 0, of_others = 0; // found on another profile's stroke
  double toned_mm = 0, whole_mm = 0;
  for (std::uint64_t seed = 1; seed <= kScenes; ++seed) {
    RandomScene scene = random_scene(seed);
    Random random(seed);
    if (seed % 3 == 2) put_eye(scene.spec, grid_of(scene.terrain), random);
    Style& style = scene.spec.style;
    if (seed % 4 != 0) style.plan = PageSpacing{random.between(0.6, 4)};
    style.simplify_mm = 0;
    style.min_stroke_mm = 0;
    style.layers = {"profiles"};
    if (random.chance(0.3)) style.light.reset();
    INFO("seed " << seed << ": " << scene.what);
    std::optional<PlacedView> placed = placed_if_any(scene.terrain, scene.spec);
    if (!placed) {
      ++refused;
      continue;
    }
    const Map toned = drawn(scene.terrain, *placed, scene.spec);
    bool has_runs = false;
    for (Sector& sector : placed->sectors)
      for (PlannedProfile& profile : sector.profiles) {
        has_runs |= profile.runs.has_value();
        profile.runs.reset();
      }
    toned_views += has_runs ? 1 : 0;
    const Map whole = drawn(scene.terrain, *placed, scene.spec);
    const Layer &part = toned.drawing.layers.front(), &all = whole.drawing.layers.front();
    const auto segments = segments_by_profile(all);
    // Where two profiles tie, one of two equal strokes was dropped: its place is drawn all the
    // same.
    Segments all_segments;
    for (const auto& [number, of_profile] : segments)
      all_segments.insert(all_segments.end(), of_profile.begin(), of_profile.end());
    bool all_on = true;
    for (const Stroke& stroke : part.strokes) {
      ++strokes;
      widened += stroke.width_mm > 0 ? 1 : 0;
      const auto found = segments.find(stroke.profile);
      const auto points = part.points(stroke);
      // Rounded to 1e-4 mm, and so are those of the whole.
      const auto is_drawn = [&](Vec2 p) {
        constexpr double kRounding_mm = 2e-4;
        if (found != segments.end() && lies_on(p, found->second, kRounding_mm)) return true;
        ++of_others;
        return lies_on(p, all_segments, kRounding_mm);
      };
      for (std::size_t i = 0; all_on && i < points.size(); ++i)
        all_on = is_drawn(points[i]) && (i == 0 || is_drawn(0.5 * (points[i] + points[i - 1])));
    }
    CHECK(all_on);
    CHECK(ink_mm(part) <= ink_mm(all) * (1 + 1e-6) + 0.01);
    points_count += part.page_mm.size();
    toned_mm += ink_mm(part);
    whole_mm += ink_mm(all);
  }
  WARN(strokes << " strokes, " << widened << " with a width, " << toned_mm << " of " << whole_mm
               << " mm; " << toned_views << " views with tone, " << refused << " refused");
  CHECK(of_others < points_count / 1000);
  CHECK(refused < kScenes / 4);
  CHECK(toned_views > kScenes / 2);
  CHECK(widened > 10 * kScenes);
  CHECK(toned_mm < 0.9 * whole_mm);
  CHECK(toned_mm > 0.2 * whole_mm);
}

TEST_CASE("whole profiles with light show all that they show without") {
  for (std::uint64_t seed = 1; seed <= kScenes / 4; ++seed) {
    RandomScene scene = random_scene(seed);
    Style& style = scene.spec.style;
    style.simplify_mm = 0;
    style.min_stroke_mm = 0;
    style.layers = {"profiles"};
    INFO("seed " << seed << ": " << scene.what);
    const PlacedView lit = placed_view(scene.terrain, scene.spec);
    const double lit_mm = ink_mm(drawn(scene.terrain, lit, scene.spec).drawing.layers.front());
    style.light.reset();
    const PlacedView plain = placed_view(scene.terrain, scene.spec);
    const double plain_mm = ink_mm(drawn(scene.terrain, plain, scene.spec).drawing.layers.front());
    CHECK(lit.depths_m == plain.depths_m);
    // Joints are rounded to 1e-4 mm.
    CHECK(std::abs(lit_mm - plain_mm) < 1e-4 * plain_mm + 0.01);
  }
}

TEST_CASE("tone is the same on any number of threads") {
  for (std::uint64_t seed = 1; seed <= kScenes / 20; ++seed) {
    RandomScene scene = random_scene(seed);
    scene.spec.style.plan = PageSpacing{1};
    INFO("seed " << seed << ": " << scene.what);
    std::vector<Map> maps;
    for (const int jobs : {1, 2, 3})
      on_cores(jobs, {}, [&] {
        const PlacedView placed = placed_view(scene.terrain, scene.spec);
        maps.push_back(drawn(scene.terrain, placed, scene.spec));
      });
    CHECK(difference(maps[0].drawing, maps[1].drawing).empty());
    CHECK(difference(maps[0].drawing, maps[2].drawing).empty());
  }
}

namespace {

// A plane that falls to one side, one cell a metre.
TerrainData tilted_plane(double azimuth_deg, double slope) {
  constexpr int kSide = 120;
  const Vec2 down = direction_of_azimuth(Angle::degrees(azimuth_deg));
  Grid grid{kSide, kSide, PlaneLattice{{0, kSide - 1.0}, {1, 0}, {0, -1}}, std::vector<float>()};
  std::vector<float> heights;
  for (int row = 0; row < kSide; ++row)
    for (int column = 0; column < kSide; ++column)
      heights.push_back(
          static_cast<float>(100 - slope * (down.x * column + down.y * (kSide - 1 - row))));
  grid.heights_m = std::move(heights);
  TerrainData terrain;
  terrain.surface = std::move(grid);
  return terrain;
}

// Ink over paper about places wholly on the plane's picture.
struct Tone {
  double mean = 0, worst = 0; ///< and the greatest share of it by which a place is off
  std::size_t places = 0;
};

// Weights fall from 1 at a place to 0 at the next one, `apart_mm` from it, across and down: of
// windows with edges some have a line more than others.
Tone tone_of(const Layer& layer, double apart_mm) {
  using Place = std::pair<long, long>;
  std::map<Place, double> ink;
  constexpr double kStep_mm = 0.02;
  const auto add = [&](Vec2 p, double area) {
    const double x = p.x / apart_mm, y = p.y / apart_mm;
    const long left = std::lround(std::floor(x)), above = std::lround(std::floor(y));
    for (const long i : {left, left + 1})
      for (const long j : {above, above + 1})
        ink[{i, j}] += area * (1 - std::abs(x - static_cast<double>(i))) *
                       (1 - std::abs(y - static_cast<double>(j)));
  };
  for (const Stroke& stroke : layer.strokes) {
    const auto points = layer.points(stroke);
    for (std::size_t i = 1; i < points.size(); ++i) {
      const double length = plain_length(points[i] - points[i - 1]);
      const double steps = std::ceil(length / kStep_mm);
      for (double k = 0.5; k < steps; ++k)
        add(points[i - 1] + (k / steps) * (points[i] - points[i - 1]),
            stroke.width_mm * length / steps);
    }
  }
  const auto is_inside = [&](Place at) {
    for (long i = -2; i <= 2; ++i)
      for (long j = -2; j <= 2; ++j)
        if (!ink.contains({at.first + i, at.second + j})) return false;
    return true;
  };
  std::vector<double> inside;
  for (const auto& [at, sum] : ink)
    if (is_inside(at)) inside.push_back(sum / (apart_mm * apart_mm));
  Tone tone;
  tone.places = inside.size();
  for (const double dark : inside) tone.mean += dark / static_cast<double>(inside.size());
  for (const double dark : inside)
    tone.worst = std::max(tone.worst, std::abs(dark / tone.mean - 1));
  return tone;
}

} // namespace

namespace {

// Seen from the south, from so high; straight above, half of it lies behind the eye.
void check_tilted_planes(double elevation_deg) {
  for (const double azimuth_deg : {0., 45., 90., 135., 180., 225., 270., 315.}) {
    const double slope = 0.15;
    const TerrainData terrain = tilted_plane(azimuth_deg, slope);
    MapSpec spec;
    spec.view.exaggeration = 1;
    spec.view.from_elevation = Angle::degrees(elevation_deg);
    spec.view.field_of_view = Angle::degrees(60); // near and far
    spec.style.layers = {"profiles"};
    spec.style.haze = 0;
    INFO("falls to " << azimuth_deg << ", seen from " << elevation_deg);
    const PlacedView placed = placed_view(terrain, spec);
    REQUIRE(placed.sectors.size() == (elevation_deg == 90 ? 2 : 1));
    const Tone tone = tone_of(drawn(terrain, placed, spec).drawing.layers.front(), 6);
    // What light asks for, from the left and the viewer's side.
    const LightSpec light;
    const Vec2 down = direction_of_azimuth(Angle::degrees(azimuth_deg)),
               from = direction_of_azimuth(light.azimuth);
    const double lit = (slope * dot(down, from) * cos(light.altitude) + sin(light.altitude)) /
                       std::hypot(slope, 1);
    const double asked = 0.125 + 0.375 * std::pow(1 - lit, 1.2);
    WARN(azimuth_deg << ": " << tone.mean << " asked " << asked << ", worst " << tone.worst
                     << " of " << tone.places);
    CHECK(tone.places > 30);
    CHECK(tone.worst < 0.12);
    CHECK(std::abs(tone.mean - asked) < 0.02);
  }
}

} // namespace

TEST_CASE("a tilted plane is equally dark all over, though levels change across it",
          "[unsanitized]") {
  check_tilted_planes(20);
}

TEST_CASE("and seen straight down, ahead of the eye and behind it", "[unsanitized]") {
  check_tilted_planes(90);
}

} // namespace orograph::tone_scenes_test
