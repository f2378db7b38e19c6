// SPDX-License-Identifier: GPL-3.0-or-later
// A line of a lattice on the earth, as a view looks at it from above.
#pragma once

#include "dem/grid.hpp"
#include "geometry/vec.hpp"
#include "profiles/earth_strips.hpp"
#include "view/view.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace orograph {

/// Which sides of what is looked at a vertex is beyond, and on which side of an edge the eye is:
/// that of the lines with higher numbers, or of those with lower ones. A block of vertices is
/// reckoned by where its first and its last one have their feet and by how much heights differ in
/// it; only where that doesn't tell by its vertices, one by one.
///
/// Where ground isn't there it goes on as high as before, or else as it begins.
class EarthLine {
public:
  /// Vertices of a block, of the last one perhaps fewer.
  static constexpr int kBlock = EarthStrips::kBlock;
  /// Bits of a vertex.
  static constexpr std::uint8_t kBehind = 1, kLeft = 2, kRight = 4;
  /// Bits of an edge.
  static constexpr std::uint8_t kHigh = 1, kLow = 2;

  /// Of the rows or columns of a grid. `next_is_left`: the next line is on the left of the way
  /// along a line, seen from above. REQUIRES that grid and view outlive it.
  EarthLine(const Grid& grid, const View& view, const LookedAt& looked, bool are_rows,
            bool next_is_left);

  /// From now on it is another line. `before`: the one before it in number, or itself where none
  /// was read. Some 2 ns a vertex, and where a block is in doubt 10 more.
  void read(int line, const EarthLine& before);

  const std::vector<std::uint8_t>& beyond() const { return beyond_; } ///< of vertices
  const std::vector<std::uint8_t>& sides() const { return sides_; }   ///< of edges

  /// Where a vertex is, u and v.
  Vec2 place(int vertex) const;
  struct Depths {
    double nearest_m, farthest_m;
  };
  /// Bounds of a block's vertices.
  Depths depths(std::size_t block) const;

  /// Sets `falls` of the vertices from `first` to `end` to 1 where the edge to the same vertex of
  /// the next line has the eye on the side of lower numbers of vertices.
  void find_falls(const EarthLine& next, int first, int end, std::span<std::uint8_t> falls) const;

  /// Whether no triangle between it and the next line is turned over, of the cells from `first` to
  /// `end`. REQUIRES that none is whose ground is there.
  bool are_apart(const EarthLine& next, int first, int end) const;

private:
  // Bounds of a block, with feet at height 0.
  struct Block {
    Vec2 first, last;  // feet of its first vertex, and of the next block's first or of the last one
    double off_m;      // of a vertex from the way between those
    double away_m;     // of a vertex
    double high_m;     // of a height, or of a depth below the sea
    double across_m;   // of heights' differences from the line before it
    double slant;      // of what a metre of height goes aside
    Vec2 edge;         // from a vertex to the next one, on the average
    double edge_off_m; // of any from that
  };

  template <class Height>
  void take_heights(const Heights<Height>& heights);
  void fill();
  int end_of(std::size_t block) const;
  Vec2 on_plane(Vec3 at) const;
  Vec2 at_height(int vertex, double height_m) const;
  double turn(Vec2 from, Vec2 to) const;
  double off_turn(double place_m, double place_off_m, double way_m, double way_off_m) const;
  struct Way {
    Vec2 m;
    double off_m;
  };
  Way way_to(const EarthLine& next, std::size_t block) const;
  bool is_missing(int vertex) const {
    return !missing_.empty() && missing_[static_cast<std::size_t>(vertex)] != 0;
  }
  void bound(std::size_t number, double along_m);
  bool is_told(std::size_t number);
  void judge(std::size_t block);

  const Grid& grid_;
  const EarthLattice& earth_;
  const View& view_;
  LookedAt looked_;
  bool are_rows_, next_is_left_;
  int vertices_, line_ = -1;
  double along_rad_, across_rad_, bend_m_, places_m_;
  std::vector<float> heights_;        // by which vertices lean
  std::vector<double> filled_m_;      // the same, or none where they are the grid's
  std::vector<std::uint8_t> missing_; // of vertices, or none
  std::vector<Block> blocks_;
  std::vector<std::uint8_t> beyond_, sides_;
};

} // namespace orograph
