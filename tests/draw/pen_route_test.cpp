// SPDX-License-Identifier: GPL-3.0-or-later
// Ways of a pen by their definitions: each line once; the nearest first, found by looking at all;
// and of a few lines none of all the changes that exchanging is to try makes a way shorter.
#include "draw/pen_route.hpp"
#include "draw/shorten_route.hpp"
#include "geometry/on_all_cores.hpp"
#include "tests/catch.hpp"
#include "tests/support/random.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace orograph::pen_route_test {
namespace {

// A line as its places: of an open one its two ends, which may share a place.
struct Line {
  std::vector<Vec2> places;
  bool is_ring;
};

// How a line is drawn: from which of its places.
struct Visit {
  std::size_t line, place;
};

using Visits = std::vector<Visit>;

Vec2 left_at(const Line& line, std::size_t place) {
  return line.places[line.is_ring ? place : 1 - place];
}

double way(const std::vector<Line>& lines, Vec2 pen, const Visits& visits) {
  double sum = 0;
  for (const auto& [line, place] : visits) {
    sum += length(lines[line].places[place] - pen);
    pen = left_at(lines[line], place);
  }
  return sum;
}

struct Case {
  std::vector<Line> lines;
  Vec2 pen;
  PenLines pen_lines;

  // On a lattice of few places ends meet and ways tie.
  Case(Random& random, int most_lines) {
    const int lattice = random.pick({2, 6, 0});
    const auto point = [&] {
      return lattice == 0 ? Vec2{random.between(0, 100), random.between(0, 50)}
                          : Vec2{1.0 * random.whole(0, lattice), 1.0 * random.whole(0, lattice)};
    };
    const double rings = random.pick({0.0, 0.3, 1.0});
    const int count = random.whole(0, most_lines);
    for (int i = 0; i < count; ++i) {
      const bool is_ring = random.chance(rings);
      const int places = is_ring ? random.whole(1, 5) : 2;
      Line line{{}, is_ring};
      for (int k = 0; k < places; ++k) line.places.push_back(point());
      if (is_ring)
        pen_lines.add_ring(line.places);
      else
        pen_lines.add_open(line.places[0], line.places[1]);
      lines.push_back(line);
    }
    pen = point();
  }

  // Each line once, from a place of its own.
  Visits visits(const PenRoute& route) const {
    Visits out;
    std::vector<int> times(lines.size(), 0);
    for (const std::uint32_t place : route) {
      std::size_t line = 0, first = 0;
      while (first + lines[line].places.size() <= place) first += lines[line++].places.size();
      ++times[line];
      out.push_back({line, place - first});
    }
    REQUIRE(std::ranges::count(times, 1) == static_cast<std::ptrdiff_t>(lines.size()));
    REQUIRE(out.size() == lines.size());
    return out;
  }
};

} // namespace

TEST_CASE("each time the nearest place of what is left comes next") {
  for (std::uint64_t seed = 1; seed <= last_seed(1000); ++seed) {
    INFO("seed " << seed);
    Random random(seed);
    const Case of(random, 30);
    const PenRoute route = nearest_first(of.pen_lines, of.pen);
    const Visits visits = of.visits(route);
    std::vector<bool> drawn(of.lines.size(), false);
    Vec2 pen = of.pen;
    for (const Visit& visit : visits) {
      double least = std::numeric_limits<double>::infinity();
      Visit first{};
      for (std::size_t line = 0; line < of.lines.size(); ++line)
        for (std::size_t place = 0; place < of.lines[line].places.size(); ++place) {
          const Vec2 away = of.lines[line].places[place] - pen;
          if (drawn[line] || dot(away, away) >= least) continue;
          least = dot(away, away);
          first = {line, place};
        }
      REQUIRE((visit.line == first.line && visit.place == first.place));
      drawn[visit.line] = true;
      pen = left_at(of.lines[visit.line], visit.place);
    }
    CHECK(std::abs(way_mm(of.pen_lines, of.pen, route) - way(of.lines, of.pen, visits)) < 1e-9);
  }
}

TEST_CASE("of five lines no part is better turned round, none moved, no ring begun elsewhere") {
  constexpr double kGain = 1e-5; // less isn't worth an exchange
  const std::uint64_t kCases = last_seed(5000);
  std::size_t shorter = 0;
  for (std::uint64_t seed = 1; seed <= kCases; ++seed) {
    INFO("seed " << seed);
    Random random(seed);
    const Case of(random, 5);
    const PenRoute sorted = nearest_first(of.pen_lines, of.pen);
    const Visits visits = of.visits(shortened(of.pen_lines, of.pen, sorted));
    const double mm = way(of.lines, of.pen, visits);
    const double before = way(of.lines, of.pen, of.visits(sorted));
    CHECK(mm <= before + 1e-9);
    if (mm < before - kGain) ++shorter;
    const auto turn = [&](Visits& some, std::size_t begin, std::size_t end) {
      std::reverse(some.begin() + static_cast<std::ptrdiff_t>(begin),
                   some.begin() + static_cast<std::ptrdiff_t>(end));
      for (std::size_t i = begin; i < end; ++i)
        if (!of.lines[some[i].line].is_ring) some[i].place = 1 - some[i].place;
    };
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t begin = 0; begin < visits.size(); ++begin)
      for (std::size_t end = begin + 1; end <= visits.size(); ++end) {
        Visits turned = visits;
        turn(turned, begin, end);
        least = std::min(least, way(of.lines, of.pen, turned));
        if (end - begin > 3) continue;
        for (const bool turns : {false, true}) {
          Visits rest = visits;
          if (turns) turn(rest, begin, end);
          const auto first = rest.begin() + static_cast<std::ptrdiff_t>(begin),
                     last = rest.begin() + static_cast<std::ptrdiff_t>(end);
          const Visits moved(first, last);
          rest.erase(first, last);
          for (std::size_t to = 0; to <= rest.size(); ++to) {
            Visits put = rest;
            put.insert(put.begin() + static_cast<std::ptrdiff_t>(to), moved.begin(), moved.end());
            least = std::min(least, way(of.lines, of.pen, put));
          }
        }
      }
    for (std::size_t i = 0; i < visits.size(); ++i)
      for (std::size_t p = 0;
           of.lines[visits[i].line].is_ring && p < of.lines[visits[i].line].places.size(); ++p) {
        Visits begun = visits;
        begun[i].place = p;
        least = std::min(least, way(of.lines, of.pen, begun));
      }
    CHECK(least > mm - kGain);
  }
  CHECK(shorter > enough(kCases / 20));
}

TEST_CASE("many lines: each once, never a longer way, mostly a fifth shorter, on any threads") {
  double before = 0, after = 0;
  for (std::uint64_t seed = 1; seed <= last_seed(60); ++seed) {
    INFO("seed " << seed);
    Random random(seed);
    const Case of(random, seed % 10 == 0 ? 4000 : 400);
    const PenRoute sorted = nearest_first(of.pen_lines, of.pen);
    PenRoute best, on_one;
    on_cores(0, {}, [&] { best = shortened(of.pen_lines, of.pen, sorted); });
    on_cores(1, {}, [&] { on_one = shortened(of.pen_lines, of.pen, sorted); });
    CHECK(best == on_one);
    const double mm = way(of.lines, of.pen, of.visits(best)),
                 sorted_mm = way(of.lines, of.pen, of.visits(sorted));
    CHECK(mm <= sorted_mm + 1e-9);
    before += sorted_mm;
    after += mm;
  }
  INFO(after / before);
  CHECK(after < 0.85 * before);
}

TEST_CASE("ordering ends when it is told to stop") {
  Random random(1);
  PenLines lines;
  for (int i = 0; i < 20000; ++i)
    lines.add_open({random.between(0, 100), random.between(0, 100)},
                   {random.between(0, 100), random.between(0, 100)});
  const PenRoute sorted = nearest_first(lines, {0, 0});
  std::stop_source stop;
  stop.request_stop();
  CHECK_THROWS(on_cores(1, stop.get_token(), [&] { nearest_first(lines, {0, 0}); }));
  CHECK_THROWS(on_cores(1, stop.get_token(), [&] { shortened(lines, {0, 0}, sorted); }));
}

} // namespace orograph::pen_route_test
