// SPDX-License-Identifier: GPL-3.0-or-later
// Notation: p is the segment that is clipped, s the source of a horizon piece, [a, b] the stretch
// of X looked at in one step: inside p, and inside the piece.
#include "horizon/clip.hpp"

#include <algorithm>
#include <array>

namespace orograph {
namespace {

// A stretch of p above or below s; one step has at most two of them.
struct Stretch {
  double x_begin, x_end, t_begin, t_end;
  bool above;
};

struct Step {
  int count = 0;
  std::array<Stretch, 2> stretches;
  bool tied = false;
};

// What [a, b] of p is against the piece. Where p is tied to it, `above` is whether to draw p there.
Step resolve(const Segment& p, const HorizonPiece& piece, double a, double b,
             const ClipOptions& options) {
  using enum Standing::Kind;
  const double t_a = parameter_at(p, a), t_b = parameter_at(p, b);
  const auto whole = [&](bool above, double t_begin, double t_end) {
    if (a == p.x0) t_begin = 0;
    if (b == p.x1) t_end = 1;
    return Step{1, {Stretch{a, b, t_begin, t_end, above}}, false};
  };
  if (is_sky(piece)) return whole(true, t_a, t_b);
  const bool exact = options.role == Role::occluder;
  const Standing standing = compare(p, piece.source, exact ? TieTolerance{} : options.tolerance);
  if (standing.kind == tied) {
    Step step = whole(!exact && !piece.inked, t_a, t_b);
    step.tied = true;
    return step;
  }
  if (standing.kind == above || standing.kind == below)
    return whole(standing.kind == above, t_a, t_b);
  const bool first_above = standing.kind == above_then_below;
  // A crossing may round to where a horizon has fragmented: then, too, its place along p is its
  // own.
  if (standing.x <= a) return whole(!first_above, standing.x == a ? standing.t : t_a, t_b);
  if (standing.x >= b) return whole(first_above, t_a, standing.x == b ? standing.t : t_b);
  return {2,
          {Stretch{a, standing.x, t_a, standing.t, first_above},
           Stretch{standing.x, b, standing.t, t_b, !first_above}},
          false};
}

// The horizon along a stretch after the step.
HorizonPiece raised(const Segment& p, const HorizonPiece& piece, const Stretch& stretch, bool tied,
                    Role role) {
  HorizonPiece after = piece;
  after.x_begin = stretch.x_begin;
  after.x_end = stretch.x_end;
  if (!stretch.above) return after;
  if (tied) {
    after.inked = true;
  } else if (role != Role::compared) {
    after.source = p;
    after.inked = role == Role::drawn_occluder;
  }
  return after;
}

bool continues(const HorizonPiece& left, const HorizonPiece& right) {
  return left.source.id == right.source.id && left.inked == right.inked;
}

void append(Horizon& horizon, const HorizonPiece& piece, bool collapse) {
  if (collapse && !horizon.empty() && continues(horizon.back(), piece))
    horizon.back().x_end = piece.x_end;
  else
    horizon.push_back(piece);
}

void append(std::vector<Piece>& pieces, const Piece& piece) {
  if (!pieces.empty() && pieces.back().segment == piece.segment &&
      pieces.back().x_end == piece.x_begin) {
    pieces.back().x_end = piece.x_end;
    pieces.back().t_end = piece.t_end;
  } else {
    pieces.push_back(piece);
  }
}

} // namespace

ClipStep clip_segments(const Segment& profile, std::uint32_t number, double x_begin,
                       const HorizonPiece& horizon, const ClipOptions& options) {
  ClipStep out;
  const double b = std::min(profile.x1, horizon.x_end);
  if (horizon.x_begin < x_begin) {
    out.new_horizon.push_back(horizon);
    out.new_horizon.back().x_end = x_begin;
  }
  const Step step = resolve(profile, horizon, x_begin, b, options);
  out.tied = step.tied;
  for (int i = 0; i < step.count; ++i) {
    const Stretch& s = step.stretches[static_cast<std::size_t>(i)];
    out.new_horizon.push_back(raised(profile, horizon, s, step.tied, options.role));
    if (s.above && options.role != Role::occluder)
      out.draw = Piece{number, s.x_begin, s.x_end, s.t_begin, s.t_end};
  }
  if (profile.x1 > b) {
    out.rest_of_profile = profile;
    out.rest_begin = b;
  }
  if (horizon.x_end > b) {
    out.rest_of_horizon = horizon;
    out.rest_of_horizon->x_begin = b;
  }
  return out;
}

void clip(std::span<const Segment> segments, Horizon& horizon, const ClipOptions& options,
          ClipWorkspace& workspace) {
  auto& [visible, hidden, tied, keep_hidden, steps, pieces_uncollapsed, pieces_collapsed, ties,
         next] = workspace;
  visible.clear();
  hidden.clear();
  tied.clear();
  next.clear();

  std::size_t at = 0;
  HorizonPiece current = horizon.front(); // what is left of horizon[at]
  const auto emit = [&](const HorizonPiece& piece) {
    append(next, piece, options.collapse);
    ++pieces_uncollapsed;
  };
  for (std::uint32_t number = 0; number < segments.size(); ++number) {
    const Segment& p = segments[number];
    while (current.x_end <= p.x0) {
      emit(current);
      current = horizon[++at];
    }
    if (current.x_begin < p.x0) {
      HorizonPiece left = current;
      left.x_end = p.x0;
      emit(left);
      current.x_begin = p.x0;
    }
    for (double a = p.x0; a < p.x1;) {
      const double b = std::min(p.x1, current.x_end);
      const Step step = resolve(p, current, a, b, options);
      ++steps;
      ties += step.tied ? 1 : 0;
      for (int i = 0; i < step.count; ++i) {
        const Stretch& s = step.stretches[static_cast<std::size_t>(i)];
        emit(raised(p, current, s, step.tied, options.role));
        const Piece piece{number, s.x_begin, s.x_end, s.t_begin, s.t_end};
        if (s.above && options.role != Role::occluder)
          append(visible, piece);
        else if (keep_hidden)
          append(step.tied ? tied : hidden, piece);
      }
      current.x_begin = a = b;
      if (current.x_end <= b) current = horizon[++at];
    }
  }
  emit(current);
  for (++at; at < horizon.size(); ++at) emit(horizon[at]);
  pieces_collapsed += next.size();
  horizon.swap(next);
}

} // namespace orograph
