// SPDX-License-Identifier: GPL-3.0-or-later
#include "hidden_lines/sector_in_work.hpp"

#include "profiles/profile.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace orograph {
namespace {

// Where a profile crosses what hides, rounding may leave a slit: a share of a span, far below the
// page's step.
constexpr double kSlit = 1e-9;

// Whether nothing is between a run's end and the next one's begin.
bool meet(const ProfileInWork& work, const VisibleRun& a, const VisibleRun& b) {
  if (a.last == b.first) return b.t_begin <= a.t_end + kSlit;
  if (a.t_end < 1 - kSlit || b.t_begin > kSlit) return false;
  // Between the two spans are at most some without any extent in X.
  for (std::uint32_t i = a.last + 1; i < b.first; ++i)
    if (work.profile.after[i] == Span::gap || work.profile.after[i] == Span::wall ||
        work.projected.x[i] < work.projected.x[i + 1])
      return false;
  return true;
}

} // namespace

namespace {

void join(const ProfileInWork& work, const std::vector<std::vector<VisibleRun>>& by_strip,
          std::vector<VisibleRun>& visible) {
  visible.clear();
  for (const std::vector<VisibleRun>& runs : by_strip)
    visible.insert(visible.end(), runs.begin(), runs.end());
  const auto in_order = [](const VisibleRun& a, const VisibleRun& b) {
    return a.first != b.first ? a.first < b.first : a.t_begin < b.t_begin;
  };
  if (!std::is_sorted(visible.begin(), visible.end(), in_order))
    std::sort(visible.begin(), visible.end(), in_order);
  std::size_t count = 0;
  for (const VisibleRun& run : visible) {
    if (count > 0 && meet(work, visible[count - 1], run)) {
      visible[count - 1].last = run.last;
      visible[count - 1].t_end = run.t_end;
    } else {
      visible[count++] = run;
    }
  }
  visible.resize(count);
}

void add_pieces(const std::vector<Segment>& segments, const std::vector<VisibleRun>& runs,
                std::vector<Piece>& out) {
  auto segment = segments.begin();
  for (const VisibleRun& run : runs) {
    segment = std::partition_point(segment, segments.end(),
                                   [&](const Segment& s) { return left_vertex(s) < run.first; });
    for (; segment != segments.end() && left_vertex(*segment) <= run.last; ++segment) {
      const std::uint32_t span = left_vertex(*segment);
      const double begin = span == run.first ? run.t_begin : 0,
                   end = span == run.last ? run.t_end : 1;
      const auto x_at = [&](double t) {
        return t >= 1 ? segment->x1 : segment->x0 + t * (segment->x1 - segment->x0);
      };
      out.push_back({static_cast<std::uint32_t>(segment - segments.begin()), x_at(begin), x_at(end),
                     begin, end});
      if (span == run.last) break; // the next run may begin on the same segment
    }
  }
}

} // namespace

SpansByStrip spans_by_strip(Profile& profile, const EarthStrips& strips) {
  SpansByStrip out;
  out.cells = std::move(profile.triangles);
  profile.triangles.clear();
  int strip_before = -1;
  for (std::size_t i = 0; i < out.cells.size(); ++i) {
    const std::uint32_t triangle = out.cells[i];
    if (profile.after[i] == Span::gap) {
      strip_before = -1;
      continue;
    }
    const auto [strip, cell] = strips.cell_of(triangle);
    out.cells[i] = 2 * static_cast<std::uint32_t>(cell) + triangle % 2;
    const auto span = static_cast<std::uint32_t>(i);
    if (strip != strip_before) out.runs.push_back({strip, span, span});
    out.runs.back().end = span + 1;
    strip_before = strip;
  }
  const auto by_strip = [](const SpansByStrip::Run& a, const SpansByStrip::Run& b) {
    return a.strip != b.strip ? a.strip < b.strip : a.first < b.first;
  };
  if (!std::ranges::is_sorted(out.runs, by_strip)) std::ranges::sort(out.runs, by_strip);
  return out;
}

void join_strips(ProfileInWork& work) {
  join(work, work.by_strip, work.visible);
  join(work, work.underside_by_strip, work.underside);
}

PiecesOfProfile pieces_of(const ProfileInWork& work, const View& view) {
  PiecesOfProfile out;
  std::vector<Segment> wide, uprights;
  project_profile(work.profile, static_cast<std::uint32_t>(work.planned.number), view, wide,
                  uprights);
  std::merge(wide.begin(), wide.end(), uprights.begin(), uprights.end(),
             std::back_inserter(out.segments),
             [](const Segment& a, const Segment& b) { return a.id < b.id; });
  add_pieces(out.segments, work.visible, out.visible);
  add_pieces(out.segments, work.underside, out.underside);
  return out;
}

std::vector<Segment> near_cut(const SectorInWork& work) {
  const View& view = work.sector.view;
  std::vector<Segment> segments, uprights;
  if (!view.is_perspective()) return segments;
  constexpr std::uint32_t kNumber = 0x7fffffff; // no profile has it
  Profile cut;
  work.cutter.cut(view.near_m, cut);
  project_profile(cut, kNumber, view, segments, uprights);
  return segments;
}

} // namespace orograph
