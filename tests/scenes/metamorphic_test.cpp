// SPDX-License-Identifier: GPL-3.0-or-later
// Turn, scale, shift: what must not change a drawing. Each is drawn twice and compared layer by
// layer, before simplification: visible length, and the farthest that ink of one is from ink of the
// other.
#include "map/draw_map.hpp"
#include "tests/catch.hpp"
#include "tests/scenes/random_scene.hpp"
#include "tests/support/grid_of.hpp"
#include "tests/support/random.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

namespace orograph::metamorphic_test {
namespace {

const std::uint64_t kScenes = last_seed(60);

struct Picture {
  TerrainData terrain;
  MapSpec spec;
};

Drawing draw(const Picture& picture) {
  const PlacedView scene = placed_view(picture.terrain, picture.spec);
  return draw_map(picture.terrain, scene, picture.spec, [](double) {}).drawing;
}

struct Line {
  Vec2 from, to;
};

std::vector<Line> lines_of(const Layer& layer) {
  std::vector<Line> lines;
  for (const Stroke& stroke : layer.strokes) {
    const auto points = layer.points(stroke);
    for (std::size_t i = 0; i + 1 < points.size(); ++i) lines.push_back({points[i], points[i + 1]});
  }
  return lines;
}

double distance_mm(Vec2 p, const Line& line) {
  const Vec2 along = line.to - line.from;
  const double share =
      std::clamp(dot(p - line.from, along) / std::max(dot(along, along), 1e-300), 0.0, 1.0);
  return length(p - (line.from + share * along));
}

double length_mm(const std::vector<Line>& lines) {
  double sum = 0;
  for (const Line& line : lines) sum += length(line.to - line.from);
  return sum;
}

// Length of ink that is farther than `near_mm` from all other ink, asked at points every 0.2 mm.
double lonely_mm(const std::vector<Line>& ink, const std::vector<Line>& other, double near_mm) {
  double lonely = 0;
  for (const Line& line : ink) {
    const double whole = length(line.to - line.from);
    const int count = static_cast<int>(std::ceil(whole / 0.2));
    for (int i = 0; i < count; ++i) {
      const Vec2 p = line.from + ((i + 0.5) / count) * (line.to - line.from);
      const bool near = std::any_of(other.begin(), other.end(), [&](const Line& o) {
        if (p.x < std::min(o.from.x, o.to.x) - near_mm ||
            p.x > std::max(o.from.x, o.to.x) + near_mm)
          return false;
        return distance_mm(p, o) <= near_mm;
      });
      if (!near) lonely += whole / count;
    }
  }
  return lonely;
}

// A random scene, framed by the view, whose answer doesn't hang on exact ties.
Picture picture_of(std::uint64_t seed) {
  RandomScene scene = random_scene(seed);
  Picture picture{std::move(scene.terrain), scene.spec};
  MapSpec& spec = picture.spec;
  spec.style.simplify_mm = 0;
  spec.style.silhouette_jump = 0;
  spec.style.flat = FlatGround::draw;
  Random random(seed + 5);
  spec.view.from_azimuth = Angle::degrees(random.between(0, 360));
  if (spec.view.from_elevation < Angle::degrees(1)) spec.view.from_elevation = Angle::degrees(13);
  const auto heights = std::get<Heights<float>>(grid_of(picture.terrain).heights_m).own();
  // In double, so that what is done to them rounds little; off their plateaus.
  std::vector<double> wider(heights.begin(), heights.end());
  for (double& h : wider) h += random.between(0, 0.5);
  grid_of(picture.terrain).heights_m = std::move(wider);
  return picture;
}

std::span<double> heights_of(Picture& picture) {
  return std::get<Heights<double>>(grid_of(picture.terrain).heights_m).own();
}

// Draws both, and compares all layers.
void check_same(const Picture& one, const Picture& other, double near_mm, double share,
                const std::function<Vec2(Vec2, const Page&)>& place = {}) {
  const Drawing a = draw(one), b = draw(other);
  CHECK(std::abs(a.page.width_mm - b.page.width_mm) <= near_mm);
  CHECK(std::abs(a.page.height_mm - b.page.height_mm) <= near_mm);
  REQUIRE(a.layers.size() == b.layers.size());
  for (std::size_t i = 0; i < a.layers.size(); ++i) {
    std::vector<Line> ink = lines_of(a.layers[i]), other_ink = lines_of(b.layers[i]);
    if (place)
      for (Line& line : other_ink) line = {place(line.from, b.page), place(line.to, b.page)};
    const double whole = length_mm(ink);
    CAPTURE(a.layers[i].name, whole, length_mm(other_ink));
    CHECK(std::abs(length_mm(other_ink) - whole) <= share * whole + 10 * near_mm);
    CHECK(lonely_mm(ink, other_ink, near_mm) <= share * whole);
    CHECK(lonely_mm(other_ink, ink, near_mm) <= share * whole);
  }
}

Vec2 turned(Vec2 p, double turn) {
  const double s = std::sin(turn), c = std::cos(turn);
  return {c * p.x - s * p.y, s * p.x + c * p.y};
}

// Page points are rounded to 1e-4 mm; crumbs of that length come and go.
constexpr double kNear = 3e-4, kShare = 2e-4;

} // namespace

TEST_CASE("turning terrain and view together changes nothing", "[unsanitized]") {
  for (std::uint64_t seed = 1; seed <= kScenes; ++seed) {
    CAPTURE(seed);
    const Picture one = picture_of(seed);
    Picture other = one;
    Random random(seed);
    const double degrees = random.between(-180, 180);
    const double turn = degrees * std::acos(-1.0) / 180;
    Grid& grid = grid_of(other.terrain);
    // About the middle, which the view is placed by.
    grid.plane().first_vertex_m = turned(grid.plane().first_vertex_m, turn);
    grid.plane().column_step_m = turned(grid.plane().column_step_m, turn);
    grid.plane().row_step_m = turned(grid.plane().row_step_m, turn);
    // A view looks at the middle of the bounding box, which doesn't turn along: name the target.
    const Vec2 target =
        grid_of(one.terrain)
            .plane()
            .position_m(grid_of(one.terrain).columns / 2, grid_of(one.terrain).rows / 2);
    Picture first = one;
    first.spec.view.look_at_map = Vec3{target.x, target.y, 100};
    const Vec2 turned_target = turned(target, turn);
    other.spec.view.look_at_map = Vec3{turned_target.x, turned_target.y, 100};
    other.spec.view.from_azimuth =
        Angle::degrees(one.spec.view.from_azimuth.in_degrees() - degrees);
    check_same(first, other, kNear, kShare);
  }
}

TEST_CASE("scaling everything changes nothing; by a power of two, not a bit",
          "[slow][unsanitized]") {
  for (std::uint64_t seed = 1; seed <= kScenes; ++seed) {
    CAPTURE(seed);
    const Picture one = picture_of(seed);
    for (const double scale : {1024.0, 0.3}) {
      Picture other = one;
      Grid& grid = grid_of(other.terrain);
      grid.plane().first_vertex_m = scale * grid.plane().first_vertex_m;
      grid.plane().column_step_m = scale * grid.plane().column_step_m;
      grid.plane().row_step_m = scale * grid.plane().row_step_m;
      for (double& h : heights_of(other)) h *= scale;
      check_same(one, other, kNear, kShare);
    }
  }
}

TEST_CASE("a shift by 1e7 changes nothing", "[unsanitized]") {
  for (std::uint64_t seed = 1; seed <= kScenes; ++seed) {
    CAPTURE(seed);
    const Picture one = picture_of(seed);
    Picture other = one;
    grid_of(other.terrain).plane().first_vertex_m =
        grid_of(other.terrain).plane().first_vertex_m + Vec2{1e7, -1e7};
    check_same(one, other, kNear, kShare);
  }
}

TEST_CASE("doubling every vertex changes nothing", "[unsanitized]") {
  std::uint64_t compared = 0;
  for (std::uint64_t seed = 1; seed <= kScenes; ++seed) {
    CAPTURE(seed);
    Picture one = picture_of(seed);
    Picture other = one;
    const Grid& coarse = grid_of(one.terrain);
    Grid& fine = grid_of(other.terrain);
    fine.columns = 2 * coarse.columns - 1;
    fine.rows = 2 * coarse.rows - 1;
    fine.plane().column_step_m = 0.5 * coarse.plane().column_step_m;
    fine.plane().row_step_m = 0.5 * coarse.plane().row_step_m;
    std::vector<double> heights(fine.size());
    // The new vertices lie on edges; the one in a cell's middle on its diagonal.
    for (int r = 0; r < fine.rows; ++r)
      for (int c = 0; c < fine.columns; ++c)
        heights[fine.index(c, r)] =
            0.5 * (coarse.height_m(c / 2, r / 2) + coarse.height_m((c + 1) / 2, (r + 1) / 2));
    fine.heights_m = std::move(heights);
    // A triangle with a hole at one vertex leaves three of its four small ones.
    const auto all = heights_of(one);
    if (std::any_of(all.begin(), all.end(), [](double h) { return std::isnan(h); })) continue;
    ++compared;
    // Where a view begins near the eye is told in cells.
    one.spec.view.projection = other.spec.view.projection = Projection::orthographic;
    check_same(one, other, kNear, kShare);
  }
  CHECK(compared > kScenes / 2);
}

TEST_CASE("a half turn, which keeps the diagonals, changes nothing", "[unsanitized]") {
  for (std::uint64_t seed = 1; seed <= kScenes; ++seed) {
    CAPTURE(seed);
    const Picture one = picture_of(seed);
    Picture other = one;
    Grid& grid = grid_of(other.terrain);
    // The same ground, told from its other end.
    grid.plane().first_vertex_m = grid.plane().position_m(grid.columns - 1, grid.rows - 1);
    grid.plane().column_step_m = -1.0 * grid.plane().column_step_m;
    grid.plane().row_step_m = -1.0 * grid.plane().row_step_m;
    std::reverse(heights_of(other).begin(), heights_of(other).end());
    check_same(one, other, kNear, kShare);
  }
}

TEST_CASE("a mirror image of ground whose diagonals don't matter is the mirrored drawing",
          "[unsanitized]") {
  for (std::uint64_t seed = 1; seed <= kScenes; ++seed) {
    CAPTURE(seed);
    Picture one = picture_of(seed);
    Random random(seed);
    // Cells are planar where a height is a function of the column plus one of the row.
    Grid& grid = grid_of(one.terrain);
    std::vector<double> by_column, by_row;
    for (int c = 0; c < grid.columns; ++c) by_column.push_back(random.between(0, 300));
    for (int r = 0; r < grid.rows; ++r) by_row.push_back(random.between(0, 300));
    for (int r = 0; r < grid.rows; ++r)
      for (int c = 0; c < grid.columns; ++c)
        heights_of(one)[grid.index(c, r)] =
            by_column[static_cast<std::size_t>(c)] + by_row[static_cast<std::size_t>(r)];
    grid.plane().first_vertex_m = {0, 0};
    grid.plane().column_step_m = {100, 0};
    grid.plane().row_step_m = {0, -100};
    one.spec.view.from_azimuth = Angle::degrees(random.between(0, 360));
    Picture other = one;
    for (int r = 0; r < grid.rows; ++r) {
      const auto row = heights_of(other).begin() + r * grid.columns;
      std::reverse(row, row + grid.columns);
    }
    other.spec.view.from_azimuth = Angle::degrees(-one.spec.view.from_azimuth.in_degrees());
    other.spec.view.oblique.rise =
        Angle::degrees(180 - one.spec.view.oblique.rise.in_degrees()); // to the left
    check_same(one, other, kNear, kShare, [](Vec2 p, const Page& page) {
      return Vec2{page.width_mm - p.x, p.y};
    });
  }
}

} // namespace orograph::metamorphic_test
