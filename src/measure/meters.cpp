// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/meters.hpp"

#include "dem/height_at.hpp"
#include "placing/sector.hpp"
#include "profiles/profile.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace orograph {
namespace {

constexpr std::size_t kNone = static_cast<std::size_t>(-1);
// The search begins here: the promised accuracy of ends.
constexpr double kNearest_mm = 1e-9;

} // namespace

double InkSample::error() const {
  return visible == 0 ? 0 : static_cast<double>(hidden + missing) / static_cast<double>(visible);
}

// Of a ratio of sums over points: wrong, w, over visible, v. Each point differs from the ratio e by
// w - e v: by 1 where it is drawn but hidden, by 1 - e where missing, by -e where rightly drawn.
double InkSample::standard_error() const {
  if (visible == 0) return 0;
  const double e = error(), v = static_cast<double>(visible);
  const auto h = static_cast<double>(hidden), m = static_cast<double>(missing);
  return std::sqrt(h + m * (1 - e) * (1 - e) + (v - m) * e * e) / v;
}

double InkSample::smallest_seen() const {
  return visible == 0 ? 1 : 3 / static_cast<double>(visible); // 0.05 is about exp(-3)
}

InkSample operator+(const InkSample& a, const InkSample& b) {
  return {a.asked + b.asked,   a.ties + b.ties,       a.visible + b.visible,
          a.hidden + b.hidden, a.missing + b.missing, a.length_mm + b.length_mm};
}

InkMeter::InkMeter(const Surface& surface, const PlacedView& scene, const MapSpec& spec,
                   double stride_mm, const Surface* full_heights)
    : scene_(scene), full_(full_heights), draws_level_(spec.style.flat == FlatGround::draw),
      judges_(judges_of(full_ ? *full_ : surface, scene, spec.style.visibility_tolerance_mm)),
      stride_mm_(stride_mm), to_next_mm_(stride_mm * share()),
      rest_of_stride_mm_(stride_mm_ - to_next_mm_) {}

double InkMeter::share() {
  return static_cast<double>(engine_() >> 11U) * 0x1p-53;
}

void InkMeter::judge(const Sector& sector, const ProfileLine& line, double t, bool on_edge,
                     bool drawn, InkSample& sample) {
  Verdict verdict = Verdict::tied;
  if (full_) {
    ProfilePoint at = point_between(line.from, line.to, t);
    const Vec3 ground = to_ground_m(sector.view, at);
    const auto height = height_at(*full_, {ground.x, ground.y});
    if (!height) return; // the overview's border isn't the full heights'
    const Vec2 as_drawn = page_mm(at, sector.view, sector.to_page);
    at.z = *height * sector.view.exaggeration - sector.view.drop.at(at.u, at.v);
    if (drawn)
      farthest_mm_ =
          std::max(farthest_mm_, length(page_mm(at, sector.view, sector.to_page) - as_drawn));
    verdict = judge_of(sector).verdict(at, on_edge);
  } else {
    verdict = judge_of(sector).verdict(line, t, on_edge, drawn);
  }
  ++sample.asked;
  if (verdict == Verdict::tied) ++sample.ties;
  // What is tied counts as drawn rightly, if it is drawn.
  const bool visible = verdict == Verdict::tied ? drawn : verdict == Verdict::visible;
  if (visible) ++sample.visible;
  if (drawn && !visible) ++sample.hidden;
  if (visible && !drawn) ++sample.missing;
}

template <class IsDrawn>
void InkMeter::ask(const Sector& sector, const ProfileLine& line, bool on_edge,
                   const IsDrawn& is_drawn, InkSample& sample) {
  const auto on_page = LineOnPage::of(line, sector.view, sector.to_page, scene_.frame_mm);
  if (!on_page) return;
  sample.length_mm += on_page->length_mm();
  if (!std::isfinite(stride_mm_)) return;
  double place = to_next_mm_;
  while (place < on_page->length_mm()) {
    const double t = on_page->share_at(place);
    judge(sector, line, t, on_edge, is_drawn(t), sample);
    const double within = share() * stride_mm_;
    place += rest_of_stride_mm_ + within;
    rest_of_stride_mm_ = stride_mm_ - within;
  }
  to_next_mm_ = place - on_page->length_mm();
}

void InkMeter::see(const SeenProfile& seen) {
  const auto& [sector, clipped, profile, segments, visible] = seen;
  const auto at = [&](std::uint32_t vertex) {
    return ProfilePoint{profile.u_m[vertex], profile.depth_m, profile.z_m[vertex]};
  };
  auto first = visible.begin();
  for (std::uint32_t i = 0; i < segments.size(); ++i) {
    const std::uint32_t left = left_vertex(segments[i]);
    if (profile.after[left] == Span::level && !draws_level_) continue; // left out on purpose
    while (first != visible.end() && first->segment < i) ++first;
    const auto is_drawn = [&](double t) {
      for (auto piece = first; piece != visible.end() && piece->segment == i; ++piece)
        if (piece->t_begin <= t && t <= piece->t_end) return true;
      return false;
    };
    ask(sector, {at(left), at(left + 1)}, profile.after[left] == Span::wall, is_drawn, profiles_);
  }
}

void InkMeter::see(const SeenLines& seen) {
  const auto& [sector, clipped, lines, visible, listed] = seen;
  if (full_) return;
  const View& view = sector.view;
  auto first = visible.begin();
  for (std::uint32_t i = 0; i < lines.size(); ++i) {
    if (!lines.line(i).drawn) continue;
    ProfileLine line = lines.whole(i);
    // What is in front of the near plane is cut away; shares then are of the rest.
    double from = 0, to = 1;
    if (view.is_perspective()) {
      if (std::max(line.from.v, line.to.v) <= view.near_m) continue;
      const double cut = (view.near_m - line.from.v) / (line.to.v - line.from.v);
      if (line.from.v < view.near_m) from = cut;
      if (line.to.v < view.near_m) to = cut;
    }
    while (first != visible.end() && first->line < i) ++first;
    const auto is_drawn = [&](double share) {
      const double t = from + share * (to - from);
      for (auto part = first; part != visible.end() && part->line == i; ++part)
        if (part->t_begin <= t && t <= part->t_end) return true;
      return false;
    };
    ask(sector, {point_between(line.from, line.to, from), point_between(line.from, line.to, to)},
        true, is_drawn, lines_);
  }
}

EndMeter::EndMeter(const Surface& surface, const PlacedView& scene, const MapSpec& spec,
                   Wanted wanted)
    : scene_(scene), tolerance_mm_(spec.style.visibility_tolerance_mm),
      draws_level_(spec.style.flat == FlatGround::draw),
      judges_(judges_of(surface, scene, spec.style.visibility_tolerance_mm)), wanted_(wanted) {}

// The profile as runs of connected stretches on the page, and which segment is which stretch.
void EndMeter::trace(const Profile& profile, const std::vector<Segment>& segments) {
  path_.clear();
  stretch_of_.assign(segments.size(), kNone);
  const auto point = [&](std::uint32_t vertex) {
    return ProfilePoint{profile.u_m[vertex], profile.depth_m, profile.z_m[vertex]};
  };
  std::uint32_t last_vertex = 0;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const std::uint32_t left = left_vertex(segments[i]);
    if (profile.after[left] == Span::level && !draws_level_) continue;
    const ProfileLine line{point(left), point(left + 1)};
    const auto picture = LineOnPage::of(line, sector_->view, sector_->to_page, scene_.frame_mm);
    if (!picture) continue;
    const std::size_t number = path_.size();
    const bool goes_on = number > 0 && last_vertex == left;
    stretch_of_[i] = number;
    path_.push_back({line, *picture,
                     goes_on ? path_.back().start_mm + path_.back().picture.length_mm() : 0,
                     goes_on ? path_.back().run_begin : number, 0});
    last_vertex = left + 1;
  }
  for (std::size_t i = path_.size(); i-- > 0;)
    path_[i].run_end = i + 1 < path_.size() && path_[i + 1].run_begin == path_[i].run_begin
                           ? path_[i + 1].run_end
                           : i + 1;
}

// An end where the path ends too tells nothing.
void EndMeter::add_end(std::size_t stretch, double t, double forward) {
  const Stretch& s = path_[stretch];
  const double mm = s.picture.mm_at(t);
  constexpr double kRounding_mm = 1e-6;
  if (mm < -kRounding_mm || mm > s.picture.length_mm() + kRounding_mm) return; // off the page
  const double at_mm = s.start_mm + mm;
  const Stretch& last = path_[s.run_end - 1];
  if (at_mm < kRounding_mm || at_mm > last.start_mm + last.picture.length_mm() - kRounding_mm)
    return;
  found_.push_back({stretch, at_mm, forward});
}

ProfilePoint EndMeter::at(const Stretch& of_run, double mm) const {
  const auto begin = path_.begin() + static_cast<std::ptrdiff_t>(of_run.run_begin);
  const auto end = path_.begin() + static_cast<std::ptrdiff_t>(of_run.run_end);
  auto next = std::partition_point(begin, end, [&](const Stretch& s) { return s.start_mm <= mm; });
  const Stretch& s = next == begin ? *begin : *std::prev(next);
  return point_between(s.line.from, s.line.to, s.picture.share_at(mm - s.start_mm));
}

double EndMeter::above_mm(ProfilePoint p, bool on_edge) const {
  return judges_[sector_->behind ? 1 : 0].above(p, on_edge) *
         sector_->to_page.mm_per_y(project(sector_->view, p));
}

void EndMeter::measure(const End& end, bool on_edge) {
  const Stretch& stretch = path_[end.stretch];
  const Stretch& last = path_[stretch.run_end - 1];
  const double length_mm = last.start_mm + last.picture.length_mm();
  const auto above = [&](double mm) { return above_mm(at(stretch, mm), on_edge); };
  ++ends_.asked;

  // Farther and farther to both sides, the first step from hidden to visible in the sense of the
  // drawn piece.
  const auto place = [&](double mm) { return std::clamp(mm, 0.0, length_mm); };
  struct Place {
    double mm;
    bool visible;
  };
  const auto look = [&](double from_end_mm) {
    const double mm = place(end.at_mm + end.forward * from_end_mm);
    return Place{mm, above(mm) > 0};
  };
  Place back = look(-kNearest_mm), on = look(kNearest_mm);
  std::optional<std::pair<Place, Place>> step; // hidden, visible
  if (!back.visible && on.visible) step = {back, on};
  for (double reach = 2 * kNearest_mm; reach <= kFarthestEnd_mm && !step; reach *= 2) {
    const Place farther_back = look(-reach), farther_on = look(reach);
    if (!farther_back.visible && back.visible) step = {farther_back, back};
    if (!on.visible && farther_on.visible) step = {on, farther_on};
    back = farther_back;
    on = farther_on;
  }
  std::optional<double> displacement;
  if (step) {
    double hidden = step->first.mm, visible = step->second.mm;
    for (int i = 0; i < 60 && std::abs(visible - hidden) > 1e-13; ++i) {
      const double middle = 0.5 * (visible + hidden);
      (above(middle) > 0 ? visible : hidden) = middle;
    }
    const double along = std::abs(visible - end.at_mm);
    double across = 0;
    constexpr int kParts = 8;
    for (int i = 0; i <= kParts; ++i)
      across = std::max(across, std::abs(above(end.at_mm + (visible - end.at_mm) * i / kParts)));
    displacement = std::min(along, across);
  }
  // A stretch that is tied with what is in front is left out where that is drawn: it has ends, but
  // the ray walk may see it a little above.
  const bool tied = std::min(std::abs(above(end.at_mm - kNearest_mm)),
                             std::abs(above(end.at_mm + kNearest_mm))) <= tolerance_mm_;
  if (displacement && (!tied || *displacement <= tolerance_mm_))
    ends_.largest_mm = std::max(ends_.largest_mm, *displacement);
  else
    ++(tied ? ends_.tied : ends_.astray);
}

void EndMeter::measure_some(std::uint64_t count, bool on_edge) {
  for (std::uint64_t i = 0; i < count && !found_.empty(); ++i) {
    std::swap(found_[engine_() % found_.size()], found_.back());
    measure(found_.back(), on_edge);
    found_.pop_back();
  }
}

void EndMeter::see(const SeenProfile& seen) {
  const auto& [sector, clipped, profile, segments, visible] = seen;
  sector_ = &sector;
  trace(profile, segments);
  found_.clear();
  for (std::size_t i = 0; i < visible.size(); ++i) {
    const Piece& piece = visible[i];
    const std::size_t stretch = stretch_of_[piece.segment];
    if (stretch == kNone) continue;
    // Pieces of neighbouring segments that meet at their vertex don't end there.
    const auto meet = [](const Piece& a, const Piece& b) {
      return a.t_end >= 1 && b.t_begin <= 0 && a.segment + 1 == b.segment;
    };
    if (i == 0 || !meet(visible[i - 1], piece)) add_end(stretch, piece.t_begin, 1);
    if (i + 1 == visible.size() || !meet(piece, visible[i + 1])) add_end(stretch, piece.t_end, -1);
  }
  measure_some(wanted_.of_profile, false);
}

void EndMeter::see(const SeenLines& seen) {
  const auto& [sector, clipped, lines, visible, listed] = seen;
  sector_ = &sector;
  path_.clear();
  found_.clear();
  std::uint32_t last_line = 0;
  for (const LinePart& part : visible) {
    if (part.t_begin <= 0 && part.t_end >= 1) continue;
    const ProfileLine line = lines.whole(part.line);
    if (sector.view.is_perspective() && std::min(line.from.v, line.to.v) <= sector.view.near_m)
      continue;
    const auto picture = LineOnPage::of(line, sector_->view, sector_->to_page, scene_.frame_mm);
    if (!picture) continue;
    if (path_.empty() || last_line != part.line)
      path_.push_back({line, *picture, 0, path_.size(), path_.size() + 1});
    last_line = part.line;
    if (part.t_begin > 0) add_end(path_.size() - 1, part.t_begin, 1);
    if (part.t_end < 1) add_end(path_.size() - 1, part.t_end, -1);
  }
  measure_some(wanted_.of_lines, true);
}

} // namespace orograph
