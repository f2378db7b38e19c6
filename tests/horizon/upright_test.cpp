// SPDX-License-Identifier: GPL-3.0-or-later
// Profiles along walls, asked of the horizon at many places of each.
#include "horizon/clip_profile.hpp"
#include "tests/catch.hpp"
#include "tests/support/random.hpp"

#include <algorithm>
#include <cmath>

namespace orograph::upright_test {
namespace {

HorizonPiece sky(double x_begin, double x_end) {
  return {x_begin, x_end, {-kInfinity, -kInfinity, kInfinity, -kInfinity, kSky}, false};
}

// Steps, slopes and sky, with places on a lattice of quarters, where steps are.
Horizon random_horizon(Random& random) {
  Horizon horizon;
  double x = -kInfinity;
  for (int i = 0; i <= 8; ++i) {
    const double end = i < 8 ? i + 0.25 * random.whole(1, 3) : kInfinity;
    if (i == 0 || i == 8 || random.chance(0.2)) {
      horizon.push_back(sky(x, end));
    } else { // part of a longer source, of whole heights at whole places
      const double y0 = random.whole(-3, 3), y1 = y0 + 4.0 * random.whole(-1, 1);
      horizon.push_back(
          {x, end, {i - 2.0, y0, i + 2.0, y1, static_cast<std::uint64_t>(i)}, random.chance(0.5)});
    }
    x = end;
  }
  return horizon;
}

// The least limit of the horizon's height at x, from the left and from the right.
long double lower_side(const Horizon& horizon, long double x) {
  long double least = kInfinity;
  for (const HorizonPiece& p : horizon) {
    if (x < p.x_begin || x > p.x_end) continue;
    const long double share = (x - p.source.x0) / (p.source.x1 - p.source.x0);
    least =
        std::min(least, is_sky(p) ? -kInfinity : p.source.y0 + share * (p.source.y1 - p.source.y0));
  }
  return least;
}

bool covers(const std::vector<Piece>& pieces, std::uint32_t number, double t) {
  return std::any_of(pieces.begin(), pieces.end(), [&](const Piece& p) {
    return p.segment == number && p.t_begin <= t && t <= p.t_end;
  });
}

} // namespace

TEST_CASE("an upright shows where it is above the horizon's lower side") {
  int shown = 0, hidden = 0, parted = 0;
  for (std::uint64_t seed = 1; seed <= last_seed(3000); ++seed) {
    Random random(seed);
    INFO("seed " << seed);
    const Horizon horizon = random_horizon(random);
    std::vector<Segment> uprights;
    for (std::uint64_t i = 0; i < 6; ++i) {
      const double x = random.chance(0.5) ? 0.25 * random.whole(-4, 40) : random.between(-1, 10);
      const double y0 = random.whole(-6, 6), y1 = random.chance(0.3) ? y0 : random.between(-6, 6);
      uprights.push_back({x, y0, x, y1, i, 0});
    }
    const double beside = random.pick({1e-12, 1e-9});
    const std::vector<Piece> visible = visible_uprights(uprights, horizon, beside);
    for (std::size_t i = 0; i < visible.size(); ++i) {
      const Piece& p = visible[i];
      REQUIRE(p.segment < uprights.size());
      REQUIRE((i == 0 || visible[i - 1].segment < p.segment)); // one a segment, in order
      REQUIRE((0 <= p.t_begin && p.t_begin < p.t_end && p.t_end <= 1));
      REQUIRE((p.x_begin == uprights[p.segment].x0 && p.x_end == p.x_begin));
      parted += p.t_begin > 0 || p.t_end < 1;
    }
    for (std::uint32_t i = 0; i < uprights.size(); ++i) {
      const Segment& s = uprights[i];
      if (s.y0 == s.y1) {
        CHECK(!covers(visible, i, 0.5));
        continue;
      }
      for (int k = 0; k < 20; ++k) {
        const double t = random.share();
        const long double above =
            s.y0 + static_cast<long double>(t) * (s.y1 - s.y0) - lower_side(horizon, s.x0);
        if (std::abs(above) < 1e-7L) continue; // as far as a slope rises beside it
        REQUIRE(covers(visible, i, t) == (above > 0));
        ++(above > 0 ? shown : hidden);
      }
    }
  }
  CHECK(shown > enough(50000));
  CHECK(hidden > enough(10000));
  CHECK(parted > enough(1000));
}

TEST_CASE("an upright that just reaches the horizon is hidden, one that stands on it whole") {
  const Horizon horizon{sky(-kInfinity, 0), {0, 4, {0, 1, 4, 1, 7}, false}, sky(4, kInfinity)};
  const auto one = [&](double y0, double y1) {
    return visible_uprights(std::vector<Segment>{{2, y0, 2, y1, 1, 0}}, horizon, 1e-12);
  };
  CHECK(one(0, 1).empty());
  CHECK(one(1, 0).empty());
  CHECK(one(1, 1).empty());
  CHECK(one(2, 2).empty()); // no length
  CHECK(one(1, 2) == std::vector<Piece>{{0, 2, 2, 0, 1}});
  CHECK(one(2, 1) == std::vector<Piece>{{0, 2, 2, 0, 1}});
  CHECK(one(0, 2) == std::vector<Piece>{{0, 2, 2, 0.5, 1}});
  CHECK(one(2, 0) == std::vector<Piece>{{0, 2, 2, 0, 0.5}});
}

TEST_CASE("a step within rounding of an upright is at it") {
  // Its own top to the right, a hundredth of `beside` before it.
  const Horizon horizon{sky(-kInfinity, 5 - 1e-14),
                        {5 - 1e-14, 9, {5 - 1e-14, 3, 9, 3, 7}, false},
                        sky(9, kInfinity)};
  const std::vector<Segment> up{{5, 0, 5, 3, 1, 0}};
  CHECK(visible_uprights(up, horizon, 1e-12) == std::vector<Piece>{{0, 5, 5, 0, 1}});
  CHECK(visible_uprights(up, horizon, 1e-15).empty());
}

TEST_CASE("uprights and their pieces go among the others by id") {
  for (std::uint64_t seed = 1; seed <= last_seed(2000); ++seed) {
    Random random(seed);
    INFO("seed " << seed);
    std::vector<Segment> segments, uprights;
    std::vector<Piece> visible, on_walls;
    const auto count = static_cast<std::uint64_t>(random.whole(0, 12));
    for (std::uint64_t id = 0; id < count; ++id) {
      const bool upright = random.chance(0.4);
      const auto x = static_cast<double>(id);
      auto& list = upright ? uprights : segments;
      auto& pieces = upright ? on_walls : visible;
      list.push_back({x, 0, upright ? x : x + 1, 1, 100 + id, upright ? 0.0 : 1.0});
      const auto number = static_cast<std::uint32_t>(list.size() - 1);
      const int parts = random.whole(0, upright ? 1 : 3);
      for (int k = 0; k < parts; ++k)
        pieces.push_back({number, x, x, 0.25 * k, 0.25 * k + 0.125 + 0.001 * x});
    }
    // Each piece with the id of its segment, sorted: by id, then by t.
    std::vector<std::pair<std::uint64_t, double>> before, after;
    for (const Piece& p : visible) before.push_back({segments[p.segment].id, p.t_end});
    for (const Piece& p : on_walls) before.push_back({uprights[p.segment].id, p.t_end});
    std::sort(before.begin(), before.end());
    insert_uprights(uprights, on_walls, segments, visible);
    REQUIRE(segments.size() == count);
    for (std::uint64_t i = 0; i < count; ++i) CHECK(segments[i].id == 100 + i);
    for (const Piece& p : visible) after.push_back({segments[p.segment].id, p.t_end});
    CHECK(after == before);
  }
}

} // namespace orograph::upright_test
