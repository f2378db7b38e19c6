// SPDX-License-Identifier: GPL-3.0-or-later
// Smoothed strokes by their definition: the Fréchet distance by its free-space diagram, crossings
// by every pair of segments, and what a staircase becomes.
#include "draw/smooth_strokes.hpp"
#include "tests/catch.hpp"
#include "tests/draw/to_segment.hpp"
#include "tests/support/random.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <set>
#include <vector>

namespace orograph::smooth_strokes_test {
namespace {

using Line = std::vector<Vec2>;

constexpr Box2 kFrame{{-1000, -1000}, {1000, 1000}};

void add_stroke(Layer& layer, const Line& points) {
  Stroke stroke;
  stroke.first_point = static_cast<std::uint32_t>(layer.page_mm.size());
  stroke.point_count = static_cast<std::uint32_t>(points.size());
  layer.page_mm.insert(layer.page_mm.end(), points.begin(), points.end());
  layer.strokes.push_back(stroke);
}

Layer layer_of(const std::vector<Line>& lines) {
  Layer layer;
  for (const Line& line : lines) add_stroke(layer, line);
  return layer;
}

std::vector<Line> lines_of(const Layer& layer) {
  std::vector<Line> lines;
  for (const Stroke& stroke : layer.strokes) {
    const auto points = layer.points(stroke);
    lines.emplace_back(points.begin(), points.end());
  }
  return lines;
}

struct Range {
  double low = 1, high = 0;
  bool empty() const { return !(low <= high); }
};

// Of the segment from a to b the shares that are within `distance` of p.
Range free_of(Vec2 p, Vec2 a, Vec2 b, double distance) {
  const Vec2 along = b - a, off = a - p;
  const double aa = dot(along, along), bb = dot(along, off),
               cc = dot(off, off) - distance * distance;
  if (aa == 0) return cc <= 0 ? Range{0, 1} : Range{};
  const double root = bb * bb - aa * cc;
  if (root < 0) return {};
  return {std::max(0.0, (-bb - std::sqrt(root)) / aa), std::min(1.0, (-bb + std::sqrt(root)) / aa)};
}

// Whether the Fréchet distance is at most `distance` (Alt and Godau, 1995): what can be reached of
// the free-space diagram's cells' left and lower sides, cell after cell.
bool within_frechet(const Line& p, const Line& q, double distance) {
  if (length(p.front() - q.front()) > distance || length(p.back() - q.back()) > distance)
    return false;
  const std::size_t n = p.size() - 1, m = q.size() - 1;
  const auto reach = [](Range free, double from) {
    return Range{std::max(free.low, from), free.high};
  };
  // left[k]: of q's segment k at p's vertex i; below: of p's segment i at q's vertex k.
  std::vector<Range> left(m);
  for (std::size_t k = 0; k < m; ++k) {
    left[k] = free_of(p[0], q[k], q[k + 1], distance);
    if (!left[k].empty() && left[k].low > 0) left[k] = {};
    if (k > 0 && (left[k - 1].empty() || left[k - 1].high < 1)) left[k] = {};
  }
  bool bottom_open = true;
  for (std::size_t i = 0; i < n; ++i) {
    Range below = free_of(q[0], p[i], p[i + 1], distance);
    if (!bottom_open || (!below.empty() && below.low > 0)) below = {};
    bottom_open = !below.empty() && below.high >= 1;
    for (std::size_t k = 0; k < m; ++k) {
      const Range right_free = free_of(p[i + 1], q[k], q[k + 1], distance),
                  top_free = free_of(q[k + 1], p[i], p[i + 1], distance);
      const Range right = !below.empty()     ? right_free
                          : !left[k].empty() ? reach(right_free, left[k].low)
                                             : Range{};
      const Range top = !left[k].empty() ? top_free
                        : !below.empty() ? reach(top_free, below.low)
                                         : Range{};
      left[k] = right;
      below = top;
    }
    if (i + 1 == n) return !below.empty() && below.high >= 1;
  }
  return false;
}

// Boxes tell apart what lies on one line, where signs are rounding alone.
bool cross_each_other(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
  const auto apart = [](double p, double q, double r, double s) {
    return std::max(p, q) < std::min(r, s) || std::max(r, s) < std::min(p, q);
  };
  if (apart(a.x, b.x, c.x, d.x) || apart(a.y, b.y, c.y, d.y)) return false;
  const double abc = cross(b - a, c - a), abd = cross(b - a, d - a), cda = cross(d - c, a - c),
               cdb = cross(d - c, b - c);
  return (abc > 0) != (abd > 0) && (cda > 0) != (cdb > 0) && abc != 0 && abd != 0 && cda != 0 &&
         cdb != 0;
}

std::size_t crossings(const std::vector<Line>& lines) {
  std::vector<std::pair<Vec2, Vec2>> segments;
  for (const Line& line : lines)
    for (std::size_t i = 1; i < line.size(); ++i) segments.emplace_back(line[i - 1], line[i]);
  std::size_t count = 0;
  for (std::size_t i = 0; i < segments.size(); ++i)
    for (std::size_t k = 0; k < i; ++k)
      if (cross_each_other(segments[i].first, segments[i].second, segments[k].first,
                           segments[k].second))
        ++count;
  return count;
}

// The outlines of random cells of a lattice that is drawn aslant: they never cross, and where two
// meet in a vertex they don't either. Each is a ring, walked with its cells on the left, but the
// first, of which a random half may be taken.
std::vector<Line> outlines(Random& random, double cell_mm) {
  constexpr int kSide = 9;
  std::vector<std::vector<bool>> full(kSide + 2, std::vector<bool>(kSide + 2));
  const double share = random.between(0.3, 0.7);
  for (int r = 1; r <= kSide; ++r)
    for (int c = 1; c <= kSide; ++c) full[r][c] = random.chance(share);
  const double turn = random.between(0, 6), flat = random.between(0.2, 1);
  const auto place = [&](int c, int r) {
    const Vec2 at{cell_mm * c, cell_mm * r};
    return Vec2{std::cos(turn) * at.x - std::sin(turn) * at.y,
                flat * (std::sin(turn) * at.x + std::cos(turn) * at.y)};
  };
  using Vertex = std::pair<int, int>;
  std::set<std::pair<Vertex, Vertex>> edges;
  for (int r = 1; r <= kSide; ++r)
    for (int c = 1; c <= kSide; ++c) {
      if (!full[r][c]) continue;
      if (!full[r - 1][c]) edges.insert({{c + 1, r}, {c, r}});
      if (!full[r + 1][c]) edges.insert({{c, r + 1}, {c + 1, r + 1}});
      if (!full[r][c - 1]) edges.insert({{c, r}, {c, r + 1}});
      if (!full[r][c + 1]) edges.insert({{c + 1, r + 1}, {c + 1, r}});
    }
  std::vector<Line> lines;
  while (!edges.empty()) {
    auto [from, to] = *edges.begin();
    Line line{place(from.first, from.second)};
    std::optional<Vertex> before = from;
    edges.erase(edges.begin());
    while (true) {
      line.push_back(place(to.first, to.second));
      // Of two ways on, the one that turns to the side of its own cells.
      std::optional<std::pair<Vertex, Vertex>> next;
      int best = -2;
      for (const auto& edge : edges) {
        if (edge.first != to) continue;
        const int bend = (to.first - before->first) * (edge.second.second - to.second) -
                         (to.second - before->second) * (edge.second.first - to.first);
        if (-bend > best) {
          best = -bend;
          next = edge;
        }
      }
      if (!next) break;
      edges.erase(*next);
      before = to;
      to = next->second;
    }
    lines.push_back(line);
  }
  return lines;
}

} // namespace

TEST_CASE("smoothed strokes are within the bound, and cross only where they did", "[unsanitized]") {
  std::size_t strokes = 0, crossed = 0, moved = 0;
  for (std::uint64_t seed = 1; seed <= last_seed(200); ++seed) {
    Random random(seed);
    const double cell_mm = random.pick({0.05, 0.3, 1.0, 4.0}),
                 bound_mm = random.pick({0.01, 0.05, 0.3, 1.0});
    std::vector<Line> before = outlines(random, cell_mm);
    for (Line& line : before) // open ones, too
      if (line.size() > 4 && random.chance(0.3)) line.resize(line.size() / 2 + 1);
    INFO("seed " << seed << ", cells of " << cell_mm << ", bound " << bound_mm);
    const std::vector<Line> after = lines_of(smoothed(layer_of(before), {bound_mm, 0, kFrame}));
    REQUIRE(after.size() == before.size());
    bool all_within = true, ends_stay = true;
    for (std::size_t i = 0; i < after.size(); ++i) {
      ++strokes;
      all_within &= within_frechet(before[i], after[i], bound_mm * (1 + 1e-9));
      moved += within_frechet(before[i], after[i], 0.05 * bound_mm) ? 0U : 1U;
      ends_stay &= before[i].front() == before[i].back() ? after[i].front() == after[i].back()
                                                         : before[i].front() == after[i].front() &&
                                                               before[i].back() == after[i].back();
    }
    CHECK(all_within);
    CHECK(ends_stay);
    REQUIRE(crossings(before) == 0);
    crossed += crossings(after);
  }
  CHECK(moved > strokes / 2);
  CAPTURE(strokes, crossed);
  CHECK(crossed == 0);
}

TEST_CASE("what is simplified besides is within both bounds together") {
  const auto farthest = [](const Line& from, const Line& to) {
    double most = 0;
    for (std::size_t i = 0; i + 1 < from.size(); ++i)
      for (int k = 0; k <= 8; ++k) {
        const Vec2 p = from[i] + (k / 8.0) * (from[i + 1] - from[i]);
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t j = 0; j + 1 < to.size(); ++j)
          least = std::min(least, to_segment(p, to[j], to[j + 1]));
        most = std::max(most, least);
      }
    return most;
  };
  for (std::uint64_t seed = 1; seed <= last_seed(200); ++seed) {
    Random random(seed);
    const std::vector<Line> before = outlines(random, random.pick({0.1, 0.5, 2.0}));
    const double simplify_mm = random.pick({0.01, 0.1});
    const std::vector<Line> after =
        lines_of(smoothed(layer_of(before), {0.3, simplify_mm, kFrame}));
    INFO("seed " << seed);
    bool all_within = true;
    for (std::size_t i = 0; i < after.size(); ++i)
      all_within &= farthest(before[i], after[i]) <= 0.3 + simplify_mm + 1e-9 &&
                    farthest(after[i], before[i]) <= 0.3 + simplify_mm + 1e-9;
    CHECK(all_within);
  }
}

TEST_CASE("a staircase becomes a straight line") {
  for (const int steps_across : {1, 2, 3}) {
    Line stairs{{0, 0}};
    for (int i = 0; i < 60; ++i) {
      const Vec2 at = stairs.back();
      stairs.push_back({at.x + 0.3 * steps_across, at.y});
      stairs.push_back({at.x + 0.3 * steps_across, at.y + 0.3});
    }
    const std::vector<Line> after = lines_of(smoothed(layer_of({stairs}), {0.3, 0, kFrame}));
    const Vec2 along = stairs.back() - stairs.front(), across{-along.y, along.x};
    double low = 1e9, high = -1e9;
    for (const Vec2& p : after.front()) {
      // Away from its ends, which stay on a corner of the staircase.
      if (p.x < 5 || p.x > stairs.back().x - 5) continue;
      const double aside = dot(across, p) / length(across);
      low = std::min(low, aside);
      high = std::max(high, aside);
    }
    INFO(steps_across);
    CHECK(high - low < 0.02);
  }
}

TEST_CASE("an island stays as large as it is, and in the frame") {
  for (const double radius_mm : {0.3, 0.6, 1.0, 3.0, 20.0}) {
    Line ring;
    for (int i = 0; i < 400; ++i) {
      const double turn = 2 * std::numbers::pi * (i % 399) / 399;
      ring.push_back({radius_mm * std::cos(turn), radius_mm * std::sin(turn)});
    }
    ring.back() = ring.front();
    const Line after = lines_of(smoothed(layer_of({ring}), {0.3, 0, kFrame})).front();
    double low = 1e9, high = 0;
    for (const Vec2& p : after) {
      low = std::min(low, length(p));
      high = std::max(high, length(p));
    }
    INFO(radius_mm);
    CHECK(low > 0.9 * radius_mm);
    CHECK(high < 1.1 * radius_mm);
    const Box2 frame{{-radius_mm, -radius_mm}, {radius_mm, radius_mm}};
    bool in_frame = true;
    for (const Vec2& p : smoothed(layer_of({ring}), {0.3, 0, frame}).page_mm)
      in_frame &= std::abs(p.x) <= radius_mm && std::abs(p.y) <= radius_mm;
    CHECK(in_frame);
  }
}

TEST_CASE("without a bound, or one that no pen shows, strokes stay what they are") {
  Random random(1);
  const std::vector<Line> before = outlines(random, 1);
  for (const double bound_mm : {0.0, 0.5 * kLeastSmoothing_mm})
    CHECK(lines_of(smoothed(layer_of(before), {bound_mm, 0, kFrame})) == before);
}

TEST_CASE("strokes of no length stay") {
  const std::vector<Line> points{{{1, 1}, {1, 1}}, {{2, 2}, {2, 2}, {2, 2}}};
  for (const Line& line : lines_of(smoothed(layer_of(points), {0.3, 0, kFrame})))
    CHECK(std::all_of(line.begin(), line.end(), [&](Vec2 p) { return p == line.front(); }));
}

} // namespace orograph::smooth_strokes_test
