// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/uncross_lines.hpp"

#include "dem/orientation.hpp"
#include "dem/segment_buckets.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

namespace orograph {
namespace {

constexpr std::uint32_t none = 0xffffffff;

// Points, to be found by place.
class Points {
public:
  explicit Points(double reach_m) : reach_m_(reach_m) {}

  std::uint32_t at(Vec2 p) {
    const auto [place, is_new] =
        exact_.try_emplace({p.x, p.y}, static_cast<std::uint32_t>(points.size()));
    if (is_new) points.push_back(p);
    return place->second;
  }
  /// The nearest within reach; the place itself if there is none.
  std::uint32_t near(Vec2 p) {
    std::uint32_t nearest = none;
    for (auto at = exact_.lower_bound({p.x - reach_m_, -HUGE_VAL});
         at != exact_.end() && at->first.first <= p.x + reach_m_;) {
      const auto [x, y] = at->first;
      if (y < p.y - reach_m_) {
        at = exact_.lower_bound({x, p.y - reach_m_});
        continue;
      }
      if (y > p.y + reach_m_) {
        at = exact_.upper_bound({x, HUGE_VAL});
        continue;
      }
      if (length(points[at->second] - p) <= reach_m_ &&
          (nearest == none || length(points[at->second] - p) < length(points[nearest] - p)))
        nearest = at->second;
      ++at;
    }
    return nearest != none ? nearest : at_new(p);
  }

  std::vector<Vec2> points;

private:
  std::uint32_t at_new(Vec2 p) { return at(p); }

  double reach_m_;
  std::map<std::pair<double, double>, std::uint32_t> exact_;
};

struct Segment {
  Step ends;
  std::uint32_t via = none; ///< replaced by the two steps over this point
  bool dropped = false;

  bool alive() const { return via == none && !dropped; }
};

class Uncrossing {
public:
  Uncrossing(std::span<const std::vector<Vec2>> lines, double reach_m)
      : points_(reach_m), buckets_(lines) {
    for (const auto& line : lines) {
      auto& numbers = lines_.emplace_back();
      for (const Vec2 p : line) numbers.push_back(points_.at(p));
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
    uncrossed.points = std::move(points_.points);
    return uncrossed;
  }

private:
  static Step key(std::uint32_t a, std::uint32_t b) { return {std::min(a, b), std::max(a, b)}; }
  Vec2 at(std::uint32_t point) const { return points_.points[point]; }
  double length_of(std::uint32_t a, std::uint32_t b) const { return length(at(b) - at(a)); }

  // New segments stand last, and are looked at in their turn.
  void segment(std::uint32_t a, std::uint32_t b) {
    if (a == b) return;
    const auto number = static_cast<std::uint32_t>(segments_.size());
    if (!number_of_.try_emplace(key(a, b), number).second) return;
    segments_.push_back({key(a, b)});
    buckets_.add(number, at(a), at(b));
  }

  void uncross(std::uint32_t first) {
    std::vector<std::uint32_t> near;
    if (!segments_[first].alive()) return;
    buckets_.near(at(segments_[first].ends[0]), at(segments_[first].ends[1]), near);
    for (const std::uint32_t second : near) {
      if (!segments_[first].alive()) return;
      if (second == first || !segments_[second].alive() || !cross_inside(first, second)) continue;
      const std::uint32_t point = points_.near(crossing(first, second));
      const bool split_first = split(first, point), split_second = split(second, point);
      if (split_first || split_second) continue;
      const auto size = [&](std::uint32_t s) {
        return length_of(segments_[s].ends[0], segments_[s].ends[1]);
      };
      segments_[size(first) < size(second) ? first : second].dropped = true;
    }
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

  Points points_;
  SegmentBuckets buckets_;
  std::vector<Segment> segments_;
  std::map<Step, std::uint32_t> number_of_;
  std::vector<std::vector<std::uint32_t>> lines_;
};

} // namespace

UncrossedLines uncross(std::span<const std::vector<Vec2>> lines, double reach_m) {
  return Uncrossing(lines, reach_m).result();
}

} // namespace orograph
