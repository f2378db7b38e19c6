// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/reference/compare_clips.hpp"

#include "reference/exact_clip.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace orograph {
namespace {

constexpr double kPromise_mm = 1e-9;
constexpr double kPicture_mm = 200;

// A part of a segment, by parameter.
struct Stretch {
  double begin, end;
};

// The stretches that are in one of two lists of pieces of a segment alone.
std::vector<Stretch> drawn_by_one(std::span<const Piece> a, std::span<const Piece> b) {
  std::vector<double> ends;
  for (const auto& pieces : {a, b})
    for (const Piece& piece : pieces) ends.insert(ends.end(), {piece.t_begin, piece.t_end});
  std::sort(ends.begin(), ends.end());
  const auto hold = [](std::span<const Piece> pieces, double begin, double end) {
    return std::any_of(pieces.begin(), pieces.end(), [&](const Piece& piece) {
      return piece.t_begin <= begin && end <= piece.t_end;
    });
  };
  std::vector<Stretch> out;
  for (std::size_t i = 0; i + 1 < ends.size(); ++i)
    if (ends[i] < ends[i + 1] && hold(a, ends[i], ends[i + 1]) != hold(b, ends[i], ends[i + 1]))
      out.push_back({ends[i], ends[i + 1]});
  return out;
}

std::span<const Piece> pieces_of(const std::vector<Piece>& pieces, std::uint32_t segment) {
  const auto [begin, end] =
      std::equal_range(pieces.begin(), pieces.end(), Piece{segment, 0, 0, 0, 0},
                       [](const Piece& a, const Piece& b) { return a.segment < b.segment; });
  return {begin, end};
}

struct Place {
  const FlatScene& scene;
  const std::vector<Role>& roles;
  std::size_t list;
  const Segment& segment;
};

long double height_of(const Segment& s, long double x) {
  const long double share = (x - s.x0) / (static_cast<long double>(s.x1) - s.x0);
  return s.y0 + share * (static_cast<long double>(s.y1) - s.y0);
}

// Distance across the segment, in units of X, from its place at parameter t to what stands in
// front.
double distance_to_front(const Place& place, long double t) {
  const Segment& p = place.segment;
  const long double width = static_cast<long double>(p.x1) - p.x0, x = p.x0 + t * width;
  long double front = -std::numeric_limits<long double>::infinity();
  for (std::size_t nearer = 0; nearer < place.list; ++nearer)
    for (const Segment& s : place.scene[nearer])
      if (place.roles[nearer] != Role::compared && s.x0 <= x && x <= s.x1)
        front = std::max(front, height_of(s, x));
  const long double slope = (static_cast<long double>(p.y1) - p.y0) / width;
  return static_cast<double>(std::abs(height_of(p, x) - front) / std::hypot(1.0L, slope));
}

// The greatest such distance inside a stretch; at its very ends another source may begin.
double greatest_distance(const Place& place, Stretch stretch) {
  double greatest = 0;
  for (int i = 0; i < 20; ++i) {
    const long double share = (i + 0.5L) / 20;
    greatest = std::max(
        greatest, distance_to_front(place, stretch.begin + share * (stretch.end - stretch.begin)));
  }
  return greatest;
}

double mm_per_x(const FlatScene& scene) {
  double left = HUGE_VAL, right = -HUGE_VAL;
  for (const auto& segments : scene)
    for (const Segment& s : segments) {
      left = std::min(left, s.x0);
      right = std::max(right, s.x1);
    }
  return kPicture_mm / (right - left);
}

} // namespace

ClipDifferences compare_clips(const FlatScene& scene, const std::vector<Role>& roles) {
  std::vector<ExactList> lists;
  for (std::size_t i = 0; i < scene.size(); ++i) lists.push_back({scene[i], roles[i]});
  const std::vector<ExactClip> exact = exact_clip(lists);
  const double mm = mm_per_x(scene);

  ClipDifferences found;
  Horizon horizon = initial_horizon();
  ClipWorkspace workspace;
  for (std::size_t list = 0; list < scene.size(); ++list) {
    clip(scene[list], horizon, {roles[list], {}, true}, workspace);
    found.pieces += workspace.visible.size();
    found.exact_pieces += exact[list].visible.size();
    for (std::uint32_t number = 0; number < scene[list].size(); ++number) {
      const Segment& p = scene[list][number];
      const double length_mm = mm * std::hypot(p.x1 - p.x0, p.y1 - p.y0);
      const double promise_mm =
          std::max(kPromise_mm, 4 * std::numeric_limits<double>::epsilon() * length_mm);
      for (const Stretch stretch : drawn_by_one(pieces_of(workspace.visible, number),
                                                pieces_of(exact[list].visible, number))) {
        const double apart_mm = (stretch.end - stretch.begin) * length_mm;
        if (apart_mm <= promise_mm) {
          found.farthest_end_mm = std::max(found.farthest_end_mm, apart_mm);
          continue;
        }
        const double across_mm = mm * greatest_distance({scene, roles, list, p}, stretch);
        if (across_mm <= kPromise_mm) {
          ++found.close;
        } else if (found.wrong++ == 0) {
          found.first_wrong = "list " + std::to_string(list) + " segment " +
                              std::to_string(number) + ": " + std::to_string(apart_mm * 1e9) +
                              "e-9 mm along, " + std::to_string(across_mm * 1e9) + "e-9 mm across";
        }
      }
    }
  }
  return found;
}

} // namespace orograph
