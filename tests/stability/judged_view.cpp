// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/stability/judged_view.hpp"

#include "dem/approximate/tin_of_grid.hpp"
#include "geometry/error.hpp"
#include "map/draw_map.hpp"
#include "placing/placed_view.hpp"
#include "tests/stability/sight_through_triangles.hpp"
#include "tests/support/random.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

namespace orograph {
namespace {

// Ends farther away than this aren't ends of that: the ink between is asked about anyway.
constexpr double kFarthest_mm = 1e-3;

LongPlace place_on(const ProfileLine& line, long double t) {
  const auto between = [t](long double a, long double b) { return a + t * (b - a); };
  return {between(line.from.u, line.to.u), between(line.from.v, line.to.v),
          between(line.from.z, line.to.z)};
}

struct DrawnStretch {
  double begin, end;
};

bool shows(std::span<const DrawnStretch> drawn, double t) {
  return std::any_of(drawn.begin(), drawn.end(),
                     [&](const DrawnStretch& s) { return s.begin <= t && t <= s.end; });
}

// Of one sector.
class SectorJudge {
public:
  SectorJudge(const Grid& grid, const Sector& sector, const Box2& frame_mm, double tolerance_mm,
              Judged& judged)
      : sector_(sector), frame_mm_(frame_mm), sight_(grid, sector.view),
        tolerance_(tie_tolerance(sector, tolerance_mm)), tolerance_mm_(tolerance_mm),
        judged_(judged) {}

  // Not in front of the near plane, beside what was clipped, or beside the page.
  bool may_ask(const ProfileLine& line, double t, XRange range) const {
    const ProfilePoint at = point_between(line.from, line.to, t);
    const View& view = sector_.view;
    const auto rounding = static_cast<double>(sight_.rounding_m());
    if (view.is_perspective() && at.v <= std::max(view.near_m, view.drawn_from_m) + 4 * rounding)
      return false;
    const double x = project(view, at).x;
    if (!(x > range.begin && x < range.end)) return false;
    // Far beside the page a tolerance on it is less than rounding.
    const Vec3 image = sector_.to_page.of(project_homogeneous(view, at));
    const Vec2 on_page{image.x / image.z, image.y / image.z};
    return image.z > 0 && on_page.x >= frame_mm_.low.x && on_page.x <= frame_mm_.high.x &&
           on_page.y >= frame_mm_.low.y && on_page.y <= frame_mm_.high.y;
  }

  void ask(const ProfileLine& line, double t, bool drawn) {
    ++judged_.points;
    const Standing standing = standing_at(line, t);
    if (standing == Standing::tied) {
      ++judged_.ties;
      return;
    }
    if ((standing == Standing::visible) == drawn) return;
    if (turns_within_rounding(line, t, standing)) {
      ++judged_.in_rounding;
      return;
    }
    if (judged_.wrong++ == 0) {
      const LongPlace at = place_on(line, t);
      judged_.first_wrong =
          fmt::format("{} at {} of the line {},{},{} to {},{},{}: above by {}",
                      drawn ? "drawn" : "missing", t, line.from.u, line.from.v, line.from.z,
                      line.to.u, line.to.v, line.to.z, static_cast<double>(sight_.above(at)));
    }
  }

  // The end at t of a drawn piece that goes on from it in the direction of `inwards`.
  void ask_end(const ProfileLine& line, double t, double inwards,
               std::span<const DrawnStretch> drawn, XRange range) {
    const double mm = mm_per_share(line, t);
    if (!(mm > tolerance_mm_)) return; // no picture, or so small a one that all of it is a tie
    const std::array<double, 2> beside{std::clamp(t - kFarthest_mm / mm, 0.0, 1.0),
                                       std::clamp(t + kFarthest_mm / mm, 0.0, 1.0)};
    for (const double place : beside) // the near plane and the page's edge end lines as well
      if (!may_ask(line, place, range)) return;
    ++judged_.ends;
    for (double away_mm = 1e-12; away_mm <= kFarthest_mm; away_mm *= 10) {
      const double by = away_mm / mm * inwards;
      if (is_right(line, t + by, true, away_mm) && is_right(line, t - by, false, away_mm)) {
        judged_.farthest_mm = std::max(judged_.farthest_mm, away_mm);
        return;
      }
    }
    // No true end is near: either side is tied, or wrong.
    ++judged_.ends_tied;
    for (const double place : beside) ask(line, place, shows(drawn, place));
  }

private:
  enum class Standing { visible, hidden, tied };

  long double tolerance_at(const LongPlace& place) const {
    const Vec2 at =
        project(sector_.view, {static_cast<double>(place.u), static_cast<double>(place.v),
                               static_cast<double>(place.z)});
    return tolerance_.at(at.x, at.y);
  }
  Standing standing_of(const LongPlace& place) const {
    return standing_of(place, sight_.above(place));
  }
  Standing standing_of(const LongPlace& place, long double above) const {
    if (std::abs(above) <= tolerance_at(place)) return Standing::tied;
    return above > 0 ? Standing::visible : Standing::hidden;
  }
  Standing standing_at(const ProfileLine& line, double t) const {
    return standing_of(place_on(line, t));
  }
  // Whether nothing in front speaks against it by more than that; beyond the line's own ends
  // nothing does.
  bool is_right(const ProfileLine& line, double t, bool drawn, double by_mm) const {
    if (!(t > 0 && t < 1)) return true;
    const LongPlace place = place_on(line, t);
    const long double above = sight_.above(place), by = tolerance_at(place) * by_mm / tolerance_mm_;
    return drawn ? above >= -by : above <= by;
  }

  // By how much of the line its X may be off, as its ends are off by r. Of one that runs nearly
  // straight away from the eye that may be metres; if it is all of it, rounding alone tells whether
  // a crest that falls away is hidden by its nearer end or shows beside it.
  long double rounding_of_x(const ProfileLine& line, long double r) const {
    const View& view = sector_.view;
    const double x0 = project(view, line.from).x, x1 = project(view, line.to).x;
    const double nearest = view.is_perspective() ? std::min(line.from.v, line.to.v) : 1;
    return r * (1 + std::max(std::abs(x0), std::abs(x1))) / (std::abs(x0 - x1) * nearest);
  }

  // By how much of the line a place is off that is told as a share of the line's picture from the
  // near plane on, to 16 roundings: three sums and quotients, there and back. That is far below all
  // else, but where the picture reaches a million widths to the side.
  long double rounding_of_share(const ProfileLine& line, double t) const {
    constexpr double kFar = 1024;
    const View& view = sector_.view;
    if (!view.is_perspective()) return 0;
    const ProfileLine ahead = ahead_of_near_plane(line);
    const double width = std::abs(project(view, ahead.from).x - project(view, ahead.to).x);
    if (!(width > kFar)) return 0;
    const ProfilePoint at = point_between(line.from, line.to, t);
    const double u = line.to.u - line.from.u, v = line.to.v - line.from.v;
    const double x_per_share = std::abs(u * at.v - at.u * v) / (at.v * at.v);
    return 16 * std::numeric_limits<double>::epsilon() * width / x_per_share;
  }
  ProfileLine ahead_of_near_plane(const ProfileLine& line) const {
    const double near_m = sector_.view.near_m, v0 = line.from.v, v1 = line.to.v;
    if (std::min(v0, v1) >= near_m) return line;
    const ProfilePoint cut = point_between(line.from, line.to, (near_m - v0) / (v1 - v0));
    return v0 < near_m ? ProfileLine{cut, line.to} : ProfileLine{line.from, cut};
  }

  // Along the line, as a share of it, and across the ray.
  bool turns_within_rounding(const ProfileLine& line, double t, Standing standing) const {
    const double length = std::hypot(line.to.u - line.from.u, line.to.v - line.from.v);
    const LongPlace at = place_on(line, t);
    const long double r = 2 * sight_.rounding_m(); // what is nearer by less isn't in front
    const long double of_x = rounding_of_x(line, r);
    if (mm_per_share(line, t) <= tolerance_mm_ || length <= r || !(of_x < 1)) return true;
    const long double of_share = rounding_of_share(line, t);
    if (length > 0)
      for (const long double by : {-r / length, r / length, -of_x, of_x, -of_share, of_share}) {
        const long double there = t + by; // beyond the line's own ends nothing tells
        if (!(there > 0 && there < 1) || standing_of(place_on(line, there)) != standing)
          return true;
      }
    for (const LongPlace& by : {LongPlace{r, 0, 0}, {-r, 0, 0}, {0, r, 0}, {0, -r, 0}})
      if (standing_of({at.u + by.u, at.v + by.v, at.z}) != standing) return true;
    // What runs along beside the line in front of it by less than that, down to about one rounding
    // (r is 32), may hide it or not: an edge that ends where the line does.
    return standing_of(at, sight_.above(at, r / 32)) != standing;
  }

  // Length on the page of a small share of the line, over the share.
  double mm_per_share(const ProfileLine& line, double t) const {
    const ProfilePoint at = point_between(line.from, line.to, t);
    const Vec3 from = project_homogeneous(sector_.view, line.from),
               to = project_homogeneous(sector_.view, line.to);
    const Vec3 here = project_homogeneous(sector_.view, at);
    if (!(sector_.to_page.of(here).z > 0)) return 0;
    return sector_.to_page.mm_per_step(here, {to.x - from.x, to.y - from.y, to.z - from.z});
  }

  const Sector& sector_;
  Box2 frame_mm_;
  SightThroughTriangles sight_;
  TieTolerance tolerance_;
  double tolerance_mm_;
  Judged& judged_;
};

class ViewJudge : public LineObserver {
public:
  ViewJudge(const Grid& grid, const PlacedView& placed, double tolerance_mm, std::uint64_t points,
            std::uint64_t seed, Judged& judged)
      : random_(seed),
        a_profile_(points / 2 / std::max<std::size_t>(1, placed.depths_m.size()) + 1),
        a_sector_(points / 2) {
    for (const Sector& sector : placed.sectors)
      judges_.emplace_back(grid, sector, placed.frame_mm, tolerance_mm, judged);
    first_ = placed.sectors.data();
  }

  void see(const SeenProfile& seen) override {
    const Profile& profile = seen.profile;
    lines_.clear();
    drawn_.clear();
    auto piece = seen.visible.begin();
    for (std::uint32_t i = 0; i < seen.segments.size(); ++i) {
      const Segment& segment = seen.segments[i];
      std::vector<DrawnStretch> drawn;
      for (; piece != seen.visible.end() && piece->segment == i; ++piece)
        drawn.push_back({piece->t_begin, piece->t_end});
      if (segment.x0 < seen.clipped.begin || segment.x1 > seen.clipped.end) continue;
      const std::uint32_t left = left_vertex(segment);
      const auto at = [&](std::uint32_t vertex) {
        return ProfilePoint{profile.u_m[vertex], profile.depth_m, profile.z_m[vertex]};
      };
      lines_.push_back({at(left), at(left + 1)});
      drawn_.push_back(std::move(drawn));
    }
    ask_lines(seen.sector, seen.clipped, a_profile_);
  }

  void see(const SeenLines& seen) override {
    lines_.clear();
    drawn_.clear();
    std::vector<std::size_t> number(seen.lines.size());
    for (std::uint32_t i = 0; i < seen.lines.size(); ++i) {
      number[i] = lines_.size();
      if (!seen.lines.line(i).drawn) continue;
      lines_.push_back(seen.lines.whole(i));
      drawn_.emplace_back();
    }
    for (const LinePart& part : seen.visible)
      if (seen.lines.line(part.line).drawn)
        drawn_[number[part.line]].push_back({part.t_begin, part.t_end});
    ask_lines(seen.sector, seen.clipped, a_sector_);
  }

private:
  void ask_lines(const Sector& sector, XRange range, std::uint64_t points) {
    if (lines_.empty()) return;
    SectorJudge& judge = judges_[static_cast<std::size_t>(&sector - first_)];
    for (std::uint64_t i = 0; i < points; ++i) {
      const auto n =
          static_cast<std::size_t>(random_.whole(0, static_cast<int>(lines_.size()) - 1));
      const ProfileLine& line = lines_[n];
      const double t = random_.share();
      if (judge.may_ask(line, t, range)) judge.ask(line, t, shows(drawn_[n], t));
      if (drawn_[n].empty()) continue;
      const DrawnStretch& piece = drawn_[n][static_cast<std::size_t>(
          random_.whole(0, static_cast<int>(drawn_[n].size()) - 1))];
      const bool at_begin = random_.chance(0.5);
      const double end = at_begin ? piece.begin : piece.end;
      if (end > 0 && end < 1 && judge.may_ask(line, end, range) && !is_shut(drawn_[n], end))
        judge.ask_end(line, end, at_begin ? 1 : -1, drawn_[n], range);
    }
  }
  // Where rounding leaves less than a slit between two pieces there is no end.
  static bool is_shut(std::span<const DrawnStretch> drawn, double t) {
    constexpr double kSlit = 1e-12;
    return shows(drawn, t - kSlit) && shows(drawn, t + kSlit);
  }

  Random random_;
  std::uint64_t a_profile_, a_sector_;
  std::vector<SectorJudge> judges_;
  const Sector* first_ = nullptr;
  std::vector<ProfileLine> lines_;
  std::vector<std::vector<DrawnStretch>> drawn_;
};

} // namespace

void Judged::add(const Judged& other) {
  scenes += other.scenes;
  refused += other.refused;
  points += other.points;
  ties += other.ties;
  in_rounding += other.in_rounding;
  wrong += other.wrong;
  ends += other.ends;
  ends_tied += other.ends_tied;
  farthest_mm = std::max(farthest_mm, other.farthest_mm);
  if (first_wrong.empty()) first_wrong = other.first_wrong;
}

Judged judge_view(TerrainData terrain, MapSpec spec, std::uint64_t points, std::uint64_t seed,
                  bool as_tin) {
  Judged judged;
  judged.scenes = 1;
  const Grid grid = std::get<Grid>(terrain.surface);
  if (as_tin) terrain.surface = tin_of(grid);
  spec.style.simplify_mm = 0;
  spec.style.silhouette_jump = 0;
  spec.style.light = std::nullopt;
  spec.style.spread = Spread::planes;
  spec.style.layers.emplace_back("voids");
  try {
    const PlacedView placed = placed_view(terrain, spec);
    ViewJudge judge(grid, placed, spec.style.visibility_tolerance_mm, points, seed, judged);
    Instruments instruments;
    instruments.observers = {&judge};
    instruments.order_always = seed % 2 == 0;
    const Map map = draw_map(
        terrain, placed, spec, [](double) {}, instruments);
    if (const auto fault = find_fault(map.drawing)) {
      if (judged.wrong++ == 0) judged.first_wrong = *fault;
    }
  } catch (const Error&) {
    judged.refused = 1;
  }
  return judged;
}

} // namespace orograph
