// SPDX-License-Identifier: GPL-3.0-or-later
// Strokes as chains, on lattices with many ties and on scattered ends: what is drawn is what was
// there and bridges, each between two ends no farther apart than the gap.
#include "draw/join_strokes.hpp"
#include "geometry/vec.hpp"
#include "tests/catch.hpp"
#include "tests/support/random.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace orograph::join_strokes_test {
namespace {

using Point = std::pair<double, double>;
using Link = std::pair<Point, Point>;

const std::uint64_t kLayers = last_seed(2000);

void add_stroke(Layer& layer, const std::vector<Vec2>& points) {
  Stroke stroke;
  stroke.first_point = static_cast<std::uint32_t>(layer.page_mm.size());
  stroke.point_count = static_cast<std::uint32_t>(points.size());
  layer.page_mm.insert(layer.page_mm.end(), points.begin(), points.end());
  layer.strokes.push_back(stroke);
}

// On a lattice, where ends often share a place, or anywhere.
Layer random_layer(Random& random, bool on_lattice) {
  Layer layer;
  const int strokes = random.whole(1, 40);
  for (int s = 0; s < strokes; ++s) {
    std::vector<Vec2> points;
    const int count = random.whole(2, 4);
    while (static_cast<int>(points.size()) < count) {
      const Vec2 p = on_lattice ? Vec2{1.0 * random.whole(0, 6), 1.0 * random.whole(0, 6)}
                                : Vec2{random.between(0, 6), random.between(0, 6)};
      if (points.empty() || p.x != points.back().x || p.y != points.back().y) points.push_back(p);
    }
    add_stroke(layer, points);
  }
  return layer;
}

Link link(Vec2 a, Vec2 b) {
  const Point p{a.x, a.y}, q{b.x, b.y};
  return {std::min(p, q), std::max(p, q)};
}

std::map<Link, int> links_of(const Layer& layer) {
  std::map<Link, int> out;
  for (const Stroke& stroke : layer.strokes) {
    const auto points = layer.points(stroke);
    for (std::size_t i = 1; i < points.size(); ++i) ++out[link(points[i - 1], points[i])];
  }
  return out;
}

double ink_mm(const Layer& layer) {
  double sum = 0;
  for (const auto& [ends, times] : links_of(layer))
    sum += times *
           std::hypot(ends.first.first - ends.second.first, ends.first.second - ends.second.second);
  return sum;
}

// How often each place is an end of a stroke that isn't closed.
std::map<Point, int> loose_ends(const Layer& layer) {
  std::map<Point, int> out;
  for (const Stroke& stroke : layer.strokes) {
    const auto points = layer.points(stroke);
    ++out[{points.front().x, points.front().y}];
    ++out[{points.back().x, points.back().y}];
  }
  return out;
}

// The four that cost least of an end's neighbours, from all of them; then pairs, the cheapest
// first.
std::set<Link> bridges_by_definition(const Layer& layer, double gap_mm) {
  struct End {
    Vec2 at, onwards;
  };
  std::vector<End> ends;
  for (const Stroke& stroke : layer.strokes) {
    const auto points = layer.points(stroke);
    const Vec2 along = points[1] - points[0];
    const double size = plain_length(along);
    ends.push_back({points[0], (-1 / size) * along});
    ends.push_back({points[1], (1 / size) * along});
  }
  using Pair = std::pair<double, std::pair<std::size_t, std::size_t>>;
  std::set<Pair> pairs;
  for (std::size_t i = 0; i < ends.size(); ++i) {
    std::vector<Pair> of_end;
    for (std::size_t k = 0; k < ends.size(); ++k) {
      const double apart = plain_length(ends[k].at - ends[i].at);
      if (i / 2 == k / 2 || apart > gap_mm) continue; // all strokes are shorter than eight gaps
      const double turn = 0.5 * (1 + dot(ends[i].onwards, ends[k].onwards));
      of_end.push_back({apart + turn * gap_mm, std::minmax(i, k)});
    }
    std::sort(of_end.begin(), of_end.end());
    pairs.insert(of_end.begin(), of_end.begin() + static_cast<std::ptrdiff_t>(
                                                      std::min<std::size_t>(4, of_end.size())));
  }
  std::vector<bool> taken(ends.size());
  std::set<Link> out;
  for (const auto& [cost, pair] : pairs) {
    const auto [a, b] = pair;
    if (taken[a] || taken[b]) continue;
    taken[a] = taken[b] = true;
    out.insert(link(ends[a].at, ends[b].at));
  }
  return out;
}

} // namespace

TEST_CASE("in a crowd each end has its best neighbours, too") {
  std::size_t crowd = 0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    Random random(seed);
    Layer layer;
    // So many that all ends have hundreds within the gap, or some of them.
    const double width = random.pick({2.0, 6.0, 40.0});
    for (int i = 0; i < 700; ++i) {
      const Vec2 at{random.between(0, width), random.between(0, 1.5)};
      add_stroke(layer, {at, at + Vec2{random.between(-2, 2), random.between(0.01, 1)}});
    }
    double left_out_mm = 0;
    std::map<Link, int> rest = links_of(joined(layer, {1, 0, 0}, left_out_mm));
    for (const auto& [ends, times] : links_of(layer)) rest[ends] -= times;
    std::set<Link> bridges;
    for (const auto& [ends, times] : rest)
      if (times > 0) bridges.insert(ends);
    INFO("seed " << seed << ", width " << width);
    CHECK(bridges == bridges_by_definition(layer, 1));
    crowd += bridges.size();
  }
  CHECK(crowd > 4000);
}

TEST_CASE("joined strokes are all that was there, and bridges between their ends") {
  std::size_t joints = 0, bridges = 0;
  for (std::uint64_t seed = 1; seed <= kLayers; ++seed) {
    Random random(seed);
    const bool on_lattice = seed % 2 == 0;
    const Layer layer = random_layer(random, on_lattice);
    const double gap_mm = random.pick({0.0, 0.01, 0.3, 1.0, 1.5});
    INFO("seed " << seed << ", gap " << gap_mm);
    double left_out_mm = 0;
    const Layer out = joined(layer, {gap_mm, 0, 0}, left_out_mm);
    CHECK(left_out_mm == 0);
    // Each place between two points that was drawn is drawn as often, and else only bridges are.
    std::map<Link, int> rest = links_of(out);
    bool all_there = true;
    for (const auto& [ends, times] : links_of(layer)) all_there &= (rest[ends] -= times) >= 0;
    CHECK(all_there);
    const std::map<Point, int> ends_before = loose_ends(layer);
    bool between_ends = true;
    for (const auto& [ends, times] : rest) {
      if (times == 0 || ends.first == ends.second) continue;
      bridges += static_cast<std::size_t>(times);
      between_ends &= ends_before.count(ends.first) > 0 && ends_before.count(ends.second) > 0 &&
                      std::hypot(ends.first.first - ends.second.first,
                                 ends.first.second - ends.second.second) <= gap_mm * (1 + 1e-12);
    }
    CHECK(between_ends);
    joints += layer.strokes.size() - out.strokes.size();
    if (gap_mm == 0) CHECK(out.strokes.size() == layer.strokes.size());
  }
  CHECK(joints > 2 * kLayers);
  CHECK(bridges > kLayers);
}

TEST_CASE("of ends that are near no others none stays apart") {
  // Two ends within the gap with nothing else near are one line, whatever their numbers.
  for (std::uint64_t seed = 1; seed <= kLayers; ++seed) {
    Random random(seed);
    Layer layer;
    std::vector<std::vector<Vec2>> parts;
    double x = random.between(-5, 5);
    const int count = random.whole(2, 20);
    for (int i = 0; i < count; ++i) {
      const double end = x + random.between(4, 9);
      parts.push_back({{x, random.between(0, 1e-3)}, {end, random.between(0, 1e-3)}});
      x = end + random.between(0, 0.49);
    }
    for (std::size_t i = parts.size(); i-- > 1;)
      std::swap(parts[i], parts[static_cast<std::size_t>(random.whole(0, static_cast<int>(i)))]);
    for (std::vector<Vec2>& points : parts) {
      if (random.whole(0, 1) == 1) std::reverse(points.begin(), points.end());
      add_stroke(layer, points);
    }
    double left_out_mm = 0;
    INFO("seed " << seed);
    const Layer out = joined(layer, {0.5, 0, 0}, left_out_mm);
    CHECK(out.strokes.size() == 1);
    CHECK(out.page_mm.size() == 2 * parts.size());
  }
}

TEST_CASE("chains are left out as wholes") {
  double kept_mm = 0;
  for (std::uint64_t seed = 1; seed <= kLayers; ++seed) {
    Random random(seed);
    const Layer layer = random_layer(random, seed % 2 == 0);
    const double gap_mm = random.pick({0.0, 0.3, 1.0}), least_mm = random.between(0, 20);
    double none_mm = 0, left_out_mm = 0;
    const Layer all = joined(layer, {gap_mm, 0, 0}, none_mm),
                some = joined(layer, {gap_mm, least_mm, 0}, left_out_mm);
    INFO("seed " << seed);
    // What is drawn are chains of the whole, in their order, and the others have little ink.
    std::size_t at = 0;
    double short_mm = 0;
    for (const Stroke& stroke : all.strokes) {
      const auto points = all.points(stroke);
      const bool is_drawn =
          at < some.strokes.size() && std::ranges::equal(points, some.points(some.strokes[at]));
      if (is_drawn) {
        ++at;
        continue;
      }
      Layer alone;
      add_stroke(alone, {points.begin(), points.end()});
      short_mm += ink_mm(alone);
    }
    CHECK(at == some.strokes.size());
    // Bridges are no ink that was there.
    CHECK(left_out_mm <= short_mm * (1 + 1e-12));
    if (gap_mm == 0) CHECK(std::abs(left_out_mm - short_mm) < 1e-9);
    kept_mm += ink_mm(some);
    // In the layer itself, whatever is a chain with enough ink is there.
    if (left_out_mm == 0) CHECK(some.strokes.size() == all.strokes.size());
  }
  CHECK(kept_mm > 0);
}

TEST_CASE("lines that go straight on are joined before those that turn") {
  Layer layer;
  add_stroke(layer, {{0, 0}, {10, 0}});
  add_stroke(layer, {{10.2, 0}, {20, 0}});  // straight on
  add_stroke(layer, {{10.18, 0}, {15, 5}}); // nearer, but turning
  double left_out_mm = 0;
  const Layer out = joined(layer, {0.5, 0, 0}, left_out_mm);
  REQUIRE(out.strokes.size() == 2);
  CHECK(out.points(out.strokes[0]).back().x == 20);
}

TEST_CASE("a line whose ends meet is closed, and a crumb isn't") {
  Layer ring;
  add_stroke(ring, {{0, 0}, {10, 0}, {10, 10}, {0, 10}, {0, 0.1}});
  double left_out_mm = 0;
  const Layer closed = joined(ring, {0.15, 0, 0}, left_out_mm);
  CHECK(closed.page_mm.size() == 6);
  CHECK(closed.page_mm.back().y == 0);
  Layer crumb;
  add_stroke(crumb, {{0, 0}, {0.3, 0}, {0.05, 0.1}});
  CHECK(joined(crumb, {0.15, 0, 0}, left_out_mm).page_mm.size() == 3);
}

TEST_CASE("strokes with map points aren't bridged") {
  Layer layer;
  add_stroke(layer, {{0, 0}, {1, 0}});
  add_stroke(layer, {{1.1, 0}, {2, 0}});
  layer.map = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}};
  double left_out_mm = 0;
  const Layer out = joined(layer, {0.15, 1.5, 0}, left_out_mm);
  CHECK(out.strokes.size() == 2); // judged as one of 1.9 mm
  CHECK(left_out_mm == 0);
  CHECK(out.map.size() == 4);
  CHECK(joined(layer, {0.05, 1.5, 0}, left_out_mm).strokes.empty());
}

} // namespace orograph::join_strokes_test
