// SPDX-License-Identifier: GPL-3.0-or-later
// What can be exchanged are the links between lines, so all is told by ends of lines and by what
// they are linked to. The route is a cycle: one more line leads from where it ends, which is
// anywhere, to where the pen begins. A part and the rest of a cycle are turned round alike, and the
// shorter of them is.
#include "draw/shorten_route.hpp"

#include "draw/point_tree.hpp"
#include "geometry/on_all_cores.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

namespace orograph {
namespace {

// Less is no gain: sums of lengths of a page are exact to a hundred-millionth of it.
constexpr double kLeastGain_mm = 1e-6;
constexpr std::size_t kNeighbours = 11; // ten, and the end that is anywhere
constexpr int kLongestMoved = 3;
// Turning round costs what the part is long, and few gains need more than this: of a million lines
// the way is 8 percent longer for it, in half the time.
constexpr std::uint32_t kLongestTurned = 100000;

// End 2 * line is an open line's first place, 2 * line + 1 its second; both are a ring's place.
using End = std::uint32_t;
constexpr End kNoEnd = ~End{0};

class Links {
public:
  Links(const PenLines& lines, Vec2 pen, const PenRoute& route)
      : count_(static_cast<std::uint32_t>(lines.size()) + 1), free_(2 * (count_ - 1)) {
    order_.reserve(count_);
    positions_.resize(count_);
    at_mm_.resize(2 * std::size_t{count_});
    order_.push_back(free_);
    at_mm_[free_] = at_mm_[free_ + 1] = pen;
    for (const std::uint32_t place : route) {
      const std::uint32_t line = lines.line_of(place), exit = lines.exit(place);
      const End entry = 2 * line + (place > exit ? 1 : 0);
      at_mm_[entry] = lines.at(place);
      at_mm_[entry ^ 1U] = lines.at(exit);
      positions_[line] = static_cast<std::uint32_t>(order_.size());
      order_.push_back(entry);
    }
    find_neighbours();
  }

  void shorten() {
    std::vector<bool> waits(count_, true);
    std::vector<std::uint32_t> waiting;
    waiting.reserve(count_);
    for (std::uint32_t i = count_; i-- > 0;) waiting.push_back(order_[i] / 2);
    touched_.clear();
    while (!waiting.empty()) {
      throw_if_stopped();
      const std::uint32_t line = waiting.back();
      waiting.pop_back();
      waits[line] = false;
      const auto gains = [&](End end) {
        return turns_part_at(end) || moves_from(end) || moves_to(end);
      };
      while (gains(2 * line) || gains(2 * line + 1)) {
      }
      for (const std::uint32_t other : touched_)
        if (!waits[other]) {
          waits[other] = true;
          waiting.push_back(other);
        }
      touched_.clear();
    }
  }

  /// The ends at which lines are begun, in order.
  std::vector<End> entries() const {
    std::vector<End> out;
    out.reserve(count_ - 1);
    const std::uint32_t begin = positions_[free_ / 2];
    const bool backwards = order_[begin] != free_;
    for (std::uint32_t i = 1; i < count_; ++i)
      out.push_back(backwards ? order_[(begin + count_ - i) % count_] ^ 1U
                              : order_[(begin + i) % count_]);
    return out;
  }

private:
  void find_neighbours() {
    neighbours_.resize(kNeighbours * at_mm_.size(), kNoEnd);
    PointTree tree(at_mm_);
    tree.remove(free_);
    constexpr std::size_t kEndsOfTask = 1024;
    on_all_cores((at_mm_.size() + kEndsOfTask - 1) / kEndsOfTask, [&](std::size_t task) {
      std::vector<std::uint32_t> near;
      const std::size_t last = std::min(at_mm_.size(), (task + 1) * kEndsOfTask);
      for (std::size_t end = task * kEndsOfTask; end < last; ++end) {
        tree.nearest(at_mm_[end], kNeighbours + 1, near); // with both of its own line
        std::size_t found = 0;
        if (end / 2 != free_ / 2) neighbours_[kNeighbours * end + found++] = free_;
        for (const std::uint32_t other : near)
          if (other / 2 != end / 2 && found < kNeighbours)
            neighbours_[kNeighbours * end + found++] = other;
      }
    });
  }

  bool is_entry(End end) const { return order_[positions_[end / 2]] == end; }
  End linked(End end) const {
    const std::uint32_t position = positions_[end / 2];
    return order_[position] == end ? order_[(position + count_ - 1) % count_] ^ 1U
                                   : order_[(position + 1) % count_];
  }
  double apart_mm(End a, End b) const {
    return a == free_ || b == free_ ? 0 : plain_length(at_mm_[a] - at_mm_[b]);
  }
  std::span<const End> neighbours(End end) const {
    return std::span(neighbours_).subspan(kNeighbours * end, kNeighbours);
  }

  // The part that is turned round when `a` is linked to `b`: both are entries, or neither is.
  struct Part {
    std::uint32_t first, count;
  };
  Part part_between(End a, End b) const {
    const std::uint32_t shift = is_entry(a) ? 0 : 1;
    const std::uint32_t first = (positions_[a / 2] + shift) % count_,
                        end = (positions_[b / 2] + shift) % count_;
    const std::uint32_t count = (end + count_ - first) % count_;
    return 2 * count <= count_ ? Part{first, count} : Part{end, count_ - count};
  }

  void link(End a, End b) {
    const auto [first, count] = part_between(a, b);
    std::uint32_t low = first, high = (first + count + count_ - 1) % count_;
    const auto put = [&](std::uint32_t position, End entry) {
      order_[position] = entry;
      positions_[entry / 2] = position;
    };
    for (std::uint32_t i = 0; i < count / 2; ++i) {
      const End to_low = order_[high] ^ 1U, to_high = order_[low] ^ 1U;
      put(low, to_low);
      put(high, to_high);
      low = low + 1 == count_ ? 0 : low + 1;
      high = high == 0 ? count_ - 1 : high - 1;
    }
    if (count % 2 == 1) put(low, order_[low] ^ 1U);
  }

  // 2-opt: from `a` to a nearer end than now.
  bool turns_part_at(End a) {
    const End from = linked(a);
    const double now_mm = apart_mm(a, from);
    for (const End b : neighbours(a)) {
      if (b == kNoEnd) break;
      const double new_mm = apart_mm(a, b);
      if (new_mm >= now_mm) break;
      const End to = linked(b);
      if (b == from || is_entry(a) != is_entry(b) ||
          now_mm + apart_mm(b, to) - new_mm - apart_mm(from, to) < kLeastGain_mm ||
          part_between(a, b).count > kLongestTurned)
        continue;
      link(a, b);
      for (const End end : {a, b, from, to}) touched_.push_back(end / 2);
      return true;
    }
    return false;
  }

  // Or-opt: one to three lines in a row, with `s` as an end, to beside `h`. Each of `s` and `h`
  // goes through its neighbours: by one of the two a move that gains begins with a link that gains.
  bool moves_from(End s) {
    const double now_mm = apart_mm(linked(s), s);
    return for_each_row(s, [&](End e, std::span<const std::uint32_t> row) {
      const double without_mm = gain_without(s, e);
      for (const End h : neighbours(s)) {
        if (h == kNoEnd || apart_mm(s, h) >= std::max(without_mm, now_mm)) break;
        if (moves(s, e, row, h)) return true;
      }
      return false;
    });
  }
  bool moves_to(End h) {
    const double now_mm = apart_mm(h, linked(h));
    for (const End s : neighbours(h)) {
      if (s == kNoEnd || apart_mm(s, h) >= now_mm) break;
      if (for_each_row(
              s, [&](End e, std::span<const std::uint32_t> row) { return moves(s, e, row, h); }))
        return true;
    }
    return false;
  }

  // Whether `take(e, lines)` is true of the lines from `s` on to an end `e`: one, two or three.
  template <class Take>
  bool for_each_row(End s, const Take& take) const {
    std::array<std::uint32_t, kLongestMoved> row{};
    End e = s ^ 1U;
    for (std::size_t count = 1; count <= row.size() && count + 2 <= count_; ++count) {
      row[count - 1] = e / 2;
      if (take(e, std::span<const std::uint32_t>(row).first(count))) return true;
      e = linked(e) ^ 1U;
    }
    return false;
  }

  // Of taking out what is from `s` to `e`.
  double gain_without(End s, End e) const {
    const End before = linked(s), after = linked(e);
    return apart_mm(before, s) + apart_mm(e, after) - apart_mm(before, after);
  }

  bool moves(End s, End e, std::span<const std::uint32_t> row, End h) {
    if (std::ranges::find(row, h / 2) != row.end()) return false;
    const End before = linked(s), after = linked(e), beyond = linked(h);
    if (beyond == s || beyond == e) return false; // it is there already
    const double added_mm = apart_mm(s, h) + apart_mm(e, beyond) - apart_mm(h, beyond);
    if (gain_without(s, e) - added_mm < kLeastGain_mm) return false;
    const bool h_is_first = is_entry(h) == is_entry(before); // of h and beyond, going from s to e
    const End near = h_is_first ? h : beyond;
    if (part_between(before, near).count > kLongestTurned) return false;
    // before s..e after..near far: from s to near is turned round, then from near to after; and
    // what is moved alone where it is to be linked to `near` by s.
    link(before, near);
    link(before, after);
    if (h_is_first) link(h, s);
    for (const End end : {before, after, s, e, h, beyond}) touched_.push_back(end / 2);
    return true;
  }

  std::uint32_t count_;    ///< of lines, with the one that closes the cycle
  End free_;               ///< the end of it that is anywhere; the other is where the pen begins
  std::vector<End> order_; ///< the end at which each line is begun
  std::vector<std::uint32_t> positions_; ///< of each line in that order
  std::vector<Vec2> at_mm_;              ///< each end
  std::vector<End> neighbours_;          ///< of each end, nearest first, then `kNoEnd`
  std::vector<std::uint32_t> touched_;   ///< lines whose links have changed
};

// Each ring where it costs least between its neighbours. Says whether that gained anything.
bool turn_rings(const PenLines& lines, Vec2 pen, PenRoute& route) {
  bool gained = false;
  for (std::size_t i = 0; i < route.size(); ++i) {
    const std::uint32_t line = lines.line_of(route[i]);
    if (lines.is_ring(line)) {
      throw_if_stopped();
      const auto cost_mm = [&](std::uint32_t place) {
        const double to_mm = plain_length(lines.at(place) - pen);
        if (i + 1 == route.size()) return to_mm;
        return to_mm + plain_length(lines.at(route[i + 1]) - lines.at(place));
      };
      double least_mm = cost_mm(route[i]) - kLeastGain_mm;
      for (std::uint32_t p = lines.first_place(line); p < lines.end_place(line); ++p)
        if (const double mm = cost_mm(p); mm < least_mm) {
          least_mm = mm;
          route[i] = p;
          gained = true;
        }
    }
    pen = lines.at(lines.exit(route[i]));
  }
  return gained;
}

} // namespace

PenRoute shortened(const PenLines& lines, Vec2 pen, const PenRoute& route) {
  PenRoute out = route;
  do {
    Links links(lines, pen, out);
    std::vector<std::uint32_t> ring_places(lines.size());
    for (const std::uint32_t place : out) ring_places[lines.line_of(place)] = place;
    links.shorten();
    out.clear();
    for (const End entry : links.entries()) {
      const std::uint32_t line = entry / 2;
      out.push_back(lines.is_ring(line) ? ring_places[line] : lines.first_place(line) + entry % 2);
    }
  } while (turn_rings(lines, pen, out));
  return out;
}

} // namespace orograph
