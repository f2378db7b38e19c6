// SPDX-License-Identifier: GPL-3.0-or-later
#include "horizon/blocked_horizon.hpp"

#include "horizon/horizon.hpp"
#include "horizon/take_above.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace orograph {
namespace {

float lowest(const Horizon& pieces) {
  float low = std::numeric_limits<float>::infinity();
  for (const HorizonPiece& piece : pieces) low = std::min(low, piece.low);
  return low;
}

// Below a height, whatever float rounds off.
float below(double height) {
  constexpr double kMost = std::numeric_limits<float>::max();
  return static_cast<float>(std::clamp(height - 2e-7 * std::abs(height) - 1e-40, -kMost, kMost));
}

// Below all heights of a piece.
float low_of(const HorizonPiece& piece) {
  if (is_sky(piece)) return -std::numeric_limits<float>::infinity();
  return below(
      std::min(height_at(piece.source, piece.x_begin), height_at(piece.source, piece.x_end)));
}

// Makes pieces `first` to `past` - 1 so many; what those are is left open.
void make_room(Horizon& pieces, std::size_t first, std::size_t past, std::size_t count) {
  const std::size_t old = past - first, before = pieces.size();
  const auto at = [&](std::size_t i) { return pieces.begin() + static_cast<std::ptrdiff_t>(i); };
  if (count > old) {
    for (std::size_t i = old; i < count; ++i) pieces.push_back(HorizonPiece{pieces.back()});
    std::copy_backward(at(past), at(before), pieces.end());
  } else if (count < old) {
    std::copy(at(past), pieces.end(), at(first + count));
    pieces.erase(pieces.end() - static_cast<std::ptrdiff_t>(old - count), pieces.end());
  }
}

} // namespace

void append(std::vector<VisibleLinePart>& parts, std::uint32_t line, double begin, double end) {
  if (!(begin < end)) return;
  if (!parts.empty() && parts.back().line == line && parts.back().t_end == begin)
    parts.back().t_end = end;
  else
    parts.push_back({line, begin, end});
}

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

// Blocks have a few pieces each where a scene's lines are some cells wide. What is far narrower on
// the page than what is near, as along a strip of ground, fills them by hundreds, through which
// every raise would go: a strip of 20 x 65,536 heights seen along its length takes a quarter of the
// time.
void BlockedHorizon::split_where_crowded() {
  constexpr std::size_t kCrowded = 24; // pieces a block, on average
  if (size_ <= kCrowded * blocks_.size()) return;
  const double per_x = 2 * blocks_per_x_;
  const double x_end = x_begin_ + static_cast<double>(blocks_.size()) / blocks_per_x_;
  if (!(1 > 1e-12 * per_x * std::max(std::abs(x_begin_), std::abs(x_end)))) return; // of rounding
  std::vector<HorizonBlock> halves;
  halves.reserve(2 * blocks_.size());
  for (std::size_t i = 0; i < blocks_.size(); ++i) {
    HorizonBlock& left = blocks_[i];
    const double middle = x_begin_ + static_cast<double>(2 * i + 1) / per_x;
    HorizonBlock right{middle, left.x_end, left.low, left.high, {}};
    const auto cut = std::ranges::find_if(
        left.pieces, [&](const HorizonPiece& piece) { return piece.x_end > middle; });
    right.pieces.assign(cut, left.pieces.end());
    const bool is_parted = cut->x_begin < middle;
    left.pieces.erase(cut + (is_parted ? 1 : 0), left.pieces.end());
    left.x_end = middle;
    if (is_parted) {
      left.pieces.back().x_end = right.pieces.front().x_begin = middle;
      left.pieces.back().low = low_of(left.pieces.back());
      right.pieces.front().low = low_of(right.pieces.front());
    }
    for (HorizonBlock* half : {&left, &right}) {
      half->low = lowest(half->pieces);
      halves.push_back(std::move(*half));
    }
  }
  blocks_ = std::move(halves);
  blocks_per_x_ = per_x;
}

// How an occluder stands to the pieces that it meets.
struct BlockedHorizon::Stands {
  const Segment& occluder;
  Standing operator()(const HorizonPiece& piece) const { return compare(occluder, piece, {}); }
  void see_all(double, double) const {}
  Standing see_of(const HorizonPiece& piece, double, double) const { return (*this)(piece); }
};

// The same, and what of it is seen.
struct BlockedHorizon::StandsSeen {
  const Segment& occluder;
  const TieTolerance& tolerance;
  std::uint32_t line;
  std::vector<VisibleLinePart>& visible;
  bool& is_tied;

  Standing operator()(const HorizonPiece& piece) const {
    return compare(occluder, piece, tolerance);
  }
  // All between two abscissae is above what stands.
  void see_all(double x_begin, double x_end) const {
    append(visible, line, parameter_at(occluder, x_begin), parameter_at(occluder, x_end));
  }
  // What is above a piece between two abscissae; tells how the occluder stands to it exactly.
  Standing see_of(const HorizonPiece& piece, double x_begin, double x_end) const {
    const Standing standing = (*this)(piece);
    take_above(standing, occluder, piece, x_begin, x_end,
               [&](double begin, double end) { append(visible, line, begin, end); });
    if (standing.kind != Standing::Kind::tied) return standing;
    is_tied = true;
    return compare(occluder, piece.source, {});
  }
};

template <class Stand>
bool BlockedHorizon::raise_blocks(const HorizonPiece& occluder, double slack_y,
                                  const Stand& stand) {
  split_where_crowded();
  bool rises = false;
  for (std::size_t i = block_at(occluder.x_begin);
       i < blocks_.size() && blocks_[i].x_begin < occluder.x_end; ++i)
    if (raise_block(i, occluder, slack_y, stand)) rises = true;
  return rises;
}

bool BlockedHorizon::raise(const HorizonPiece& occluder) {
  return raise_blocks(occluder, 0, Stands{occluder.source});
}

BlockedHorizon::Raised BlockedHorizon::raise(const HorizonPiece& occluder,
                                             const TieTolerance& tolerance, std::uint32_t line,
                                             std::vector<VisibleLinePart>& visible) {
  Raised out;
  out.rises = raise_blocks(occluder, tolerance.greatest_y,
                           StandsSeen{occluder.source, tolerance, line, visible, out.is_tied});
  return out;
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

template <class Stand>
bool BlockedHorizon::raise_block(std::size_t number, const HorizonPiece& occluder, double slack_y,
                                 const Stand& stand) {
  HorizonBlock& block = blocks_[number];
  const double begin = std::max(occluder.x_begin, block.x_begin);
  const double end = std::min(occluder.x_end, block.x_end);
  if (!(begin < end)) return false;
  const double at_begin = height_at(occluder.source, begin),
               at_end = height_at(occluder.source, end);
  const double highest = std::max(at_begin, at_end);
  if (highest + slack_y < block.low) return false;
  const Horizon& pieces = block.pieces;
  Met met{begin, end, std::min(at_begin, at_end), 0, 0, std::numeric_limits<float>::infinity()};
  while (pieces[met.first].x_end <= begin) ++met.first;
  met.past = met.first;
  constexpr auto only = [](Standing::Kind kind) { return 1U << static_cast<unsigned>(kind); };
  unsigned kinds = 0;
  do {
    const HorizonPiece& piece = pieces[met.past];
    kinds |= only(stand(piece).kind);
    met.low_of_met = std::min(met.low_of_met, piece.low);
    ++met.past;
  } while (met.past < pieces.size() && pieces[met.past].x_begin < end);
  // It is above all that it meets nearly four times in five.
  if (kinds == only(Standing::Kind::below)) return false;
  if (kinds == only(Standing::Kind::above)) {
    stand.see_all(begin, end);
    replace(number, occluder, met);
  } else if (!raise_in_part(number, occluder, met, stand)) {
    return false;
  }
  block.high = std::max(block.high, highest);
  return true;
}

// All that an occluder meets, by it; what is left of the pieces at its ends stays.
void BlockedHorizon::replace(std::size_t number, const HorizonPiece& occluder, const Met& met) {
  const auto& [begin, end, lowest_of_occluder, first, past, low_of_met] = met;
  HorizonBlock& block = blocks_[number];
  Horizon& pieces = block.pieces;
  const HorizonPiece left = pieces[first], right = pieces[past - 1];
  const std::size_t head = left.x_begin < begin ? 1 : 0, tail = end < right.x_end ? 1 : 0,
                    count = head + 1 + tail;
  // What collapses with the blocks beside it.
  const bool at_ends = (first == 0 && head == 0) || (past == pieces.size() && tail == 0);
  const std::size_t before = at_ends ? size_at(number) : pieces.size();
  make_room(pieces, first, past, count);
  HorizonPiece* at = &pieces[first];
  const float low_of_occluder = below(lowest_of_occluder);
  float low_new = low_of_occluder;
  const auto put = [&](const HorizonPiece& piece, double from, double to) {
    *at = piece;
    at->x_begin = from;
    at->x_end = to;
    at->low = low_of(*at);
    low_new = std::min(low_new, at->low);
    ++at;
  };
  if (head) put(left, left.x_begin, begin);
  *at = occluder;
  at->x_begin = begin;
  at->x_end = end;
  at->low = low_of_occluder;
  ++at;
  if (tail) put(right, end, right.x_end);
  pieces_uncollapsed_ += head + (past - first) + tail;
  pieces_collapsed_ += count + (first > 0 ? 1 : 0) + (first + count < pieces.size() ? 1 : 0);
  size_ += (at_ends ? size_at(number) : pieces.size()) - before;
  // The lowest piece is looked for only if it may be one of those that have gone.
  block.low = low_of_met > block.low ? std::min<double>(block.low, low_new) : lowest(pieces);
}

// Where it is above some that it meets, or tied.
template <class Stand>
bool BlockedHorizon::raise_in_part(std::size_t number, const HorizonPiece& occluder, const Met& met,
                                   const Stand& stand) {
  HorizonBlock& block = blocks_[number];
  Horizon& pieces = block.pieces;
  auto [begin, end, lowest_of_occluder, first, past, low_of_met] = met;
  bool rises = false, all_rises = true;
  stretches_.clear();
  for (std::size_t i = first; i < past; ++i) {
    const HorizonPiece& piece = pieces[i];
    const double from = std::max(piece.x_begin, begin), to = std::min(piece.x_end, end);
    const Standing standing = stand.see_of(piece, from, to);
    const auto add = [&](double x_begin, double x_end, bool above) {
      rises = rises || above;
      all_rises = all_rises && above;
      stretches_.push_back({i, x_begin, x_end, above});
    };
    using enum Standing::Kind;
    const bool falls = standing.kind == above_then_below;
    if (!falls && standing.kind != below_then_above) {
      add(from, to, standing.kind == above); // what is tied stays
    } else if (standing.x <= from || standing.x >= to) {
      add(from, to, falls == (standing.x >= to));
    } else {
      add(from, standing.x, falls);
      add(standing.x, to, !falls);
    }
  }
  if (!rises) return false;
  if (all_rises) {
    replace(number, occluder, met);
    return true;
  }
  const std::size_t before = size_at(number);
  const HorizonPiece left = pieces[first], right = pieces[past - 1];
  // One more on either side may collapse with what is new.
  next_.clear();
  if (first > 0) next_.push_back(pieces[first - 1]);
  const auto write = [&](const HorizonPiece& piece, double from, double to) {
    if (!(from < to)) return;
    ++pieces_uncollapsed_;
    HorizonPiece part = piece;
    part.x_begin = from;
    part.x_end = to;
    part.low = low_of(part);
    append(next_, part, true);
  };
  write(left, left.x_begin, begin);
  for (const auto& [piece, x_begin, x_end, above] : stretches_)
    write(above ? occluder : pieces[piece], x_begin, x_end);
  write(right, end, right.x_end);
  if (past < pieces.size()) append(next_, pieces[past++], true);
  if (first > 0) --first;
  pieces_collapsed_ += next_.size();
  make_room(pieces, first, past, next_.size());
  std::copy(next_.begin(), next_.end(), pieces.begin() + static_cast<std::ptrdiff_t>(first));
  size_ += size_at(number) - before;
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
