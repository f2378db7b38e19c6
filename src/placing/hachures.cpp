// SPDX-License-Identifier: GPL-3.0-or-later
// Evenly spaced streamlines as Jobard and Lefer place them (Creating evenly-spaced streamlines of
// arbitrary density, 1997), with distances measured on the page.
#include "placing/hachures.hpp"

#include "geometry/angle.hpp"
#include "geometry/on_all_cores.hpp"
#include "placing/smooth_ground.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <optional>
#include <span>

namespace orograph {
namespace {

constexpr double kSmoothOver_mm = 1.5;
// Shares of the spacing: of a step along a line; how close lines may come; how far from others one
// may begin, and where that is tried, from the best on; the shortest line.
constexpr double kStep = 0.25, kClosest = 0.65, kBegin = 0.7, kShortest = 3;
constexpr std::array kTried{1.0, 0.85, 0.72};
// Steps of width, and the shortest part of a line that has its own.
constexpr double kWidthRatio = 1.1, kLeastRun_mm = 1;

constexpr double kDegree = std::numbers::pi / 180;

// A place on the smoothed ground as the page shows it.
struct OnPage {
  Vec2 place, page_mm;
  Vec2 per_u, per_v; ///< of the page, a metre on the ground
  Vec2 down;         ///< in plan, unit
  double slope_deg, node_m;

  Vec2 on_page(Vec2 step_m) const { return step_m.x * per_u + step_m.y * per_v; }
};

class PageField {
public:
  PageField(const SmoothGround& ground, const PlacedView& placed, const HachureSpec& spec)
      : ground_(ground), placed_(placed), least_slope_(std::tan(spec.from_deg * kDegree)) {}

  std::optional<Vec2> page_mm(Vec2 place) const {
    const auto smooth = ground_.at(place.x, place.y);
    return smooth ? page_of({place.x, place.y, smooth->z_m}) : std::nullopt;
  }

  // None where there is no slope that the page shows from its upper side.
  std::optional<OnPage> at(Vec2 place) const {
    const auto smooth = ground_.at(place.x, place.y);
    if (!smooth || !(smooth->slope() > least_slope_)) return std::nullopt;
    const ProfilePoint here{place.x, place.y, smooth->z_m};
    const auto page = page_of(here);
    const Box2& frame = placed_.frame_mm;
    if (!page || page->x < frame.low.x || page->x > frame.high.x || page->y < frame.low.y ||
        page->y > frame.high.y)
      return std::nullopt;
    const double step_m = 1e-3 * smooth->node_m;
    const auto along_u = page_of({here.u + step_m, here.v, here.z + step_m * smooth->per_u}),
               along_v = page_of({here.u, here.v + step_m, here.z + step_m * smooth->per_v});
    if (!along_u || !along_v) return std::nullopt;
    OnPage out{place,
               *page,
               (1 / step_m) * (*along_u - *page),
               (1 / step_m) * (*along_v - *page),
               (-1 / smooth->slope()) * Vec2{smooth->up_u, smooth->up_v},
               std::atan(smooth->slope()) / kDegree,
               smooth->node_m};
    // On the page y grows downwards: seen from above, right and away turn to the left of each
    // other.
    return cross(out.per_u, out.per_v) < 0 ? std::optional(out) : std::nullopt;
  }

private:
  std::optional<Vec2> page_of(ProfilePoint p) const {
    const Vec3 image = placed_.on_page(p);
    if (!(image.z > 0)) return std::nullopt;
    return Vec2{image.x / image.z, image.y / image.z};
  }

  const SmoothGround& ground_;
  const PlacedView& placed_;
  double least_slope_;
};

// Points of lines, by where they are on the page. Ground that the page shows behind other ground is
// no neighbour of it: how far apart points are in plan, as the page shows that, tells.
class LinesOnPage {
public:
  LinesOnPage(const Box2& frame_mm, double cell_mm)
      : low_(frame_mm.low), cell_mm_(cell_mm),
        columns_(static_cast<std::size_t>(frame_mm.width() / cell_mm) + 1),
        cells_(columns_ * (static_cast<std::size_t>(frame_mm.height() / cell_mm) + 1)) {}

  void add(const OnPage& point) {
    cells_[cell(point.page_mm.y) * columns_ + column(point.page_mm.x)].push_back(
        {point.page_mm, point.place});
  }

  // REQUIRES a distance of no more than a cell.
  bool has_within(const OnPage& of, double distance_mm) const {
    constexpr double kAsidePlan = 2;
    const std::size_t c = column(of.page_mm.x), r = cell(of.page_mm.y),
                      rows = cells_.size() / columns_;
    for (std::size_t row = r > 0 ? r - 1 : 0; row <= std::min(r + 1, rows - 1); ++row)
      for (std::size_t col = c > 0 ? c - 1 : 0; col <= std::min(c + 1, columns_ - 1); ++col)
        for (const auto& [page_mm, place] : cells_[row * columns_ + col])
          if (plain_length(page_mm - of.page_mm) < distance_mm &&
              plain_length(of.on_page(place - of.place)) < kAsidePlan * distance_mm)
            return true;
    return false;
  }

private:
  struct Point {
    Vec2 page_mm, place;
  };
  std::size_t column(double x) const { return static_cast<std::size_t>((x - low_.x) / cell_mm_); }
  std::size_t cell(double y) const { return static_cast<std::size_t>((y - low_.y) / cell_mm_); }

  Vec2 low_;
  double cell_mm_;
  std::size_t columns_;
  std::vector<std::vector<Point>> cells_;
};

// What is kept of a line's points: a poster has millions.
struct LinePoint {
  Vec2 place, page_mm;
  float slope_deg;
};
using Line = std::vector<LinePoint>;

class Hachures {
public:
  Hachures(const SmoothGround& ground, const PlacedView& placed, const HachureSpec& spec)
      : ground_(ground), field_(ground, placed, spec), frame_mm_(placed.frame_mm),
        spacing_mm_(spec.spacing_mm), on_page_(placed.frame_mm, spec.spacing_mm) {}

  std::vector<Line> find() {
    const Box2& all = ground_.bounds_m();
    double size_m = ground_.node_m();
    while (size_m < std::max(all.width(), all.height())) size_m *= 2;
    seed({all.low, all.low + Vec2{size_m, size_m}});
    return std::move(lines_);
  }

private:
  // Tries places about a spacing apart on the page, all over a square.
  void seed(const Box2& square) {
    const Box2& all = ground_.bounds_m();
    if (square.low.x > all.high.x || square.low.y > all.high.y) return;
    const Vec2 middle = square.centre();
    // In nodes: a larger square may hold ground far from its middle; between smaller ones there is
    // nothing that the ground beside them doesn't tell.
    constexpr double kLargest = 64, kSmallest = 0.25;
    const double size = square.width() / ground_.node_m();
    const auto page = field_.page_mm(middle);
    if (!page && size <= 1) return; // no ground
    bool is_small = size <= kSmallest;
    if (page && size <= kLargest && !is_small) {
      double across_mm = 0;
      for (const Vec2 corner : {square.low, square.high, Vec2{square.low.x, square.high.y},
                                Vec2{square.high.x, square.low.y}})
        if (const auto at = field_.page_mm(corner))
          across_mm = std::max(across_mm, 2 * plain_length(*at - *page));
      const Vec2 beside{std::max({frame_mm_.low.x - page->x, page->x - frame_mm_.high.x, 0.0}),
                        std::max({frame_mm_.low.y - page->y, page->y - frame_mm_.high.y, 0.0})};
      if (across_mm > 0 && plain_length(beside) > 2 * across_mm) return;
      is_small = across_mm > 0 && across_mm < 1.5 * spacing_mm_;
    }
    if (!is_small) {
      const auto& [low, high] = square;
      for (const Box2& quarter : {Box2{low, middle}, Box2{{middle.x, low.y}, {high.x, middle.y}},
                                  Box2{{low.x, middle.y}, {middle.x, high.y}}, Box2{middle, high}})
        seed(quarter);
      return;
    }
    throw_if_stopped(++seeds_);
    if (begin_at(middle)) go_on();
  }

  // From one line to the next, as long as there is room beside one.
  void go_on() {
    for (; next_line_ < lines_.size(); ++next_line_)
      for (std::size_t i = 0; i < lines_[next_line_].size(); i += 2) {
        throw_if_stopped(++seeds_);
        if (const auto at = field_.at(lines_[next_line_][i].place)) begin_beside(*at);
      }
  }

  void begin_beside(const OnPage& at) {
    const Vec2 across{-at.down.y, at.down.x};
    const Vec2 down_mm = at.on_page(at.down), across_mm = at.on_page(across);
    // What of a step to the side is across the line on the page.
    const double mm_a_metre = std::abs(cross(down_mm, across_mm)) / plain_length(down_mm);
    if (!(mm_a_metre > 0)) return;
    for (const double side : {-1.0, 1.0})
      for (const double share : kTried) {
        const Vec2 step_m = (side * share * spacing_mm_ / mm_a_metre) * across;
        if (is_taken(at, step_m)) continue;
        if (begin_at(at.place + step_m)) break;
      }
  }

  // Whether a line is surely too close to a place beside a point; told without looking at the
  // ground there.
  bool is_taken(const OnPage& at, Vec2 step_m) const {
    constexpr double kSurely = 0.8;
    OnPage beside = at;
    beside.place = at.place + step_m;
    beside.page_mm = at.page_mm + at.on_page(step_m);
    const Box2& frame = frame_mm_;
    const bool is_in_frame = beside.page_mm.x >= frame.low.x && beside.page_mm.x <= frame.high.x &&
                             beside.page_mm.y >= frame.low.y && beside.page_mm.y <= frame.high.y;
    return !is_in_frame || on_page_.has_within(beside, kSurely * kBegin * spacing_mm_);
  }

  bool begin_at(Vec2 place) {
    const auto start = field_.at(place);
    if (!start || on_page_.has_within(*start, kBegin * spacing_mm_)) return false;
    std::vector<OnPage> whole = traced(*start, -1);
    const std::vector<OnPage> down = traced(*start, 1);
    std::ranges::reverse(whole);
    whole.push_back(*start);
    whole.insert(whole.end(), down.begin(), down.end());
    double length_mm = 0;
    for (std::size_t i = 1; i < whole.size(); ++i)
      length_mm += plain_length(whole[i].page_mm - whole[i - 1].page_mm);
    if (length_mm < kShortest * spacing_mm_) return false;
    Line& line = lines_.emplace_back();
    line.reserve(whole.size());
    for (const OnPage& point : whole) {
      on_page_.add(point);
      line.push_back({point.place, point.page_mm, static_cast<float>(point.slope_deg)});
    }
    return true;
  }

  // From a place down the slope, or up.
  std::vector<OnPage> traced(const OnPage& start, double sign) const {
    std::vector<OnPage> line;
    OnPage here = start;
    const auto steps = static_cast<std::size_t>((frame_mm_.width() + frame_mm_.height()) /
                                                (kStep * spacing_mm_) * 4);
    while (line.size() < steps) {
      const Vec2 way = sign * here.down;
      const double mm_a_metre = plain_length(here.on_page(way));
      const double step_m = std::min(kStep * spacing_mm_ / mm_a_metre, 0.5 * here.node_m);
      const auto middle = field_.at(here.place + 0.5 * step_m * way);
      if (!middle || dot(middle->down, here.down) <= 0) break;
      const auto next = field_.at(here.place + (sign * step_m) * middle->down);
      if (!next || dot(next->down, here.down) <= 0 ||
          on_page_.has_within(*next, kClosest * spacing_mm_))
        break;
      line.push_back(*next);
      here = *next;
    }
    return line;
  }

  const SmoothGround& ground_;
  PageField field_;
  Box2 frame_mm_;
  double spacing_mm_;
  LinesOnPage on_page_;
  std::vector<Line> lines_;
  std::size_t next_line_ = 0; ///< beside which there may be room
  std::size_t seeds_ = 0;
};

HachureRun run_of(std::span<const LinePoint> points) {
  HachureRun run{{}, 0, 0};
  for (const LinePoint& point : points) {
    run.places.push_back(point.place);
    run.slope_deg += point.slope_deg / static_cast<double>(points.size());
  }
  return run;
}

} // namespace

double hachure_width_mm(const HachureSpec& spec, double pen_width_mm, double slope_deg) {
  const double share = (slope_deg - spec.from_deg) / (spec.heaviest_from_deg - spec.from_deg);
  const double least_mm = std::min(0.5 * pen_width_mm, 0.5 * spec.spacing_mm);
  return std::lerp(least_mm, 0.5 * spec.spacing_mm, std::clamp(share, 0.0, 1.0));
}

std::vector<HachureRun> hachures(const Surface& surface, const PlacedView& placed,
                                 const HachureSpec& spec, double pen_width_mm) {
  const SmoothGround ground(surface, placed, kSmoothOver_mm);
  if (!(ground.node_m() > 0)) return {};
  const std::vector<Line> lines = Hachures(ground, placed, spec).find();
  const double least_mm = hachure_width_mm(spec, pen_width_mm, spec.from_deg);
  const auto step_of = [&](double slope_deg) {
    const double width_mm = hachure_width_mm(spec, pen_width_mm, slope_deg);
    return std::log(width_mm / least_mm) / std::log(kWidthRatio);
  };
  std::vector<HachureRun> runs;
  for (const Line& line : lines) {
    throw_if_stopped(runs.size());
    std::vector<double> way_mm(line.size(), 0);
    for (std::size_t i = 1; i < line.size(); ++i)
      way_mm[i] = way_mm[i - 1] + plain_length(line[i].page_mm - line[i - 1].page_mm);
    std::size_t from = 0;
    double step = step_of(line.front().slope_deg);
    const auto close = [&](std::size_t last) {
      HachureRun run = run_of(std::span(line).subspan(from, last - from + 1));
      run.width_mm = least_mm * std::pow(kWidthRatio, std::round(step_of(run.slope_deg)));
      runs.push_back(std::move(run));
      from = last;
    };
    for (std::size_t i = 1; i + 1 < line.size(); ++i) {
      const double here = step_of(line[i].slope_deg);
      if (std::abs(here - step) < 1 || way_mm[i] - way_mm[from] < kLeastRun_mm ||
          way_mm.back() - way_mm[i] < kLeastRun_mm)
        continue;
      close(i);
      step = here;
    }
    close(line.size() - 1);
  }
  return runs;
}

} // namespace orograph
