// SPDX-License-Identifier: GPL-3.0-or-later
#include "hidden_lines/lattice_strip.hpp"

#include "geometry/on_all_cores.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace orograph {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

} // namespace

LatticeStrip::LatticeStrip(const LatticeInWork& lattice, const Strip& strip,
                           std::span<const LineAtDepth> which, std::span<const Segment> near_cut,
                           std::size_t number)
    : lattice_(lattice), range_(strip.range), inner_range_(range_), number_(number),
      pictures_(lattice.work.terrain.surface, lattice.work.sector, lattice.work.lines, strip.range,
                lattice.work.from_m),
      horizon_(strip.core.begin, strip.core.end, strip.blocks, pictures_.looked_at().begin,
               pictures_.looked_at().end),
      uprights_(lattice.grid, lattice.work.sector.view, lattice.work.from_m),
      cursors_(lattice.work.sector.profiles.size(), 0) {
  const XRange looked_at = pictures_.looked_at();
  if (!std::isinf(range_.begin)) inner_range_.begin += range_.begin - looked_at.begin;
  if (!std::isinf(range_.end)) inner_range_.end -= looked_at.end - range_.end;
  if (lattice.work.silhouettes) {
    silhouettes_.emplace(lattice, *lattice.work.silhouettes, pictures_);
    if (lattice.work.folds) {
      const bool whole = lattice.work.placed.extent.valid == lattice.grid.size();
      ridges_.emplace(*lattice.work.folds, pictures_, whole);
    }
  }
  order_lines(which);
  for (const Segment& s : near_cut)
    if (s.x0 <= range_.end && s.x1 >= range_.begin) horizon_.raise({s.x0, s.x1, s, false});
}

// Into the order of their turns.
void LatticeStrip::order_lines(std::span<const LineAtDepth> which) {
  const auto add = [&](std::uint32_t line) {
    throw_if_stopped(lines_.size());
    lines_.push_back({lattice_.turn_of(pictures_, pictures_.line(line).edge), line});
  };
  for (const LineAtDepth& line : which) add(line.line);
  if (silhouettes_ && lattice_.work.sector.keeps_strip) {
    // What was moved ahead isn't found at its line's place. It lies on the line under the eye.
    const int strips =
        (lattice_.order.rows_are_strips() ? lattice_.grid.rows : lattice_.grid.columns) - 1;
    const double under_eye = lattice_.strip.at_origin;
    for (const double line : {std::floor(under_eye), std::floor(under_eye) + 1})
      if (line > 0 && line < strips)
        for (const SurfaceEdge& edge : silhouettes_->moved(static_cast<int>(line)))
          add(pictures_.add_found(
              {edge, LineKind::silhouette, true, lattice_.work.draws_silhouettes, false}));
  }
  std::size_t steps = 0;
  const auto before = [&](const LineAtTurn& a, const LineAtTurn& b) {
    throw_if_stopped(++steps);
    if (a.turn != b.turn) return a.turn < b.turn;
    const auto kind = [&](const LineAtTurn& at) { return pictures_.line(at.line).kind; };
    return kind(a) != kind(b) ? kind(a) < kind(b) : a.line < b.line;
  };
  std::sort(lines_.begin(), lines_.end(), before);
}

void LatticeStrip::take(std::uint32_t number, std::span<ProfileInWork* const> profiles) {
  throw_if_stopped();
  place_ = number;
  const LatticeOrder::Place place = lattice_.order.place(number);
  const ShownOfPlace shown = shown_of(lattice_, place, pictures_.looked_at());
  if (silhouettes_) silhouettes_->find(place, shown, horizon_);
  find_profiles(place, shown, profiles);
  if (silhouettes_) found_ = silhouettes_->of(PlacePart::line);
  while (look_at_next(PlacePart::line)) take_looked_at();
  for (const PlacePart side : {PlacePart::outwards, PlacePart::backwards}) take_side(side);
  if (ridges_ && place.strip != LatticeOrder::Place::kNone) judge_folds(place);
}

void LatticeStrip::judge_folds(const LatticeOrder::Place& place) {
  const View& view = lattice_.view;
  const auto& [at_origin, per_u, per_v] = lattice_.strip;
  // Strips on this side of the eye are taken with rising numbers, or with falling ones.
  const bool rises = lattice_.order.strips_rise(place_);
  const double line = rises ? place.strip + 1 : place.strip;
  ridges_->judge_early(horizon_, [&](double x) {
    const double ahead = view.is_perspective() ? line - at_origin : line - at_origin - per_u * x,
                 per_depth =
                     view.is_perspective() ? per_u * x + per_v : per_v - per_u * view.x_per_v;
    // A ray that runs to the other side isn't told about.
    return (per_depth > 0) == rises && per_depth != 0 ? ahead / per_depth : kInfinity;
  });
}

void LatticeStrip::finish() {
  if (!ridges_) return;
  ridges_->judge(horizon_);
  const std::vector<LinePart> rest = ridges_->unjudged();
  parts_.insert(parts_.end(), rest.begin(), rest.end());
}

// Of the lines on the next edge in this part of the place, those that may be seen or hide anything;
// none if nothing is left.
std::optional<LatticeStrip::EdgeAtTurn> LatticeStrip::look_at_next(PlacePart part) {
  constexpr LatticeOrder::Turn kNone = std::numeric_limits<LatticeOrder::Turn>::max();
  const auto listed_turn = [&] {
    if (next_line_ == lines_.size()) return kNone;
    const LatticeOrder::Turn turn = lines_[next_line_].turn;
    const bool is_here =
        LatticeOrder::place_of(turn) == place_ && part_of(lattice_.order, turn) == part;
    return is_here ? turn : kNone;
  };
  const LatticeOrder::Turn no_sooner = listed_turn();
  looked_at_.clear();
  found_alone_ = nullptr;
  // Nearly always there is nothing but silhouettes.
  for (; !found_.empty() && found_.front().turn < no_sooner; found_ = found_.subspan(1)) {
    const PlaceSilhouettes::Found& found = found_.front();
    if (!look_at_alone(found)) continue;
    found_ = found_.subspan(1);
    return EdgeAtTurn{found.turn, found.edge};
  }
  if (no_sooner == kNone) return std::nullopt;
  const EdgeAtTurn at{no_sooner, pictures_.line(lines_[next_line_].line).edge};
  bool silhouette_drawn = false;
  if (!found_.empty() && found_.front().turn == at.turn) {
    silhouette_drawn = lattice_.work.draws_silhouettes;
    look_at(pictures_.add_found({at.edge, LineKind::silhouette, true, silhouette_drawn, false}),
            found_.front().picture);
    found_ = found_.subspan(1);
  }
  for (; listed_turn() == at.turn; ++next_line_) {
    const std::uint32_t number = lines_[next_line_].line;
    const EdgeLine& line = pictures_.line(number);
    // An edge of several kinds is drawn as the first.
    if (silhouette_drawn && !line.hides) continue;
    silhouette_drawn = silhouette_drawn || (line.kind == LineKind::silhouette && line.drawn);
    look_at(number, pictures_.picture(number, pictures_.whole(number)));
  }
  return at;
}

bool LatticeStrip::look_at_alone(const PlaceSilhouettes::Found& found) {
  const LinePicture& picture = found.picture;
  const Segment& s = picture.source;
  if (picture.is_upright()) {
    look_at(pictures_.add_found(
                {found.edge, LineKind::silhouette, true, lattice_.work.draws_silhouettes, false}),
            picture);
    if (looked_at_.empty()) pictures_.drop_last_found();
    return !looked_at_.empty();
  }
  const XRange looked_at = pictures_.looked_at();
  found_shown_ = {std::max(s.x0, looked_at.begin), std::min(s.x1, looked_at.end)};
  const auto [begin, end] = found_shown_;
  if (!(begin < end) ||
      is_below_blocks(horizon_, begin, end, std::max(height_at(s, begin), height_at(s, end))))
    return false;
  found_alone_ = &found;
  return true;
}

void LatticeStrip::look_at(std::uint32_t number, const LinePicture& picture) {
  if (std::max(picture.left.v, picture.right.v) <= pictures_.from_m()) return;
  SurfaceLine line = pictures_.surface_line(number, picture);
  line.source.id = source_id(number);
  if (!pictures_.cut_to_range(line)) return;
  if (line.upright() ? !line.drawn || pictures_.is_hidden(picture, horizon_)
                     : is_below_blocks(horizon_, line.begin, line.end,
                                       std::max(height_at(line.source, line.begin),
                                                height_at(line.source, line.end))))
    return;
  looked_at_.push_back({line, picture, number});
}

void LatticeStrip::take_looked_at() {
  if (found_alone_)
    take_alone();
  else
    take_group();
}

// It gets its number only if it is part of the picture.
void LatticeStrip::take_alone() {
  const auto& [turn, edge, picture] = *found_alone_;
  const bool drawn = lattice_.work.draws_silhouettes;
  const auto number = static_cast<std::uint32_t>(pictures_.size());
  HorizonPiece occluder{found_shown_.begin, found_shown_.end, picture.source, drawn};
  occluder.source.id = source_id(number);
  visible_.clear();
  const bool rises = drawn ? horizon_.raise(occluder, lattice_.work.tolerance, number, visible_)
                           : horizon_.raise(occluder);
  if (!rises && visible_.empty()) return;
  pictures_.add_found({edge, LineKind::silhouette, true, drawn, false});
  if (!visible_.empty()) add_visible(number, picture, found_shown_);
}

// All lines of an edge are compared before any of them hides.
void LatticeStrip::take_group() {
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
    if (!visible_.empty())
      add_visible(number, picture,
                  line.upright() ? XRange{line.source.x0, line.source.x1}
                                 : XRange{line.begin, line.end});
  }
  for (const LookedAt& at : looked_at_)
    if (raises(at.line)) horizon_.raise(occluder_of(at.line));
}

// Of line number `number` what is in `visible_`; the line is shown in a range of X.
void LatticeStrip::add_visible(std::uint32_t number, const LinePicture& picture, XRange shown) {
  const std::size_t before = parts_.size();
  for (const auto& [same, t_begin, t_end] : visible_)
    pictures_.add_part(number, picture, t_begin, t_end, parts_);
  // What the strips beside this one look at as well is judged as a whole.
  if (ridges_ && is_found(number) && shown.begin > inner_range_.begin &&
      shown.end < inner_range_.end)
    ridges_->take(picture, visible_, parts_, before);
}

void LatticeStrip::find_profiles(const LatticeOrder::Place& place, const ShownOfPlace& shown,
                                 std::span<ProfileInWork* const> profiles) {
  outwards_.clear();
  backwards_.clear();
  if (shown.empty()) return;
  auto at = std::partition_point(profiles.begin(), profiles.end(), [&](const ProfileInWork* p) {
    return p->planned.depth_m < shown.nearest_m;
  });
  for (; at != profiles.end() && (*at)->planned.depth_m <= shown.farthest_m; ++at)
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
  if (silhouettes_) found_ = silhouettes_->of(part);
  while (const auto next = look_at_next(part)) {
    const std::uint32_t from = next->edge.from;
    const auto column = static_cast<int>(from % columns), row = static_cast<int>(from / columns);
    const int cell = lattice_.order.rows_are_strips() ? column : row;
    // What lies on the edge itself is taken before that hides.
    take_up_to((!back                                  ? cell
                : LatticeOrder::is_upright(next->turn) ? -cell
                                                       : -(cell + 1)) +
               lattice_.rounding);
    if (LatticeOrder::is_diagonal(next->turn))
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
