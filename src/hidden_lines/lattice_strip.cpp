// SPDX-License-Identifier: GPL-3.0-or-later
#include "hidden_lines/lattice_strip.hpp"

#include "geometry/on_all_cores.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace orograph {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// A corner of the part of a place that a strip of X shows.
struct Corner {
  double u, v;
};

// A convex polygon of few corners, cut by half-planes.
class Shown {
public:
  void add(Corner corner) { corners_[count_++] = corner; }
  // Leaves what `inside` is not negative of; it is linear.
  template <class Inside>
  void cut(const Inside& inside) {
    Shown left;
    for (std::size_t i = 0; i < count_; ++i) {
      const Corner a = corners_[i], b = corners_[(i + 1) % count_];
      const double at_a = inside(a), at_b = inside(b);
      if (at_a >= 0) left.add(a);
      if ((at_a >= 0) == (at_b >= 0)) continue;
      const double share = at_a / (at_a - at_b);
      left.add({a.u + share * (b.u - a.u), a.v + share * (b.v - a.v)});
    }
    *this = left;
  }
  bool empty() const { return count_ == 0; }
  std::pair<double, double> depths_m() const {
    std::pair<double, double> out{kInfinity, -kInfinity};
    for (std::size_t i = 0; i < count_; ++i)
      out = {std::min(out.first, corners_[i].v), std::max(out.second, corners_[i].v)};
    return out;
  }

private:
  std::array<Corner, 12> corners_; // four, and at most one more for each cut
  std::size_t count_ = 0;
};

} // namespace

LatticeStrip::LatticeStrip(const LatticeInWork& lattice, const Strip& strip,
                           std::span<const LineAtDepth> which, std::span<const Segment> near_cut,
                           std::size_t number)
    : lattice_(lattice), range_(strip.range), number_(number),
      pictures_(lattice.work.terrain.surface, lattice.work.sector, lattice.work.lines, strip.range,
                lattice.work.from_m),
      horizon_(strip.core.begin, strip.core.end, strip.blocks, pictures_.looked_at().begin,
               pictures_.looked_at().end),
      uprights_(lattice.grid, lattice.work.sector.view, lattice.work.from_m),
      cursors_(lattice.work.sector.profiles.size(), 0) {
  order_lines(which);
  for (const Segment& s : near_cut)
    if (s.x0 <= range_.end && s.x1 >= range_.begin) horizon_.raise({s.x0, s.x1, s, false});
}

// Into the order of their turns: parted by place first, which is cheaper than a sort of all.
void LatticeStrip::order_lines(std::span<const LineAtDepth> which) {
  std::vector<LineAtTurn> unordered;
  unordered.reserve(which.size());
  std::vector<std::uint32_t> end(lattice_.order.place_count() + 2, 0);
  for (const LineAtDepth& line : which) {
    throw_if_stopped(unordered.size());
    unordered.push_back({lattice_.turn_of(pictures_, line.line), line.line});
    ++end[LatticeOrder::place_of(unordered.back().turn) + 1];
  }
  for (std::size_t i = 1; i < end.size(); ++i) end[i] += end[i - 1];
  lines_.resize(unordered.size());
  for (const LineAtTurn& line : unordered) lines_[end[LatticeOrder::place_of(line.turn)]++] = line;
  const auto at = [&](std::uint32_t i) { return lines_.begin() + static_cast<std::ptrdiff_t>(i); };
  std::uint32_t begin = 0;
  for (const std::uint32_t past : end) {
    throw_if_stopped(begin);
    std::sort(at(begin), at(past), [](const LineAtTurn& a, const LineAtTurn& b) {
      return a.turn != b.turn ? a.turn < b.turn : a.line < b.line;
    });
    begin = past;
  }
}

void LatticeStrip::take(std::uint32_t number, std::span<ProfileInWork* const> profiles) {
  throw_if_stopped();
  const LatticeOrder::Place place = lattice_.order.place(number);
  find_profiles(place, profiles);
  for (Group group = next_group(number, true); !group.empty(); group = next_group(number, true))
    if (look_at(group)) take_looked_at();
  for (const bool back : {false, true}) take_side(number, back);
}

// The lines of the next edge, if it is at the place, on its line or not.
LatticeStrip::Group LatticeStrip::next_group(std::uint32_t place, bool on_line) {
  const std::size_t first = next_line_;
  if (first == lines_.size()) return {};
  const LatticeOrder::Turn turn = lines_[first].turn;
  if (LatticeOrder::place_of(turn) != place || LatticeOrder::is_on_line(turn) != on_line) return {};
  while (next_line_ < lines_.size() && lines_[next_line_].turn == turn) ++next_line_;
  return {&lines_[first], next_line_ - first};
}

// Whether any of the lines may be seen, or hide anything.
bool LatticeStrip::look_at(Group group) {
  looked_at_.clear();
  for (const LineAtTurn& at : group) {
    const LinePicture picture = pictures_.picture(at.line, pictures_.whole(at.line));
    if (std::max(picture.left.v, picture.right.v) <= pictures_.from_m()) continue;
    SurfaceLine line = pictures_.surface_line(at.line, picture);
    if (!pictures_.cut_to_range(line)) continue;
    if (line.upright() ? !line.drawn || pictures_.is_hidden(picture, horizon_)
                       : is_below_blocks(horizon_, line.begin, line.end,
                                         std::max(height_at(line.source, line.begin),
                                                  height_at(line.source, line.end))))
      continue;
    looked_at_.push_back({line, picture, at.line});
  }
  return !looked_at_.empty();
}

// All lines of an edge are compared before any of them hides.
void LatticeStrip::take_looked_at() {
  for (const auto& [line, picture, number] : looked_at_) {
    if (!line.drawn) continue;
    visible_.clear();
    if (line.upright())
      add_above_height(
          line, number,
          uprights_.in_front(pictures_.line(number).edge, picture.t_left < picture.t_right),
          visible_);
    else
      add_above_horizon(line, number, horizon_, lattice_.work.tolerance, visible_);
    for (const auto& [same, t_begin, t_end] : visible_)
      pictures_.add_part(number, picture, t_begin, t_end, parts_);
  }
  for (const LookedAt& at : looked_at_)
    if (raises(at.line)) horizon_.raise(occluder_of(at.line));
}

void LatticeStrip::find_profiles(const LatticeOrder::Place& place,
                                 std::span<ProfileInWork* const> profiles) {
  outwards_.clear();
  backwards_.clear();
  if (profiles.empty()) return;
  const auto [line, strip] = place;
  constexpr int kNone = LatticeOrder::Place::kNone;
  const int first = line != kNone && (strip == kNone || line < strip) ? line : strip,
            last = strip == kNone ? line : std::max(line, strip + 1);
  if (first == kNone) return;
  const bool rows = lattice_.order.rows_are_strips();
  const int cells = rows ? lattice_.grid.columns - 1 : lattice_.grid.rows - 1;
  const View& view = lattice_.work.sector.view;
  Shown shown;
  for (const auto& [at_strip, at_cell] :
       {std::pair{first, 0}, {last, 0}, {last, cells}, {first, cells}}) {
    const Vec2 at =
        lattice_.grid.plane().position_m(rows ? at_cell : at_strip, rows ? at_strip : at_cell) -
        view.depth_origin_m;
    shown.add({dot(at, view.right), dot(at, view.forward)});
  }
  const double slack_m = 1e-6 * lattice_.work.placed.cell_m;
  if (view.is_perspective()) shown.cut([&](Corner p) { return p.v - view.near_m; });
  const auto beside = [&](Corner p, double x) {
    return view.is_perspective() ? p.u - x * p.v : p.u + p.v * view.x_per_v - x;
  };
  if (!std::isinf(range_.begin))
    shown.cut([&](Corner p) { return beside(p, range_.begin) + slack_m; });
  if (!std::isinf(range_.end)) shown.cut([&](Corner p) { return slack_m - beside(p, range_.end); });
  if (shown.empty()) return;
  const auto [nearest_m, farthest_m] = shown.depths_m();
  auto at = std::partition_point(profiles.begin(), profiles.end(), [&](const ProfileInWork* p) {
    return p->planned.depth_m < nearest_m - slack_m;
  });
  for (; at != profiles.end() && (*at)->planned.depth_m <= farthest_m + slack_m; ++at)
    add_profile(place, **at);
}

void LatticeStrip::add_profile(const LatticeOrder::Place& place, ProfileInWork& profile) {
  const std::vector<double>& u = profile.profile.u_m;
  if (u.size() < 2) return;
  const auto& [at_origin, per_u, per_v] = lattice_.strip;
  const double at_depth = at_origin + per_v * profile.planned.depth_m;
  const int strips =
      (lattice_.order.rows_are_strips() ? lattice_.grid.rows : lattice_.grid.columns) - 1;
  const XRange reach{at_depth + per_u * u.front(), at_depth + per_u * u.back()};
  const double line = std::round(reach.begin);
  // All of it lies on one line of the lattice: taken before that hides.
  const bool on_line = std::abs(reach.begin - line) <= lattice_.rounding &&
                       std::abs(reach.end - line) <= lattice_.rounding;
  URange within;
  if (on_line) {
    if (place.line != static_cast<int>(line)) return;
  } else if (place.strip == LatticeOrder::Place::kNone) {
    return;
  } else {
    // Neighbouring strips have the same number for the line between them; there is nothing beyond
    // the first and the last.
    const auto u_at = [&](int l) {
      if (per_u == 0) return at_depth < l ? kInfinity : -kInfinity;
      return (l - at_depth) / per_u;
    };
    const double low = per_u < 0 ? kInfinity : -kInfinity;
    const double at_first = place.strip == 0 ? (per_u == 0 ? -kInfinity : low) : u_at(place.strip),
                 at_last = place.strip + 1 == strips ? (per_u == 0 ? kInfinity : -low)
                                                     : u_at(place.strip + 1);
    within = per_u < 0 ? URange{at_last, at_first} : URange{at_first, at_last};
    if (!(within.low_m < within.high_m)) return;
  }
  // No span is longer than a cell's edges together.
  const auto& [first_vertex_m, column_step_m, row_step_m] = lattice_.grid.plane();
  const double longest_m = length(column_step_m) + length(row_step_m);
  const URange shown = u_range(lattice_.work.sector.view, profile.planned.depth_m, range_);
  within.low_m = std::max(within.low_m, shown.low_m - longest_m);
  within.high_m = std::min(within.high_m, shown.high_m + longest_m);
  // The first span whose middle isn't before a place.
  const auto spans = static_cast<std::uint32_t>(u.size() - 1);
  const auto middle = [&](std::uint32_t span) { return 0.5 * (u[span] + u[span + 1]); };
  const auto first_from = [&](double at, std::uint32_t guess) {
    constexpr int kNear = 8;
    for (int i = 0; i < kNear; ++i) {
      if (guess < spans && middle(guess) < at)
        ++guess;
      else if (guess > 0 && !(middle(guess - 1) < at))
        --guess;
      else
        return guess;
    }
    std::uint32_t low = 0, high = spans;
    while (low < high) {
      const std::uint32_t half = low + (high - low) / 2;
      if (middle(half) < at)
        low = half + 1;
      else
        high = half;
    }
    return low;
  };
  std::uint32_t& cursor = cursors_[profile.index];
  const std::uint32_t first = first_from(within.low_m, std::min(cursor, spans)),
                      last = first_from(within.high_m, first);
  if (first >= last) return;
  cursor = first;
  profile.horizon_sizes[number_] = horizon_.size();
  if (is_hidden(profile, first, last)) return;
  if (on_line) {
    clip(profile, first, last);
    return;
  }
  // On either side of where cells begin to be taken backwards.
  const double cell_at_depth = lattice_.cell.at(0, profile.planned.depth_m),
               cell_per_u = lattice_.cell.per_u;
  const int own = lattice_.order.first_outwards();
  std::uint32_t middle_span = cell_per_u < 0 ? last : first; // where the forward side begins
  if (own > 0) {
    middle_span = first;
    while (middle_span < last &&
           (cell_at_depth + cell_per_u * middle(middle_span) < own) == (cell_per_u >= 0))
      ++middle_span;
  }
  const auto begin = static_cast<std::ptrdiff_t>(first), end = static_cast<std::ptrdiff_t>(last),
             parting = static_cast<std::ptrdiff_t>(middle_span);
  if (cell_per_u >= 0) {
    if (parting < end) outwards_.push_back({&profile, parting, end, 1, cell_at_depth, cell_per_u});
    if (begin < parting)
      backwards_.push_back({&profile, parting - 1, begin - 1, -1, -cell_at_depth, -cell_per_u});
  } else {
    if (begin < parting)
      outwards_.push_back({&profile, parting - 1, begin - 1, -1, cell_at_depth, cell_per_u});
    if (parting < end)
      backwards_.push_back({&profile, parting, end, 1, -cell_at_depth, -cell_per_u});
  }
}

// By bounds alone, as they stand before the strip's own lines rise: they never fall.
bool LatticeStrip::is_hidden(const ProfileInWork& profile, std::uint32_t first,
                             std::uint32_t last) const {
  constexpr std::uint32_t kMostSpans = 64; // of more, some part is likely to be seen
  if (last - first > kMostSpans) return false;
  const double* const y = profile.projected.y.data();
  double highest = y[first], lowest = highest;
  for (std::uint32_t i = first + 1; i <= last; ++i) {
    highest = std::max(highest, y[i]);
    lowest = std::min(lowest, y[i]);
  }
  // What is tied is nearer than this, and rounding far less.
  const double slack =
      lattice_.work.tolerance.greatest_y + 1e-12 * (std::abs(lowest) + std::abs(highest));
  return is_below_blocks(horizon_, std::max(profile.projected.x[first], range_.begin),
                         std::min(profile.projected.x[last], range_.end), highest + slack);
}

// The lines of a strip on one side of the eye's cell, between them the profiles.
void LatticeStrip::take_side(std::uint32_t place, bool back) {
  side_ = back ? &backwards_ : &outwards_;
  begun_ = done_ = 0;
  const auto first_cell = [](const ProfilePart& part) { return part.cell(part.next); };
  if (!std::is_sorted(side_->begin(), side_->end(),
                      [&](const auto& a, const auto& b) { return first_cell(a) < first_cell(b); }))
    std::stable_sort(side_->begin(), side_->end(),
                     [&](const auto& a, const auto& b) { return first_cell(a) < first_cell(b); });
  const auto columns = static_cast<std::uint32_t>(lattice_.grid.columns);
  while (next_line_ < lines_.size() && lattice_.order.goes_back(lines_[next_line_].turn) == back) {
    const Group group = next_group(place, false);
    if (group.empty()) break;
    if (!look_at(group)) continue;
    const LatticeOrder::Turn turn = group.front().turn;
    const std::uint32_t from = pictures_.line(group.front().line).edge.from;
    const auto column = static_cast<int>(from % columns), row = static_cast<int>(from / columns);
    const int cell = lattice_.order.rows_are_strips() ? column : row;
    const bool diagonal = LatticeOrder::is_diagonal(turn);
    // What lies on the edge itself is taken before that hides.
    take_up_to((!back                            ? cell
                : LatticeOrder::is_upright(turn) ? -cell
                                                 : -(cell + 1)) +
               lattice_.rounding);
    if (diagonal)
      take_diagonal(column, row, back);
    else
      take_looked_at();
  }
  take_up_to(kInfinity);
}

// The cell of a diagonal: its near triangle, the diagonal, its far one.
void LatticeStrip::take_diagonal(int column, int row, bool back) {
  const bool rows = lattice_.order.rows_are_strips(),
             lower_near = lattice_.order.is_lower_near(column, row);
  const int cell = rows ? column : row;
  const double end = back ? -cell : cell + 1;
  const auto column_less_row = [&](const ProfileInWork& profile, double u) {
    const double v = profile.planned.depth_m;
    const double at_strip = lattice_.strip.at(u, v), at_cell = lattice_.cell.at(u, v);
    return rows ? at_cell - at_strip : at_strip - at_cell;
  };
  far_.clear();
  for (; begun_ < side_->size() && (*side_)[begun_].cell((*side_)[begun_].next) < end; ++begun_) {
  }
  for (std::size_t i = done_; i < begun_; ++i) {
    ProfilePart& part = (*side_)[i];
    for (; !part.done() && part.cell(part.next) < end; part.next += part.step) {
      const double aside = column_less_row(*part.profile, part.middle(part.next)) - (column - row);
      const bool is_near = lower_near ? aside <= lattice_.rounding : aside >= -lattice_.rounding;
      if (is_near)
        clip(*part.profile, part.next, part.next + 1);
      else
        far_.push_back({part.profile, part.next});
    }
  }
  take_looked_at();
  for (const auto& [profile, span] : far_) clip(*profile, span, span + 1);
}

void LatticeStrip::take_up_to(double cell) {
  std::vector<ProfilePart>& side = *side_;
  while (begun_ < side.size() &&
         (side[begun_].done() || side[begun_].cell(side[begun_].next) < cell))
    ++begun_;
  for (std::size_t i = done_; i < begun_; ++i) {
    ProfilePart& part = side[i];
    const std::ptrdiff_t first = part.next;
    while (!part.done() && part.cell(part.next) < cell) part.next += part.step;
    if (part.next == first) continue;
    if (part.step > 0)
      clip(*part.profile, first, part.next);
    else
      clip(*part.profile, part.next + 1, first + 1);
  }
  while (done_ < begun_ && side[done_].done()) ++done_;
}

// Spans first to last - 1, less gaps.
void LatticeStrip::clip(ProfileInWork& profile, std::ptrdiff_t first, std::ptrdiff_t last) {
  const std::vector<Span>& after = profile.profile.after;
  for (auto span = static_cast<std::uint32_t>(first); span < static_cast<std::uint32_t>(last);) {
    std::uint32_t end = span;
    while (end < static_cast<std::uint32_t>(last) && after[end] != Span::gap) ++end;
    if (span < end)
      clip_run(profile.projected, {span, end}, range_, horizon_, lattice_.work.tolerance,
               profile.by_strip[number_], counts_);
    span = end + 1;
  }
}

} // namespace orograph
