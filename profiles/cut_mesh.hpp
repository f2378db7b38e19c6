// SPDX-License-Identifier: GPL-3.0-or-later
// The exact cut of TINs by planes of constant depth: a walk from triangle to triangle.
#pragma once

#include "dem/mesh/tin_index.hpp"
#include "dem/tin.hpp"
#include "profiles/mesh.hpp"
#include "profiles/profile.hpp"
#include "profiles/tin_places.hpp"
#include "profiles/triangles.hpp"
#include "view/view.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <vector>

namespace orograph {

// A mesh's border, by depth: where a plane may come in.

/// Sides of triangles that have nothing beyond them, in buckets of the depths that they reach into.
/// Memory: 12 bytes and more for a side.
template <class Side>
class BorderSides {
public:
  struct Depths {
    double nearest_m, farthest_m;
  };

  /// `depths_of(side)` are those of its two ends.
  template <class DepthsOf>
  BorderSides(const std::vector<Side>& border, const DepthsOf& depths_of) {
    std::vector<Depths> depths;
    depths.reserve(border.size());
    for (const Side& side : border) {
      depths.push_back(depths_of(side));
      nearest_m_ = std::min(nearest_m_, depths.back().nearest_m);
      farthest_m_ = std::max(farthest_m_, depths.back().farthest_m);
    }
    // As many as there are rows in a large grid, and no more than there are sides.
    constexpr std::size_t kMostBuckets = 4096;
    const std::size_t count = std::min(kMostBuckets, border.size() + 1);
    if (farthest_m_ > nearest_m_)
      buckets_per_m_ = static_cast<double>(count) / (farthest_m_ - nearest_m_);
    begin_.assign(count + 1, 0);
    const auto for_each_bucket = [&](std::size_t i, const auto& take) {
      const std::size_t last = bucket_of(depths[i].farthest_m);
      for (std::size_t b = bucket_of(depths[i].nearest_m); b <= last; ++b) take(b);
    };
    for (std::size_t i = 0; i < border.size(); ++i)
      for_each_bucket(i, [&](std::size_t b) { ++begin_[b + 1]; });
    for (std::size_t b = 0; b < count; ++b) begin_[b + 1] += begin_[b];
    sides_.resize(begin_.back());
    std::vector<std::uint32_t> next(begin_.begin(), begin_.end() - 1);
    for (std::size_t i = 0; i < border.size(); ++i)
      for_each_bucket(i, [&](std::size_t b) { sides_[next[b]++] = border[i]; });
  }

  /// Of all sides; of no side at all, infinity and -infinity.
  double nearest_m() const { return nearest_m_; }
  double farthest_m() const { return farthest_m_; }

  /// All sides that the plane at a depth meets, and others about there.
  std::span<const Side> at(double depth_m) const {
    const std::size_t b = bucket_of(depth_m);
    return {sides_.data() + begin_[b], sides_.data() + begin_[b + 1]};
  }

private:
  std::size_t bucket_of(double depth_m) const {
    const double bucket = (depth_m - nearest_m_) * buckets_per_m_;
    return std::min(static_cast<std::size_t>(std::max(bucket, 0.0)), begin_.size() - 2);
  }

  double nearest_m_ = std::numeric_limits<double>::infinity(), farthest_m_ = -nearest_m_;
  double buckets_per_m_ = 0;
  std::vector<std::uint32_t> begin_; ///< of bucket i in `sides_`; one more at the end
  std::vector<Side> sides_;
};

/// Cuts one TIN for one view, plane after plane, in any order; the profile is that of `GridCutter`,
/// but that there are no vertices where there is no terrain.
///
///  (1) There is a vertex wherever the plane crosses an edge, in order from left to right, once; a
///      plane through a TIN's vertex has that vertex.
///  (2) Between two vertices the profile lies in one triangle, or there is a gap. An edge that lies
///      in the plane is there, and level if either of its triangles is.
///  (3) A crossing is reckoned from its edge's vertex of lower index, exact at both ends.
///  (4) A wall is crossed straight up or down; where it is turned away from the eye there is a gap,
///      unless both its sides are asked for.
///      A wall that lies in the plane isn't crossed: the profile keeps to its foot or its top,
///      whichever the ground in front of it has.
/// Cost a plane: O(segments + border edges of about its depth).
class TinCutter {
public:
  /// REQUIRES that `tin` and `level` (the triangles whose spans are marked level; may be empty)
  /// outlive the cutter. `places` are the TIN's, and are found if they aren't given; with its
  /// `index` a part of a profile costs no more than what it holds. Cost: a look at each box of the
  /// border's sides; with walls one pass over the triangles.
  TinCutter(const Tin& tin, const View& view, const TriangleSet& level,
            std::shared_ptr<const TinPlaces> places = nullptr,
            std::shared_ptr<const TinIndex> index = nullptr, bool both_sides = false);

  void cut(double depth_m, Profile& out) const;
  /// At least the part from the first range's left end to the last one's right end: without an
  /// index, and of a TIN with walls, all of it.
  void cut(double depth_m, std::span<const URange> ranges, Profile& out) const;

  /// Depths between which the TIN lies.
  double nearest_m() const { return nearest_m_; }
  double farthest_m() const { return farthest_m_; }

private:
  const Tin& tin_;
  View view_;
  const TriangleSet& level_;
  std::shared_ptr<const TinPlaces> places_;
  std::shared_ptr<const TinIndex> index_;
  BorderSides<std::uint32_t> boxes_; ///< of the border
  double nearest_m_, farthest_m_;    ///< the border's ends are those of all vertices
  TriangleSet turned_walls_;
};

} // namespace orograph
