// SPDX-License-Identifier: GPL-3.0-or-later
// The function CLIP of the seed, its four cases in its order. Lists are spans with, in front, what
// is left of a first element that wasn't handled whole ("stuck onto the rest of the list").
#include "horizon/clip.hpp"

#include <stdexcept>

namespace orograph {
namespace {

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

} // namespace orograph
