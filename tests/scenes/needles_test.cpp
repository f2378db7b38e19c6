// SPDX-License-Identifier: GPL-3.0-or-later
// Needles: heights of hundreds of kilometres over cells of 30 m, seen from straight above, or
// nearly. What is drawn is asked of every triangle, in long double, and of the ray walk.
#include "dem/approximate/tin_of_grid.hpp"
#include "map/draw_map.hpp"
#include "reference/judge.hpp"
#include "reference/sight_segment.hpp"
#include "tests/catch.hpp"
#include "tests/scenes/visible_parts.hpp"
#include "tests/support/random.hpp"

#include <cmath>

namespace orograph::needles_test {
namespace {

TerrainData needles(int side, double highest_m, std::uint64_t seed) {
  Random random(seed);
  Grid grid;
  grid.columns = grid.rows = side;
  grid.plane() = {{0, 0}, {30, 0}, {0, -30}};
  std::vector<float> heights;
  for (int i = 0; i < side * side; ++i)
    heights.push_back(static_cast<float>(random.between(0, highest_m)));
  grid.heights_m = std::move(heights);
  TerrainData terrain;
  terrain.surface = std::move(grid);
  return terrain;
}

MapSpec from_above(double azimuth_deg, double elevation_deg) {
  MapSpec spec;
  spec.view.projection = Projection::perspective;
  spec.view.from_azimuth = Angle::degrees(azimuth_deg);
  spec.view.from_elevation = Angle::degrees(elevation_deg);
  spec.view.exaggeration = 1;
  spec.style.silhouette_jump = 0;
  spec.style.simplify_mm = 0;
  return spec;
}

// By segments of sight to each triangle.
class Triangles {
public:
  Triangles(const Surface& surface, const View& view) : view_(view) {
    const Tin tin = tin_of(std::get<Grid>(surface));
    for (const auto& corners : tin.triangles) {
      LongTriangle& triangle = triangles_.emplace_back();
      for (std::size_t i = 0; i < 3; ++i)
        triangle[i] = long_vec(to_profile_frame(view, tin.vertices_m[corners[i]]));
    }
  }
  // Whether a triangle is between the eye and a point of the surface, not just beside the point.
  bool surely_hides(ProfilePoint p) const {
    const LongVec eye{0, 0, view_.eye_z_m}, at = long_vec(p);
    const SightSegment segment{eye, eye + 0.9999L * (at - eye)};
    for (const LongTriangle& triangle : triangles_)
      if (surely_crosses(segment, triangle, 1e-6L)) return true;
    return false;
  }

private:
  View view_;
  std::vector<LongTriangle> triangles_;
};

struct Tally {
  std::size_t points = 0, drawn_but_hidden = 0, not_by_the_walk = 0;
};

void ask(const TerrainData& terrain, const MapSpec& spec, const Instruments& how, Tally& tally) {
  const PlacedView placed = placed_view(terrain, spec);
  VisibleParts parts(placed);
  Instruments instruments = how;
  instruments.observers = {&parts};
  draw_map(
      terrain, placed, spec, [](double) {}, instruments);
  const std::vector<Judge> judges =
      judges_of(terrain.surface, placed, spec.style.visibility_tolerance_mm);
  std::vector<Triangles> sectors;
  for (const Sector& sector : placed.sectors) sectors.emplace_back(terrain.surface, sector.view);
  std::size_t asked = 0;
  for (const SeenOfLine& line : parts.lines)
    for (std::size_t i = 0; i < line.seen.size(); i += 2) {
      // Of large scenes one in eight, and all that begins close to the plane beside the eye.
      const bool is_close = std::min(std::abs(line.whole.from.v), std::abs(line.whole.to.v)) < 60;
      if (parts.lines.size() > 1000 && !is_close && ++asked % 8 != 0) continue;
      const double t = 0.5 * (line.seen[i] + line.seen[i + 1]);
      const ProfilePoint p = point_between(line.whole.from, line.whole.to, t);
      if (p.v <= placed.sectors[line.sector].view.near_m) continue;
      ++tally.points;
      if (!sectors[line.sector].surely_hides(p)) continue;
      ++tally.drawn_but_hidden;
      if (judges[line.sector].verdict(line.whole, t, line.is_edge, true) == Verdict::hidden)
        continue;
      ++tally.not_by_the_walk;
      UNSCOPED_INFO((line.is_edge ? "edge " : "span ")
                    << line.whole.from.u << " " << line.whole.from.v << " " << line.whole.from.z
                    << " to " << line.whole.to.u << " " << line.whole.to.v << " " << line.whole.to.z
                    << " at " << t << " from " << line.seen[i] << " to " << line.seen[i + 1]
                    << " above " << judges[line.sector].above(p, line.is_edge));
    }
}

} // namespace

TEST_CASE("needles hide what is behind them, seen from straight above", "[slow]") {
  std::uint64_t views = 0;
  for (const int side : {17, 30})
    for (const double highest_m : {1e6, 1e5})
      for (const double elevation : {90.0, 89.999})
        for (const double azimuth : {225.0, 90.0, 45.0, 0.0}) {
          if (++views > last_seed(32)) return;
          const TerrainData terrain = needles(side, highest_m, 1);
          const MapSpec spec = from_above(azimuth, elevation);
          for (const bool in_list : {false, true}) {
            CAPTURE(side, highest_m, elevation, azimuth, in_list);
            Tally tally;
            ask(terrain, spec, {.one_list = in_list, .order_always = true}, tally);
            CAPTURE(tally.points);
            CHECK(tally.drawn_but_hidden == 0);
            CHECK(tally.not_by_the_walk == 0);
          }
        }
}

} // namespace orograph::needles_test
