// SPDX-License-Identifier: GPL-3.0-or-later
// Lines of a map laid on a surface.
#pragma once

#include "dem/mesh/tin_index.hpp"
#include "dem/surface.hpp"
#include "geometry/profile_point.hpp"
#include "profiles/slab_lines.hpp"
#include "view/view.hpp"

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

namespace orograph {

/// Straight pieces, each within one triangle. A piece begins where the one before it ends, if that
/// ends at its first point.
struct DrapedLine {
  struct Piece {
    std::uint32_t from, to; ///< points
    std::uint32_t triangle;
  };
  std::vector<ProfilePoint> points; ///< in the view's profile frame
  std::vector<Piece> pieces;
  bool is_whole = true; ///< no part is beside the surface, or over a void
};

/// Lays lines on a surface, triangle by triangle. Places are counted as the surface is laid out: of
/// a grid in columns and rows, whole at its vertices, so that straight is what is straight on the
/// map, in degrees too; of a TIN in metres of the ground frame.
class Draper {
public:
  /// REQUIRES that both outlive it. Cost: of a TIN, an index.
  Draper(const Surface& surface, const View& view);

  /// Of the line through `places`, `above_m` higher than the ground, as the view exaggerates it.
  /// Cost: O(1) a triangle; of a TIN, a little more.
  void drape(std::span<const Vec2> places, double above_m, DrapedLine& out);

private:
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
  struct InTriangle {
    double from, to; ///< shares of the way
    std::uint32_t triangle;
  };
  void find(Vec2 from, Vec2 to);
  void find_on_grid(const Grid& grid, Vec2 from, Vec2 to);
  void find_on_tin(const Tin& tin, Vec2 from, Vec2 to);
  ProfilePoint at(std::uint32_t triangle, Vec2 place);

  const Surface& surface_;
  EdgeEnds ends_;
  std::optional<TinIndex> index_;
  std::vector<InTriangle> found_; ///< along one straight line, in order
  std::vector<double> shares_;
  std::vector<std::uint32_t> triangles_;
  std::array<std::uint32_t, 3> corners_{kNone, kNone, kNone}; ///< of the last point's triangle
  std::array<ProfilePoint, 3> at_corners_;
};

} // namespace orograph
