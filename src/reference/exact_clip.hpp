// SPDX-License-Identifier: GPL-3.0-or-later
// The reference for the clip: the same pieces, in exact rational arithmetic (docs/how-it-works.md).
#pragma once

#include "geometry/segment.hpp"
#include "horizon/clip.hpp" // Role and Piece

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

namespace orograph {

/// Segments that don't hide one another (their interiors share no X), and what they do.
struct ExactList {
  std::span<const Segment> segments;
  Role role = Role::drawn_occluder;
};

struct ExactClip {
  /// In order of segments and, on each, of X; neighbouring pieces of one segment are joined. Their
  /// ends are the true ones, rounded to the nearest double.
  std::vector<Piece> visible;
  /// Pieces of the true horizon behind the list, from -infinity to +infinity: no horizon of these
  /// sources has fewer.
  std::size_t least_horizon = 1;
};

/// The true horizon. Doubles are taken as exact, and so is every comparison. What lies on the
/// horizon all along leaves it as it is. Sources are told by their ids.
class ExactHorizon {
public:
  ExactHorizon();
  ~ExactHorizon();
  ExactHorizon(const ExactHorizon&) = delete;
  ExactHorizon& operator=(const ExactHorizon&) = delete;

  /// Clips a list against the horizon, and raises it as its role says. A piece that lies on the
  /// horizon all along is drawn only where no line is drawn yet (docs/how-it-works.md, with a
  /// tolerance of 0). REQUIRES finite coordinates and x0 < x1. Cost about 5 microseconds for each
  /// segment and for each piece of horizon that it meets.
  ExactClip clip(const ExactList& list);
  /// Raises the horizon by pieces that may overlap. Where two lie on each other, the first stays.
  void raise(std::span<const HorizonPiece> occluders);

  /// Pieces from -infinity to +infinity: no horizon of these sources has fewer.
  std::size_t size() const;
  /// The same as a list. Ends are rounded to the nearest double: a piece may have no width left.
  Horizon pieces() const;

private:
  struct Content;
  std::unique_ptr<Content> content_;
};

/// Clips lists of segments, nearest list first, each against the horizon of the lists in front.
std::vector<ExactClip> exact_clip(std::span<const ExactList> lists);

} // namespace orograph
