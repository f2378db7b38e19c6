// SPDX-License-Identifier: GPL-3.0-or-later
#include "draw/join_strokes.hpp"

#include "draw/chain.hpp"
#include "draw/simplify.hpp"
#include "geometry/on_all_cores.hpp"
#include "geometry/sort_by_number.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <mutex>
#include <span>
#include <vector>

namespace orograph {
namespace {

// End number 2 * stroke is the stroke's first point, 2 * stroke + 1 its last.
struct StrokeEnd {
  Vec2 at_mm, onwards; ///< the place, and the direction in which the line would go on
  std::uint64_t cell;
  std::uint32_t end;
};

struct EndPair {
  double cost_mm;
  std::uint32_t a, b; ///< a < b
};

// The bend of a line near its end, of the size of a cell, says nothing about where it goes.
constexpr double kDirectionOver_mm = 0.5;

Vec2 direction_at(std::span<const Vec2> points, bool is_last) {
  const auto at = [&](std::size_t i) {
    return is_last ? points[points.size() - 1 - i] : points[i];
  };
  Vec2 away = at(0) - at(1);
  for (std::size_t i = 1; i < points.size(); ++i) {
    away = at(0) - at(i);
    if (plain_length(away) >= kDirectionOver_mm) break;
  }
  const double size = plain_length(away);
  return size > 0 ? (1 / size) * away : Vec2{0, 0};
}

// All ends, by square cells as large as the gap: numbers that rise along a row of them.
class EndsByCell {
public:
  EndsByCell(const Layer& layer, double gap_mm) : layer_(layer), gap_mm_(gap_mm) {
    for (const Stroke& stroke : layer.strokes)
      for (const Vec2& p : {layer.points(stroke).front(), layer.points(stroke).back()})
        low_ = {std::min(low_.x, p.x), std::min(low_.y, p.y)};
    ends_.reserve(2 * layer.strokes.size());
    for (std::uint32_t i = 0; i < layer.strokes.size(); ++i) {
      throw_if_stopped(i);
      const std::span<const Vec2> points = layer.points(layer.strokes[i]);
      for (const bool is_last : {false, true}) {
        const Vec2 at = is_last ? points.back() : points.front();
        ends_.push_back(
            {at, direction_at(points, is_last), cell(at.x, at.y), 2 * i + (is_last ? 1U : 0U)});
      }
    }
    sort_by_number(ends_, [](const StrokeEnd& end) { return end.cell; });
  }

  std::vector<EndPair> pairs() {
    constexpr std::size_t kEndsOfTask = 4096;
    std::vector<std::vector<EndPair>> of_tasks((ends_.size() + kEndsOfTask - 1) / kEndsOfTask);
    on_all_cores(of_tasks.size(), [&](std::size_t task) {
      const std::size_t first = task * kEndsOfTask,
                        end = std::min(first + kEndsOfTask, ends_.size());
      FirstBeside beside = first_beside(ends_[first]);
      for (std::size_t i = first; i < end; ++i)
        for (const Ranked& best : best_of(ends_[i], beside))
          if (best.pair.a != best.pair.b) of_tasks[task].push_back(best.pair);
    });
    std::vector<EndPair> out;
    for (const auto& some : of_tasks) out.insert(out.end(), some.begin(), some.end());
    const auto before = [](const EndPair& p, const EndPair& q) {
      if (p.cost_mm != q.cost_mm) return p.cost_mm < q.cost_mm;
      return p.a != q.a ? p.a < q.a : p.b < q.b;
    };
    std::sort(out.begin(), out.end(), before);
    return out;
  }

private:
  static constexpr std::size_t kNeighbours = 4;
  static constexpr std::uint64_t kCellsARow = std::uint64_t{1} << 31U;
  static constexpr std::size_t kMostScanned = 256; // more is a crowd
  static constexpr int kRowsAGap = 32;

  std::uint64_t cell(double x_mm, double y_mm) const {
    const auto along = [&](double mm, double low) { // from 1 on, so that each has a neighbour
      return 1 + static_cast<std::uint64_t>(std::max(0.0, std::floor((mm - low) / gap_mm_)));
    };
    return along(y_mm, low_.y) * kCellsARow + along(x_mm, low_.x);
  }

  // Of several that cost the same the one with the lowest number in `ends_` comes first.
  struct Ranked {
    EndPair pair;
    std::size_t number;

    bool operator<(const Ranked& other) const {
      return pair.cost_mm != other.pair.cost_mm ? pair.cost_mm < other.pair.cost_mm
                                                : number < other.number;
    }
  };
  using Best = std::array<Ranked, kNeighbours>;

  // Where the ends beside an end begin, in the row above, its own and the one below: from one end
  // to the next they only move on.
  using FirstBeside = std::array<std::size_t, 3>;
  FirstBeside first_beside(const StrokeEnd& end) const {
    FirstBeside out;
    std::uint64_t middle = end.cell - kCellsARow;
    for (std::size_t& first : out) {
      const auto at = std::partition_point(ends_.begin(), ends_.end(),
                                           [&](const StrokeEnd& e) { return e.cell + 1 < middle; });
      first = static_cast<std::size_t>(at - ends_.begin());
      middle += kCellsARow;
    }
    return out;
  }

  Best best_of(const StrokeEnd& end, FirstBeside& beside) {
    Best best;
    best.fill({{std::numeric_limits<double>::infinity(), end.end, end.end}, ends_.size()});
    std::size_t left = kMostScanned;
    std::uint64_t middle = end.cell - kCellsARow;
    for (std::size_t& first : beside) {
      while (first < ends_.size() && ends_[first].cell + 1 < middle) ++first;
      for (std::size_t other = first; other < ends_.size() && ends_[other].cell <= middle + 1;
           ++other) {
        if (left-- == 0) return best_in_crowd(end);
        take(end, other, best);
      }
      middle += kCellsARow;
    }
    return best;
  }

  void take(const StrokeEnd& end, std::size_t number, Best& best) const {
    const StrokeEnd& other = ends_[number];
    const double apart_mm = plain_length(other.at_mm - end.at_mm);
    if (other.end == end.end || !(apart_mm <= gap_mm_) || closes_crumb(end, other)) return;
    // Turning back costs as much as the widest gap, going straight on nothing.
    const double turn = 0.5 * (1 + dot(end.onwards, other.onwards));
    const Ranked found{
        {apart_mm + turn * gap_mm_, std::min(end.end, other.end), std::max(end.end, other.end)},
        number};
    if (!(found < best.back())) return;
    best.back() = found;
    for (std::size_t i = kNeighbours - 1; i > 0 && best[i] < best[i - 1]; --i)
      std::swap(best[i], best[i - 1]);
  }

  // The same where thousands are within the gap, as at the horizon of a rough sea: from the nearest
  // row on, each from its middle outwards, as long as any may cost less than what was found. An end
  // costs no less than it is away.
  Best best_in_crowd(const StrokeEnd& end) {
    std::call_once(is_by_row_, [&] { order_by_row(); });
    Best best;
    best.fill({{std::numeric_limits<double>::infinity(), end.end, end.end}, ends_.size()});
    const auto is_too_far = [&](double away_mm) {
      return away_mm > std::min(gap_mm_, best.back().pair.cost_mm);
    };
    const auto take_if_beside = [&](std::size_t number) {
      const std::uint64_t from = end.cell - kCellsARow, cell = ends_[number].cell;
      for (const std::uint64_t middle : {from, end.cell, end.cell + kCellsARow})
        if (cell + 1 >= middle && cell <= middle + 1) return take(end, number, best);
    };
    const auto take_row = [&](std::int64_t row) {
      const auto begin = std::partition_point(by_row_.begin(), by_row_.end(), [&](const InRow& e) {
        return e.row != row ? e.row < row : e.x_mm < end.at_mm.x;
      });
      for (auto e = begin; e != by_row_.end() && e->row == row; ++e) {
        if (is_too_far(e->x_mm - end.at_mm.x)) break;
        take_if_beside(e->number);
      }
      for (auto e = begin; e != by_row_.begin() && (e - 1)->row == row; --e) {
        if (is_too_far(end.at_mm.x - (e - 1)->x_mm)) break;
        take_if_beside((e - 1)->number);
      }
    };
    const std::int64_t own = row_of(end.at_mm.y);
    take_row(own);
    // Rows are rounded by far less than they are high; what is left out here is at least one off.
    for (std::int64_t k = 1; k <= kRowsAGap + 1 && (k == 1 || !is_too_far((k - 2) * row_mm()));
         ++k) {
      take_row(own - k);
      take_row(own + k);
    }
    return best;
  }

  // In narrow rows of the page, from left to right.
  void order_by_row() {
    by_row_.reserve(ends_.size());
    for (std::size_t i = 0; i < ends_.size(); ++i)
      by_row_.push_back({row_of(ends_[i].at_mm.y), ends_[i].at_mm.x, i});
    std::sort(by_row_.begin(), by_row_.end(), [](const InRow& a, const InRow& b) {
      if (a.row != b.row) return a.row < b.row;
      return a.x_mm != b.x_mm ? a.x_mm < b.x_mm : a.number < b.number;
    });
  }
  double row_mm() const { return gap_mm_ / kRowsAGap; }
  std::int64_t row_of(double y_mm) const {
    return static_cast<std::int64_t>(std::floor((y_mm - low_.y) / row_mm()));
  }

  // Both ends of one stroke that is hardly longer than the gap.
  bool closes_crumb(const StrokeEnd& a, const StrokeEnd& b) const {
    constexpr double kGapsOfARing = 8;
    return a.end / 2 == b.end / 2 &&
           line_length_mm(layer_.points(layer_.strokes[a.end / 2])) < kGapsOfARing * gap_mm_;
  }

  const Layer& layer_;
  double gap_mm_;
  Vec2 low_{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  std::vector<StrokeEnd> ends_;
  struct InRow {
    std::int64_t row;
    double x_mm;
    std::size_t number; ///< in `ends_`
  };
  std::vector<InRow> by_row_; ///< made when it is needed
  std::once_flag is_by_row_;
};

// Appends points and what stands beside them.
void append(const Layer& layer, std::span<const std::uint32_t> which, const Stroke& like,
            Layer& out) {
  Stroke stroke = like;
  stroke.first_point = static_cast<std::uint32_t>(out.page_mm.size());
  stroke.point_count = static_cast<std::uint32_t>(which.size());
  for (const std::uint32_t i : which) {
    out.page_mm.push_back(layer.page_mm[i]);
    if (!layer.map.empty()) out.map.push_back(layer.map[i]);
    if (!layer.depths_m.empty()) out.depths_m.push_back(layer.depths_m[i]);
  }
  out.strokes.push_back(stroke);
}

// The joints at both ends of each stroke.
std::vector<ChainLink> joints_of(const Layer& layer, double gap_mm) {
  std::vector<ChainLink> links(layer.strokes.size(), {kLooseEnd, kLooseEnd});
  if (!(gap_mm > 0)) return links;
  std::uint64_t joints = 0;
  const auto end = [&](std::uint32_t number) -> std::uint64_t& {
    ChainLink& link = links[number / 2];
    return number % 2 == 0 ? link.begin : link.end;
  };
  for (const EndPair& pair : EndsByCell(layer, gap_mm).pairs())
    if (end(pair.a) == kLooseEnd && end(pair.b) == kLooseEnd) end(pair.a) = end(pair.b) = joints++;
  return links;
}

} // namespace

Layer joined(const Layer& layer, const JoinSettings& settings, double& left_out_mm) {
  Layer out = layer;
  out.clear();
  const std::vector<ChainLink> joints = joints_of(layer, settings.gap_mm);
  const Chains chains = chain(joints);
  const bool bridges = layer.map.empty();
  std::vector<std::uint32_t> places, kept; // of points, in the layer and then among the places
  std::vector<Vec2> page_mm;
  const auto draw = [&](const Stroke& like) {
    page_mm.clear();
    for (const std::uint32_t i : places) page_mm.push_back(layer.page_mm[i]);
    simplify(page_mm, settings.simplify_mm, kept);
    for (std::uint32_t& i : kept) i = places[i];
    append(layer, kept, like, out);
    places.clear();
  };
  for (std::size_t i = 0; i < chains.size(); ++i) {
    throw_if_stopped(i);
    double ink_mm = 0;
    for (const ChainedPiece& piece : chains[i])
      ink_mm += line_length_mm(layer.points(layer.strokes[piece.piece]));
    if (ink_mm < settings.min_stroke_mm) {
      left_out_mm += ink_mm;
      continue;
    }
    for (const auto& [number, turned] : chains[i]) {
      const Stroke& stroke = layer.strokes[number];
      for (std::uint32_t p = 0; p < stroke.point_count; ++p)
        places.push_back(stroke.first_point + (turned ? stroke.point_count - 1 - p : p));
      if (!bridges) draw(stroke);
    }
    if (!bridges) continue;
    const auto& [first, first_turned] = chains[i].front();
    const auto& [last, last_turned] = chains[i].back();
    const std::uint64_t entry = first_turned ? joints[first].end : joints[first].begin,
                        exit = last_turned ? joints[last].begin : joints[last].end;
    if (entry != kLooseEnd && entry == exit) places.push_back(places.front()); // a ring
    draw(layer.strokes[first]);
  }
  return out;
}

} // namespace orograph
