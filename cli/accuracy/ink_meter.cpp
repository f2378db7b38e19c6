// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/accuracy/ink_meter.hpp"

#include "dem/height_at.hpp"
#include "placing/sector.hpp"
#include "profiles/profile.hpp"

#include <algorithm>
#include <cmath>

namespace orograph {

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
    at.z = *height * sector.view.exaggeration;
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
  const auto& [sector, clipped, lines, visible] = seen;
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

} // namespace orograph
