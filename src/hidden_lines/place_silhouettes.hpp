// SPDX-License-Identifier: GPL-3.0-or-later
// The silhouettes at a place of the lattice's order, as far as a strip of X may show them.
#pragma once

#include "hidden_lines/lattice_in_work.hpp"
#include "hidden_lines/line_pictures.hpp"
#include "hidden_lines/shown_of_place.hpp"
#include "horizon/blocked_horizon.hpp"
#include "profiles/silhouettes.hpp"

#include <span>
#include <vector>

namespace orograph {

/// The three parts of a place, in the order in which they are taken.
enum class PlacePart { line, outwards, backwards };
/// The part that what has a turn is taken in.
inline PlacePart part_of(const LatticeOrder& order, LatticeOrder::Turn turn) {
  if (LatticeOrder::is_on_line(turn)) return PlacePart::line;
  return order.goes_back(turn) ? PlacePart::backwards : PlacePart::outwards;
}

class PlaceSilhouettes {
public:
  /// REQUIRES marks by the strips of the lattice's order, and that all outlive it.
  PlaceSilhouettes(const LatticeInWork& lattice, const SilhouetteMarks& marks,
                   const LinePictures& pictures)
      : lattice_(lattice), marks_(marks), pictures_(pictures) {}

  struct Found {
    LatticeOrder::Turn turn;
    SurfaceEdge edge;
    LinePicture picture;
  };
  /// Finds those in the strip's range that may rise above the horizon as it stands, less those that
  /// `LinePictures` moves.
  void find(const LatticeOrder::Place& place, const ShownOfPlace& shown,
            const BlockedHorizon& horizon);
  /// By turn.
  std::span<const Found> of(PlacePart part) const { return found_[static_cast<std::size_t>(part)]; }

  /// Those on a line of the lattice that `LinePictures` moves.
  std::vector<SurfaceEdge> moved(int line) const;

private:
  void find_on_earth(const LatticeOrder::Place& place, const ShownOfPlace& shown,
                     const BlockedHorizon& horizon);
  void find_marked(std::span<const std::uint8_t> marks, const ShownOfPlace& shown,
                   std::uint8_t which);
  SurfaceEdge edge_at(int strip, int cell, std::uint8_t mark) const;
  void add(PlacePart part, SurfaceEdge edge, const BlockedHorizon& horizon);

  const LatticeInWork& lattice_;
  const SilhouetteMarks& marks_;
  const LinePictures& pictures_;
  std::array<std::vector<Found>, 3> found_;
  std::vector<int> cells_; ///< that are marked
};

} // namespace orograph
