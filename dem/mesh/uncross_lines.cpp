// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/mesh/uncross_lines.hpp"

#include "dem/mesh/orientation.hpp"
#include "dem/mesh/segment_buckets.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace orograph {
namespace {

constexpr std::uint32_t none = 0xffffffff;

struct Segment {
  Step ends;
  std::uint32_t via = none; ///< replaced by the two steps over this point
  bool dropped = false;

  bool alive() const { return via == none && !dropped; }
};

class Uncrossing {
public:
  Uncrossing(std::span<const std::vector<Vec2>> lines, std::span<const Vec2> fixed, double reach_m)
      : reach_m_(reach_m), point_buckets_(lines, reach_m), buckets_(lines, reach_m) {
    for (const Vec2 p : fixed) point(p);
    for (const auto& line : lines) {
      auto& numbers = lines_.emplace_back();
      for (const Vec2 p : line) numbers.push_back(point_near(p));
      for (std::size_t i = 1; i < numbers.size(); ++i) segment(numbers[i - 1], numbers[i]);
    }
    for (std::uint32_t next = 0; next < segments_.size(); ++next) uncross(next);
  }

  UncrossedLines result() {
    UncrossedLines uncrossed;
    for (const auto& numbers : lines_) {
      auto& steps = uncrossed.lines.emplace_back();
      for (std::size_t i = 1; i < numbers.size(); ++i) expand(numbers[i - 1], numbers[i], steps);
    }
    uncrossed.points = std::move(points_);
    return uncrossed;
  }

private:
  static Step key(std::uint32_t a, std::uint32_t b) { return {std::min(a, b), std::max(a, b)}; }
  Vec2 at(std::uint32_t point) const { return points_[point]; }
  double length_of(std::uint32_t a, std::uint32_t b) const { return length(at(b) - at(a)); }

  std::uint32_t point(Vec2 p) {
    const auto number = static_cast<std::uint32_t>(points_.size());
    const auto [place, is_new] = number_at_.try_emplace({p.x, p.y}, number);
    if (is_new) {
      points_.push_back(p);
      point_buckets_.add(number, p, p);
    }
    return place->second;
  }
  // The nearest point within reach; a new one if there is none.
  std::uint32_t point_near(Vec2 p) {
    point_buckets_.near(p, p, near_points_);
    std::uint32_t nearest = none;
    for (const std::uint32_t candidate : near_points_)
      if (length(at(candidate) - p) <= reach_m_ &&
          (nearest == none || length(at(candidate) - p) < length(at(nearest) - p)))
        nearest = candidate;
    return nearest != none ? nearest : point(p);
  }

  // New segments stand last, and are looked at in their turn.
  void segment(std::uint32_t a, std::uint32_t b) {
    if (a == b) return;
    const auto number = static_cast<std::uint32_t>(segments_.size());
    if (!number_of_.try_emplace(key(a, b), number).second) return;
    segments_.push_back({key(a, b)});
    buckets_.add(number, at(a), at(b));
  }

  bool passes(std::uint32_t number, std::uint32_t point) const {
    const auto [a, b] = segments_[number].ends;
    if (point == a || point == b) return false;
    const Vec2 along = at(b) - at(a), off = at(point) - at(a);
    const double share = dot(off, along) / dot(along, along);
    return share > 0 && share < 1 && std::abs(cross(along, off)) <= reach_m_ * length(along);
  }
  bool lead_through_points(std::uint32_t number) {
    const auto [a, b] = segments_[number].ends;
    point_buckets_.near(at(a), at(b), near_points_);
    for (const std::uint32_t point : near_points_)
      if (passes(number, point) && split(number, point)) return true;
    return false;
  }

  void uncross(std::uint32_t first) {
    if (!segments_[first].alive() || lead_through_points(first)) return;
    const auto [a, b] = segments_[first].ends;
    buckets_.near(at(a), at(b), near_);
    for (const std::uint32_t second : near_) {
      if (second == first || !segments_[second].alive() || !cross_inside(first, second)) continue;
      const std::size_t before = points_.size();
      const std::uint32_t point = point_near(crossing(first, second));
      const bool split_first = split(first, point), split_second = split(second, point);
      if (points_.size() > before) lead_through(point);
      if (!split_first && !split_second) drop_shorter(first, second);
      if (!segments_[first].alive()) return;
    }
  }
  // A new point: what passes it.
  void lead_through(std::uint32_t point) {
    std::vector<std::uint32_t> passing;
    buckets_.near(at(point), at(point), passing);
    for (const std::uint32_t segment : passing)
      if (segments_[segment].alive() && passes(segment, point)) split(segment, point);
  }
  void drop_shorter(std::uint32_t first, std::uint32_t second) {
    const auto size = [&](std::uint32_t s) {
      return length_of(segments_[s].ends[0], segments_[s].ends[1]);
    };
    segments_[size(first) < size(second) ? first : second].dropped = true;
  }

  bool cross_inside(std::uint32_t first, std::uint32_t second) const {
    const auto [a, b] = segments_[first].ends;
    const auto [c, d] = segments_[second].ends;
    return orientation(at(a), at(b), at(c)) * orientation(at(a), at(b), at(d)) < 0 &&
           orientation(at(c), at(d), at(a)) * orientation(at(c), at(d), at(b)) < 0;
  }
  Vec2 crossing(std::uint32_t first, std::uint32_t second) const {
    const Vec2 a = at(segments_[first].ends[0]), b = at(segments_[first].ends[1]);
    const Vec2 c = at(segments_[second].ends[0]), d = at(segments_[second].ends[1]);
    const double before = cross(d - c, a - c), after = cross(d - c, b - c);
    const double share = before == after ? 0.5 : before / (before - after);
    return a + std::clamp(share, 0.0, 1.0) * (b - a);
  }
  bool split(std::uint32_t number, std::uint32_t point) {
    const auto [a, b] = segments_[number].ends;
    const double whole = length_of(a, b);
    if (point == a || point == b || length_of(a, point) >= whole || length_of(point, b) >= whole)
      return false;
    segments_[number].via = point;
    segment(a, point);
    segment(point, b);
    return true;
  }

  void expand(std::uint32_t from, std::uint32_t to, std::vector<Step>& steps) const {
    if (from == to) return;
    const Segment& s = segments_[number_of_.at(key(from, to))];
    if (s.dropped) return;
    if (s.via == none) return steps.push_back({from, to});
    expand(from, s.via, steps);
    expand(s.via, to, steps);
  }

  double reach_m_;
  std::vector<Vec2> points_;
  std::map<std::pair<double, double>, std::uint32_t> number_at_;
  std::vector<Segment> segments_;
  std::map<Step, std::uint32_t> number_of_;
  SegmentBuckets point_buckets_, buckets_;
  std::vector<std::uint32_t> near_points_, near_; // to be reused
  std::vector<std::vector<std::uint32_t>> lines_;
};

} // namespace

UncrossedLines uncross(std::span<const std::vector<Vec2>> lines, std::span<const Vec2> fixed,
                       double reach_m) {
  return Uncrossing(lines, fixed, reach_m).result();
}

} // namespace orograph
