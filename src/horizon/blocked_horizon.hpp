// SPDX-License-Identifier: GPL-3.0-or-later
// A horizon in blocks of X with bounds, so that what is wholly above or below a block of it is
// decided at once, and what raises it is copied in its block alone.
#pragma once

#include "horizon/compare.hpp"
#include "horizon/horizon.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace orograph {

/// A part of line number `line`; along its source, 0 at the left end and 1 at the right.
struct VisibleLinePart {
  std::uint32_t line;
  double t_begin, t_end;
};

/// Appends a part, unless it is empty; what goes on where the last one ended becomes one with it.
void append(std::vector<VisibleLinePart>& parts, std::uint32_t line, double begin, double end);

/// Pieces that tile the block's X, at least one; heights between `low` and `high` (-infinity: the
/// sky).
struct HorizonBlock {
  double x_begin, x_end, low, high;
  Horizon pieces;
};

/// The same heights and sources at each X as those of `raise` (horizon/clip.hpp), but that a piece
/// ends where its block does, and, where two occluders are equally high, either may stand. Copies
/// of one source in neighbouring blocks are collapsed by `joined`.
class BlockedHorizon {
public:
  /// The sky, in `count` blocks, equally wide in [x_begin, x_end]; the first begins at `first` and
  /// the last ends at `last`, and nothing beyond is looked at. Blocks that fill are halved, all at
  /// once. REQUIRES first <= x_begin < x_end <= last, the two in the middle finite, and count > 0.
  BlockedHorizon(double x_begin, double x_end, std::size_t count,
                 double first = -std::numeric_limits<double>::infinity(),
                 double last = std::numeric_limits<double>::infinity());

  const std::vector<HorizonBlock>& blocks() const { return blocks_; }
  /// The block that holds x, or is nearest to it; where two meet, the right one.
  std::size_t block_at(double x) const {
    const double last = static_cast<double>(blocks_.size() - 1);
    auto block = static_cast<std::size_t>(std::clamp((x - x_begin_) * blocks_per_x_, 0.0, last));
    while (block > 0 && x < blocks_[block].x_begin) --block;
    while (block + 1 < blocks_.size() && x >= blocks_[block].x_end) ++block;
    return block;
  }

  /// Whether a height is above all blocks between two abscissae, by more than what is tied: what is
  /// nowhere lower there is seen from end to end, without a look at pieces.
  bool is_all_below(double height, double x_begin, double x_end,
                    const TieTolerance& tolerance) const {
    constexpr double kRounding = 1e-12; // far more than any height is rounded by
    const double above = height - tolerance.greatest_y - kRounding * std::abs(height);
    for (std::size_t i = block_at(x_begin); i < blocks_.size() && blocks_[i].x_begin <= x_end; ++i)
      if (!(above > blocks_[i].high)) return false;
    return true;
  }

  /// Raises it by one occluder, exactly, and tells whether that changes it. Cost: the pieces of the
  /// blocks that it rises above somewhere; O(1) for blocks that are above it.
  bool raise(const HorizonPiece& occluder);
  /// The same, and appends to `visible` what of the occluder is above the horizon as it was, as a
  /// line number `line` that is drawn: of a tie that which no line is drawn along already.
  struct Raised {
    bool rises = false;
    bool is_tied = false; ///< with some of what stands
  };
  Raised raise(const HorizonPiece& occluder, const TieTolerance& tolerance, std::uint32_t line,
               std::vector<VisibleLinePart>& visible);
  /// Whether a source stands anywhere between two abscissae.
  bool shows(std::uint64_t source_id, double x_begin, double x_end) const;
  /// Marks a part of a block's piece number `at` as inked.
  void ink(std::size_t block, std::size_t at, double begin, double end);

  /// In one list, collapsed.
  Horizon joined() const;
  std::size_t size() const { return size_; } ///< pieces, collapsed

  std::size_t pieces_uncollapsed() const { return pieces_uncollapsed_; } ///< as made, in all
  std::size_t pieces_collapsed() const { return pieces_collapsed_; }     ///< as kept, in all

private:
  struct Stands;
  struct StandsSeen;
  // In a block: the part of an occluder and its lowest height, the pieces `first` to `past` - 1
  // that it meets, and the least of their bounds.
  struct Met {
    double begin, end, lowest_of_occluder;
    std::size_t first, past;
    float low_of_met;
  };
  void split_where_crowded();
  template <class Stand>
  bool raise_blocks(const HorizonPiece& occluder, double slack_y, const Stand& stand);
  template <class Stand>
  bool raise_block(std::size_t number, const HorizonPiece& occluder, double slack_y,
                   const Stand& stand);
  void replace(std::size_t number, const HorizonPiece& occluder, const Met& met);
  template <class Stand>
  bool raise_in_part(std::size_t number, const HorizonPiece& occluder, const Met& met,
                     const Stand& stand);
  std::size_t size_at(std::size_t number) const;

  double x_begin_, blocks_per_x_;
  std::vector<HorizonBlock> blocks_;
  struct PieceStretch {
    std::size_t piece;
    double x_begin, x_end;
    bool above;
  };
  std::vector<PieceStretch> stretches_; ///< scratch
  Horizon next_;                        ///< scratch
  std::size_t size_ = 1;
  std::size_t pieces_uncollapsed_ = 0, pieces_collapsed_ = 0;
};

/// Goes along the pieces of one block after another.
class BlockedCursor {
public:
  BlockedCursor(const BlockedHorizon& horizon, double x);
  explicit operator bool() const { return block_ != horizon_->blocks().size(); }
  const HorizonPiece& operator*() const { return horizon_->blocks()[block_].pieces[at_]; }
  const HorizonPiece* operator->() const { return &**this; }
  void operator++() {
    if (++at_ == horizon_->blocks()[block_].pieces.size()) {
      at_ = 0;
      ++block_;
    }
  }

private:
  const BlockedHorizon* horizon_;
  std::size_t block_, at_ = 0;
};

/// From the first piece that reaches to or beyond x.
inline BlockedCursor pieces_from(const BlockedHorizon& horizon, double x) {
  return {horizon, x};
}

} // namespace orograph
