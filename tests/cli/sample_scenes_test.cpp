// SPDX-License-Identifier: GPL-3.0-or-later
// The scenes of data_samples/: each is read, and those of the sources have the edges, light and
// dark, that these tell (Chen and Sabbagh 1983; Angell and Jones 1983, chapter 9).
#include "cli/report/run_report.hpp"
#include "placing/placed_view.hpp"
#include "solids/read_scene.hpp"
#include "solids/solids_in_view.hpp"
#include "tests/catch.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <set>

using namespace orograph;
namespace fs = std::filesystem;

namespace {

const fs::path kSamples = fs::path(OROGRAPH_SOURCE_DIR) / "data_samples";

RenderSettings settings_of(const std::string& scene) {
  RenderSettings settings;
  settings.inputs = {(kSamples / "scenes" / scene).string()};
  settings.solids = std::make_shared<const SceneFile>(read_scene(settings.inputs.front()));
  return settings;
}

// A scene alone, as a view has its only solid.
struct Seen {
  RenderSettings settings;
  PlacedView scene;
  SolidInView solid;

  explicit Seen(RenderSettings of)
      : settings(std::move(of)),
        scene(placed_view(read_ground(settings), settings.map, settings.solids.get())) {
    REQUIRE(scene.solids.size() == 1);
    solid = in_view(scene.solids.front(), scene.view);
  }
  Seen(const std::string& scene_name, const std::string& view)
      : Seen([&] {
          RenderSettings with_view = settings_of(scene_name);
          with_view.map.view.file = read_view((kSamples / "views" / view).string());
          return with_view;
        }()) {}

  const std::vector<Vec3>& vertices() const { return scene.solids.front().vertices_m; }
  const std::vector<SolidEdge>& edges() const { return scene.solids.front().solid->edges; }
  std::ptrdiff_t count(EdgeFacing facing) const {
    return std::count(solid.edges.begin(), solid.edges.end(), facing);
  }
  Vec2 in_picture(Vec3 vertex) const {
    return scene.view.to_picture(project(scene.view, to_profile_frame(scene.view, vertex)));
  }
};

// x, y and z of the book, of which y is up.
Vec3 of_book(Vec3 v) {
  return {v.x, v.z, v.y};
}

void check_near(Vec2 a, Vec2 b) {
  CHECK(std::hypot(a.x - b.x, a.y - b.y) < 1e-9);
}

} // namespace

TEST_CASE("every scene of data_samples is read and has something to draw") {
  std::size_t count = 0;
  for (const auto& file : fs::directory_iterator(kSamples / "scenes")) {
    INFO(file.path().string());
    const SceneFile scene = read_scene(file.path().string());
    CHECK(!scene.instances.empty());
    ++count;
  }
  CHECK(count >= 10);
}

TEST_CASE("the tent: light in front and on the right, in perspective and in parallel") {
  for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
    RenderSettings settings = settings_of("tent.toml");
    ViewSpec& view = settings.map.view;
    view.from_azimuth = Angle::degrees(150);
    view.from_elevation = Angle::degrees(20);
    view.projection = projection;
    const Seen tent(settings);
    std::set<std::pair<std::uint32_t, std::uint32_t>> dark;
    for (std::size_t i = 0; i < tent.edges().size(); ++i)
      if (tent.solid.edges[i] == EdgeFacing::dark)
        dark.insert({tent.edges()[i].from, tent.edges()[i].to});
    // Of the left, the back and the bottom face alone: all three meet at the origin.
    CHECK(dark == std::set<std::pair<std::uint32_t, std::uint32_t>>{{0, 1}, {0, 3}, {0, 4}});
    CHECK(tent.count(EdgeFacing::seen) == 6);
  }
}

TEST_CASE("example 9.1: the cube's vertices are where the book's matrices take them") {
  const Seen b("cube_moved.toml", "cube_b.toml"), c("cube_moved.toml", "cube_c.toml"),
      d("cube_moved.toml", "cube_d.toml");
  // 25 times the ACTUAL position.
  std::set<std::array<long, 3>> actual;
  for (const Vec3& vertex : b.vertices()) {
    const Vec3 p = of_book(vertex);
    actual.insert({std::lround(25 * p.x), std::lround(25 * p.y), std::lround(25 * p.z)});
    CHECK(std::abs(25 * p.x - std::round(25 * p.x)) < 1e-9);
    check_near(b.in_picture(vertex), {p.x, p.y});
    // F E D, with (FX, FY, FZ) = (-1, 2, 2), r the root of 5 and s = 3.
    const double r = std::sqrt(5.0), x = p.x + 1;
    check_near(c.in_picture(vertex), {(-2 * (-x + 2 * p.y) / r + r * p.z) / 3, (-2 * x - p.y) / r});
    // The first two rows of Q.
    check_near(d.in_picture(vertex),
               {-0.894427191 * p.x - 0.4472135955 * p.z - 0.894427191,
                0.298142397 * p.x + 0.7453559925 * p.y - 0.596284794 * p.z + 0.298142397});
  }
  CHECK(actual == std::set<std::array<long, 3>>{{26, -5, 7},
                                                {-14, -5, -23},
                                                {-38, -35, 9},
                                                {2, -35, 39},
                                                {8, 35, 31},
                                                {-32, 35, 1},
                                                {-56, 5, 33},
                                                {-16, 5, 63}});
}

TEST_CASE("figure 9.1: what is seen of the cube") {
  const Seen straight("cube.toml", "cube_a.toml");
  CHECK(straight.count(EdgeFacing::seen) == 4); // of the one light face
  for (const std::string view : {"cube_b.toml", "cube_c.toml", "cube_d.toml"}) {
    INFO(view);
    const Seen cube("cube_moved.toml", view);
    CHECK(cube.count(EdgeFacing::seen) == 9);
    CHECK(cube.count(EdgeFacing::dark) == 3);
    // Which meet in the farthest vertex: z of the OBSERVED position, into the screen.
    const auto depth = [&](std::uint32_t vertex) {
      const Vec3 p = of_book(cube.vertices()[vertex]);
      return view == "cube_b.toml" ? p.z : (p.x - 2 * p.y - 2 * p.z + 10) / 3;
    };
    std::uint32_t farthest = 0;
    for (std::uint32_t v = 1; v < 8; ++v)
      if (depth(v) > depth(farthest)) farthest = v;
    for (std::size_t i = 0; i < cube.edges().size(); ++i) {
      const SolidEdge& edge = cube.edges()[i];
      if (cube.solid.edges[i] == EdgeFacing::dark)
        CHECK((edge.from == farthest || edge.to == farthest));
    }
  }
}

TEST_CASE("listing 9.11: an edge of the spheroid is seen if a face beside it is light") {
  constexpr int kRound = 10, kDown = 8;
  const auto corner = [](int round, int down) {
    const double turn = M_PI / 25 + 2 * M_PI * round / kRound, fall = M_PI * down / kDown;
    return Vec3{std::sin(fall) * std::cos(turn), std::sin(fall) * std::sin(turn), std::cos(fall)};
  };
  // The face between two vertical lines and two horizontal ones; all planes are off the centre, so
  // the outward normal is that of the side on which it lies.
  const auto is_light = [&](int round, int down) {
    const Vec3 p = corner(round, down), q = corner(round + 1, down + 1);
    const Vec3 across = corner(round + 1, down) - corner(round, down + 1);
    Vec3 normal = cross(q - p, across);
    if (dot(normal, p + q) < 0) normal = -1.0 * normal;
    return dot(normal, {1, 3, 2}) > 0;
  };
  // Nothing where it is no line of the net.
  const auto expected = [&](Vec3 from, Vec3 to) -> std::optional<bool> {
    const auto is = [](Vec3 a, Vec3 b) { return length(a - b) < 1e-9; };
    for (int round = 0; round < kRound; ++round)
      for (int down = 0; down < kDown; ++down) {
        const Vec3 p = corner(round, down);
        const Vec3 below = corner(round, down + 1), beside = corner(round + 1, down);
        if ((is(p, from) && is(below, to)) || (is(p, to) && is(below, from)))
          return is_light(round, down) || is_light(round - 1, down);
        if (down > 0 && ((is(p, from) && is(beside, to)) || (is(p, to) && is(beside, from))))
          return is_light(round, down) || is_light(round, down - 1);
      }
    return std::nullopt;
  };
  const Seen spheroid("spheroid.toml", "spheroid.toml");
  int lines = 0, seen = 0;
  for (std::size_t i = 0; i < spheroid.edges().size(); ++i) {
    const SolidEdge& edge = spheroid.edges()[i];
    const auto is_seen = expected(spheroid.vertices()[edge.from], spheroid.vertices()[edge.to]);
    const EdgeFacing facing = spheroid.solid.edges[i];
    CHECK(is_seen.has_value() == !edge.smooth);
    if (!is_seen) {
      CHECK(facing == EdgeFacing::not_drawn);
      continue;
    }
    CHECK(facing == (*is_seen ? EdgeFacing::seen : EdgeFacing::dark));
    ++lines;
    seen += *is_seen ? 1 : 0;
  }
  CHECK(lines == 80 + 70);
  CHECK(seen > 75);
  CHECK(seen < lines);
}
