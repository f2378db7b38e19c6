// SPDX-License-Identifier: GPL-3.0-or-later
// Whether strips of cells on the earth have an order: a scan of all lines of the lattice.
#include "geometry/on_all_cores.hpp"
#include "profiles/earth_line.hpp"
#include "profiles/earth_strips.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace orograph {

// Takes some lines at a time.
class EarthStripsScan {
public:
  EarthStripsScan(const Grid& grid, const View& view, const LookedAt& looked, bool are_rows)
      : grid_(grid), out_(grid, view, looked, are_rows) {
    const DegreeLattice& degrees = grid.earth().degrees();
    const bool is_mirrored = (degrees.lon_step_deg > 0) == (degrees.lat_step_deg > 0);
    // Rows run to the right of the way to the next row, columns to the left, seen from above.
    next_is_left_ = are_rows == is_mirrored;
    out_.lower_is_right_ = !is_mirrored;
  }

  std::optional<EarthStrips> found() {
    const int tasks = (out_.strips() + kStripsOfTask - 1) / kStripsOfTask;
    std::vector<Found> found(static_cast<std::size_t>(tasks));
    on_all_cores(found.size(), [&](std::size_t task) {
      scan(static_cast<int>(task) * kStripsOfTask, found[task]);
    });
    if (!join(found) || !choose_own()) return std::nullopt;
    return std::move(out_);
  }

private:
  static constexpr int kStripsOfTask = 64;

  struct OfLine {
    int first = std::numeric_limits<int>::max(), last = -1; // edges looked at
    bool any_high = false, any_low = false; // the eye is on the side of higher numbers, or lower
  };
  struct Found {
    bool is_right = true;
    std::vector<OfLine> lines; // from the first of the task's
    FallingRuns falling;       // of the task's strips
  };

  void scan(int first, Found& out) {
    const int end = std::min(first + kStripsOfTask, out_.strips());
    out.lines.resize(static_cast<std::size_t>(end - first + 1));
    const EarthLine unread(grid_, out_.view_, out_.looked_, out_.are_rows_, next_is_left_);
    std::array<EarthLine, 2> lines{unread, unread};
    EarthLine *before = &lines[0], *behind = &lines[1];
    before->read(first, *before);
    put_blocks(first, *before);
    for (int strip = first; strip < end && out.is_right; ++strip) {
      throw_if_stopped();
      behind->read(strip + 1, *before);
      if (strip + 1 < end || end == out_.strips()) put_blocks(strip + 1, *behind);
      take(strip, *before, *behind, &out.lines[static_cast<std::size_t>(strip - first)], out);
      std::swap(before, behind);
    }
  }

  void put_blocks(int line, const EarthLine& of) {
    EarthStrips::Block* block =
        &out_.block_[static_cast<std::size_t>(line) * static_cast<std::size_t>(out_.blocks_)];
    for (int i = 0; i < out_.blocks_; ++i, ++block) {
      const Vec2 first = of.place(i * EarthStrips::kBlock);
      const auto [nearest_m, farthest_m] = of.depths(static_cast<std::size_t>(i));
      // Rounded to float outwards.
      constexpr double kFloat = 1e-6;
      *block = {out_.x_of({first.x, first.y, 0}),
                static_cast<float>(nearest_m - kFloat * std::abs(nearest_m)),
                static_cast<float>(farthest_m + kFloat * std::abs(farthest_m))};
    }
    EarthStrips::Line& ahead = out_.line_[static_cast<std::size_t>(line)];
    const std::vector<std::uint8_t>& beyond = of.beyond();
    std::uint8_t all = 0;
    for (std::uint8_t bits : beyond) all |= bits;
    if ((all & EarthLine::kBehind) == 0) { // mostly
      ahead.first_ahead = 0;
      ahead.last_ahead = static_cast<int>(beyond.size()) - 1;
      return;
    }
    const auto is_ahead = [](std::uint8_t bits) { return (bits & EarthLine::kBehind) == 0; };
    const auto first = std::ranges::find_if(beyond, is_ahead);
    const auto last = std::find_if_not(first, beyond.end(), is_ahead);
    ahead.first_ahead = static_cast<int>(first - beyond.begin());
    ahead.last_ahead = static_cast<int>(last - beyond.begin()) - 1;
    // In one piece, if it is to be looked at.
    if (std::find_if(last, beyond.end(), is_ahead) != beyond.end()) ahead.last_ahead = kBroken;
  }

  // What is in a strip of cells, and the lines on both sides of it.
  void take(int strip, const EarthLine& a, const EarthLine& b, OfLine* lines, Found& out) {
    const auto cells = static_cast<std::size_t>(out_.cells());
    const std::uint8_t *const a_beyond = a.beyond().data(), *const b_beyond = b.beyond().data(),
                              *const a_sides = a.sides().data(), *const b_sides = b.sides().data();
    const auto is_looked_at = [&](std::size_t i) {
      return (a_beyond[i] & a_beyond[i + 1] & b_beyond[i] & b_beyond[i + 1]) == 0;
    };
    std::size_t first = 0, end = cells;
    while (first < cells && !is_looked_at(first)) ++first;
    while (end > first && !is_looked_at(end - 1)) --end;
    out.falling.begin_strip();
    if (first == end) return;
    std::uint8_t of_a = 0, of_b = 0, broken = 0;
    for (std::size_t i = first; i < end; ++i) {
      of_a |= a_sides[i];
      of_b |= b_sides[i];
      broken |= is_looked_at(i) ? 0 : 1;
    }
    if (broken) {
      out.is_right = false;
      return;
    }
    out_.looked_at_[static_cast<std::size_t>(strip)] = {static_cast<int>(first),
                                                        static_cast<int>(end)};
    for (const auto& [line, sides] : {std::pair{lines, of_a}, std::pair{lines + 1, of_b}}) {
      line->first = std::min(line->first, static_cast<int>(first));
      line->last = std::max(line->last, static_cast<int>(end) - 1);
      line->any_high = line->any_high || (sides & EarthLine::kHigh) != 0;
      line->any_low = line->any_low || (sides & EarthLine::kLow) != 0;
      if (line->any_high && line->any_low) out.is_right = false;
    }
    if (!out.is_right) return;
    if (!a.are_apart(b, static_cast<int>(first), static_cast<int>(end))) {
      out.is_right = false;
      return;
    }
    // An upright has the cell with the higher number on the side that the next line is on of
    // an edge along the strip, turned.
    thread_local std::vector<std::uint8_t> falls;
    falls.resize(cells);
    a.find_falls(b, static_cast<int>(first) + 1, static_cast<int>(end), falls);
    const auto begin = falls.begin();
    for (auto at = begin + static_cast<std::ptrdiff_t>(first) + 1,
              last = begin + static_cast<std::ptrdiff_t>(end);
         (at = std::find(at, last, 1)) < last;) {
      const auto behind = std::find(at, last, 0);
      out.falling.add({static_cast<int>(at - begin) - 1, static_cast<int>(behind - begin) - 1});
      at = behind;
    }
  }

  bool join(std::vector<Found>& found) {
    lines_.resize(static_cast<std::size_t>(out_.lines_));
    for (std::size_t task = 0; task < found.size(); ++task) {
      const Found& of = found[task];
      if (!of.is_right) return false;
      for (std::size_t i = 0; i < of.lines.size(); ++i) {
        OfLine& line = lines_[task * kStripsOfTask + i];
        const OfLine& more = of.lines[i];
        line.first = std::min(line.first, more.first);
        line.last = std::max(line.last, more.last);
        line.any_high = line.any_high || more.any_high;
        line.any_low = line.any_low || more.any_low;
        if (line.any_high && line.any_low) return false;
      }
      out_.falling_.append(of.falling);
    }
    return true;
  }

  // The lines with the eye on the side of higher numbers come first in number, and no ray meets any
  // of them and any of the others as well.
  bool choose_own() {
    constexpr XRange kNone{kInfinity, -kInfinity};
    int last_high = -1, first_low = out_.lines_;
    XRange of_high = kNone, of_low = kNone, before = kNone;
    for (int i = 0; i < out_.lines_; ++i) {
      const OfLine& line = lines_[static_cast<std::size_t>(i)];
      EarthStrips::Line& of = out_.line_[static_cast<std::size_t>(i)];
      if (line.last < 0) {
        of.last_ahead = of.first_ahead - 1;
        before = kNone;
        continue;
      }
      if (of.last_ahead == kBroken) return false;
      of.first = line.first;
      of.last = line.last + 1;
      of.first_ahead = std::max(of.first_ahead, of.first);
      of.last_ahead = std::min(of.last_ahead, of.last);
      // Whether the next line is on the left of it as the eye sees it is as X rises.
      of.rises = line.any_high != next_is_left_;
      if (line.any_high && last_high < i - 1) before = kNone;
      if (line.any_low && first_low == out_.lines_) before = kNone;
      if (line.any_high) last_high = i;
      if (line.any_low) first_low = std::min(first_low, i);
      const XRange x = x_of_line(i);
      if (!(x.begin < x.end)) {
        before = kNone;
        continue;
      }
      XRange& side = line.any_high ? of_high : of_low;
      side = {std::min(side.begin, x.begin), std::max(side.end, x.end)};
      // Where one shares no X with the next there would be no order between them.
      if (before.begin < before.end && (before.end <= x.begin || x.end <= before.begin))
        return false;
      before = x;
    }
    if (last_high > first_low) return false;
    if (of_high.begin < of_low.end && of_low.begin < of_high.end) return false;
    out_.own_ = last_high;
    for (int strip = 0; strip < out_.strips(); ++strip) {
      const EarthStrips::Cells cells = out_.cells_of(strip);
      if (cells.empty()) continue;
      const auto a = out_.depths_of(strip, cells), b = out_.depths_of(strip + 1, cells);
      out_.depths_[static_cast<std::size_t>(strip)] = {std::min(a.nearest_m, b.nearest_m),
                                                       std::max(a.farthest_m, b.farthest_m)};
    }
    return true;
  }

  // Of what is looked at of a line, as far as that is ahead and in the range.
  XRange x_of_line(int line) const {
    const EarthStrips::Line& of = out_.line_[static_cast<std::size_t>(line)];
    if (of.first_ahead > of.last_ahead) return {kInfinity, -kInfinity};
    const auto x_at_end = [&](int ahead, int beyond) {
      ProfilePoint p = out_.filled_vertex(line, ahead);
      if (beyond >= of.first && beyond <= of.last) { // behind
        const ProfilePoint q = out_.filled_vertex(line, beyond);
        p = point_between(p, q, (out_.looked_.from_m - p.v) / (q.v - p.v));
      }
      return out_.x_of(p);
    };
    const auto [begin, end] = std::minmax(
        {x_at_end(of.first_ahead, of.first_ahead - 1), x_at_end(of.last_ahead, of.last_ahead + 1)});
    return {std::max(begin, out_.looked_.range.begin), std::min(end, out_.looked_.range.end)};
  }

  static constexpr int kBroken = -2;
  const Grid& grid_;
  EarthStrips out_;
  bool next_is_left_;
  std::vector<OfLine> lines_;
};

std::optional<EarthStrips> EarthStrips::of(const Grid& grid, const View& view,
                                           const LookedAt& looked, bool are_rows) {
  return EarthStripsScan(grid, view, looked, are_rows).found();
}

std::optional<EarthStrips> EarthStrips::of(const Grid& grid, const View& view,
                                           const LookedAt& looked) {
  const int column = grid.columns / 2, row = grid.rows / 2;
  const auto at = [&](int c, int r) {
    const ProfilePoint p = to_profile_frame(view, grid.earth().vertex_m(c, r, 0));
    return Vec2{p.u, p.v};
  };
  const Vec2 along_row = at(column, row) - at(column - 1, row),
             along_column = at(column, row) - at(column, row - 1);
  // Depth changes less along those that are crossed more steeply.
  const bool rows_first =
      std::abs(along_row.y) * length(along_column) <= std::abs(along_column.y) * length(along_row);
  std::optional<EarthStrips> out = of(grid, view, looked, rows_first);
  return out ? std::move(out) : of(grid, view, looked, !rows_first);
}

} // namespace orograph
