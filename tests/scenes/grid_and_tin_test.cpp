// SPDX-License-Identifier: GPL-3.0-or-later
// One surface, as a grid and as the TIN of its triangles: the same lines, bit for bit.
#include "dem/approximate/tin_of_grid.hpp"
#include "dem/read/read_raster.hpp"
#include "map/draw_map.hpp"
#include "placing/placed_view.hpp"
#include "profiles/profile.hpp"
#include "tests/catch.hpp"
#include "tests/scenes/random_scene.hpp"
#include "tests/support/grid_of.hpp"
#include "tests/support/random.hpp"
#include "tests/support/sample_names.hpp"

#include <cmath>
#include <cstring>

namespace orograph::grid_and_tin_test {
namespace {

// What is visible, before anything is laid out on the page.
class Seen : public LineObserver {
public:
  struct Part {
    ProfilePoint from, to;
    int kind; ///< -1 for a profile
    double t_begin, t_end;
    bool operator==(const Part& o) const {
      return std::memcmp(&from, &o.from, sizeof from) == 0 &&
             std::memcmp(&to, &o.to, sizeof to) == 0 && kind == o.kind && t_begin == o.t_begin &&
             t_end == o.t_end;
    }
  };
  std::vector<Part> parts;

  void see(const SeenProfile& seen) override {
    const auto& [sector, clipped, profile, segments, visible] = seen;
    for (const Piece& piece : visible) {
      const std::uint32_t left = left_vertex(segments[piece.segment]);
      const auto at = [&](std::uint32_t i) {
        return ProfilePoint{profile.u_m[i], profile.depth_m, profile.z_m[i]};
      };
      parts.push_back({at(left), at(left + 1), profile.after[left] == Span::level ? -2 : -1,
                       piece.t_begin, piece.t_end});
    }
  }
  void see(const SeenLines& seen) override {
    const auto& [sector, clipped, lines, visible] = seen;
    for (const LinePart& part : visible) {
      const ProfileLine whole = lines.whole(part.line);
      parts.push_back({whole.from, whole.to, static_cast<int>(lines.line(part.line).kind),
                       part.t_begin, part.t_end});
    }
  }
};

// The smallest region of a grid that counts as water, as an area.
double smallest_water_m2(const Grid& grid) {
  const double triangles =
      static_cast<double>(std::max<std::size_t>(500, 2 * grid.size() / 5000)) - 0.5;
  return triangles * std::abs(cross(grid.plane().column_step_m, grid.plane().row_step_m)) / 2;
}

struct Compared {
  std::size_t parts = 0, strokes = 0, views = 0;
};

void compare_in(const TerrainData& as_grid, const TerrainData& as_tin, const MapSpec& spec,
                Compared& compared) {
  const Grid& grid = grid_of(as_grid);
  const Tin& tin = std::get<Tin>(as_tin.surface);
  PlacedView scene = placed_view(as_grid, spec);
  Seen by_grid, by_tin;
  const Map drawn_grid =
      draw_map(as_grid, scene, spec, [](double) {}, {.observers = {&by_grid}, .beyond_page = true});
  // The same view and plan; what belongs to the surface is the TIN's own.
  scene.border = border_edges(tin);
  if (spec.style.flat == FlatGround::shore)
    scene.level = find_level_ground(tin, smallest_water_m2(grid));
  const Map drawn_tin =
      draw_map(as_tin, scene, spec, [](double) {}, {.observers = {&by_tin}, .beyond_page = true});
  REQUIRE(by_grid.parts.size() == by_tin.parts.size());
  std::size_t different = 0;
  for (std::size_t i = 0; i < by_grid.parts.size(); ++i) {
    const bool same = by_grid.parts[i] == by_tin.parts[i];
    if (!same && different == 0) {
      const Seen::Part &g = by_grid.parts[i], &t = by_tin.parts[i];
      UNSCOPED_INFO("part " << i << ": kind " << g.kind << " " << t.kind << ", from " << g.from.u
                            << " " << g.from.v << " " << g.from.z << " against " << t.from.u << " "
                            << t.from.v << " " << t.from.z << ", t " << g.t_begin << " " << g.t_end
                            << " against " << t.t_begin << " " << t.t_end << " diff "
                            << g.t_begin - t.t_begin << " " << g.t_end - t.t_end);
    }
    different += !same;
  }
  CHECK(different == 0);
  CHECK(drawn_grid.facts.counts.strokes == drawn_tin.facts.counts.strokes);
  for (std::size_t i = 0; i < drawn_grid.drawing.layers.size(); ++i)
    CHECK((drawn_grid.drawing.layers[i].page_mm == drawn_tin.drawing.layers[i].page_mm));
  compared.parts += by_grid.parts.size();
  compared.strokes += drawn_grid.facts.counts.strokes;
  ++compared.views;
}

TerrainData tin_terrain(const TerrainData& as_grid) {
  TerrainData terrain = as_grid;
  terrain.surface = tin_of(grid_of(as_grid));
  return terrain;
}

} // namespace

TEST_CASE("all samples, ten views each", "[slow]") {
  Compared compared;
  for (const char* name : sample_names()) {
    const TerrainData as_grid =
        read_raster(std::string(OROGRAPH_SOURCE_DIR "/data_samples/") + name + ".tif");
    const TerrainData as_tin = tin_terrain(as_grid);
    for (int i = 0; i < 10; ++i) {
      MapSpec spec;
      spec.view.from_azimuth = Angle::degrees(i % 5 == 0 ? 45.0 * i : 37.3 * i);
      spec.view.from_elevation = Angle::degrees(i % 2 ? 8 + 3 * i : 40 - 3 * i);
      spec.view.projection = i % 3 == 2 ? Projection::orthographic : Projection::perspective;
      spec.style.plan = ProfileCount{40};
      if (i == 3) spec.style.occluder = Occluder::profiles;
      if (i == 4) spec.style.flat = FlatGround::draw;
      if (i == 6) spec.style.layers.push_back("edges");
      CAPTURE(name, i);
      compare_in(as_grid, as_tin, spec, compared);
    }
  }
  WARN(compared.views << " views, " << compared.parts << " visible parts, " << compared.strokes
                      << " strokes");
  CHECK(compared.views == 10 * sample_names().size());
  CHECK(compared.parts > enough<500000>);
}

TEST_CASE("and made scenes with holes, spikes and steps") {
  Compared compared;
  for (std::uint64_t seed = 1; seed <= last_seed(300); ++seed) {
    RandomScene scene = random_scene(seed);
    if (seed % 2 == 0) scene.spec.style.layers.push_back("voids");
    CAPTURE(seed, scene.what);
    compare_in(scene.terrain, tin_terrain(scene.terrain), scene.spec, compared);
  }
  WARN(compared.views << " views, " << compared.parts << " visible parts");
  CHECK(compared.parts > enough<100000>);
}

} // namespace orograph::grid_and_tin_test
