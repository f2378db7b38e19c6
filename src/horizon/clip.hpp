// SPDX-License-Identifier: GPL-3.0-or-later
// Clipping segments against the horizon: Greenspun and Little, "Recursive hidden-line elimination
// on an infinite surface" (1988), "Recursive clipping" and "Real work"; made exact:
// docs/how-it-works.md.
#pragma once

#include "horizon/compare.hpp"
#include "horizon/horizon.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace orograph {

/// What the segments do.
enum class Role {
  drawn_occluder, ///< drawn where above the horizon, which they raise there (the seed's profiles)
  occluder,       ///< not drawn; they raise the horizon, compared exactly
  compared        ///< drawn where above the horizon, which stays as it is
};

/// A piece of segment number `segment` of the list that was clipped, told by X and, more exactly on
/// steep segments, by the parameter along it (0 at the left end, 1 at the right).
struct Piece {
  std::uint32_t segment;
  double x_begin, x_end, t_begin, t_end;
  bool operator==(const Piece&) const = default;
};

struct ClipOptions {
  Role role = Role::drawn_occluder;
  TieTolerance tolerance;
  bool collapse = true; ///< join neighbouring horizon pieces of one source
  /// Of what isn't an occluder alone: whether it is drawn where it is visible. Otherwise that is
  /// told, and no line counts as drawn there.
  bool is_drawn = true;
};

/// The four values of the seed's step, and whether the two were tied.
struct ClipStep {
  std::optional<Piece> draw;
  std::vector<HorizonPiece> new_horizon;  ///< one to three
  std::optional<Segment> rest_of_profile; ///< from `rest_begin` on; the source stays whole
  double rest_begin = 0;
  std::optional<HorizonPiece> rest_of_horizon;
  bool tied = false;
};

/// Compares the part of `profile` from x_begin on with a horizon piece that holds x_begin, up to
/// the leftmost right end of the two. The executable form of the seed's figure 4.
ClipStep clip_segments(const Segment& profile, std::uint32_t number, double x_begin,
                       const HorizonPiece& horizon, const ClipOptions& options);

struct ClipResult {
  std::vector<Piece> visible; ///< left to right; neighbouring pieces of one segment are joined
  Horizon horizon;
};

/// The seed's recursion over two lists, as written there: the specification of `clip`. For tests
/// and small scenes; its depth is the number of steps.
ClipResult clip_recursive(std::span<const Segment> profile, const Horizon& horizon,
                          const ClipOptions& options);

/// What `clip` reuses from profile to profile, and what it found.
struct ClipWorkspace {
  std::vector<Piece> visible; ///< of the last call, as in ClipResult
  std::vector<Piece> hidden;  ///< of the last call: below the horizon; filled if `keep_hidden`
  std::vector<Piece> tied; ///< of the last call: tied with a line that is drawn already; likewise
  bool keep_hidden = false;

  std::size_t steps = 0;              ///< pieces compared, over all calls
  std::size_t pieces_uncollapsed = 0; ///< horizon pieces as made, over all calls
  std::size_t pieces_collapsed = 0;   ///< horizon pieces as kept, over all calls
  std::size_t ties = 0;               ///< over all calls

  struct Mark {
    std::size_t at;
    double begin, end;
  };
  std::vector<Mark> marks;                       ///< scratch
  Horizon next;                                  ///< scratch
  std::vector<std::vector<HorizonPiece>> chains; ///< scratch of `raise`
  std::vector<Horizon> envelopes;                ///< scratch of `raise`
};

/// Clips segments (in order of X, disjoint but for shared ends, gaps allowed) against `horizon` and
/// brings it up to date. The same pieces as `clip_recursive`, by a loop over flat arrays.
/// Cost O(segments + horizon pieces); no allocation once warm.
///
///  (1) visible, hidden and tied pieces tile the segments;
///  (2) a visible piece lies above the horizon as it was, up to rounding (ties apart);
///  (3) the new horizon is nowhere below the old one.
void clip(std::span<const Segment> segments, Horizon& horizon, const ClipOptions& options,
          ClipWorkspace& workspace);

/// Raises `horizon` by occluders that may overlap and come in any order (it sorts them): compared
/// exactly, nothing drawn. They are parted into chains of disjoint pieces, the chains are merged
/// pairwise, and what comes out is merged into the horizon. No allocation once warm. Cost
/// O(occluders * log of how many overlap + horizon pieces). Without `collapse` pieces stay apart as
/// they were cut.
void raise(std::vector<HorizonPiece>& occluders, Horizon& horizon, ClipWorkspace& workspace,
           bool collapse = true);

} // namespace orograph
