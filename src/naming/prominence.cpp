// SPDX-License-Identifier: GPL-3.0-or-later
#include "naming/prominence.hpp"

#include "geometry/on_all_cores.hpp"
#include "profiles/outline.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <tuple>
#include <variant>

namespace orograph {
namespace {

// A place where ground comes together on the way down: `vertex` with what is higher on one of its
// sides, or with what is beyond the terrain.
struct Meeting {
  double height_m;
  std::uint32_t vertex;
  std::uint32_t with; ///< a higher neighbour, or kBeyond
};
constexpr std::uint32_t kBeyond = ~std::uint32_t{0};

// The order in which ground comes out of a falling flood.
bool is_earlier(const Meeting& a, const Meeting& b) {
  if (a.height_m != b.height_m) return a.height_m > b.height_m;
  return std::tie(a.vertex, a.with) < std::tie(b.vertex, b.with);
}

// Ground that hangs together above the flood.
struct Island {
  std::uint32_t up; ///< the island that it has become a part of, or itself
  std::uint32_t summit;
  double height_m;
  Prominence prominence = {};
  bool is_known = false; ///< the summit's prominence
  bool is_open = false;  ///< it reaches the terrain's border

  bool is_higher(const Island& other) const {
    return height_m != other.height_m ? height_m > other.height_m : summit < other.summit;
  }
};

class Islands {
public:
  /// `summits` rise.
  template <class HeightOf>
  Islands(const std::vector<std::uint32_t>& summits, const HeightOf& height_of) {
    islands_.reserve(summits.size());
    for (std::size_t i = 0; i < summits.size(); ++i)
      islands_.push_back({static_cast<std::uint32_t>(i), summits[i], height_of(summits[i])});
  }

  void meet_beyond(std::uint32_t island, double height_m) {
    Island& one = islands_[root(island)];
    if (!one.is_open) know(one, height_m, true);
    one.is_open = true;
  }
  void meet(std::uint32_t a, std::uint32_t b, double height_m) {
    a = root(a);
    b = root(b);
    if (a == b) return;
    if (islands_[b].is_higher(islands_[a])) std::swap(a, b);
    Island &higher = islands_[a], &lower = islands_[b];
    know(lower, height_m, false);
    if (lower.is_open && !higher.is_open) {
      know(higher, height_m, true);
      higher.is_open = true;
    }
    lower.up = a;
  }
  /// Of a vertex; none of its own where it is no summit.
  Prominence of_summit(std::uint32_t vertex) const {
    const auto found = std::ranges::lower_bound(islands_, vertex, {}, &Island::summit);
    return found != islands_.end() && found->summit == vertex ? found->prominence : Prominence{};
  }

private:
  static void know(Island& island, double height_m, bool is_at_least) {
    if (island.is_known) return;
    island.prominence = {island.height_m - height_m, is_at_least};
    island.is_known = true;
  }
  std::uint32_t root(std::uint32_t island) {
    while (islands_[island].up != island) {
      islands_[island].up = islands_[islands_[island].up].up;
      island = islands_[island].up;
    }
    return island;
  }

  std::vector<Island> islands_; ///< by summit
};

std::vector<Prominence> of_each(const Islands& islands, std::span<const std::uint32_t> vertices) {
  std::vector<Prominence> out;
  for (const std::uint32_t vertex : vertices) out.push_back(islands.of_summit(vertex));
  return out;
}

// The six neighbours of a grid's vertex along its edges, in turn round it; the first three come
// after it in the grid's order, so that of equal heights theirs are lower.
struct Step {
  int column, row;
};
constexpr std::array<Step, 6> kRound{{{1, 0}, {1, 1}, {0, 1}, {-1, 0}, {-1, -1}, {0, -1}}};
constexpr std::uint8_t kNoGround = 64; // instead of a bit for each neighbour that is higher
constexpr std::uint8_t kBorder = 128;  // a bit more: a neighbour isn't there

std::uint32_t beside(const Grid& grid, std::uint32_t vertex, unsigned step) {
  const std::int64_t by = std::int64_t{kRound[step].row} * grid.columns + kRound[step].column;
  return static_cast<std::uint32_t>(vertex + by);
}

// Neighbours make arcs, by their bits.
constexpr bool begins_arc(unsigned bits, unsigned i) {
  return (bits >> i & 1U) != 0 && (bits >> (i + 5) % 6 & 1U) == 0;
}
// Where that begins which holds a neighbour; if all of them are higher, or none, nowhere.
unsigned arc_of(unsigned bits, unsigned i) {
  for (unsigned back = 0; back < 6; ++back)
    if (begins_arc(bits, (i + 6 - back) % 6)) return (i + 6 - back) % 6;
  return 6;
}
// Marks of vertices that neither part nor join anything: one arc, and no border; and of none.
constexpr auto kIsPlain = [] {
  std::array<bool, 256> plain{};
  for (unsigned bits = 0; bits < 64; ++bits) {
    unsigned arcs = 0;
    for (unsigned i = 0; i < 6; ++i) arcs += begins_arc(bits, i) ? 1 : 0;
    plain[bits] = arcs == 1;
  }
  plain[kNoGround] = true;
  return plain;
}();

// What a pass over a grid finds.
struct GridSlopes {
  std::vector<std::uint8_t> higher; ///< of each vertex: its neighbours' bits, or kNoGround
  std::vector<std::uint32_t> summits;
  std::vector<Meeting> meetings;
};

// Neighbours' bits of a row's vertices but the first and the last; without a branch, and without a
// choice that might be one, so that compilers do several at once.
template <class T>
void mark_row(const T* above, const T* here, const T* below, std::size_t columns,
              std::uint8_t* higher) {
  for (std::size_t c = 1; c + 1 < columns; ++c) {
    const T h = here[c], east = here[c + 1], south_east = below[c + 1], south = below[c],
            west = here[c - 1], north_west = above[c - 1], north = above[c];
    const T sum = east + south_east + south + west + north_west + north;
    const unsigned marks = unsigned{east > h} | unsigned{south_east > h} << 1U |
                           unsigned{south > h} << 2U | unsigned{west >= h} << 3U |
                           unsigned{north_west >= h} << 4U | unsigned{north >= h} << 5U |
                           unsigned{sum != sum} * kBorder;
    const unsigned is_there = 0U - unsigned{h == h};
    higher[c] = static_cast<std::uint8_t>((marks & is_there) | (kNoGround & ~is_there));
  }
}

// The same of any vertex.
template <class T>
std::uint8_t marks_of(const Grid& grid, const Heights<T>& heights_m, int column, int row) {
  const T h = heights_m[grid.index(column, row)];
  if (std::isnan(h)) return kNoGround;
  unsigned marks = 0;
  for (std::size_t i = 0; i < kRound.size(); ++i) {
    const int c = column + kRound[i].column, r = row + kRound[i].row;
    const bool is_inside = c >= 0 && r >= 0 && c < grid.columns && r < grid.rows;
    const T other = is_inside ? heights_m[grid.index(c, r)] : static_cast<T>(NAN);
    if (std::isnan(other))
      marks |= kBorder;
    else if (other > h || (other == h && i >= 3))
      marks |= 1U << i;
  }
  return static_cast<std::uint8_t>(marks);
}

// Ground comes together only where what is higher around a vertex isn't one arc.
template <class T>
GridSlopes slopes_of(const Grid& grid, const Heights<T>& heights_m) {
  const auto columns = static_cast<std::size_t>(grid.columns);
  GridSlopes out;
  out.higher.resize(grid.size());
  struct OfRows {
    std::vector<std::uint32_t> summits;
    std::vector<Meeting> meetings;
  };
  constexpr int kRows = 32;
  std::vector<OfRows> parts(static_cast<std::size_t>((grid.rows + kRows - 1) / kRows));
  on_all_cores(parts.size(), [&](std::size_t part) {
    auto& [summits, meetings] = parts[part];
    const int first = static_cast<int>(part) * kRows;
    for (int row = first; row < std::min(first + kRows, grid.rows); ++row) {
      const std::size_t begin = grid.index(0, row);
      std::uint8_t* const higher = out.higher.data() + begin;
      const bool is_inner = row > 0 && row + 1 < grid.rows;
      if (is_inner)
        mark_row(heights_m.data() + begin - columns, heights_m.data() + begin,
                 heights_m.data() + begin + columns, columns, higher);
      for (int column = 0; column < grid.columns; ++column)
        if (!is_inner || column == 0 || column + 1 == grid.columns)
          higher[column] = marks_of(grid, heights_m, column, row);
      for (std::size_t column = 0; column < columns; ++column) {
        const std::uint8_t marks = higher[column];
        if (kIsPlain[marks]) continue; // nearly all
        const std::uint8_t bits = marks % kNoGround;
        higher[column] = bits;
        const auto number = static_cast<std::uint32_t>(begin + column);
        const double height_m = heights_m[number];
        if (bits == 0) summits.push_back(number);
        // The way up goes through the arc of the first that is higher: others meet that.
        const unsigned own = arc_of(bits, static_cast<unsigned>(std::countr_zero(bits)));
        for (unsigned i = 0; i < 6; ++i)
          if (begins_arc(bits, i) && i != own)
            meetings.push_back({height_m, number, beside(grid, number, i)});
        if (marks != bits) meetings.push_back({height_m, number, kBeyond});
      }
    }
  });
  for (OfRows& part : parts) {
    out.summits.insert(out.summits.end(), part.summits.begin(), part.summits.end());
    out.meetings.insert(out.meetings.end(), part.meetings.begin(), part.meetings.end());
  }
  return out;
}

std::vector<Prominence> of_grid(const Grid& grid, std::span<const std::uint32_t> vertices) {
  GridSlopes slopes = std::visit([&](const auto& h) { return slopes_of(grid, h); }, grid.heights_m);
  std::sort(slopes.meetings.begin(), slopes.meetings.end(), is_earlier);
  Islands islands(slopes.summits, [&](std::uint32_t vertex) {
    return std::visit([&](const auto& h) { return static_cast<double>(h[vertex]); },
                      grid.heights_m);
  });
  // Where the summits of each row begin.
  std::vector<std::uint32_t> rows(static_cast<std::size_t>(grid.rows) + 1);
  const auto columns = static_cast<std::uint32_t>(grid.columns);
  for (const std::uint32_t summit : slopes.summits) ++rows[summit / columns + 1];
  std::partial_sum(rows.begin(), rows.end(), rows.begin());
  // Whichever way is up, it leads to a summit of the same island.
  const auto island_of = [&](std::uint32_t vertex) {
    while (slopes.higher[vertex] != 0)
      vertex = beside(grid, vertex, static_cast<unsigned>(std::countr_zero(slopes.higher[vertex])));
    const std::uint32_t* const row = &rows[vertex / columns];
    const auto first = slopes.summits.begin();
    return static_cast<std::uint32_t>(std::lower_bound(first + row[0], first + row[1], vertex) -
                                      first);
  };
  std::size_t step = 0;
  for (const Meeting& meeting : slopes.meetings) {
    throw_if_stopped(step++);
    const std::uint32_t here = island_of(meeting.vertex);
    if (meeting.with == kBeyond)
      islands.meet_beyond(here, meeting.height_m);
    else
      islands.meet(here, island_of(meeting.with), meeting.height_m);
  }
  return of_each(islands, vertices);
}

// Each vertex is an island at first, and each edge a meeting.
std::vector<Prominence> of_tin(const Tin& tin, std::span<const std::uint32_t> vertices) {
  const auto height_of = [&](std::uint32_t vertex) { return tin.vertices_m[vertex].z; };
  std::vector<Meeting> meetings;
  const auto add = [&](std::uint32_t a, std::uint32_t b) {
    if (height_of(b) < height_of(a) || (height_of(b) == height_of(a) && b > a)) std::swap(a, b);
    meetings.push_back({height_of(a), a, b});
  };
  for (const auto& triangle : tin.triangles)
    for (std::size_t i = 0; i < 3; ++i) add(triangle[i], triangle[(i + 1) % 3]);
  for (const BorderEdge& edge : border_edges(tin))
    for (const std::uint32_t vertex : {edge.edge.from, edge.edge.to})
      meetings.push_back({height_of(vertex), vertex, kBeyond});
  std::sort(meetings.begin(), meetings.end(), is_earlier);
  std::vector<std::uint32_t> all(tin.vertices_m.size());
  std::iota(all.begin(), all.end(), 0U);
  Islands islands(all, height_of);
  std::size_t step = 0;
  for (const Meeting& meeting : meetings) {
    throw_if_stopped(step++);
    if (meeting.with == kBeyond)
      islands.meet_beyond(meeting.vertex, meeting.height_m);
    else
      islands.meet(meeting.vertex, meeting.with, meeting.height_m);
  }
  return of_each(islands, vertices);
}

} // namespace

std::vector<Prominence> prominences(const Surface& surface,
                                    std::span<const std::uint32_t> vertices) {
  if (vertices.empty()) return {};
  if (const Tin* tin = std::get_if<Tin>(&surface)) return of_tin(*tin, vertices);
  return of_grid(std::get<Grid>(surface), vertices);
}

} // namespace orograph
