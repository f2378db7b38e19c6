// SPDX-License-Identifier: GPL-3.0-or-later
#include "map/check.hpp"

#include "geometry/on_all_cores.hpp"
#include "placing/sector.hpp"
#include "profiles/profile.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace orograph {
namespace {

constexpr double kSlit = 1e-12; // share of a segment

// A panorama's in each of its sectors.
std::size_t profile_count(const PlacedView& placed) {
  std::size_t count = 0;
  for (const Sector& sector : placed.sectors) count += sector.profiles.size();
  return count;
}

// The segments that reach into the range that was clipped, from which share of each to which, and
// what is visible of them. Near a panorama's eye few lie within a sector.
struct Clipped {
  std::vector<Segment> segments;
  std::vector<std::pair<double, double>> shares;
  std::vector<Piece> visible;
};
Clipped within(const SeenProfile& seen) {
  Clipped out;
  auto piece = seen.visible.begin();
  for (std::size_t i = 0; i < seen.segments.size(); ++i) {
    const Segment& segment = seen.segments[i];
    const auto& [begin, end] = seen.clipped;
    const bool is_upright = segment.x0 == segment.x1;
    const bool reaches = is_upright ? segment.x0 >= begin && segment.x1 <= end
                                    : segment.x0 < end && segment.x1 > begin;
    for (; piece != seen.visible.end() && piece->segment == i; ++piece) {
      if (!reaches) continue;
      out.visible.push_back(*piece);
      out.visible.back().segment = static_cast<std::uint32_t>(out.segments.size());
    }
    if (!reaches) continue;
    const double width = segment.x1 - segment.x0;
    out.segments.push_back(segment);
    out.shares.emplace_back(segment.x0 < begin ? (begin - segment.x0) / width : 0,
                            segment.x1 > end ? (end - segment.x0) / width : 1);
  }
  return out;
}

} // namespace

Check::Check(const TerrainData& terrain, const PlacedView& placed, double tolerance_mm,
             std::uint64_t points, bool both_sides)
    : terrain_(terrain), block_base_m_(placed.block_base_m), tolerance_mm_(tolerance_mm),
      a_profile_(points / 2 / std::max<std::size_t>(1, profile_count(placed)) + 1),
      a_sector_(points / 2 / placed.sectors.size()), both_sides_(both_sides) {}

void Check::begin(const Sector& sector) {
  if (sector_ == &sector) return;
  sector_ = &sector;
  tolerance_ = tie_tolerance(sector, tolerance_mm_);
  const auto turn = [&](auto& judge, const auto&... of) {
    if (judge)
      judge->set_view(sector.view, tolerance_);
    else
      judge.emplace(of..., sector.view, tolerance_);
  };
  if (both_sides_ && block_base_m_)
    turn(block_judge_, terrain_, *block_base_m_);
  else if (both_sides_)
    turn(sheet_judge_, terrain_.surface);
  else
    turn(judge_, terrain_.surface);
  engine_.seed(20240229); // always the same: a check can be run again
}

double Check::share() {
  return static_cast<double>(engine_() >> 11U) * 0x1p-53;
}

std::size_t Check::below(std::size_t count) {
  return engine_() % count;
}

// Close to one of a piece's ends, on either side of it: from a thousandth to a tenth of its length.
// At the line's own ends inside of it, and not on them, where what is on either side of an X meets.
double Check::near_end(double begin, double end) {
  const double distance = (end - begin) * std::pow(10, -1 - 2 * share());
  const double at = engine_() & 1U ? begin : end;
  const double place = engine_() & 1U ? at + distance : at - distance;
  return std::clamp(place > 0 && place < 1 ? place : 2 * at - place, 1e-9, 1 - 1e-9);
}

void Check::judge(const ProfileLine& line, double t, bool on_edge, bool drawn) {
  if (drawn_alone_ && !drawn) return;
  throw_if_stopped(); // a ray may go over thousands of triangles
  ++counts_.asked;
  const Verdict verdict = judge_->verdict(line, t, on_edge, drawn);
  if (verdict == Verdict::tied)
    ++counts_.ties;
  else if ((verdict == Verdict::visible) != drawn)
    ++(drawn ? counts_.hidden : counts_.missing);
}

void Check::judge(const ProfileLine& line, double t, const SheetJudge::Drawn& drawn) {
  throw_if_stopped();
  ++counts_.asked;
  const auto add_missing = [&] { // until it is known what is drawn there
    ++counts_.missing;
    const Vec2 place = project(sector_->view, point_between(line.from, line.to, t));
    undrawn_.add(place, tolerance_.at(place.x, place.y));
  };
  if (block_judge_) {
    using Sight = ClosedBlockJudge::Sight;
    const Sight sight = block_judge_->sight(line, t);
    const bool is_drawn = drawn.as_upper || drawn.as_underside;
    if (sight == Sight::unsure) ++counts_.ties;
    if (sight == Sight::hidden && is_drawn) ++counts_.hidden;
    if (sight == Sight::seen && !is_drawn) add_missing();
    return;
  }
  using Found = SheetJudge::Verdict;
  const Found found = sheet_judge_->ask(line, t, drawn).verdict;
  if (found == Found::unsure) ++counts_.ties;
  if (found == Found::drawn_wrong) ++counts_.hidden;
  if (found == Found::missing) add_missing();
}

void Check::see(const SeenProfile& seen) {
  if (both_sides_)
    upper_ = within(seen).visible; // with its underside, which comes next
  else
    ask_profile(seen, {});
}

void Check::see_underside(const SeenProfile& seen) {
  ask_profile(seen, upper_);
}

void Check::ask_profile(const SeenProfile& seen, const std::vector<Piece>& upper) {
  begin(seen.sector);
  const Clipped clipped = within(seen);
  const auto& [segments, shares, visible] = clipped;
  const Profile& profile = seen.profile;
  owed_ += a_profile_;
  if (segments.empty()) return; // the next ones are asked instead
  for (; owed_ > 0; --owed_) {
    std::uint32_t number = 0;
    double t = 0;
    const bool of_upper = both_sides_ && (visible.empty() || owed_ % 4 == 1);
    const std::vector<Piece>& pieces = of_upper ? upper : visible;
    if (owed_ % 2 == 0 || pieces.empty()) {
      number = static_cast<std::uint32_t>(below(segments.size()));
      const auto& [from, to] = shares[number];
      t = from + share() * (to - from);
    } else {
      const Piece& piece = pieces[below(pieces.size())];
      // Where two occluders meet, rounding may leave a slit between them.
      if (piece.t_end - piece.t_begin <= kSlit) continue;
      number = piece.segment;
      t = near_end(piece.t_begin, piece.t_end);
      if (!(t > shares[number].first && t < shares[number].second)) continue;
    }
    const auto holds = [&](const std::vector<Piece>& of) {
      const auto piece = std::partition_point(of.begin(), of.end(), [&](const Piece& p) {
        return p.segment < number || (p.segment == number && p.t_end < t);
      });
      return piece != of.end() && piece->segment == number && piece->t_begin <= t;
    };
    const std::uint32_t left = left_vertex(segments[number]);
    const auto at = [&](std::uint32_t vertex) {
      return ProfilePoint{profile.u_m[vertex], profile.depth_m, profile.z_m[vertex]};
    };
    // On a wall the way up is an edge: what is above and below it is at the same depth.
    const ProfileLine line{at(left), at(left + 1)};
    if (both_sides_)
      judge(line, t, {false, holds(upper), holds(visible)});
    else
      judge(line, t, profile.after[left] == Span::wall, holds(visible));
  }
}

bool Check::ask_line(const SeenLines& seen, std::uint32_t line, double t) {
  const auto& [sector, range, lines, visible, listed] = seen;
  const View& view = sector.view;
  if (!lines.line(line).drawn) return false;
  const ProfilePoint at = lines.point(line, t);
  // Cut away, or not: rounding of the place, of the cut and of the cut's own line decides.
  if (view.is_perspective() && at.v <= view.near_m + 4 * lines.rounding_m()) return false;
  const bool may_be_left_out = at.v <= view.drawn_from_m + 4 * lines.rounding_m();
  const double x = project(view, at).x;
  if (!(x >= range.begin && x <= range.end)) return false;
  const auto part = std::partition_point(visible.begin(), visible.end(), [&](const LinePart& p) {
    return p.line < line || (p.line == line && p.t_end < t);
  });
  const bool drawn = part != visible.end() && part->line == line && part->t_begin <= t;
  if (!drawn && may_be_left_out) return false;
  if (both_sides_) {
    if (lines.is_moved(lines.line(line).edge)) return false; // between two sectors
    const LineKind kind = lines.line(line).kind;
    judge(lines.whole(line), t, {is_on_ground(kind) || kind == LineKind::shore, drawn, drawn});
    return true;
  }
  // Straight below an edge, too, what is at the same place isn't in front.
  judge(lines.whole(line), t, lines.is_edge(line) || is_on_wall(lines.line(line).kind), drawn);
  return true;
}

void Check::see(const SeenLines& seen) {
  begin(seen.sector);
  const auto& [sector, range, lines, visible, listed] = seen;
  // Of a panorama's lines a sector has few.
  const std::size_t found = lines.found().size(), first_found = lines.size() - found,
                    from_list = listed ? listed->size() : first_found;
  const auto number = [&](std::size_t i) {
    return static_cast<std::uint32_t>(i >= from_list ? first_found + (i - from_list)
                                      : listed       ? (*listed)[i]
                                                     : i);
  };
  if (from_list + found == 0) return;
  const auto ask_one = [&](bool anywhere) {
    if (anywhere || visible.empty()) {
      const double at = share(); // compilers differ in which argument they reckon first
      return ask_line(seen, number(below(from_list + found)), at);
    }
    const LinePart& part = visible[below(visible.size())];
    return ask_line(seen, part.line, near_end(part.t_begin, part.t_end));
  };
  // Many lines are beside what is shown.
  constexpr int kTries = 16;
  for (std::uint64_t i = 0; i < a_sector_; ++i)
    for (int tries = 0; tries < kTries && !ask_one(i % 2 == 0); ++tries) {
    }
  const std::uint64_t tied = undrawn_.count(seen);
  counts_.missing -= tied;
  counts_.ties += tied;
}

std::vector<Judge> judges_of(const Surface& surface, const PlacedView& placed,
                             double tolerance_mm) {
  std::vector<Judge> judges;
  for (const Sector& sector : placed.sectors)
    judges.emplace_back(surface, sector.view, tie_tolerance(sector, tolerance_mm));
  return judges;
}

} // namespace orograph
