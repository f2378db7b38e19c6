// SPDX-License-Identifier: GPL-3.0-or-later
#include "horizon/clip.hpp"

#include "horizon/clip_step.hpp"
#include "horizon/horizon_pieces.hpp"

#include <algorithm>
#include <limits>

namespace orograph {
namespace {

Step resolve(const Segment& p, const HorizonPiece& piece, double a, double b,
             const ClipOptions& options) {
  return resolve(p, piece, a, b, options.role == Role::occluder, options.tolerance);
}

Piece piece_of(const Segment& p, std::uint32_t number, const Step& step, const Stretch& s) {
  return {number, s.x_begin, s.x_end, t_begin(p, step, s), t_end(p, step, s)};
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
    if (s.above && options.role != Role::occluder) out.draw = piece_of(profile, number, step, s);
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

// The walk along a list and the horizon at once. `sink` is told what becomes of the horizon, left
// to right: `keep` for a part of a piece that nothing meets, `meet` for a stretch of the list
// against a piece, `rest` for the piece from an X on and all behind it.
template <class List, class Sink>
void walk(const List& list, const Horizon& horizon, const ClipOptions& options,
          ClipWorkspace& workspace, Sink& sink) {
  workspace.visible.clear();
  workspace.hidden.clear();
  workspace.tied.clear();
  std::size_t at = 0;
  double begin = horizon.front().x_begin; // of what is left of horizon[at]
  for (std::uint32_t number = 0; number < list.size(); ++number) {
    const Item item = item_of(list[number], options);
    if (item.source.id == kSky) continue;
    while (horizon[at].x_end <= item.x_begin) {
      sink.keep(horizon[at], begin, horizon[at].x_end);
      begin = horizon[++at].x_begin;
    }
    if (begin < item.x_begin) sink.keep(horizon[at], begin, item.x_begin);
    for (begin = item.x_begin; begin < item.x_end;) {
      const HorizonPiece& piece = horizon[at];
      const double end = std::min(item.x_end, piece.x_end);
      const Step step = resolve(item.source, piece, begin, end, options);
      ++workspace.steps;
      workspace.ties += step.tied ? 1 : 0;
      for (int i = 0; i < step.count; ++i) {
        const Stretch& s = step.stretches[static_cast<std::size_t>(i)];
        sink.meet(item, at, s, step.tied);
        if (s.above && options.role != Role::occluder)
          append(workspace.visible, piece_of(item.source, number, step, s));
        else if (workspace.keep_hidden)
          append(step.tied ? workspace.tied : workspace.hidden,
                 piece_of(item.source, number, step, s));
      }
      begin = end;
      if (piece.x_end <= end) ++at;
    }
  }
  sink.rest(at, begin);
}

// Writes the horizon anew.
struct Writer {
  const Horizon& horizon;
  const ClipOptions& options;
  ClipWorkspace& workspace;

  void write(const HorizonPiece& piece) {
    append(workspace.next, piece, options.collapse);
    ++workspace.pieces_uncollapsed;
  }
  void keep(HorizonPiece piece, double begin, double end) {
    piece.x_begin = begin;
    piece.x_end = end;
    write(piece);
  }
  void meet(const Item& item, std::size_t at, const Stretch& stretch, bool tied) {
    write(raised(item.source, item.inked, horizon[at], stretch, tied, options.role));
  }
  void rest(std::size_t at, double begin) {
    keep(horizon[at], begin, horizon[at].x_end);
    for (++at; at < horizon.size(); ++at) write(horizon[at]);
  }
};

// Leaves the horizon as it is, and notes where it is tied and drawn.
struct Marker {
  const Horizon& horizon;
  std::vector<ClipWorkspace::Mark>& marks;

  void keep(const HorizonPiece&, double, double) {}
  void meet(const Item&, std::size_t at, const Stretch& stretch, bool tied) {
    if (tied && stretch.above && !horizon[at].inked)
      marks.push_back({at, stretch.x_begin, stretch.x_end});
  }
  void rest(std::size_t, double) {}
};

template <class List>
void clip_list(const List& list, Horizon& horizon, const ClipOptions& options,
               ClipWorkspace& workspace) {
  workspace.next.clear();
  Writer writer{horizon, options, workspace};
  walk(list, horizon, options, workspace, writer);
  workspace.pieces_collapsed += workspace.next.size();
  horizon.swap(workspace.next);
}

// What is compared changes the horizon only where it is tied and drawn, which is rare: the horizon
// is not written anew.
void clip_compared(std::span<const Segment> segments, Horizon& horizon, const ClipOptions& options,
                   ClipWorkspace& workspace) {
  auto& marks = workspace.marks;
  marks.clear();
  Marker marker{horizon, marks};
  walk(segments, horizon, options, workspace, marker);
  for (auto mark = marks.rbegin(); mark != marks.rend(); ++mark)
    ink(horizon, mark->at, mark->begin, mark->end, options.collapse);
}

// The sky with a list of disjoint pieces in it.
void put_into_sky(std::span<const HorizonPiece> pieces, Horizon& horizon) {
  horizon.clear();
  HorizonPiece sky = initial_horizon().front();
  for (const HorizonPiece& piece : pieces) {
    sky.x_end = piece.x_begin;
    if (sky.x_begin < sky.x_end) horizon.push_back(sky);
    horizon.push_back(piece);
    sky.x_begin = piece.x_end;
  }
  sky.x_end = std::numeric_limits<double>::infinity();
  horizon.push_back(sky);
}

} // namespace

void clip(std::span<const Segment> segments, Horizon& horizon, const ClipOptions& options,
          ClipWorkspace& workspace) {
  if (options.role == Role::compared)
    clip_compared(segments, horizon, options, workspace);
  else
    clip_list(segments, horizon, options, workspace);
}

void raise(std::vector<HorizonPiece>& occluders, Horizon& horizon, ClipWorkspace& workspace,
           bool collapse) {
  if (occluders.empty()) return;
  std::sort(occluders.begin(), occluders.end(), is_raised_before);
  auto& chains = workspace.chains;
  for (auto& pieces : chains) pieces.clear();
  std::size_t used = 0;
  for (const HorizonPiece& piece : occluders) {
    std::size_t i = 0;
    while (i < used && chains[i].back().x_end > piece.x_begin) ++i;
    if (i == used && ++used > chains.size()) chains.emplace_back();
    chains[i].push_back(piece);
  }
  const ClipOptions exact{Role::occluder, {}, collapse};
  if (used == 1) {
    clip_list(chains.front(), horizon, exact, workspace);
    return;
  }
  auto& envelopes = workspace.envelopes;
  if (envelopes.size() < used) envelopes.resize(used);
  for (std::size_t i = 0; i < used; ++i) put_into_sky(chains[i], envelopes[i]);
  for (std::size_t apart = 1; apart < used; apart *= 2)
    for (std::size_t i = 0; i + apart < used; i += 2 * apart)
      clip_list(envelopes[i + apart], envelopes[i], exact, workspace);
  clip_list(envelopes.front(), horizon, exact, workspace);
}

} // namespace orograph
