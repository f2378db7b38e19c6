// SPDX-License-Identifier: GPL-3.0-or-later
// Standing solids as a view has them: light and dark triangles, what they hide of lines, and
// whether the eye is inside of one.
#pragma once

#include "geometry/box.hpp"
#include "solids/shadow.hpp"
#include "solids/standing_solid.hpp"
#include "view/view.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace orograph {

/// A box in the visibility plane, and depths. Infinite where something reaches beside the eye.
struct SeenBox {
  double x_begin, x_end, y_low, y_high, nearest_m, farthest_m;
};
/// Of points of the profile frame.
SeenBox seen_box(const View& view, const Vec3* points, std::size_t count);
/// It stands in front of nothing then. What is nearer than the near plane does, though it has no
/// picture.
inline bool is_behind_eye(const View& view, const SeenBox& box) {
  return view.is_perspective() && box.farthest_m <= 0;
}

/// What a light triangle hides.
struct TriangleShadow {
  Shadow shadow;
  SeenBox box;
  std::uint32_t triangle;
};

/// How an edge stands to the eye (Chen and Sabbagh 1983, sections 5.8 and 5.9: light and dark
/// faces).
enum class EdgeFacing : std::uint8_t {
  seen,     ///< between two light triangles, or the outline; or a wire
  dark,     ///< behind its own solid as a whole
  not_drawn ///< smooth, and no outline
};

struct SolidInView {
  const StandingSolid* standing = nullptr;
  std::vector<Vec3> vertices; ///< profile frame
  std::vector<TriangleShadow> shadows;
  std::vector<EdgeFacing> edges;
  SeenBox box{};
  double rounding_m = 0; ///< bound on the rounding of positions
};

/// REQUIRES that the standing solid outlives what comes back. A triangle that is seen edge-on
/// counts as dark.
SolidInView in_view(const StandingSolid& standing, const View& view);

/// A straight line of the profile frame, in front of the near plane.
struct LineInView {
  Vec3 from, to;
  SeenBox box;
};
inline LineInView line_in_view(const View& view, Vec3 from, Vec3 to) {
  const Vec3 ends[] = {from, to};
  return {from, to, seen_box(view, ends, 2)};
}

/// An edge of one of the solids, which its own two triangles don't hide; or no edge of any.
struct OwnEdge {
  static constexpr std::size_t kNone = ~std::size_t{0};
  std::size_t solid = kNone;
  std::uint32_t left = SolidEdge::kNoTriangle, right = SolidEdge::kNoTriangle;
};

class SolidsInView {
public:
  /// REQUIRES that the standing solids outlive it.
  SolidsInView(std::span<const StandingSolid> standing, const View& view);

  const View& view() const { return view_; }
  const std::vector<SolidInView>& solids() const { return solids_; }

  /// Parts of lines that are no longer are left by rounding: some hundred times that of positions,
  /// since a line may cross a plane at a small angle.
  double sliver_m() const { return sliver_m_; }
  /// Whether any solid reaches into a range of X.
  bool any_in(double x_begin, double x_end) const { return x_begin <= x_end_ && x_end >= x_begin_; }
  /// Calls `take` with the number of every solid whose box a box in the picture overlaps, and that
  /// begins no farther than the box ends; with some of them more than once.
  template <class Take>
  void for_each_before(const SeenBox& box, const Take& take) const {
    if (!any_in(box.x_begin, box.x_end)) return;
    const auto ask = [&](const std::vector<std::uint32_t>& bucket) {
      for (const std::uint32_t i : bucket) {
        const SeenBox& solid = solids_[i].box;
        if (overlap(solid, box) && solid.nearest_m <= box.farthest_m) take(std::size_t{i});
      }
    };
    ask(everywhere_);
    if (buckets_.empty()) return;
    const std::size_t last_row = row_of(box.y_high), last_column = column_of(box.x_end);
    for (std::size_t r = row_of(box.y_low); r <= last_row; ++r)
      for (std::size_t c = column_of(box.x_begin); c <= last_column; ++c)
        ask(buckets_[r * side_ + c]);
  }
  /// The same with every solid that reaches into a range of X, below a height, and ends farther
  /// than a depth.
  template <class Take>
  void for_each_behind(double x_begin, double x_end, double y_high, double depth_m,
                       const Take& take) const {
    if (!any_in(x_begin, x_end)) return;
    const auto ask = [&](const std::vector<std::uint32_t>& bucket) {
      for (const std::uint32_t i : bucket) {
        const SeenBox& solid = solids_[i].box;
        if (solid.farthest_m > depth_m && solid.y_low < y_high && solid.x_begin <= x_end &&
            solid.x_end >= x_begin)
          take(std::size_t{i});
      }
    };
    ask(everywhere_);
    if (columns_.empty()) return;
    const std::size_t last = column_of(x_end);
    for (std::size_t c = column_of(x_begin); c <= last; ++c) ask(columns_[c]);
  }
  /// Appends what solids hide of a line.
  void add_hidden(const LineInView& line, const OwnEdge& own, std::vector<Share>& hidden) const;

  static bool overlap(const SeenBox& a, const SeenBox& b) {
    return a.x_begin <= b.x_end && b.x_begin <= a.x_end && a.y_low <= b.y_high &&
           b.y_low <= a.y_high;
  }

private:
  std::size_t column_of(double x) const { return number_of((x - core_.low.x) * per_x_); }
  std::size_t row_of(double y) const { return number_of((y - core_.low.y) * per_y_); }
  std::size_t number_of(double buckets) const {
    return static_cast<std::size_t>(std::clamp(buckets, 0.0, static_cast<double>(side_ - 1)));
  }

  View view_;
  std::vector<SolidInView> solids_;
  double sliver_m_ = 0;
  double x_begin_, x_end_; ///< of all
  // Those that reach beside the eye, and the others in buckets of the picture, by row.
  std::vector<std::uint32_t> everywhere_;
  Box2 core_;
  double per_x_ = 0, per_y_ = 0; ///< buckets to a unit
  std::size_t side_ = 0;         ///< buckets across, and up
  std::vector<std::vector<std::uint32_t>> buckets_, columns_;
};

/// Whether the eye of a perspective view is inside of a solid, however its closed parts lie in or
/// across each other: which of its triangles are above the eye is told by the same signs for
/// neighbours, so that none is counted twice and none is missed. An eye on the surface, to
/// rounding, may count as inside or not. Cost: a pass over the triangles.
bool holds_eye(const StandingSolid& standing, const View& view);

} // namespace orograph
