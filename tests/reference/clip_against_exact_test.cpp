// SPDX-License-Identifier: GPL-3.0-or-later
// What double precision promises (DESIGN section 4): `clip` draws what the exact clip draws, with
// ends within 1e-9 mm on A4, or with the two sources that close all the way between the two ends.
#include "horizon/clip.hpp"
#include "reference/exact_clip.hpp"
#include "tests/catch.hpp"
#include "tests/horizon/flat_scenes.hpp"

#include <algorithm>
#include <cmath>

using namespace orograph;

namespace {

constexpr double kPromise_mm = 1e-9;
constexpr double kEpsilon = std::numeric_limits<double>::epsilon();
constexpr double kPicture_mm = 200; // the scene's X range on A4

struct Tally {
  std::size_t pieces = 0, exact = 0; ///< drawn by `clip` and by the exact clip
  std::size_t apart = 0;      ///< stretches drawn by one of the two alone, longer than promised
  std::size_t wrong = 0;      ///< of these, not within 1e-9 mm of the horizon
  double farthest_end_mm = 0; ///< of the ends within the promise
};

using Roles = std::vector<Role>;

long double y_at(const Segment& s, long double x) {
  return s.y0 + (x - s.x0) / (static_cast<long double>(s.x1) - s.x0) *
                    (static_cast<long double>(s.y1) - s.y0);
}

// Distance across p, in units of X, from a place on it to what stands in front of it.
double distance_to_front(const FlatScene& scene, const Roles& roles, std::size_t list,
                         const Segment& p, long double t) {
  const long double x = p.x0 + t * (static_cast<long double>(p.x1) - p.x0);
  long double front = -std::numeric_limits<long double>::infinity();
  for (std::size_t nearer = 0; nearer < list; ++nearer)
    for (const Segment& s : scene[nearer])
      if (roles[nearer] != Role::compared && s.x0 <= x && x <= s.x1)
        front = std::max(front, y_at(s, x));
  const long double slope = (static_cast<long double>(p.y1) - p.y0) / (p.x1 - p.x0);
  return static_cast<double>(std::abs(y_at(p, x) - front) / std::hypot(1.0L, slope));
}

// The stretches, by parameter, that are in one of two lists of pieces of a segment alone.
std::vector<std::pair<double, double>> drawn_by_one(std::span<const Piece> a,
                                                    std::span<const Piece> b) {
  std::vector<double> ends;
  for (const auto& pieces : {a, b})
    for (const Piece& piece : pieces) ends.insert(ends.end(), {piece.t_begin, piece.t_end});
  std::sort(ends.begin(), ends.end());
  const auto holds = [](std::span<const Piece> pieces, double begin, double end) {
    return std::any_of(pieces.begin(), pieces.end(), [&](const Piece& piece) {
      return piece.t_begin <= begin && end <= piece.t_end;
    });
  };
  std::vector<std::pair<double, double>> out;
  for (std::size_t i = 0; i + 1 < ends.size(); ++i)
    if (ends[i] < ends[i + 1] && holds(a, ends[i], ends[i + 1]) != holds(b, ends[i], ends[i + 1]))
      out.emplace_back(ends[i], ends[i + 1]);
  return out;
}

std::span<const Piece> of_segment(const std::vector<Piece>& pieces, std::uint32_t number) {
  const auto range =
      std::equal_range(pieces.begin(), pieces.end(), Piece{number, 0, 0, 0, 0},
                       [](const Piece& a, const Piece& b) { return a.segment < b.segment; });
  return {range.first, range.second};
}

Tally compare_clips(const FlatScene& scene, const Roles& roles) {
  double left = HUGE_VAL, right = -HUGE_VAL;
  std::vector<ExactList> lists;
  for (std::size_t i = 0; i < scene.size(); ++i) {
    lists.push_back({scene[i], roles[i]});
    for (const Segment& s : scene[i]) {
      left = std::min(left, s.x0);
      right = std::max(right, s.x1);
    }
  }
  const double mm = kPicture_mm / (right - left);
  const std::vector<ExactClip> exact = exact_clip(lists);

  Tally tally;
  Horizon horizon = initial_horizon();
  ClipWorkspace workspace;
  for (std::size_t list = 0; list < scene.size(); ++list) {
    clip(scene[list], horizon, {roles[list], {}, true}, workspace);
    tally.pieces += workspace.visible.size();
    tally.exact += exact[list].visible.size();
    for (std::uint32_t number = 0; number < scene[list].size(); ++number) {
      const Segment& p = scene[list][number];
      const double length_mm = mm * std::hypot(p.x1 - p.x0, p.y1 - p.y0);
      for (const auto& [begin, end] : drawn_by_one(of_segment(workspace.visible, number),
                                                   of_segment(exact[list].visible, number))) {
        const double apart_mm = (end - begin) * length_mm;
        if (apart_mm <= std::max(kPromise_mm, 4 * kEpsilon * length_mm)) {
          tally.farthest_end_mm = std::max(tally.farthest_end_mm, apart_mm);
          continue;
        }
        ++tally.apart;
        double farthest = 0;
        for (int i = 0; i <= 20; ++i) // inside: where a source ends the front may jump
          farthest =
              std::max(farthest, distance_to_front(scene, roles, list, p,
                                                   begin + (end - begin) * (1e-3L + i * 0.0499L)));
        if (farthest * mm > kPromise_mm) {
          ++tally.wrong;
          UNSCOPED_INFO("list " << list << " segment " << number << " t " << begin << " to " << end
                                << " of " << length_mm << " mm: " << farthest * mm
                                << " mm from the front");
        }
      }
    }
  }
  return tally;
}

// The seed's profiles; the surface's occluders and profiles; all three in turn.
Roles roles_of(std::uint64_t seed, std::size_t lists) {
  Roles roles(lists, Role::drawn_occluder);
  for (std::size_t i = 0; i < lists; ++i) {
    if (seed % 3 == 1) roles[i] = i % 2 ? Role::compared : Role::occluder;
    if (seed % 3 == 2) roles[i] = static_cast<Role>(i % 3);
  }
  return roles;
}

} // namespace

TEST_CASE("ten thousand random scenes") {
  for (const SceneKind& kind : scene_kinds()) {
    Tally sum;
    for (std::uint64_t seed = 1; seed <= 143; ++seed) {
      CAPTURE(kind.name, seed);
      const FlatScene scene = flat_scene(kind, seed);
      const Tally tally = compare_clips(scene, roles_of(seed, scene.size()));
      sum.pieces += tally.pieces;
      sum.exact += tally.exact;
      sum.apart += tally.apart;
      sum.wrong += tally.wrong;
      sum.farthest_end_mm = std::max(sum.farthest_end_mm, tally.farthest_end_mm);
    }
    WARN(kind.name << ": " << sum.pieces << " pieces, exact " << sum.exact << "; " << sum.apart
                   << " stretches apart, " << sum.wrong << " wrong; farthest end "
                   << sum.farthest_end_mm * 1e12 << "e-12 mm");
    CHECK(sum.wrong == 0);
  }
}
