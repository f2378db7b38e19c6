// SPDX-License-Identifier: GPL-3.0-or-later
#include "horizon/blocked_horizon.hpp"

#include "horizon/clip_step.hpp"
#include "horizon/horizon.hpp"

#include <algorithm>
#include <limits>

namespace orograph {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

double lowest(const Horizon& pieces) {
  double low = kInfinity;
  for (const HorizonPiece& piece : pieces) {
    if (is_sky(piece)) return -kInfinity;
    low = std::min(
        {low, height_at(piece.source, piece.x_begin), height_at(piece.source, piece.x_end)});
  }
  return low;
}

} // namespace

BlockedHorizon::BlockedHorizon(double x_begin, double x_end, std::size_t count, double first,
                               double last)
    : x_begin_(x_begin), blocks_per_x_(static_cast<double>(count) / (x_end - x_begin)) {
  HorizonPiece sky = initial_horizon().front();
  sky.x_begin = first;
  for (std::size_t i = 0; i < count; ++i) {
    const double next = x_begin + static_cast<double>(i + 1) / blocks_per_x_;
    sky.x_end = i + 1 < count ? next : last;
    blocks_.push_back({sky.x_begin, sky.x_end, -kInfinity, -kInfinity, {sky}});
    sky.x_begin = sky.x_end;
  }
}

std::size_t BlockedHorizon::block_at(double x) const {
  const double last = static_cast<double>(blocks_.size() - 1);
  auto block = static_cast<std::size_t>(std::clamp((x - x_begin_) * blocks_per_x_, 0.0, last));
  while (block > 0 && x < blocks_[block].x_begin) --block;
  while (block + 1 < blocks_.size() && x >= blocks_[block].x_end) ++block;
  return block;
}

bool BlockedHorizon::raise(const HorizonPiece& occluder) {
  bool rises = false;
  for (std::size_t i = block_at(occluder.x_begin);
       i < blocks_.size() && blocks_[i].x_begin < occluder.x_end; ++i)
    if (raise_block(i, occluder)) rises = true;
  return rises;
}

bool BlockedHorizon::shows(std::uint64_t source_id, double x_begin, double x_end) const {
  for (std::size_t i = block_at(x_begin); i < blocks_.size() && blocks_[i].x_begin <= x_end; ++i)
    for (const HorizonPiece& piece : blocks_[i].pieces)
      if (piece.source.id == source_id && piece.x_begin <= x_end && piece.x_end >= x_begin)
        return true;
  return false;
}

// Of the collapsed pieces, those of a block and of its ends.
std::size_t BlockedHorizon::size_at(std::size_t number) const {
  const Horizon& pieces = blocks_[number].pieces;
  std::size_t ends = 0; // that are none
  if (number > 0) ends += continues(blocks_[number - 1].pieces.back(), pieces.front()) ? 1 : 0;
  if (number + 1 < blocks_.size())
    ends += continues(pieces.back(), blocks_[number + 1].pieces.front()) ? 1 : 0;
  return 2 + pieces.size() - ends;
}

bool BlockedHorizon::raise_block(std::size_t number, const HorizonPiece& occluder) {
  HorizonBlock& block = blocks_[number];
  const Segment& source = occluder.source;
  const double begin = std::max(occluder.x_begin, block.x_begin);
  const double end = std::min(occluder.x_end, block.x_end);
  if (!(begin < end)) return false;
  const double at_begin = height_at(source, begin), at_end = height_at(source, end);
  const double highest = std::max(at_begin, at_end);
  if (highest < block.low) return false;
  Horizon& pieces = block.pieces;
  // Pieces i to k - 1 meet the occluder; one more on either side may collapse with what is new.
  std::size_t i = 0;
  while (pieces[i].x_end <= begin) ++i;
  std::size_t k = i;
  bool rises = false;
  next_.clear();
  if (i > 0) next_.push_back(pieces[i - 1]);
  const auto write = [&](const HorizonPiece& piece, double from, double to) {
    if (!(from < to)) return;
    ++pieces_uncollapsed_;
    HorizonPiece part = piece;
    part.x_begin = from;
    part.x_end = to;
    append(next_, part, true);
  };
  for (; k < pieces.size() && pieces[k].x_begin < end; ++k) {
    const HorizonPiece& piece = pieces[k];
    const double from = std::max(piece.x_begin, begin), to = std::min(piece.x_end, end);
    write(piece, piece.x_begin, from);
    const Step step = resolve(source, piece, from, to, true, {});
    for (int n = 0; n < step.count; ++n) {
      const Stretch& s = step.stretches[static_cast<std::size_t>(n)];
      rises = rises || s.above;
      write(s.above ? occluder : piece, s.x_begin, s.x_end);
    }
    write(piece, to, piece.x_end);
  }
  if (!rises) return false;
  if (k < pieces.size()) append(next_, pieces[k++], true);
  if (i > 0) --i;
  pieces_collapsed_ += next_.size();
  const std::size_t before = size_at(number);
  const auto place = pieces.begin() + static_cast<std::ptrdiff_t>(i);
  const std::size_t old = k - i, kept = std::min(old, next_.size());
  std::copy_n(next_.begin(), kept, place);
  const auto behind = place + static_cast<std::ptrdiff_t>(kept);
  if (next_.size() > old)
    pieces.insert(behind, next_.begin() + static_cast<std::ptrdiff_t>(kept), next_.end());
  else
    pieces.erase(behind, behind + static_cast<std::ptrdiff_t>(old - kept));
  size_ += size_at(number) - before;
  block.high = std::max(block.high, highest);
  block.low = lowest(pieces);
  return true;
}

void BlockedHorizon::ink(std::size_t block, std::size_t at, double begin, double end) {
  const std::size_t before = size_at(block);
  orograph::ink(blocks_[block].pieces, at, begin, end, true);
  size_ += size_at(block) - before;
}

Horizon BlockedHorizon::joined() const {
  Horizon pieces;
  for (const HorizonBlock& block : blocks_)
    for (const HorizonPiece& piece : block.pieces) append(pieces, piece, true);
  return pieces;
}

BlockedCursor::BlockedCursor(const BlockedHorizon& horizon, double x)
    : horizon_(&horizon), block_(horizon.block_at(x)) {
  const auto& blocks = horizon.blocks();
  // Where two blocks meet, the left one's last piece reaches to x, too.
  if (block_ > 0 && x == blocks[block_].x_begin) --block_;
  while (blocks[block_].pieces[at_].x_end < x) ++at_;
}

} // namespace orograph
