// SPDX-License-Identifier: GPL-3.0-or-later
// A walk from triangle to triangle, as over a grid (cut_grid.cpp): a vertex is *near* if its depth
// is less than the plane's, otherwise *far*, and the plane crosses the edges between a near and a
// far vertex. A walk begins at a border edge over which the plane comes in, and ends at another.
// Each walk is a run of vertices; runs are put in order of u.
#include "profiles/cut_tin.hpp"

#include "profiles/facing.hpp"
#include "profiles/tin_edges.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace orograph {
namespace {

struct CutVertex {
  std::uint32_t index;
  ProfilePoint at;
};

// A walk's vertices in the workspace.
struct Run {
  std::size_t begin, end;
  double u_first, u_last;
  bool along; ///< a border edge in the plane, with nothing in front of it
};

struct Walk {
  const Tin& tin;
  const View& view;
  const TriangleSet &level, &walls, &turned_walls;
  double depth;
  bool far_at_plane; ///< whether a vertex in the plane counts as far
  Profile& out;      ///< of one run after the other

  CutVertex vertex(std::uint32_t i) const { return {i, to_profile_frame(view, tin.vertices_m[i])}; }
  bool is_far(const CutVertex& p) const { return far_at_plane ? p.at.v >= depth : p.at.v > depth; }
  bool is_wall(std::uint32_t t) const { return !walls.empty() && walls.has(t); }

  Span span_in(std::uint32_t t) const {
    if (is_wall(t)) return turned_walls.has(t) ? Span::gap : Span::wall;
    return !level.empty() && level.has(t) ? Span::level : Span::slope;
  }

  void add(double u, double z, Span before, std::size_t begin) {
    if (out.size() > begin) {
      // Around a vertex in the plane all edges cross at that vertex: it is there once, and the
      // triangles that only touch it don't matter.
      if (u == out.u_m.back() && z == out.z_m.back()) return;
      out.after.back() = before;
      // Crossings an ulp apart may round to the wrong order, and a wall's differ by as much.
      u = before == Span::wall ? out.u_m.back() : std::max(u, out.u_m.back());
    }
    out.u_m.push_back(u);
    out.z_m.push_back(z);
    out.after.push_back(Span::gap);
  }

  void add_crossing(const CutVertex& near, const CutVertex& far, Span before, std::size_t begin) {
    const bool near_first = near.index < far.index;
    const ProfilePoint a = near_first ? near.at : far.at, b = near_first ? far.at : near.at;
    const double t = (depth - a.v) / (b.v - a.v);
    double u = a.u + t * (b.u - a.u), z = a.z + t * (b.z - a.z);
    if (t >= 1) u = b.u, z = b.z;
    if (t <= 0) u = a.u, z = a.z;
    add(u, z, before, begin);
  }

  // What the plane meets on its way through triangle t, from edge near-far to `ahead`.
  Span span_of(std::uint32_t t, std::size_t k, const CutVertex& near, const CutVertex& far,
               const CutVertex& ahead) const {
    const Span span = span_in(t);
    // An edge in the plane belongs to the triangle on its other side as well.
    const CutVertex& on_plane = far_at_plane ? far : near;
    if (on_plane.at.v != depth || ahead.at.v != depth) return span;
    const std::uint32_t other = tin.neighbours[t][(k + (far_at_plane ? 2 : 1)) % 3];
    if (other == kNoTriangle || is_wall(other)) return span;
    return is_wall(t) ? span_in(other) : std::max(span, span_in(other));
  }

  // From the side of a border triangle opposite to its vertex k inwards.
  void run(std::uint32_t t, std::size_t k) {
    const std::size_t begin = out.size();
    CutVertex far = vertex(tin.triangles[t][(k + 1) % 3]),
              near = vertex(tin.triangles[t][(k + 2) % 3]);
    add_crossing(near, far, Span::gap, begin);
    for (;;) {
      const CutVertex ahead = vertex(tin.triangles[t][k]);
      const Span span = span_of(t, k, near, far, ahead);
      std::size_t leave = 0;
      if (is_far(ahead)) {
        far = ahead;
        leave = (k + 1) % 3;
      } else {
        near = ahead;
        leave = (k + 2) % 3;
      }
      add_crossing(near, far, span, begin);
      const std::uint32_t next = tin.neighbours[t][leave];
      if (next == kNoTriangle) return;
      const auto& back = tin.neighbours[next];
      k = static_cast<std::size_t>(std::find(back.begin(), back.end(), t) - back.begin());
      t = next;
    }
  }

  // A border edge that lies in the plane, with nothing in front of it.
  void run_along(std::uint32_t t, std::size_t k) {
    const std::size_t begin = out.size();
    ProfilePoint left = vertex(tin.triangles[t][(k + 1) % 3]).at,
                 right = vertex(tin.triangles[t][(k + 2) % 3]).at;
    if (left.u > right.u) std::swap(left, right);
    add(left.u, left.z, Span::gap, begin);
    add(right.u, right.z, is_wall(t) ? Span::slope : span_in(t), begin);
  }
};

// Takes away border edges in the plane that lie where there is ground in front of it as well: a
// wall is missing between the two.
void keep_ground_in_front(std::vector<Run>& runs) {
  std::vector<Run> through;
  for (const Run& run : runs)
    if (!run.along) through.push_back(run);
  std::sort(through.begin(), through.end(),
            [](const Run& a, const Run& b) { return a.u_last < b.u_last; });
  std::erase_if(runs, [&](const Run& run) {
    if (!run.along) return false;
    const auto next = std::partition_point(through.begin(), through.end(), [&](const Run& other) {
      return other.u_last <= run.u_first;
    });
    return next != through.end() && next->u_first < run.u_last;
  });
}

// The runs of `from`, in order and joined where one ends at the vertex at which the next begins.
void put_in_order(const Profile& from, std::vector<Run>& runs, Profile& out) {
  std::sort(runs.begin(), runs.end(), [](const Run& a, const Run& b) {
    return a.u_first != b.u_first ? a.u_first < b.u_first : a.u_last < b.u_last;
  });
  for (const Run& run : runs) {
    std::size_t i = run.begin;
    if (out.size() > 0) {
      if (run.u_last <= out.u_m.back() && run.u_first < out.u_m.back()) continue;
      if (from.u_m[i] == out.u_m.back() && from.z_m[i] == out.z_m.back()) {
        out.after.back() = from.after[i];
        ++i;
      }
    }
    for (; i < run.end; ++i) {
      const double u = from.u_m[i];
      out.u_m.push_back(out.size() > 0 ? std::max(u, out.u_m.back()) : u);
      out.z_m.push_back(from.z_m[i]);
      out.after.push_back(from.after[i]);
    }
  }
}

} // namespace

TinCutter::TinCutter(const Tin& tin, const View& view, const TriangleSet& level)
    : tin_(tin), view_(view), level_(level), nearest_m_(std::numeric_limits<double>::infinity()),
      farthest_m_(-nearest_m_), walls_(walls_of(tin)) {
  for (const Vec3& vertex : tin.vertices_m) {
    const double v = to_profile_frame(view, vertex).v;
    nearest_m_ = std::min(nearest_m_, v);
    farthest_m_ = std::max(farthest_m_, v);
  }
  if (!walls_.empty()) {
    turned_walls_ = TriangleSet(tin.triangles.size());
    const std::vector<std::uint8_t> facing = facing_of_triangles(tin, view);
    for (std::size_t t = 0; t < facing.size(); ++t)
      if (walls_.has(t) && (facing[t] & kMayTurn)) turned_walls_.add(t); // edge-on, too
  }

  // Border edges into buckets of depth: as many as there are rows in a large grid, and no more than
  // there are edges.
  std::vector<BorderSide> border;
  for (std::uint32_t t = 0; t < tin.triangles.size(); ++t)
    for (std::uint8_t k = 0; k < 3; ++k)
      if (tin.neighbours[t][k] == kNoTriangle) border.push_back({t, k});
  constexpr std::size_t kMostBuckets = 4096;
  const std::size_t count = std::min(kMostBuckets, border.size() + 1);
  buckets_per_m_ =
      farthest_m_ > nearest_m_ ? static_cast<double>(count) / (farthest_m_ - nearest_m_) : 0;
  bucket_begin_.assign(count + 1, 0);
  const auto buckets = [&](const BorderSide& side) {
    const auto& triangle = tin.triangles[side.triangle];
    const double a = to_profile_frame(view, tin.vertices_m[triangle[(side.k + 1U) % 3]]).v;
    const double b = to_profile_frame(view, tin.vertices_m[triangle[(side.k + 2U) % 3]]).v;
    return std::pair{bucket_of(std::min(a, b)), bucket_of(std::max(a, b))};
  };
  for (const BorderSide& side : border)
    for (auto [b, last] = buckets(side); b <= last; ++b) ++bucket_begin_[b + 1];
  for (std::size_t b = 0; b < count; ++b) bucket_begin_[b + 1] += bucket_begin_[b];
  sides_.resize(bucket_begin_.back());
  std::vector<std::uint32_t> next(bucket_begin_.begin(), bucket_begin_.end() - 1);
  for (const BorderSide& side : border)
    for (auto [b, last] = buckets(side); b <= last; ++b) sides_[next[b]++] = side;
}

std::size_t TinCutter::bucket_of(double depth_m) const {
  const double bucket = (depth_m - nearest_m_) * buckets_per_m_;
  return std::min(static_cast<std::size_t>(std::max(bucket, 0.0)), bucket_begin_.size() - 2);
}

void TinCutter::cut(double depth_m, Profile& out) const {
  out.clear();
  out.depth_m = depth_m;
  if (!(depth_m >= nearest_m_ && depth_m <= farthest_m_)) return;
  Profile found;
  // Vertices in the plane count as far, except where the TIN only touches the plane from behind:
  // then nothing would be near.
  Walk walk{tin_, view_, level_, walls_, turned_walls_, depth_m, depth_m > nearest_m_, found};
  std::vector<Run> runs;
  const std::size_t bucket = bucket_of(depth_m);
  for (std::size_t i = bucket_begin_[bucket]; i < bucket_begin_[bucket + 1]; ++i) {
    const auto& [t, k] = sides_[i];
    const std::size_t begin = found.size();
    bool along = false;
    const auto corner = [&](std::size_t n) { return walk.vertex(tin_.triangles[t][(k + n) % 3]); };
    const CutVertex from = corner(1), to = corner(2);
    if (walk.is_far(from) && !walk.is_far(to))
      walk.run(t, k);
    else if (from.at.v == depth_m && to.at.v == depth_m &&
             walk.is_far(corner(0)) == walk.is_far(from)) {
      walk.run_along(t, k);
      along = true;
    }
    if (found.size() > begin + 1)
      runs.push_back({begin, found.size(), found.u_m[begin], found.u_m.back(), along});
  }
  keep_ground_in_front(runs);
  put_in_order(found, runs, out);
}

} // namespace orograph
