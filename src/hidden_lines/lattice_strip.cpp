// SPDX-License-Identifier: GPL-3.0-or-later
#include "hidden_lines/lattice_strip.hpp"

#include "geometry/on_all_cores.hpp"

#include <algorithm>
#include <cmath>

namespace orograph {

LatticeStrip::LatticeStrip(const LatticeInWork& lattice, const Strip& strip,
                           std::span<const LineAtDepth> which, std::span<const Segment> near_cut,
                           std::size_t number)
    : lattice_(lattice), range_(strip.range), number_(number),
      pictures_(lattice.work.terrain.surface, lattice.work.placed.reach_m,
                lattice.work.on_ground.points, lattice.work.sector, lattice.work.lines, strip.range,
                lattice.work.from_m, lattice.work.on_ground.overlays_are_lifted),
      horizon_(strip.core.begin, strip.core.end, strip.blocks, pictures_.looked_at().begin,
               pictures_.looked_at().end),
      lines_(lattice, range_, which, pictures_, horizon_),
      cursors_(lattice.work.sector.profiles.size(), 0) {
  pictures_.set_seen_with(lattice.work.seen_with);
  for (const Segment& s : near_cut)
    if (s.x0 <= range_.end && s.x1 >= range_.begin) horizon_.raise({s.x0, s.x1, s, false});
}

void LatticeStrip::take(std::uint32_t number, const ProfilesOfPlace& profiles) {
  throw_if_stopped();
  const LatticeOrder::Place place = lattice_.order.place(number);
  const ShownOfPlace shown = shown_of(lattice_, place, pictures_.looked_at());
  lines_.begin_place(number, shown);
  find_profiles(place, shown, profiles);
  lines_.begin_part(PlacePart::line);
  while (lines_.next()) {
    throw_if_stopped();
    lines_.take();
  }
  for (const PlacePart side : {PlacePart::outwards, PlacePart::backwards}) take_side(side);
  lines_.end_place();
}

void LatticeStrip::find_profiles(const LatticeOrder::Place& place, const ShownOfPlace& shown,
                                 const ProfilesOfPlace& of_place) {
  outwards_.clear();
  backwards_.clear();
  if (shown.empty()) return;
  if (const EarthStrips* earth = lattice_.order.earth()) {
    find_spans(*earth, place.strip, of_place.spans);
    return;
  }
  const std::span<ProfileInWork* const> profiles = of_place.by_depth;
  auto at = std::partition_point(profiles.begin(), profiles.end(), [&](const ProfileInWork* p) {
    return p->planned.depth_m < shown.nearest_m;
  });
  for (; at != profiles.end() && (*at)->planned.depth_m <= shown.farthest_m; ++at)
    add_profile(place, **at);
}

void LatticeStrip::add_profile(const LatticeOrder::Place& place, ProfileInWork& profile) {
  const std::vector<double>& u = profile.profile.u_m;
  if (u.size() < 2) {
    if (lattice_.work.passes_over_profiles) profile.horizon_sizes[number_] = horizon_.size();
    return;
  }
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

// What of them is in the strip of X.
void LatticeStrip::find_spans(const EarthStrips& earth, int strip,
                              std::span<const SpansOfPlace> spans) {
  for (auto of = std::ranges::lower_bound(spans, range_.begin, {}, &SpansOfPlace::x_last);
       of != spans.end() && of->x_begin <= range_.end; ++of) {
    if (of->x_end < range_.begin) continue;
    const std::vector<double>& x = of->profile->projected.x;
    const auto begin = x.begin() + of->first, end = x.begin() + of->end;
    const auto first = std::partition_point(
        begin, end, [&](const double& left) { return (&left)[1] < range_.begin; });
    const auto last =
        std::partition_point(first, end, [&](double left) { return left <= range_.end; });
    if (first != last)
      add_in_order(earth, strip, *of->profile, static_cast<std::uint32_t>(first - x.begin()),
                   static_cast<std::uint32_t>(last - x.begin()));
  }
}

// Spans that a profile has one after another in a strip of cells pass those one after another, too.
void LatticeStrip::add_in_order(const EarthStrips& earth, int strip, ProfileInWork& profile,
                                std::uint32_t first, std::uint32_t last) {
  if (is_hidden(profile, first, last)) return;
  profile.horizon_sizes[number_] = horizon_.size();
  const SpansByStrip& spans = profile.on_earth;
  const bool rises = spans.cell(first) <= spans.cell(last - 1);
  const auto add = [&](std::uint32_t from, std::uint32_t to, double first_place, int per_cell) {
    const auto begin = static_cast<std::ptrdiff_t>(from), end = static_cast<std::ptrdiff_t>(to);
    if (begin == end) return;
    if ((per_cell > 0) == rises)
      outwards_.push_back({&profile, begin, end, 1, first_place, per_cell * 1.0, true});
    else
      outwards_.push_back({&profile, end - 1, begin - 1, -1, first_place, per_cell * 1.0, true});
  };
  // The spans up to a cell, as they come.
  const auto parting = [&](int cell, bool with_it) {
    const auto begin = spans.cells.begin() + first, end = spans.cells.begin() + last;
    const auto is_before = [&](std::uint32_t twice) {
      const int of = static_cast<int>(twice / 2);
      return of == cell ? with_it : (of < cell) == rises;
    };
    return static_cast<std::uint32_t>(std::partition_point(begin, end, is_before) -
                                      spans.cells.begin());
  };
  std::uint32_t from = rises ? first : last;
  for (const FallingRun& run : earth.runs_of(strip)) {
    const std::uint32_t a = parting(rises ? run.first : run.last, false),
                        b = parting(rises ? run.last : run.first, true);
    if (a == b) continue;
    if (rises)
      add(from, a, 0, 1);
    else
      add(b, from, 0, 1);
    add(a, b, run.first + run.last, -1);
    from = rises ? b : a;
  }
  if (rises)
    add(from, last, 0, 1);
  else
    add(first, from, 0, 1);
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
void LatticeStrip::take_side(PlacePart part) {
  const bool back = part == PlacePart::backwards;
  side_ = back ? &backwards_ : &outwards_;
  begun_ = done_ = 0;
  const auto first_cell = [](const ProfilePart& p) { return p.cell(p.next); };
  if (!std::is_sorted(side_->begin(), side_->end(),
                      [&](const auto& a, const auto& b) { return first_cell(a) < first_cell(b); }))
    std::stable_sort(side_->begin(), side_->end(),
                     [&](const auto& a, const auto& b) { return first_cell(a) < first_cell(b); });
  const auto columns = static_cast<std::uint32_t>(lattice_.grid.columns);
  lines_.begin_part(part);
  while (const auto next = lines_.next()) {
    throw_if_stopped();                             // a strip of cells may have thousands of lines
    if (LatticeOrder::is_of_triangle(next->turn)) { // and hides nothing
      lines_.take();
      continue;
    }
    // What lies on the edge itself is taken before that hides.
    const double cell = first_not_taken(*next, back);
    take_up_to(cell + lattice_.rounding);
    const std::uint32_t from = next->edge.from;
    if (LatticeOrder::is_diagonal(next->turn))
      take_diagonal(static_cast<int>(from % columns), static_cast<int>(from / columns), cell + 1);
    else
      lines_.take();
  }
  take_up_to(kInfinity);
}

// The cell, as it counts on a side, from which on nothing is in front of an edge.
double LatticeStrip::first_not_taken(const LatticeLines::EdgeAtTurn& edge, bool back) const {
  if (lattice_.order.earth())
    return LatticeOrder::cell_place(edge.turn) + (LatticeOrder::is_behind_cell(edge.turn) ? 1 : 0);
  const auto columns = static_cast<std::uint32_t>(lattice_.grid.columns);
  const auto cell = static_cast<int>(lattice_.order.rows_are_strips() ? edge.edge.from % columns
                                                                      : edge.edge.from / columns);
  return !back ? cell : LatticeOrder::is_upright(edge.turn) ? -cell : -(cell + 1);
}

// Whether the part's next span is in front of the diagonal of its cell, or on it.
bool LatticeStrip::is_near(const ProfilePart& part, int column, int row, bool lower_near) const {
  const ProfileInWork& profile = *part.profile;
  if (lattice_.order.earth())
    return profile.on_earth.is_lower(static_cast<std::size_t>(part.next)) == lower_near;
  const double u = part.middle(part.next), v = profile.planned.depth_m;
  const double at_strip = lattice_.strip.at(u, v), at_cell = lattice_.cell.at(u, v);
  const double column_less_row =
      lattice_.order.rows_are_strips() ? at_cell - at_strip : at_strip - at_cell;
  const double aside = column_less_row - (column - row);
  return lower_near ? aside <= lattice_.rounding : aside >= -lattice_.rounding;
}

// The cell of a diagonal: its near triangle, the diagonal, its far one. The cell's end counts
// `end`.
void LatticeStrip::take_diagonal(int column, int row, double end) {
  const bool lower_near = lattice_.order.is_lower_near(column, row);
  far_.clear();
  for (; begun_ < side_->size() && (*side_)[begun_].cell((*side_)[begun_].next) < end; ++begun_) {
  }
  for (std::size_t i = done_; i < begun_; ++i) {
    ProfilePart& part = (*side_)[i];
    for (; !part.done() && part.cell(part.next) < end; part.next += part.step) {
      if (is_near(part, column, row, lower_near))
        clip(*part.profile, part.next, part.next + 1);
      else
        far_.push_back({part.profile, part.next});
    }
  }
  lines_.take();
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
               lattice_.work.draws_profiles, profile.by_strip[number_], counts_);
    span = end + 1;
  }
}

} // namespace orograph
