// SPDX-License-Identifier: GPL-3.0-or-later
#include "horizon/blocked_horizon.hpp"

#include "horizon/clip_step.hpp"
#include "horizon/horizon_pieces.hpp"

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

// By what pieces collapse.
struct Collapsing {
  std::uint64_t source;
  bool inked;
  bool operator==(const Collapsing&) const = default;
};
Collapsing collapsing(const HorizonPiece& piece) {
  return {piece.source.id, piece.inked};
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

void BlockedHorizon::raise(const HorizonPiece& occluder) {
  for (std::size_t i = block_at(occluder.x_begin);
       i < blocks_.size() && blocks_[i].x_begin < occluder.x_end; ++i)
    raise_block(i, occluder);
}

// Changes the pieces of a block and keeps count of them; neighbouring blocks are looked at only
// where an end has changed.
template <class Change>
void BlockedHorizon::change(std::size_t number, const Change& make) {
  Horizon& pieces = blocks_[number].pieces;
  const Collapsing first = collapsing(pieces.front()), last = collapsing(pieces.back());
  size_ -= pieces.size();
  make(pieces);
  size_ += pieces.size();
  const auto at_end = [&](Collapsing before, Collapsing after, const HorizonPiece& neighbour) {
    const Collapsing beside = collapsing(neighbour);
    size_ += beside == before ? 1 : 0;
    size_ -= beside == after ? 1 : 0;
  };
  const Collapsing first_now = collapsing(pieces.front()), last_now = collapsing(pieces.back());
  if (number > 0 && first_now != first) at_end(first, first_now, blocks_[number - 1].pieces.back());
  if (number + 1 < blocks_.size() && last_now != last)
    at_end(last, last_now, blocks_[number + 1].pieces.front());
}

void BlockedHorizon::raise_block(std::size_t number, const HorizonPiece& occluder) {
  HorizonBlock& block = blocks_[number];
  const Segment& source = occluder.source;
  const double begin = std::max(occluder.x_begin, block.x_begin);
  const double end = std::min(occluder.x_end, block.x_end);
  if (!(begin < end)) return;
  const double at_begin = height_at(source, begin), at_end = height_at(source, end);
  const double highest = std::max(at_begin, at_end);
  if (highest < block.low) return;
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
  if (!rises) return;
  if (k < pieces.size()) append(next_, pieces[k++], true);
  if (i > 0) --i;
  pieces_collapsed_ += next_.size();
  change(number, [&](Horizon& list) {
    const auto place = list.begin() + static_cast<std::ptrdiff_t>(i);
    const std::size_t old = k - i, kept = std::min(old, next_.size());
    std::copy_n(next_.begin(), kept, place);
    const auto behind = place + static_cast<std::ptrdiff_t>(kept);
    if (next_.size() > old)
      list.insert(behind, next_.begin() + static_cast<std::ptrdiff_t>(kept), next_.end());
    else
      list.erase(behind, behind + static_cast<std::ptrdiff_t>(old - kept));
  });
  block.high = std::max(block.high, highest);
  block.low = lowest(pieces);
}

void BlockedHorizon::ink(std::size_t block, std::size_t at, double begin, double end) {
  change(block, [&](Horizon& pieces) { orograph::ink(pieces, at, begin, end, true); });
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
