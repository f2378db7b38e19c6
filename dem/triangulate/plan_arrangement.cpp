// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/triangulate/plan_arrangement.hpp"

#include "dem/triangulate/orientation.hpp"
#include "dem/triangulate/plane_triangulation.hpp"
#include "geometry/box.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace orograph {
namespace {

// Square buckets over the ground of some lines, about one for each of their segments. A segment
// may be a single point.
class SegmentBuckets {
public:
  // REQUIRES reach_m > 0, some times the rounding of coordinates at least.
  SegmentBuckets(std::span<const std::vector<Vec2>> lines, double reach_m);

  void add(std::uint32_t segment, Vec2 from, Vec2 to);
  // All segments within reach of the one given, and others near it, each once, in ascending
  // order.
  void near(Vec2 from, Vec2 to, std::vector<std::uint32_t>& out) const;

private:
  template <class Visit>
  void for_each_bucket(Vec2 from, Vec2 to, Visit visit) const;

  Box2 box_;
  double bucket_m_ = 1, slack_m_ = 0;
  int columns_ = 1, rows_ = 1;
  std::vector<std::vector<std::uint32_t>> buckets_;
};

SegmentBuckets::SegmentBuckets(std::span<const std::vector<Vec2>> lines, double reach_m) {
  double count = 1;
  for (const auto& line : lines) {
    count += static_cast<double>(line.size());
    for (const Vec2 p : line) box_.include(p);
  }
  bucket_m_ = 4 * reach_m;
  if (!box_.empty()) {
    const double width = box_.width(), height = box_.height();
    bucket_m_ = std::max(
        {bucket_m_, std::sqrt(width) * std::sqrt(height / count), std::max(width, height) / count});
    columns_ = 1 + static_cast<int>(width / bucket_m_);
    rows_ = 1 + static_cast<int>(height / bucket_m_);
  }
  slack_m_ = 2 * reach_m + 0x1p-20 * bucket_m_;
  buckets_.resize(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_));
}

// Row by row of buckets, where the segment is, with slack for the reach and rounding.
template <class Visit>
void SegmentBuckets::for_each_bucket(Vec2 from, Vec2 to, Visit visit) const {
  if (from.y > to.y) std::swap(from, to);
  const auto number = [&](double place_m, int count) {
    return static_cast<int>(std::clamp(place_m / bucket_m_, 0.0, count - 1.0));
  };
  const int last_row = number(to.y + slack_m_ - box_.low.y, rows_);
  for (int row = number(from.y - slack_m_ - box_.low.y, rows_); row <= last_row; ++row) {
    const double low_y = box_.low.y + row * bucket_m_ - slack_m_;
    const double high_y = box_.low.y + (row + 1) * bucket_m_ + slack_m_;
    const auto x_at = [&](double y) {
      const double share = to.y > from.y ? (y - from.y) / (to.y - from.y) : 0;
      return from.x + std::clamp(share, 0.0, 1.0) * (to.x - from.x);
    };
    double x0 = from.y < low_y ? x_at(low_y) : from.x, x1 = to.y > high_y ? x_at(high_y) : to.x;
    if (x0 > x1) std::swap(x0, x1);
    const int last_column = number(x1 + slack_m_ - box_.low.x, columns_);
    for (int column = number(x0 - slack_m_ - box_.low.x, columns_); column <= last_column; ++column)
      visit(static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
            static_cast<std::size_t>(column));
  }
}

void SegmentBuckets::add(std::uint32_t segment, Vec2 from, Vec2 to) {
  for_each_bucket(from, to, [&](std::size_t bucket) { buckets_[bucket].push_back(segment); });
}

void SegmentBuckets::near(Vec2 from, Vec2 to, std::vector<std::uint32_t>& out) const {
  out.clear();
  for_each_bucket(from, to, [&](std::size_t bucket) {
    out.insert(out.end(), buckets_[bucket].begin(), buckets_[bucket].end());
  });
  std::sort(out.begin(), out.end());
  out.erase(std::unique(out.begin(), out.end()), out.end());
}

constexpr std::uint32_t kNoPoint = 0xffffffff;

struct Segment {
  Step ends;
  std::uint32_t via = kNoPoint; ///< replaced by the two steps over this point
  bool dropped = false;

  bool alive() const { return via == kNoPoint && !dropped; }
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
    std::uint32_t nearest = kNoPoint;
    for (const std::uint32_t candidate : near_points_)
      if (length(at(candidate) - p) <= reach_m_ &&
          (nearest == kNoPoint || length(at(candidate) - p) < length(at(nearest) - p)))
        nearest = candidate;
    return nearest != kNoPoint ? nearest : point(p);
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
    if (s.via == kNoPoint) return steps.push_back({from, to});
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

PlanArrangement arrange(std::span<const std::vector<Vec2>> lines, std::span<const Vec2> fixed,
                        double reach_m) {
  UncrossedLines uncrossed = uncross(lines, fixed, reach_m);
  std::vector<Edge> edges; // each once, from the lower point to the higher
  std::map<Step, std::size_t> number_of;
  for (const auto& line : uncrossed.lines)
    for (const auto& [a, b] : line) {
      const auto [low, high] = std::minmax({a, b});
      if (number_of.try_emplace({low, high}, edges.size()).second) edges.push_back({low, high});
    }

  TriangulatedLines triangulated = triangulate_lines(uncrossed.points, edges);
  PlanArrangement arrangement;
  arrangement.points = std::move(uncrossed.points);
  arrangement.faces = std::move(triangulated.faces);
  for (const auto& steps : uncrossed.lines) {
    auto& line = arrangement.lines.emplace_back();
    for (const auto& [a, b] : steps) {
      std::vector<std::uint32_t> through =
          triangulated.through[number_of.at({std::min(a, b), std::max(a, b)})];
      if (through.front() != a) std::reverse(through.begin(), through.end());
      const bool goes_on = !line.empty() && line.back() == a;
      line.insert(line.end(), through.begin() + (goes_on ? 1 : 0), through.end());
    }
  }
  return arrangement;
}

} // namespace orograph
