// SPDX-License-Identifier: GPL-3.0-or-later
#include "hidden_lines/lattice_lines.hpp"

#include "geometry/on_all_cores.hpp"
#include "geometry/sort_by_number.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace orograph {
namespace {

constexpr LatticeOrder::Turn kNoTurn = std::numeric_limits<LatticeOrder::Turn>::max();

} // namespace

LatticeLines::LatticeLines(const LatticeInWork& lattice, XRange range,
                           std::span<const LineAtDepth> which, LinePictures& pictures,
                           BlockedHorizon& horizon)
    : lattice_(lattice), inner_range_(range), pictures_(pictures), horizon_(horizon),
      uprights_(lattice.grid, lattice.view, lattice.work.from_m) {
  const XRange looked_at = pictures_.looked_at();
  if (!std::isinf(range.begin)) inner_range_.begin += range.begin - looked_at.begin;
  if (!std::isinf(range.end)) inner_range_.end -= looked_at.end - range.end;
  if (lattice.work.silhouettes) {
    silhouettes_.emplace(lattice, *lattice.work.silhouettes, pictures_);
    if (lattice.work.folds) {
      const bool whole = lattice.work.placed.extent.valid == lattice.grid.size();
      ridges_.emplace(*lattice.work.folds, pictures_, whole);
    }
  }
  if (!lattice.work.contour_levels_m.empty())
    contours_.emplace(lattice, lattice.work.contour_levels_m, inner_range_, pictures_, horizon_,
                      uprights_);
  order_lines(which);
  parts_.reserve(which.size()); // mostly one of a line; what isn't used costs nothing
}

// Into the order of their turns.
void LatticeLines::order_lines(std::span<const LineAtDepth> which) {
  const auto add = [&](std::uint32_t line) {
    throw_if_stopped(lines_.size());
    lines_.push_back({lattice_.turn_of(pictures_, line), line});
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
  const auto before = [&](const LineAtTurn& a, const LineAtTurn& b) {
    const auto kind = [&](const LineAtTurn& at) { return pictures_.line(at.line).kind; };
    return kind(a) != kind(b) ? kind(a) < kind(b) : a.line < b.line;
  };
  sort_by_number_then(
      lines_, [](const LineAtTurn& at) { return at.turn; }, before);
}

void LatticeLines::begin_place(std::uint32_t place, const ShownOfPlace& shown) {
  place_ = place;
  taken_to_m_ = shown.farthest_m;
  if (silhouettes_) silhouettes_->find(lattice_.order.place(place), shown, horizon_);
  if (contours_) contours_->begin_place(lattice_.order.place(place), shown);
}

void LatticeLines::begin_part(PlacePart part) {
  part_ = part;
  if (silhouettes_) found_ = silhouettes_->of(part);
  if (contours_) contours_->begin_part(part);
}

void LatticeLines::end_place() {
  const LatticeOrder::Place place = lattice_.order.place(place_);
  if (!ridges_ || place.strip == LatticeOrder::Place::kNone) return;
  if (lattice_.order.earth()) {
    ridges_->judge_early(horizon_, [&](double) { return taken_to_m_; });
    return;
  }
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
    return (per_depth > 0) == rises && per_depth != 0 ? ahead / per_depth
                                                      : std::numeric_limits<double>::infinity();
  });
}

void LatticeLines::finish() {
  if (contours_) contours_->finish();
  if (!ridges_) return;
  ridges_->judge(horizon_);
  const std::vector<LinePart> rest = ridges_->unjudged();
  parts_.insert(parts_.end(), rest.begin(), rest.end());
}

// Contours hide nothing: all of them up to that edge are compared before it rises.
std::optional<LatticeLines::EdgeAtTurn> LatticeLines::next() {
  const std::optional<EdgeAtTurn> edge = next_edge();
  if (contours_) contours_->take(edge ? edge->turn : kNoTurn);
  return edge;
}

// Of the lines on the next edge in this part of the place, those that may be seen or hide anything;
// none if nothing is left.
std::optional<LatticeLines::EdgeAtTurn> LatticeLines::next_edge() {
  const auto listed_turn = [&] {
    if (next_line_ == lines_.size()) return kNoTurn;
    const LatticeOrder::Turn turn = lines_[next_line_].turn;
    const bool is_here =
        LatticeOrder::place_of(turn) == place_ && part_of(lattice_.order, turn) == part_;
    return is_here ? turn : kNoTurn;
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
  if (no_sooner == kNoTurn) return std::nullopt;
  const EdgeAtTurn at{no_sooner, pictures_.line(lines_[next_line_].line).edge};
  bool silhouette_drawn = false;
  if (!found_.empty() && found_.front().turn == at.turn) {
    silhouette_drawn = lattice_.work.draws_silhouettes;
    look_at(pictures_.add_found({at.edge, LineKind::silhouette, true, silhouette_drawn, false}),
            found_.front().picture);
    found_ = found_.subspan(1);
  }
  for (; listed_turn() == at.turn; ++next_line_) {
    // By turns lines are all over the memory: waiting for them was a tenth of the time.
    constexpr std::size_t kLineAhead = 16, kPointsAhead = 8;
    if (next_line_ + kLineAhead < lines_.size())
      pictures_.fetch(lines_[next_line_ + kLineAhead].line);
    if (next_line_ + kPointsAhead < lines_.size())
      pictures_.fetch_points(lines_[next_line_ + kPointsAhead].line);
    const std::uint32_t number = lines_[next_line_].line;
    const EdgeLine& line = pictures_.line(number);
    // An edge of several kinds is drawn as the first; lines on the ground are themselves.
    if (silhouette_drawn && !line.hides && !is_on_ground(line.kind)) continue;
    silhouette_drawn = silhouette_drawn || (line.kind == LineKind::silhouette && line.drawn);
    look_at(number, pictures_.picture(number, pictures_.whole(number)));
  }
  return at;
}

bool LatticeLines::look_at_alone(const PlaceSilhouettes::Found& found) {
  const LinePicture& picture = found.picture;
  const Segment& s = picture.source;
  if (picture.is_upright()) {
    const std::uint32_t number = pictures_.add_found(
        {found.edge, LineKind::silhouette, true, lattice_.work.draws_silhouettes, false});
    look_at(number, picture);
    if (looked_at_.empty()) pictures_.drop_found(number);
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

void LatticeLines::look_at(std::uint32_t number, const LinePicture& picture) {
  if (std::max(picture.left.v, picture.right.v) <= pictures_.from_m()) return;
  SurfaceLine line = pictures_.surface_line(number, picture);
  line.source.id = source_id(number);
  if (!pictures_.cut_to_range(line)) return;
  if (line.upright()) {
    if (!line.drawn || pictures_.is_hidden(picture, horizon_)) return;
  } else {
    const auto [low, high] =
        std::minmax({height_at(line.source, line.begin), height_at(line.source, line.end)});
    if (is_below_blocks(horizon_, line.begin, line.end, high)) return;
    if (is_whole_on_ground(number, picture, line) &&
        horizon_.is_all_below(low, line.begin, line.end, lattice_.work.tolerance) &&
        lattice_.work.marks_whole({number, 0, 1}))
      return;
  }
  looked_at_.push_back({line, picture, number});
}

void LatticeLines::take() {
  if (found_alone_)
    take_alone();
  else
    take_group();
}

// Whether a line on the ground is shown from end to end.
bool LatticeLines::is_whole_on_ground(std::uint32_t number, const LinePicture& picture,
                                      const SurfaceLine& line) const {
  return !line.hides && is_on_ground(pictures_.line(number).kind) && line.begin == line.source.x0 &&
         line.end == line.source.x1 && std::min(picture.t_left, picture.t_right) <= 0 &&
         std::max(picture.t_left, picture.t_right) >= 1 &&
         std::min(picture.left.v, picture.right.v) >= lattice_.view.drawn_from_m;
}

// It gets its number only if it is part of the picture.
void LatticeLines::take_alone() {
  const auto& [turn, edge, picture] = *found_alone_;
  const bool drawn = lattice_.work.draws_silhouettes;
  const std::uint32_t number = pictures_.next_found();
  HorizonPiece occluder{found_shown_.begin, found_shown_.end, picture.source, drawn};
  occluder.source.id = source_id(number);
  visible_.clear();
  BlockedHorizon::Raised raised;
  if (drawn)
    raised = horizon_.raise(occluder, lattice_.work.tolerance, number, visible_);
  else
    raised.rises = horizon_.raise(occluder);
  if (!raised.rises && visible_.empty()) return;
  pictures_.add_found({edge, LineKind::silhouette, true, drawn, false});
  if (!visible_.empty()) add_visible(number, picture, found_shown_, !raised.is_tied);
}

// All lines of an edge are compared before any of them hides.
void LatticeLines::take_group() {
  for (const auto& [line, picture, number] : looked_at_) {
    if (!line.drawn) continue;
    visible_.clear();
    if (line.upright())
      add_above_height(line, number,
                       pictures_.is_edge(number)
                           ? uprights_.in_front(pictures_.line(number).edge,
                                                picture.t_left < picture.t_right, line, horizon_)
                           : height_in_front(line, horizon_),
                       visible_);
    else
      add_above_horizon(line, number, horizon_, lattice_.work.tolerance, visible_);
    if (!visible_.empty())
      add_visible(number, picture,
                  line.upright() ? XRange{line.source.x0, line.source.x1}
                                 : XRange{line.begin, line.end},
                  false);
  }
  for (const LookedAt& at : looked_at_)
    if (raises(at.line)) horizon_.raise(occluder_of(at.line));
}

// Of line number `number` what is in `visible_`; the line is shown in a range of X. `stands`: all
// of that is part of the horizon.
void LatticeLines::add_visible(std::uint32_t number, const LinePicture& picture, XRange shown,
                               bool stands) {
  const std::size_t before = parts_.size();
  for (const auto& [same, t_begin, t_end] : visible_)
    pictures_.add_seen(number, picture, t_begin, t_end, parts_);
  if (parts_.size() == before + 1 && lattice_.work.marks_whole(parts_.back())) parts_.pop_back();
  // What the strips beside this one look at as well is judged as a whole.
  if (ridges_ && is_found(number) && shown.begin > inner_range_.begin &&
      shown.end < inner_range_.end)
    ridges_->take(picture, visible_, stands, parts_, before);
}

} // namespace orograph
