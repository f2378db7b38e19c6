// SPDX-License-Identifier: GPL-3.0-or-later
// What is cut, and what sheets show, judged point by point: a place of a stroke is drawn where a
// box holds it, and nowhere else; strokes end where they ended before, or on an edge.
#include "draw/cut_drawing.hpp"
#include "draw/round_drawing.hpp"
#include "draw/sheets.hpp"
#include "geometry/error.hpp"
#include "tests/catch.hpp"
#include "tests/draw/made_drawing.hpp"
#include "tests/draw/to_segment.hpp"
#include "tests/support/random.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace orograph::cut_drawing_test {
namespace {

constexpr double kNear_mm = 3e-4; // two roundings to the page's step, and some

// Random walks on the page, whose corners lie on a lattice in one drawing of three, so that they
// meet the edges of boxes.
Drawing random_walks(Random& random, const Page& page) {
  Drawing drawing;
  drawing.page = page;
  drawing.layers = {empty_layer("profiles"), empty_layer("border")};
  const double lattice_mm = random.chance(0.3) ? 5 : 1e-4;
  const Box2 inner = page.inner_mm();
  const auto on_lattice = [&](double mm) {
    return rounded_to_page_step(lattice_mm * std::round(mm / lattice_mm));
  };
  for (Layer& layer : drawing.layers)
    for (int s = 0; s < 6; ++s) {
      Stroke stroke{.first_point = static_cast<std::uint32_t>(layer.page_mm.size()), .profile = s};
      const int points = random.whole(2, 8);
      for (int i = 0; i < points; ++i) {
        const Vec2 p{on_lattice(random.between(inner.low.x, inner.high.x)),
                     on_lattice(random.between(inner.low.y, inner.high.y))};
        if (i == 0 || p != layer.page_mm.back()) layer.page_mm.push_back(p);
      }
      stroke.point_count = static_cast<std::uint32_t>(layer.page_mm.size()) - stroke.first_point;
      if (stroke.point_count > 1) layer.strokes.push_back(stroke);
    }
  return drawing;
}

double distance_mm(const Layer& layer, Vec2 p) {
  double least = 1e9;
  for (const Stroke& stroke : layer.strokes) {
    const auto points = layer.points(stroke);
    for (std::size_t i = 0; i + 1 < points.size(); ++i)
      least = std::min(least, to_segment(p, points[i], points[i + 1]));
  }
  return least;
}

bool holds(const Box2& box, Vec2 p, double grown_by) {
  return p.x >= box.low.x - grown_by && p.x <= box.high.x + grown_by &&
         p.y >= box.low.y - grown_by && p.y <= box.high.y + grown_by;
}

bool on_edge(const Box2& box, Vec2 p) {
  return holds(box, p, 0) &&
         (p.x == box.low.x || p.x == box.high.x || p.y == box.low.y || p.y == box.high.y);
}

bool is_end(const Layer& layer, Vec2 p) {
  return std::ranges::any_of(layer.strokes, [&](const Stroke& stroke) {
    return layer.points(stroke).front() == p || layer.points(stroke).back() == p;
  });
}

std::vector<Vec2> places_on(const Layer& layer, Random& random) {
  std::vector<Vec2> places;
  for (const Stroke& stroke : layer.strokes) {
    const auto points = layer.points(stroke);
    for (std::size_t i = 0; i + 1 < points.size(); ++i)
      for (int k = 0; k < 4; ++k)
        places.push_back(points[i] + random.share() * (points[i + 1] - points[i]));
  }
  return places;
}

// Of `cut` as what the box shows of `whole`; how many places were drawn.
int check_cut(const Layer& whole, const Layer& cut, const Box2& box, Random& random) {
  int drawn = 0;
  for (const Vec2 p : places_on(whole, random)) {
    if (!holds(box, p, -2 * kNear_mm)) continue;
    ++drawn;
    CHECK(distance_mm(cut, p) < kNear_mm);
  }
  for (const Vec2 p : places_on(cut, random)) {
    CHECK(holds(box, p, 1e-12));
    CHECK(distance_mm(whole, p) < kNear_mm);
  }
  for (const Stroke& stroke : cut.strokes)
    for (const Vec2 end : {cut.points(stroke).front(), cut.points(stroke).back()})
      CHECK((on_edge(box, end) || is_end(whole, end)));
  return drawn;
}

} // namespace

TEST_CASE("strokes are cut at a box's edges and nowhere else") {
  int drawn = 0;
  for (std::uint64_t seed = 1; seed <= last_seed(200); ++seed) {
    Random random(seed);
    const Drawing whole = random_walks(random, {100, 80, 5});
    Drawing cut = whole;
    const Box2 box = middle_of(whole.page, {5.0 * random.whole(1, 20), 5.0 * random.whole(1, 16)});
    cut_to(cut, box);
    INFO("seed " << seed);
    REQUIRE(cut.layers.size() == whole.layers.size());
    CHECK(!find_fault(cut));
    for (std::size_t i = 0; i < whole.layers.size(); ++i)
      drawn += check_cut(whole.layers[i], cut.layers[i], box, random);
  }
  CHECK(drawn > enough(2000));
}

TEST_CASE("sheets show all of a drawing, twice where they overlap") {
  for (std::uint64_t seed = 1; seed <= last_seed(100); ++seed) {
    Random random(seed);
    const Page sheet{60, 50, 5};
    const SheetsRequest request{random.whole(1, 3), random.whole(1, 3),
                                random.pick({0.0, 2.5, 10.0})};
    const Page page = page_of_sheets(sheet, request);
    CHECK(page.width_mm ==
          Approx(10 + 50 * request.columns - request.overlap_mm * (request.columns - 1)));
    const Drawing whole = random_walks(random, page);
    const std::vector<Drawing> sheets = sheets_of(whole, sheet, request);
    REQUIRE(sheets.size() == static_cast<std::size_t>(request.columns * request.rows));
    INFO("seed " << seed);
    for (int row = 0; row < request.rows; ++row)
      for (int column = 0; column < request.columns; ++column) {
        const Drawing& one = sheets[static_cast<std::size_t>(row * request.columns + column)];
        CHECK(!find_fault(one));
        REQUIRE(one.layers.size() == whole.layers.size() + 1);
        const Vec2 corner{column * (50 - request.overlap_mm), row * (40 - request.overlap_mm)};
        const Box2 box{corner + Vec2{5, 5}, corner + Vec2{55, 45}};
        for (std::size_t i = 0; i < whole.layers.size(); ++i) {
          Layer back = one.layers[i];
          for (Vec2& p : back.page_mm)
            p = {rounded_to_page_step(p.x + corner.x), rounded_to_page_step(p.y + corner.y)};
          check_cut(whole.layers[i], back, box, random);
        }
        // Two crosses on each seam, whole ones where the overlap has room for them.
        const std::size_t seams =
            (column > 0) + (column + 1 < request.columns) + (row > 0) + (row + 1 < request.rows);
        if (request.overlap_mm == 10) CHECK(one.layers.back().strokes.size() >= 4 * seams);
        CHECK((one.layers.back().strokes.empty()) == (seams == 0));
      }
    const Drawing overview = overview_of(whole, sheet, request);
    CHECK(!find_fault(overview));
    CHECK(overview.page.width_mm == 60);
  }
}

TEST_CASE("crosses of neighbouring sheets lie upon each other") {
  const Page sheet{60, 50, 5};
  const SheetsRequest request{2, 2, 10};
  Drawing whole;
  whole.page = page_of_sheets(sheet, request);
  const std::vector<Drawing> sheets = sheets_of(whole, sheet, request);
  // The middle of the overlap of the left sheets with the right ones is at 50.
  const auto draws = [&](std::size_t i, Vec2 from, Vec2 to) {
    const Layer& marks = sheets[i].layers.back();
    return std::ranges::any_of(marks.strokes, [&](const Stroke& stroke) {
      return marks.points(stroke).front() == from && marks.points(stroke).back() == to;
    });
  };
  CHECK(draws(0, {47, 20}, {53, 20}));
  CHECK(draws(1, {7, 20}, {13, 20}));
  CHECK(draws(0, {50, 17}, {50, 23}));
  CHECK(draws(1, {10, 17}, {10, 23}));
  CHECK(draws(0, {17, 40}, {23, 40}));
  CHECK(draws(2, {17, 10}, {23, 10}));
}

TEST_CASE("each sheet bears another number, where its neighbour covers it or it is cut off") {
  for (const auto& [columns, rows] : {std::pair{3, 4}, {1, 2}, {2, 1}, {1, 1}}) {
    INFO(columns << "x" << rows);
    const Page sheet{160, 150, 5};
    const SheetsRequest request{columns, rows, 10};
    Drawing whole;
    whole.page = page_of_sheets(sheet, request);
    const Box2 inner = sheet.inner_mm();
    std::vector<std::vector<Vec2>> numbers;
    for (const Drawing& one : sheets_of(whole, sheet, request)) {
      const Layer& marks = one.layers.back();
      const std::size_t i = numbers.size();
      const int column = static_cast<int>(i) % columns, row = static_cast<int>(i) / columns;
      // Nearer to an edge than the middle of the overlap is, with a neighbour behind it.
      const auto is_hidden = [&](Vec2 p) {
        return (column + 1 < columns && p.x > inner.high.x - 5) ||
               (column > 0 && p.x < inner.low.x + 5) ||
               (row + 1 < rows && p.y > inner.high.y - 5) || (row > 0 && p.y < inner.low.y + 5);
      };
      std::vector<Vec2>& number = numbers.emplace_back();
      Vec2 low{1e9, 1e9};
      for (const Stroke& stroke : marks.strokes) {
        const auto points = marks.points(stroke);
        if (length(points.back() - points.front()) > 2) continue; // a cross's
        for (const Vec2 p : points) {
          CHECK(is_hidden(p));
          low = {std::min(low.x, p.x), std::min(low.y, p.y)};
          number.push_back(p);
        }
      }
      for (Vec2& p : number) p = {std::round(1e3 * (p.x - low.x)), std::round(1e3 * (p.y - low.y))};
      CHECK(number.empty() == (columns * rows == 1));
    }
    for (std::size_t i = 0; i < numbers.size(); ++i)
      for (std::size_t j = i + 1; j < numbers.size(); ++j) CHECK(numbers[i] != numbers[j]);
  }
  // An overlap without room for it.
  Drawing whole;
  whole.page = page_of_sheets({160, 150, 5}, {2, 1, 2});
  for (const Drawing& one : sheets_of(whole, {160, 150, 5}, {2, 1, 2}))
    CHECK(one.layers.back().strokes.size() == 4);
}

TEST_CASE("no pen is put in twice for what is beside the map") {
  const Page sheet{60, 50, 5};
  const SheetsRequest request{2, 1, 10};
  Drawing whole;
  whole.page = page_of_sheets(sheet, request);
  for (const int number : {4, 2}) {
    whole.layers.push_back(empty_layer("pen"));
    whole.layers.back().pen = Pen{.number = number};
    add_stroke(whole.layers.back(), {{10, 10.0 + number}, {100, 10}}, -1);
  }
  std::vector<Drawing> all = sheets_of(whole, sheet, request);
  all.push_back(overview_of(whole, sheet, request));
  for (const Drawing& one : all) {
    REQUIRE(one.layers.size() == 2);
    CHECK(one.layers[0].strokes.size() >= 3); // a line, and crosses or frames
    CHECK(one.layers[1].strokes.size() == 1);
    CHECK(!find_fault(one));
  }
}

TEST_CASE("an overlap that leaves nothing of a sheet is refused") {
  CHECK_THROWS_AS(page_of_sheets({60, 50, 5}, {2, 2, 39.5}), UsageError);
  CHECK_NOTHROW(page_of_sheets({60, 50, 5}, {2, 2, 39}));
}

} // namespace orograph::cut_drawing_test
