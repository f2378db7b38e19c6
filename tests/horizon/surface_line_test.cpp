// SPDX-License-Identifier: GPL-3.0-or-later
// Visibility inside a slab against its definition, asked at many places of every line: hidden where
// the horizon in front, or a nearer occluder of the slab, is higher. And `raise` against the
// pointwise maximum.
#include "horizon/clip.hpp"
#include "horizon/surface_line.hpp"
#include "tests/catch.hpp"
#include "tests/support/random.hpp"

#include <algorithm>
#include <cmath>

namespace orograph::surface_line_test {
namespace {

long double between(double at0, double at1, long double share) {
  return at0 + share * (static_cast<long double>(at1) - at0);
}
long double share_at(const Segment& s, long double x) {
  return (x - s.x0) / (static_cast<long double>(s.x1) - s.x0);
}
long double height_of(const Segment& s, long double x) {
  return between(s.y0, s.y1, share_at(s, x));
}

// How to draw numbers: any, or small whole ones, with which lines meet in ends and lie in a row.
struct Kind {
  const char* name;
  bool lattice;
  double y_scale, uprights;
};
constexpr Kind kKinds[] = {{"any", false, 1, 0},
                           {"uprights among them", false, 1, 0.3},
                           {"steep", false, 1e6, 0.1},
                           {"lattice", true, 1, 0.2}};

struct Slab {
  std::vector<SurfaceLine> lines;
  Horizon horizon = initial_horizon();
};

double number(const Kind& kind, Random& random, int count) {
  return kind.lattice ? random.whole(0, count) : random.between(0, count);
}

Slab made_slab(const Kind& kind, std::uint64_t seed) {
  Random random(seed);
  Slab slab;
  ClipWorkspace workspace;
  std::vector<HorizonPiece> in_front;
  const auto height = [&](int count) { return kind.y_scale * number(kind, random, count); };
  for (std::uint64_t i = 0; i < 5; ++i) {
    const double x = number(kind, random, 8), x1 = x + 1 + number(kind, random, 3);
    in_front.push_back({x, x1, {x, height(3), x1, height(3), 1000 + i}, false});
  }
  if (random.chance(0.8)) raise(in_front, slab.horizon, workspace);

  const int count = random.whole(2, 25);
  for (int i = 0; i < count; ++i) {
    SurfaceLine line{};
    const double x0 = number(kind, random, 10), y0 = height(6), y1 = height(6);
    line.nearness0 = 1 + number(kind, random, 4);
    line.nearness1 = 1 + number(kind, random, 4);
    const bool upright = random.chance(kind.uprights);
    const double x1 = x0 + (upright ? 0 : 1 + number(kind, random, 4));
    line.source = {x0, y0, x1, y1, static_cast<std::uint64_t>(i)};
    if (upright) {
      line.nearness1 = line.nearness0 - (kind.lattice ? 1 : random.between(0.1, 1));
      line.begin = random.chance(0.5) ? 0 : random.between(0, 0.4);
      line.end = random.chance(0.5) ? 1 : random.between(0.6, 1);
    } else {
      const double length = line.source.x1 - line.source.x0;
      line.begin = line.source.x0 + (random.chance(0.6) ? 0 : length * random.between(0, 0.4));
      line.end = line.source.x1 - (random.chance(0.6) ? 0 : length * random.between(0, 0.4));
    }
    line.hides = random.chance(0.7);
    line.drawn = !line.hides || random.chance(0.8);
    slab.lines.push_back(line);
  }
  return slab;
}

enum class Answer { visible, hidden, tied };

// A difference of heights or of nearness, of numbers up to `size`: too small to judge?
bool tiny(long double difference, double size) {
  return std::abs(difference) <= 1e-12L * size;
}

Answer definition(const Slab& slab, const SurfaceLine& line, double t, double y_scale) {
  const Segment& s = line.source;
  const bool upright = line.upright();
  const long double x = upright ? s.x0 : between(s.x0, s.x1, t);
  const long double y = between(s.y0, s.y1, t),
                    nearness = between(line.nearness0, line.nearness1, t);
  const double y_size = 20 * y_scale;
  Answer answer = Answer::visible;
  for (const HorizonPiece& piece : slab.horizon) {
    if (is_sky(piece) || x < piece.x_begin || x > piece.x_end) continue;
    const long double above = y - height_of(piece.source, x);
    if (tiny(above, y_size)) answer = Answer::tied;
    if (above < 0 && !tiny(above, y_size)) return Answer::hidden;
  }
  // What doesn't rise away from the eye is behind its own nearer end.
  if (upright && !(s.y1 > s.y0)) return Answer::hidden;
  for (const SurfaceLine& front : slab.lines) {
    if (&front == &line || !front.hides || front.upright() || x < front.begin || x > front.end)
      continue;
    const long double share = share_at(front.source, x);
    const long double nearer = between(front.nearness0, front.nearness1, share) - nearness;
    const long double higher = between(front.source.y0, front.source.y1, share) - y;
    const bool doubt_near = tiny(nearer, 10), doubt_high = tiny(higher, y_size);
    if (nearer > 0 && higher > 0 && !doubt_near && !doubt_high) return Answer::hidden;
    if ((doubt_near && (doubt_high || higher > 0)) || (doubt_high && nearer > 0))
      answer = Answer::tied;
  }
  return answer;
}

struct Tally {
  std::size_t visible = 0, hidden = 0, tied = 0, wrong = 0;
};

void check_slab(const Kind& kind, std::uint64_t seed, SlabHorizon& slab_horizon, Tally& tally) {
  const Slab slab = made_slab(kind, seed);
  std::vector<SurfaceLine> kept = slab.lines;
  const auto parts = slab_horizon.visible_parts(kept, slab.horizon);
  Random random(seed + 1000000);
  for (std::size_t i = 0; i < slab.lines.size(); ++i) {
    const SurfaceLine& line = slab.lines[i];
    std::vector<VisibleLinePart> mine;
    for (const VisibleLinePart& part : parts)
      if (kept[part.line].source.id == line.source.id) mine.push_back(part);
    if (!line.drawn) {
      tally.wrong += mine.size();
      continue;
    }
    const auto share = [&](double at) { // of an end of the part in the slab
      return line.upright() ? at : static_cast<double>(share_at(line.source, at));
    };
    const double t_begin = share(line.begin), t_end = share(line.end);
    for (std::size_t k = 0; k < mine.size(); ++k) { // in order, apart, in the slab
      tally.wrong += mine[k].t_begin < mine[k].t_end ? 0 : 1;
      tally.wrong += mine[k].t_begin >= t_begin - 1e-15 && mine[k].t_end <= t_end + 1e-15 ? 0 : 1;
      tally.wrong += k == 0 || mine[k - 1].t_end <= mine[k].t_begin ? 0 : 1;
    }
    for (int ask = 0; ask < 40; ++ask) {
      double t = random.between(t_begin, t_end);
      if (ask < 20 && !mine.empty()) { // on either side of an end
        const VisibleLinePart& part = mine[static_cast<std::size_t>(ask) % mine.size()];
        t = (ask % 4 < 2 ? part.t_begin : part.t_end) + random.between(-1e-5, 1e-5);
      }
      if (!(t > t_begin && t < t_end)) continue;
      const bool drawn = std::any_of(mine.begin(), mine.end(), [&](const VisibleLinePart& part) {
        return part.t_begin <= t && t <= part.t_end;
      });
      const Answer answer = definition(slab, line, t, kind.y_scale);
      tally.visible += answer == Answer::visible ? 1 : 0;
      tally.hidden += answer == Answer::hidden ? 1 : 0;
      tally.tied += answer == Answer::tied ? 1 : 0;
      if (answer != Answer::tied) tally.wrong += drawn == (answer == Answer::visible) ? 0 : 1;
    }
  }
}

SurfaceLine line_from(Segment source, double nearness0, double nearness1) {
  return {source, nearness0, nearness1, source.x0, source.x1, true, true};
}

// Of pieces that tile all X.
long double height_at_x(const Horizon& horizon, long double x) {
  long double height = -kInfinity;
  for (const HorizonPiece& piece : horizon)
    if (piece.x_begin <= x && x <= piece.x_end && !is_sky(piece))
      height = std::max(height, height_of(piece.source, x));
  return height;
}

} // namespace

TEST_CASE("what is visible in a slab, at every place of every line") {
  SlabHorizon slab_horizon; // its memory is reused, and must not matter
  for (const Kind& kind : kKinds) {
    Tally tally;
    for (std::uint64_t seed = 1; seed <= last_seed(4000); ++seed) {
      CAPTURE(kind.name, seed);
      check_slab(kind, seed, slab_horizon, tally);
      REQUIRE(tally.wrong == 0);
    }
    WARN(kind.name << ": asked of " << tally.visible << " visible places, " << tally.hidden
                   << " hidden, " << tally.tied << " tied");
    CHECK(tally.visible > enough(100000));
    CHECK(tally.hidden > enough(100000));
    CHECK(tally.tied < (kind.lattice ? tally.visible : tally.visible / 1000));
  }
}

TEST_CASE("lines that share an end don't hide each other there") {
  // A chain up and down, as silhouettes are: nothing of it is missing, to the last bit.
  for (std::uint64_t seed = 1; seed <= last_seed(200); ++seed) {
    CAPTURE(seed);
    Random random(seed);
    std::vector<SurfaceLine> lines;
    double x = random.between(0, 1), y = random.share(), nearness = 1 + random.share();
    for (std::uint64_t i = 0; i < 20; ++i) {
      const double next_x = x + random.share(), next_y = random.share(), next = 1 + random.share();
      lines.push_back(line_from({x, y, next_x, next_y, i}, nearness, next));
      x = next_x, y = next_y, nearness = next;
    }
    SlabHorizon slab;
    const auto parts = slab.visible_parts(lines, initial_horizon());
    REQUIRE(parts.size() == 20);
    for (const VisibleLinePart& part : parts) REQUIRE((part.t_begin == 0 && part.t_end == 1));
  }
}

TEST_CASE("several silhouettes meet in a vertex: each is hidden by what is nearer and higher") {
  // From (0, 0) to the right: the nearer they run, the higher, or the lower.
  for (const double sign : {1.0, -1.0}) {
    std::vector<SurfaceLine> lines;
    for (int i = 0; i < 5; ++i)
      lines.push_back(
          line_from({1, 1, 2, 1 + 0.1 * i, static_cast<std::uint64_t>(i)}, 1, 1 + sign * 0.1 * i));
    SlabHorizon slab;
    const auto parts = slab.visible_parts(lines, initial_horizon());
    CHECK(parts.size() == (sign > 0 ? 1 : 5));
  }
}

TEST_CASE(
    "at one place on the ground a line hides what is below it just if ground in front ends there") {
  // The top and the foot of a wall. Reckoned along edges of their own, they are by turns a rounding
  // nearer than each other.
  SurfaceLine top = line_from({0, 3, 4, 3, 1}, 0.5, 0.25);
  SurfaceLine foot = line_from({-1, 1, 5, 1, 2}, 0.5625 + 1e-16, 0.1875 - 1e-16);
  foot.hides = false;
  SlabHorizon slab;
  for (const double rounding_m : {0.0, 1e-12})
    for (const bool covers : {false, true}) {
      CAPTURE(rounding_m, covers);
      top.covers = covers;
      top.rounding_m = foot.rounding_m = rounding_m;
      std::vector<SurfaceLine> lines{top, foot};
      double seen = 0;
      for (const VisibleLinePart& part : slab.visible_parts(lines, initial_horizon()))
        if (part.line == 1) seen += part.t_end - part.t_begin;
      if (rounding_m > 0) CHECK(std::abs(seen - (covers ? 1 / 3.0 : 1)) <= 1e-12);
    }
  // Farther apart than rounding, what is nearer hides and what is farther doesn't.
  for (const double apart : {1e-9, -1e-9}) {
    CAPTURE(apart);
    top.nearness0 = 0.5 + apart, top.nearness1 = 0.25 + apart;
    top.covers = apart < 0;
    std::vector<SurfaceLine> lines{top, foot};
    double seen = 0;
    for (const VisibleLinePart& part : slab.visible_parts(lines, initial_horizon()))
      if (part.line == 1) seen += part.t_end - part.t_begin;
    CHECK(std::abs(seen - (apart > 0 ? 1 / 3.0 : 1)) <= 1e-6);
  }
}

TEST_CASE("a line straight away from the eye is met by what ends within rounding of its X") {
  SurfaceLine upright{{5, 0, 5, 4, 1}, 1, 0.5, 0, 1, false, true, 1e-12};
  SurfaceLine front = line_from({4, 2, 5 - 1e-13, 2, 2}, 2, 2);
  SlabHorizon slab;
  std::vector<SurfaceLine> lines{upright, front};
  auto parts = slab.visible_parts(lines, initial_horizon());
  REQUIRE(parts.size() == 2);
  CHECK(std::abs(parts[0].t_begin - 0.5) <= 1e-15);
  // And as the horizon.
  Horizon horizon = initial_horizon();
  ClipWorkspace workspace;
  clip(std::vector<Segment>{front.source}, horizon, {Role::occluder, {}, true}, workspace);
  lines = {upright};
  parts = slab.visible_parts(lines, horizon);
  REQUIRE(parts.size() == 1);
  CHECK(std::abs(parts[0].t_begin - 0.5) <= 1e-15);
  // Farther than that it passes by.
  lines = {upright};
  lines[0].beside = 1e-14;
  parts = slab.visible_parts(lines, horizon);
  REQUIRE(parts.size() == 1);
  CHECK(parts[0].t_begin == 0);
}

TEST_CASE("raising a horizon is the pointwise maximum") {
  ClipWorkspace workspace;
  for (const bool lattice : {false, true})
    for (std::uint64_t seed = 1; seed <= last_seed(3000); ++seed) {
      CAPTURE(lattice, seed);
      Random random(seed);
      const Kind kind{"", lattice, 1, 0};
      Horizon horizon = initial_horizon();
      std::vector<Segment> all;
      for (int round = 0; round < 3; ++round) {
        std::vector<HorizonPiece> occluders;
        const int count = random.whole(0, 20);
        for (int i = 0; i < count; ++i) {
          const double x = number(kind, random, 10), x1 = x + 1 + number(kind, random, 4);
          const Segment source{x, number(kind, random, 5), x1, number(kind, random, 5), all.size()};
          // A part of the source, as slabs cut it; the rest is not there.
          const double begin = x + (random.chance(0.5) ? 0 : 0.3 * (x1 - x));
          const double end = x1 - (random.chance(0.5) ? 0 : 0.3 * (x1 - x));
          occluders.push_back({begin, end, source, random.chance(0.5)});
          all.push_back({begin, static_cast<double>(height_of(source, begin)), end,
                         static_cast<double>(height_of(source, end)), source.id});
        }
        raise(occluders, horizon, workspace);
      }
      REQUIRE(horizon.front().x_begin == -kInfinity);
      REQUIRE(horizon.back().x_end == kInfinity);
      for (std::size_t i = 0; i + 1 < horizon.size(); ++i) {
        REQUIRE(horizon[i].x_end == horizon[i + 1].x_begin);
        REQUIRE(horizon[i].x_begin < horizon[i].x_end);
      }
      for (int ask = 0; ask < 60; ++ask) {
        const double x = random.between(-1, 16);
        long double greatest = -kInfinity;
        for (const Segment& s : all)
          if (s.x0 <= x && x <= s.x1) greatest = std::max(greatest, height_of(s, x));
        const long double height = height_at_x(horizon, x);
        REQUIRE((height == greatest || std::abs(height - greatest) <= 1e-13L));
      }
    }
}

} // namespace orograph::surface_line_test
