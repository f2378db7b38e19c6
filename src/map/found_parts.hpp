// SPDX-License-Identifier: GPL-3.0-or-later
// What sectors have found, put together to the whole view's.
#pragma once

#include "dem/terrain.hpp"
#include "hidden_lines/sector_pass.hpp"
#include "placing/placed_view.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace orograph {

/// Those of a kind of lines.
std::vector<LinePart> of_kind(const std::vector<EdgeLine>& lines,
                              const std::vector<LinePart>& parts, LineKind kind);

/// Parts found sector by sector, of one kind at a time as parts of the whole view.
class FoundParts {
public:
  /// `listed`: the lines that all sectors were given; `points`: of those on the ground. REQUIRES
  /// that all but these two outlive it.
  FoundParts(const TerrainData& terrain, const PlacedView& placed,
             std::span<const ProfilePoint> points, std::vector<EdgeLine> listed,
             std::vector<SectorLines> sectors);

  /// Those of the list, and those found, in order of their edges.
  const std::vector<EdgeLine>& lines() const { return lines_; }
  double folded_mm() const { return folded_mm_; } ///< of silhouettes that were folds, on the page

  /// Less the lines on the ground that are visible from end to end.
  std::vector<LinePart> of(std::vector<LinePart> SectorLines::*kind) const;
  /// Of a kind of lines, all: `visible` are those of all kinds as `of` has them.
  std::vector<LinePart> visible_of(LineKind kind, const std::vector<LinePart>& visible) const;
  /// A mark for each line on the ground, where those of a kind that are visible from end to end are
  /// marked instead of being parts; none where none is.
  std::vector<std::uint8_t> whole_of(LineKind kind) const;
  /// Of lines: what two sectors show of one, and what they hide, meets in the strip between them.
  std::vector<LinePart> hidden() const;
  std::vector<LinePart> of(std::vector<LinePart> SolidParts::*kind) const;

private:
  void number_as_one();

  const TerrainData& terrain_;
  const PlacedView& placed_;
  std::span<const ProfilePoint> points_;
  std::vector<EdgeLine> lines_;
  std::size_t listed_; ///< of them
  std::vector<SectorLines> sectors_;
  double folded_mm_ = 0;
};

} // namespace orograph
