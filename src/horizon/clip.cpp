// SPDX-License-Identifier: GPL-3.0-or-later
// Notation: p is the segment that is clipped, s the source of a horizon piece, [a, b] the stretch
// of X looked at in one step: inside p, and inside the piece.
#include "horizon/clip.hpp"

#include <algorithm>
#include <array>
#include <limits>

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
HorizonPiece raised(const Segment& p, bool inked, const HorizonPiece& piece, const Stretch& stretch,
                    bool tied, Role role) {
  HorizonPiece after = piece;
  after.x_begin = stretch.x_begin;
  after.x_end = stretch.x_end;
  if (!stretch.above) return after;
  if (tied) {
    after.inked = true;
  } else if (role != Role::compared) {
    after.source = p;
    after.inked = inked;
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
    out.new_horizon.push_back(
        raised(profile, options.role == Role::drawn_occluder, horizon, s, step.tied, options.role));
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

namespace {

// An element of a list to be clipped: a source and the part of it.
struct Item {
  const Segment& source;
  double x_begin, x_end;
  bool inked; ///< whether it is drawn where it raises the horizon
};
Item item_of(const Segment& segment, const ClipOptions& options) {
  return {segment, segment.x0, segment.x1, options.role == Role::drawn_occluder};
}
Item item_of(const HorizonPiece& piece, const ClipOptions&) {
  return {piece.source, piece.x_begin, piece.x_end, piece.inked};
}

template <class List>
void clip_list(const List& list, Horizon& horizon, const ClipOptions& options,
               ClipWorkspace& workspace) {
  workspace.visible.clear();
  workspace.hidden.clear();
  workspace.tied.clear();
  Horizon& next = workspace.next;
  next.clear();

  std::size_t at = 0;
  HorizonPiece current = horizon.front(); // what is left of horizon[at]
  const auto emit = [&](const HorizonPiece& piece) {
    append(next, piece, options.collapse);
    ++workspace.pieces_uncollapsed;
  };
  for (std::uint32_t number = 0; number < list.size(); ++number) {
    const Item item = item_of(list[number], options);
    if (item.source.id == kSky) continue;
    while (current.x_end <= item.x_begin) {
      emit(current);
      current = horizon[++at];
    }
    if (current.x_begin < item.x_begin) {
      HorizonPiece left = current;
      left.x_end = item.x_begin;
      emit(left);
      current.x_begin = item.x_begin;
    }
    for (double a = item.x_begin; a < item.x_end;) {
      const double b = std::min(item.x_end, current.x_end);
      const Step step = resolve(item.source, current, a, b, options);
      ++workspace.steps;
      workspace.ties += step.tied ? 1 : 0;
      for (int i = 0; i < step.count; ++i) {
        const Stretch& s = step.stretches[static_cast<std::size_t>(i)];
        emit(raised(item.source, item.inked, current, s, step.tied, options.role));
        const Piece piece{number, s.x_begin, s.x_end, s.t_begin, s.t_end};
        if (s.above && options.role != Role::occluder)
          append(workspace.visible, piece);
        else if (workspace.keep_hidden)
          append(step.tied ? workspace.tied : workspace.hidden, piece);
      }
      current.x_begin = a = b;
      if (current.x_end <= b) current = horizon[++at];
    }
  }
  emit(current);
  for (++at; at < horizon.size(); ++at) emit(horizon[at]);
  workspace.pieces_collapsed += next.size();
  horizon.swap(next);
}

// The sky with a list of disjoint pieces in it.
Horizon horizon_of(std::span<const HorizonPiece> pieces) {
  Horizon horizon;
  HorizonPiece sky = initial_horizon().front();
  for (const HorizonPiece& piece : pieces) {
    sky.x_end = piece.x_begin;
    if (sky.x_begin < sky.x_end) horizon.push_back(sky);
    horizon.push_back(piece);
    sky.x_begin = piece.x_end;
  }
  sky.x_end = std::numeric_limits<double>::infinity();
  horizon.push_back(sky);
  return horizon;
}

Horizon envelope_of(std::span<const std::vector<HorizonPiece>> chains, ClipWorkspace& workspace) {
  if (chains.size() == 1) return horizon_of(chains.front());
  const std::size_t half = chains.size() / 2;
  const Horizon left = envelope_of(chains.first(half), workspace);
  Horizon right = envelope_of(chains.subspan(half), workspace);
  clip_list(left, right, {Role::occluder, {}, true}, workspace);
  return right;
}

} // namespace

void clip(std::span<const Segment> segments, Horizon& horizon, const ClipOptions& options,
          ClipWorkspace& workspace) {
  clip_list(segments, horizon, options, workspace);
}

void raise(std::vector<HorizonPiece>& occluders, Horizon& horizon, ClipWorkspace& workspace) {
  if (occluders.empty()) return;
  std::sort(occluders.begin(), occluders.end(), [](const HorizonPiece& a, const HorizonPiece& b) {
    return a.x_begin != b.x_begin ? a.x_begin < b.x_begin : a.source.id < b.source.id;
  });
  auto& chains = workspace.chains;
  for (auto& pieces : chains) pieces.clear();
  std::size_t used = 0;
  for (const HorizonPiece& piece : occluders) {
    std::size_t i = 0;
    while (i < used && chains[i].back().x_end > piece.x_begin) ++i;
    if (i == used && ++used > chains.size()) chains.emplace_back();
    chains[i].push_back(piece);
  }
  const ClipOptions exact{Role::occluder, {}, true};
  if (used == 1)
    clip_list(chains.front(), horizon, exact, workspace);
  else
    clip_list(envelope_of(std::span(chains).first(used), workspace), horizon, exact, workspace);
}

} // namespace orograph
