// SPDX-License-Identifier: GPL-3.0-or-later
// What a sheet covers: against a brute-force pair of envelopes where it goes on everywhere, as the
// paper's own extension has it, and by hand where it has gaps.
#include "horizon/covered.hpp"
#include "tests/catch.hpp"
#include "tests/support/random.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace orograph::covered_test {
namespace {

// Polylines over all of [0, 1], front to back: where each turns up or down a sheet that has no
// gaps covers what is between the lowest and the highest so far.
std::vector<std::vector<Segment>> made_lines(Random& random) {
  std::vector<std::vector<Segment>> lines;
  const int count = random.whole(2, 9);
  std::uint64_t id = 0;
  for (int i = 0; i < count; ++i) {
    std::vector<double> x{0, 1};
    for (int k = random.whole(0, 12); k > 0; --k) x.push_back(random.between(0.01, 0.99));
    std::sort(x.begin(), x.end());
    const double level = random.between(-1, 1), rough = random.pick({0.0, 0.1, 1.0});
    std::vector<Segment>& line = lines.emplace_back();
    double y = level + random.between(-rough, rough);
    for (std::size_t k = 0; k + 1 < x.size(); ++k) {
      const double next = level + random.between(-rough, rough);
      line.push_back({x[k], y, x[k + 1], next, id++});
      y = next;
    }
  }
  return lines;
}

double height_of(const std::vector<Segment>& line, double x) {
  for (const Segment& s : line)
    if (x <= s.x1) return height_at(s, x);
  return height_at(line.back(), x);
}

// Where a segment is above all or below all in front: tried between all places where it might
// change.
std::vector<Shares> brute_force(const Segment& s, std::span<const std::vector<Segment>> in_front) {
  std::vector<double> breaks{s.x0, s.x1};
  for (const std::vector<Segment>& line : in_front)
    for (const Segment& other : line) {
      const double low = std::max(s.x0, other.x0), high = std::min(s.x1, other.x1);
      if (!(low < high)) continue;
      breaks.insert(breaks.end(), {low, high});
      const double at_low = height_at(s, low) - height_at(other, low),
                   at_high = height_at(s, high) - height_at(other, high);
      if (at_low * at_high < 0) breaks.push_back(low + at_low / (at_low - at_high) * (high - low));
    }
  std::sort(breaks.begin(), breaks.end());
  std::vector<Shares> seen;
  for (std::size_t k = 0; k + 1 < breaks.size(); ++k) {
    if (!(breaks[k + 1] - breaks[k] > 1e-13)) continue;
    const double x = 0.5 * (breaks[k] + breaks[k + 1]), y = height_at(s, x);
    double low = kInfinity, high = -kInfinity;
    for (const std::vector<Segment>& line : in_front) {
      low = std::min(low, height_of(line, x));
      high = std::max(high, height_of(line, x));
    }
    if (y >= low && y <= high) continue;
    const Shares part{(breaks[k] - s.x0) / (s.x1 - s.x0), (breaks[k + 1] - s.x0) / (s.x1 - s.x0)};
    if (!seen.empty() && part.begin - seen.back().end < 1e-9)
      seen.back().end = part.end;
    else
      seen.push_back(part);
  }
  return seen;
}

std::vector<Shares> joined(std::vector<Shares> parts) {
  std::vector<Shares> out;
  for (const Shares& part : parts) {
    if (part.end - part.begin < 1e-9) continue;
    if (!out.empty() && part.begin - out.back().end < 1e-9)
      out.back().end = part.end;
    else
      out.push_back(part);
  }
  return out;
}

Segment level(double y, std::uint64_t id, double begin = 0, double end = 1) {
  return {begin, y, end, y, id};
}

std::vector<double> seen_of_upright(const Covered& covered, double x, double low, double high) {
  std::vector<Shares> seen;
  covered.add_upright_seen({x, low, x, high, 99, 0}, x - 1e-9, seen);
  std::vector<double> out;
  for (const Shares& part : seen) {
    out.push_back(low + part.begin * (high - low));
    out.push_back(low + part.end * (high - low));
  }
  return out;
}

} // namespace

TEST_CASE("without gaps what is covered is between two envelopes, piece for piece") {
  const std::uint64_t kScenes = last_seed(2000);
  std::size_t pieces = 0;
  for (std::uint64_t seed = 1; seed <= kScenes; ++seed) {
    INFO("seed " << seed);
    Random random(seed);
    const std::vector<std::vector<Segment>> lines = made_lines(random);
    Covered covered({0, 1}, {-kInfinity, kInfinity}, static_cast<std::size_t>(random.whole(1, 7)));
    for (std::size_t i = 0; i < lines.size(); ++i) {
      const std::span in_front(lines.data(), i);
      for (const Segment& s : lines[i]) {
        std::vector<Shares> seen;
        covered.add_seen(s, s.x0, s.x1, {}, seen);
        seen = joined(seen);
        const std::vector<Shares> expected =
            i == 0 ? std::vector<Shares>{{0, 1}} : joined(brute_force(s, in_front));
        REQUIRE(seen.size() == expected.size());
        for (std::size_t k = 0; k < seen.size(); ++k) {
          CHECK(std::abs(seen[k].begin - expected[k].begin) < 1e-7);
          CHECK(std::abs(seen[k].end - expected[k].end) < 1e-7);
        }
        pieces += seen.size();
      }
      for (const Segment& s : lines[i])
        covered.take(s, s.x0, s.x1, i == 0 ? SheetEnd::opens : SheetEnd::turns, false);
    }
    // The upper envelope, source for source.
    for (const HorizonPiece& piece : covered.top()) {
      if (is_sky(piece)) continue;
      const double x = 0.5 * (piece.x_begin + piece.x_end);
      double high = -kInfinity;
      for (const std::vector<Segment>& line : lines) high = std::max(high, height_of(line, x));
      CHECK(height_at(piece.source, x) == Approx(high).margin(1e-12));
    }
  }
  CHECK(pieces > 10 * kScenes);
}

TEST_CASE("a sheet that ends and begins anew leaves a gap, until it comes by there") {
  Covered covered({0, 1}, {0, 1}, 1);
  covered.take(level(0, 1), 0, 1, SheetEnd::opens, false);
  covered.take(level(1, 2), 0, 1, SheetEnd::closes, false);
  CHECK(seen_of_upright(covered, 0.5, -1, 4) == std::vector<double>{-1, 0, 1, 4});
  // An island behind a gap, above; seen between the two.
  covered.take(level(2, 3), 0, 1, SheetEnd::opens, false);
  covered.take(level(3, 4), 0, 1, SheetEnd::turns, false);
  CHECK(seen_of_upright(covered, 0.5, -1, 4) == std::vector<double>{-1, 0, 1, 2, 3, 4});
  // It comes down into the first: all between is covered.
  covered.take(level(0.5, 5), 0, 1, SheetEnd::turns, false);
  CHECK(seen_of_upright(covered, 0.5, -1, 4) == std::vector<double>{-1, 0, 3, 4});
  // And up again.
  covered.take(level(3.5, 6), 0, 1, SheetEnd::closes, false);
  CHECK(seen_of_upright(covered, 0.5, -1, 4) == std::vector<double>{-1, 0, 3.5, 4});
}

TEST_CASE("bands are apart where they are, and one where they meet") {
  Covered covered({0, 1}, {0, 1}, 3);
  covered.take(level(0, 1), 0, 1, SheetEnd::opens, false);
  covered.take(level(1, 2), 0, 1, SheetEnd::closes, false);
  // Begins in the band on the left and above it on the right.
  covered.take({0, 0.5, 1, 2.5, 3}, 0, 1, SheetEnd::opens, false);
  covered.take({0, 1.5, 1, 3.5, 4}, 0, 1, SheetEnd::closes, false);
  CHECK(seen_of_upright(covered, 0.125, -1, 4) == std::vector<double>{-1, 0, 1.75, 4});
  CHECK(seen_of_upright(covered, 0.75, -1, 4) == std::vector<double>{-1, 0, 1, 2, 3, 4});
  // A level line at 1.25 is seen where the second band isn't yet, or no more.
  std::vector<Shares> seen;
  covered.add_seen(level(1.25, 5), 0, 1, {}, seen);
  REQUIRE(seen.size() == 1);
  CHECK(seen.front().begin == Approx(0.375));
  CHECK(seen.front().end == 1);
  // Of another that lies on the end of a band there is one line already, if it is drawn.
  seen.clear();
  covered.add_seen(level(0, 6), 0, 1, {}, seen);
  CHECK(seen.size() == 1);
}

} // namespace orograph::covered_test
