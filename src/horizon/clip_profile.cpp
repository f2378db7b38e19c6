// SPDX-License-Identifier: GPL-3.0-or-later
#include "horizon/clip_profile.hpp"

#include "horizon/blocked_horizon.hpp"
#include "horizon/clip_step.hpp"
#include "horizon/horizon.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace orograph {
namespace {

Segment span_of(const ProjectedProfile& profile, std::uint32_t i) {
  return {profile.x[i], profile.y[i], profile.x[i + 1], profile.y[i + 1], i};
}

// Joins visible stretches that meet. Ends along a span cost a division, so they are reckoned only
// where a stretch isn't joined to the next one.
class VisibleEnds {
public:
  VisibleEnds(const ProjectedProfile& profile, std::vector<VisibleRun>& out)
      : profile_(profile), out_(out) {}

  struct End {
    std::uint32_t span;
    double x;
    double t; ///< NaN: as x tells
  };
  void take(const End& begin, const End& end) {
    if (!open_ || begin.x != end_.x) {
      finish();
      begin_ = begin;
      open_ = true;
    }
    end_ = end;
  }
  void finish() {
    if (open_) out_.push_back({begin_.span, end_.span, t_of(begin_), t_of(end_)});
    open_ = false;
  }

private:
  double t_of(const End& end) const {
    return std::isnan(end.t) ? parameter_at(span_of(profile_, end.span), end.x) : end.t;
  }

  const ProjectedProfile& profile_;
  std::vector<VisibleRun>& out_;
  bool open_ = false;
  End begin_{}, end_{};
};

constexpr double kAsXTells = std::numeric_limits<double>::quiet_NaN();

class RunClip {
public:
  RunClip(const ProjectedProfile& profile, BlockedHorizon& horizon, const TieTolerance& tolerance,
          bool is_drawn, std::vector<VisibleRun>& visible, ProfileClipCounts& counts)
      : profile_(profile), horizon_(horizon), tolerance_(tolerance), is_drawn_(is_drawn),
        ends_(profile, visible), counts_(counts) {}

  void clip(const VertexRun& run, XRange range) {
    const double* x = profile_.x.data();
    const double* y = profile_.y.data();
    const double end = std::min(range.end, x[run.last]);
    double begin = std::max(range.begin, x[run.first]);
    if (!(begin < end)) return;
    // The span that begins at or before `begin` and ends behind it.
    auto span =
        static_cast<std::uint32_t>(std::upper_bound(x + run.first, x + run.last, begin) - x - 1);
    for (std::size_t block = horizon_.block_at(begin); begin < end; ++block) {
      const HorizonBlock& part = horizon_.blocks()[block];
      const double stop = std::min(end, part.x_end);
      double low = y[span], high = low;
      std::uint32_t next = span;
      do {
        ++next;
        low = std::min(low, y[next]);
        high = std::max(high, y[next]);
      } while (x[next] < stop);
      // What is tied is nearer than this, and rounding far less.
      const double slack = tolerance_.greatest_y + 1e-12 * (std::abs(low) + std::abs(high));
      if (low > part.high + slack)
        ends_.take({span, begin, kAsXTells}, {next - 1, stop, kAsXTells});
      else if (!(high < part.low - slack))
        clip_spans(span, begin, stop, block);
      begin = stop;
      span = x[next] > stop ? next - 1 : next;
      while (span < run.last && x[span + 1] <= begin) ++span;
    }
    ends_.finish();
  }

private:
  // Spans and the pieces of one block side by side, up to the next end of either: one loop, whose
  // branches are foreseen where a stretch stays above or below.
  void clip_spans(std::uint32_t span, double begin, double stop, std::size_t block) {
    const double* x = profile_.x.data();
    const HorizonPiece* piece = horizon_.blocks()[block].pieces.data();
    const HorizonPiece* const first = piece;
    while (piece->x_end <= begin) ++piece;
    marks_.clear();
    while (begin < stop) {
      const double span_end = x[span + 1];
      const double end = std::min(std::min(stop, span_end), piece->x_end);
      if (begin < end) {
        const int side = clear_side(span_at(span), *piece, begin, end);
        if (side > 0)
          ends_.take({span, begin, kAsXTells}, {span, end, kAsXTells});
        else if (side == 0)
          resolve_part(span, *piece, static_cast<std::size_t>(piece - first), begin, end);
        begin = end;
      }
      span += span_end <= end ? 1 : 0;
      piece += piece->x_end <= end ? 1 : 0;
    }
    for (auto mark = marks_.rbegin(); mark != marks_.rend(); ++mark)
      horizon_.ink(block, mark->at, mark->begin, mark->end);
  }

  // Of a span against a block's piece number `at`.
  void resolve_part(std::uint32_t span, const HorizonPiece& piece, std::size_t at, double begin,
                    double end) {
    const Segment source = span_of(profile_, span);
    const Step step = resolve(source, piece, begin, end, false, tolerance_);
    ++counts_.steps;
    counts_.ties += step.tied ? 1 : 0;
    for (int i = 0; i < step.count; ++i) {
      const Stretch& s = step.stretches[static_cast<std::size_t>(i)];
      if (!s.above) continue;
      ends_.take(
          {span, s.x_begin, s.begins_at_crossing && s.x_begin != source.x0 ? step.t : kAsXTells},
          {span, s.x_end, s.ends_at_crossing && s.x_end != source.x1 ? step.t : kAsXTells});
      if (step.tied && is_drawn_ && !piece.inked) marks_.push_back({at, s.x_begin, s.x_end});
    }
  }

  struct Span {
    double x0, y0, x1, y1;
  };
  Span span_at(std::uint32_t i) const {
    return {profile_.x[i], profile_.y[i], profile_.x[i + 1], profile_.y[i + 1]};
  }
  // Whether all of p from begin to end is above the piece (1) or below it (-1) by more than any tie
  // or rounding; 0 where `resolve` has to tell. Without its divisions.
  int clear_side(const Span& p, const HorizonPiece& piece, double begin, double end) const {
    if (is_sky(piece)) return 1;
    const Segment& s = piece.source;
    const double width = p.x1 - p.x0;
    const auto above = [&](double x) {
      return p.y0 * (p.x1 - x) + p.y1 * (x - p.x0) - (s.y0 + (x - s.x0) * s.slope) * width;
    };
    const double at_begin = above(begin), at_end = above(end);
    const double slack = (tolerance_.greatest_y + 1e-11 * (std::abs(p.y0) + std::abs(p.y1) +
                                                           std::abs(s.y0) + std::abs(s.y1))) *
                         width;
    if (at_begin > slack && at_end > slack) return 1;
    if (at_begin < -slack && at_end < -slack) return -1;
    return 0;
  }

  struct Mark {
    std::size_t at;
    double begin, end;
  };

  const ProjectedProfile& profile_;
  BlockedHorizon& horizon_;
  const TieTolerance& tolerance_;
  bool is_drawn_;
  VisibleEnds ends_;
  ProfileClipCounts& counts_;
  std::vector<Mark> marks_;
};

} // namespace

void clip_profile(const ProjectedProfile& profile, XRange range, BlockedHorizon& horizon,
                  const TieTolerance& tolerance, bool is_drawn, std::vector<VisibleRun>& visible,
                  ProfileClipCounts& counts) {
  RunClip clip(profile, horizon, tolerance, is_drawn, visible, counts);
  for (const VertexRun& run : profile.runs) clip.clip(run, range);
}

void clip_run(const ProjectedProfile& profile, VertexRun run, XRange range, BlockedHorizon& horizon,
              const TieTolerance& tolerance, bool is_drawn, std::vector<VisibleRun>& visible,
              ProfileClipCounts& counts) {
  RunClip(profile, horizon, tolerance, is_drawn, visible, counts).clip(run, range);
}

template <class AnyHorizon>
std::vector<Piece> visible_uprights(std::span<const Segment> uprights, const AnyHorizon& horizon,
                                    double beside) {
  std::vector<Piece> visible;
  for (std::uint32_t i = 0; i < uprights.size(); ++i) {
    const Segment& s = uprights[i];
    const double horizon_y =
        std::min(horizon_height(horizon, s.x0 - beside), horizon_height(horizon, s.x0 + beside));
    if (s.y0 == s.y1 || std::max(s.y0, s.y1) <= horizon_y) continue;
    const double share = std::min(s.y0, s.y1) >= horizon_y ? 0 : (horizon_y - s.y0) / (s.y1 - s.y0);
    if (s.y0 < s.y1)
      visible.push_back({i, s.x0, s.x0, share, 1});
    else
      visible.push_back({i, s.x0, s.x0, 0, share > 0 ? share : 1});
  }
  return visible;
}

template std::vector<Piece> visible_uprights(std::span<const Segment>, const Horizon&, double);
template std::vector<Piece> visible_uprights(std::span<const Segment>, const BlockedHorizon&,
                                             double);

void insert_uprights(std::span<const Segment> uprights, std::span<const Piece> visible_uprights,
                     std::vector<Segment>& segments, std::vector<Piece>& visible) {
  const std::vector<Segment> others = std::move(segments);
  segments.clear();
  std::vector<std::uint32_t> number_of_other(others.size()), number_of_upright(uprights.size());
  for (std::size_t i = 0, k = 0; i < others.size() || k < uprights.size();) {
    const bool other = k == uprights.size() || (i < others.size() && others[i].id < uprights[k].id);
    (other ? number_of_other[i] : number_of_upright[k]) =
        static_cast<std::uint32_t>(segments.size());
    segments.push_back(other ? others[i++] : uprights[k++]);
  }
  for (Piece& piece : visible) piece.segment = number_of_other[piece.segment];
  const auto middle = static_cast<std::ptrdiff_t>(visible.size());
  for (Piece piece : visible_uprights) {
    piece.segment = number_of_upright[piece.segment];
    visible.push_back(piece);
  }
  std::inplace_merge(visible.begin(), visible.begin() + middle, visible.end(),
                     [](const Piece& a, const Piece& b) { return a.segment < b.segment; });
}

} // namespace orograph
