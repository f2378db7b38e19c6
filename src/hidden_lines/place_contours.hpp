// SPDX-License-Identifier: GPL-3.0-or-later
// The contours at a place of the lattice's order, as far as a strip of X may show them.
#pragma once

#include "hidden_lines/contour_chains.hpp"
#include "hidden_lines/lattice_in_work.hpp"
#include "hidden_lines/place_silhouettes.hpp"
#include "hidden_lines/shown_of_place.hpp"
#include "profiles/triangle_isolines.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace orograph {

/// Finds them cell by cell, by the rule of `isolines`.
class PlaceContours {
public:
  /// `levels_m` rise. REQUIRES that all outlive this.
  PlaceContours(const LatticeInWork& lattice, std::span<const double> levels_m,
                const LinePictures& pictures);

  /// Where a level is on an edge or at a vertex, and its picture: NaN up to the near plane. A point
  /// on the line between two places is kept from the one to the other.
  struct Point {
    ProfilePoint at;
    std::uint64_t number; ///< of its ContourNode
    double x, y;
    std::uint32_t chained = ContourChains::kNone; ///< its number among those that are visible
  };
  struct Piece {
    LatticeOrder::Turn turn;
    std::uint32_t from, to; ///< points of the place
    std::uint32_t level;    ///< number
  };
  /// Finds those that may be above the horizon as it stands.
  void find(const LatticeOrder::Place& place, const ShownOfPlace& shown,
            const BlockedHorizon& horizon);
  /// By turn.
  std::span<const Piece> of(PlacePart part) const { return found_[static_cast<std::size_t>(part)]; }
  /// Of the place.
  Point& point(std::uint32_t number) { return points_[number]; }

private:
  static constexpr std::uint32_t kNone = ContourChains::kNone;
  // Vertices along a line of the lattice, from that at which cell number `first` begins: heights,
  // how many levels aren't above, places in the profile frame, and pictures.
  struct Line {
    int number = -1;
    int first = 0;
    std::vector<double> heights_m, u, v, z, x, y;
    std::vector<std::int32_t> levels;
    std::vector<std::uint8_t> is_level; // that the last of those is its height
    std::vector<int> on_level;          // cells at whose first vertex it is
    std::vector<std::uint32_t> points;  // the first behind each; kNone if they aren't known

    std::size_t index(int cell) const { return static_cast<std::size_t>(cell - first); }
    bool holds(int from, int to) const {
      return from >= first && to < first + static_cast<int>(levels.size());
    }
  };
  // One that a level crosses, and the first points there.
  struct Cell {
    int number;
    std::uint32_t upright, diagonal, upright_behind;
  };

  void take_line(Line& line, int number, const ShownOfPlace& shown, bool moves_points);
  void read(Line& line, std::size_t count);
  template <class Lattice>
  void put_in_place(const Lattice& of_grid, Line& line) const;
  void find_levels(Line& line);
  void find_cells(const ShownOfPlace& shown, const BlockedHorizon& horizon);
  bool is_ahead(int cell) const;
  bool is_hidden(int cell, const BlockedHorizon& horizon) const;
  void add_points_of_cells();
  void add_points_along(Line& line, int cell);
  enum class EdgeOfCell { along, upright, diagonal };
  // Tells the number of the first. Most edges have none.
  std::uint32_t add_points(EdgeOfCell edge, const Line& line_from, int from, const Line& line_to,
                           int to) {
    const auto first = static_cast<std::uint32_t>(points_.size());
    if (line_from.levels[line_from.index(from)] != line_to.levels[line_to.index(to)])
      add_crossings(edge, line_from, from, line_to, to);
    return first;
  }
  void add_crossings(EdgeOfCell edge, const Line& line_from, int from, const Line& line_to, int to);
  void add_point(std::uint64_t number, ProfilePoint at);
  std::uint32_t add_vertex(std::uint32_t vertex);
  void add_pieces(PlacePart part, const Cell& cell);
  void add_pieces(PlacePart part, const Cell& cell, bool with_far, LatticeOrder::Turn turn);
  void add_plain_pieces(std::vector<Piece>& found, const Cell& cell, bool with_far,
                        LatticeOrder::Turn turn) const;
  void add_edges_within();
  void add_edges_along(const Line& line, const ShownOfPlace& shown);
  void add_edge(std::uint32_t from, std::uint32_t to, std::int32_t level);
  bool is_level(const Line& line_a, std::size_t a, const Line& line_b, std::size_t b) const;
  bool cell_falls(std::int32_t levels, int strip, int cell, int line, int at) const;

  static ProfilePoint place_of(const Line& line, std::size_t i) {
    return {line.u[i], line.v[i], line.z[i]};
  }
  LevelStanding standing(const Line& line, int cell) const {
    const std::size_t i = line.index(cell);
    return {line.heights_m[i], line.levels[i], line.is_level[i] != 0};
  }
  bool is_looked_at(int strip, int cell) const;
  int column(int line, int cell) const { return rows_ ? cell : line; }
  int row(int line, int cell) const { return rows_ ? line : cell; }
  std::uint32_t vertex(int line, int cell) const {
    return static_cast<std::uint32_t>(lattice_.grid.index(column(line, cell), row(line, cell)));
  }

  const LatticeInWork& lattice_;
  const LinePictures& pictures_;
  IsolineLevels levels_;
  bool rows_; // are strips
  std::uint64_t columns_, vertices_;
  Line near_, far_; // beside the present strip, near_ that of lower number
  std::vector<Point> points_, points_before_; // those of a few places
  std::vector<std::uint8_t> is_crossed_;      // cells, from the first that is shown
  std::vector<std::uint32_t> near_level_;     // vertices of a line
  std::vector<Cell> cells_;                   // by number
  std::array<std::vector<Piece>, 3> found_;
};

} // namespace orograph
