// SPDX-License-Identifier: GPL-3.0-or-later
#include "horizon/clip.hpp"

#include "horizon/clip_step.hpp"
#include "horizon/horizon.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>

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
                    bool tied, const ClipOptions& options) {
  HorizonPiece after = piece;
  after.x_begin = stretch.x_begin;
  after.x_end = stretch.x_end;
  if (!stretch.above) return after;
  if (tied) {
    after.inked = after.inked || options.is_drawn;
  } else if (options.role != Role::compared) {
    after.source = p;
    after.inked = inked && options.is_drawn;
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
        raised(profile, options.role == Role::drawn_occluder, horizon, s, step.tied, options));
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

// The function CLIP of the seed, its four cases in its order. Lists are spans with, in front, what
// is left of a first element that wasn't handled whole ("stuck onto the rest of the list").

struct ProfileList {
  double first_begin; ///< from where on the first segment is still to do
  std::uint32_t first_number;
  std::span<const Segment> segments;
};

struct HorizonList {
  std::optional<HorizonPiece> rest; ///< in front of `pieces`
  std::span<const HorizonPiece> pieces;

  bool empty() const { return !rest && pieces.empty(); }
  const HorizonPiece& first() const { return rest ? *rest : pieces.front(); }
  HorizonList without_first() const {
    return rest ? HorizonList{std::nullopt, pieces} : HorizonList{std::nullopt, pieces.subspan(1)};
  }
};

ProfileList without_first(const ProfileList& list) {
  const auto rest = list.segments.subspan(1);
  return {rest.empty() ? 0 : rest.front().x0, list.first_number + 1, rest};
}

// Results are built from the right end, as the recursion returns; they are turned round at the end.
void recurse(const ProfileList& profile, const HorizonList& horizon, const ClipOptions& options,
             ClipResult& reversed) {
  const auto push_horizon = [&](const HorizonPiece& piece) { reversed.horizon.push_back(piece); };
  if (horizon.empty()) throw std::logic_error("ran out of horizon");
  if (profile.segments.empty()) {
    for (auto it = horizon.pieces.rbegin(); it != horizon.pieces.rend(); ++it) push_horizon(*it);
    if (horizon.rest) push_horizon(*horizon.rest);
    return;
  }
  if (profile.first_begin >= horizon.first().x_end) {
    recurse(profile, horizon.without_first(), options, reversed);
    push_horizon(horizon.first());
    return;
  }
  const ClipStep step = clip_segments(profile.segments.front(), profile.first_number,
                                      profile.first_begin, horizon.first(), options);
  const ProfileList rest_of_profile =
      step.rest_of_profile ? ProfileList{step.rest_begin, profile.first_number, profile.segments}
                           : without_first(profile);
  HorizonList rest_of_horizon = horizon.without_first();
  if (step.rest_of_horizon) rest_of_horizon.rest = step.rest_of_horizon;
  recurse(rest_of_profile, rest_of_horizon, options, reversed);
  if (step.draw) reversed.visible.push_back(*step.draw);
  for (auto it = step.new_horizon.rbegin(); it != step.new_horizon.rend(); ++it) push_horizon(*it);
}

} // namespace

ClipResult clip_recursive(std::span<const Segment> profile, const Horizon& horizon,
                          const ClipOptions& options) {
  ClipResult reversed;
  recurse({profile.empty() ? 0 : profile.front().x0, 0, profile}, {std::nullopt, horizon}, options,
          reversed);
  ClipResult out;
  for (auto it = reversed.visible.rbegin(); it != reversed.visible.rend(); ++it) {
    if (!out.visible.empty() && out.visible.back().segment == it->segment &&
        out.visible.back().x_end == it->x_begin) {
      out.visible.back().x_end = it->x_end;
      out.visible.back().t_end = it->t_end;
    } else {
      out.visible.push_back(*it);
    }
  }
  // The seed's outer loop collapses subsegments of one segment after each profile.
  for (auto it = reversed.horizon.rbegin(); it != reversed.horizon.rend(); ++it) {
    if (options.collapse && !out.horizon.empty() && out.horizon.back().source.id == it->source.id &&
        out.horizon.back().inked == it->inked)
      out.horizon.back().x_end = it->x_end;
    else
      out.horizon.push_back(*it);
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
    write(raised(item.source, item.inked, horizon[at], stretch, tied, options));
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
  if (!options.is_drawn) return;
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
