// SPDX-License-Identifier: GPL-3.0-or-later
// A strip of X in the lattice's order.
#pragma once

#include "hidden_lines/lattice_in_work.hpp"
#include "hidden_lines/lattice_lines.hpp"
#include "hidden_lines/line_pictures.hpp"
#include "hidden_lines/sector_in_work.hpp"
#include "hidden_lines/strips.hpp"
#include "horizon/blocked_horizon.hpp"
#include "horizon/clip_profile.hpp"
#include "profiles/lattice_order.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace orograph {

/// Spans of a profile in a strip of a lattice's cells on the earth, from `first` on, `end` not
/// included.
struct SpansOfPlace {
  ProfileInWork* profile;
  std::uint32_t first, end;
  double x_begin, x_end;
  double x_last; ///< the greatest end up to these
};

/// The profiles that a place may hold something of, by depth; on the earth the spans that it holds,
/// by where they begin.
struct ProfilesOfPlace {
  std::span<ProfileInWork* const> by_depth;
  std::span<const SpansOfPlace> spans;
};

/// Takes place after place of the order: compares what is drawn with the horizon, and raises the
/// horizon by what hides.
class LatticeStrip {
public:
  /// The strip's lines are `which`, by number; `near_cut` stands in front of everything. `number`
  /// is that of the strip among the sector's. REQUIRES that all outlive it.
  LatticeStrip(const LatticeInWork& lattice, const Strip& strip, std::span<const LineAtDepth> which,
               std::span<const Segment> near_cut, std::size_t number);
  LatticeStrip(const LatticeStrip&) = delete;
  LatticeStrip& operator=(const LatticeStrip&) = delete;

  /// What is at a place; of the profiles what is visible there goes to their runs of this strip,
  /// in no particular order. REQUIRES that places are taken in order.
  void take(std::uint32_t place, const ProfilesOfPlace& profiles);

  /// Once everything was taken.
  void finish() { lines_.finish(); }

  const LatticeLines& lines() const { return lines_; }
  LatticeContours* contours() { return lines_.contours(); }
  const LinePictures& pictures() const { return pictures_; }
  const BlockedHorizon& horizon() const { return horizon_; }
  const ProfileClipCounts& counts() const { return counts_; }

private:
  // What of a profile is in the present strip of cells, from span `next` up to `end`, outwards from
  // the eye. Cells are counted outwards as well: backwards on one side.
  struct ProfilePart {
    ProfileInWork* profile;
    std::ptrdiff_t next, end, step;
    double first_cell, cell_per_u;
    bool by_number = false; ///< cells are told by it, and not by u

    bool done() const { return next == end; }
    double middle(std::ptrdiff_t span) const {
      const auto i = static_cast<std::size_t>(span);
      return 0.5 * (profile->profile.u_m[i] + profile->profile.u_m[i + 1]);
    }
    double cell(std::ptrdiff_t span) const {
      return first_cell + cell_per_u * (by_number
                                            ? profile->on_earth.cell(static_cast<std::size_t>(span))
                                            : middle(span));
    }
  };

  void find_profiles(const LatticeOrder::Place& place, const ShownOfPlace& shown,
                     const ProfilesOfPlace& profiles);
  void add_profile(const LatticeOrder::Place& place, ProfileInWork& profile);
  void find_spans(const EarthStrips& earth, int strip, std::span<const SpansOfPlace> spans);
  void add_in_order(const EarthStrips& earth, int strip, ProfileInWork& profile,
                    std::uint32_t first, std::uint32_t last);
  double first_not_taken(const LatticeLines::EdgeAtTurn& edge, bool back) const;
  bool is_near(const ProfilePart& part, int column, int row, bool lower_near) const;
  bool is_hidden(const ProfileInWork& profile, std::uint32_t first, std::uint32_t last) const;
  void take_side(PlacePart part);
  void take_diagonal(int column, int row, double end);
  void take_up_to(double cell);
  void clip(ProfileInWork& profile, std::ptrdiff_t first, std::ptrdiff_t last);

  const LatticeInWork& lattice_;
  XRange range_;
  std::size_t number_;
  LinePictures pictures_;
  BlockedHorizon horizon_;
  LatticeLines lines_;
  ProfileClipCounts counts_;
  std::vector<ProfilePart> outwards_, backwards_;
  std::vector<ProfilePart>* side_ = nullptr;
  std::size_t begun_ = 0, done_ = 0; ///< of the side's
  struct FarSpan {
    ProfileInWork* profile;
    std::ptrdiff_t span;
  };
  std::vector<FarSpan> far_;           ///< of the present diagonal's cell
  std::vector<std::uint32_t> cursors_; ///< by profile: a span of it near where it was taken last
};

} // namespace orograph
