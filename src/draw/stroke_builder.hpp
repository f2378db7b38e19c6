// SPDX-License-Identifier: GPL-3.0-or-later
// From visible polylines in the visibility plane to strokes on the page.
#pragma once

#include "draw/drawing.hpp"
#include "geometry/clip_by_planes.hpp"
#include "geometry/homography.hpp"
#include "geometry/panorama_page.hpp"
#include "geometry/profile_point.hpp"
#include "geometry/turn.hpp"

#include <algorithm>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace orograph {

/// Both are affine functions of one point of the scene.
struct StrokePoint {
  Vec3 plane; ///< in the visibility plane, in homogeneous coordinates (X w, Y w, w)
  ProfilePoint scene;
};

/// From the u and z of points at one depth, as a profile has them, to those of both of their
/// places.
struct PointsAtDepth {
  double u_sign; ///< -1 where the profile's frame looks the other way than the scene's
  double v;      ///< of all points, in the scene
  double aside, per_z, above, w; ///< in the plane X w is u + aside and Y w is per_z z + above
  /// Of a panorama, whose scene has no one depth for them: from the profile's frame, in which they
  /// are at depth v, to the scene's.
  std::optional<Turn> turn = std::nullopt;

  StrokePoint at(double u, double z) const {
    if (turn) return {{}, (*turn)({u, v, z})};
    const double scene_u = u_sign * u;
    return {{scene_u + aside, per_z * z + above, w}, {scene_u, v, z}};
  }
};

/// Where in a view volume's depth a point of the scene is: between -w at the back plane and 0 at
/// the front plane, w being that of the point on the page.
struct VolumeDepth {
  double per_u, per_v, per_z, at_origin;
};

/// Rounding puts a point of a plane on either side of it: a picture that fills the frame touches
/// its sides (in mm), and along the front and back plane, where they cut the terrain, lines lie in
/// them.
constexpr double kInPlane = 1e-9;

/// For each plane of the view volume (left, right, above, below, back, front) how far inside a
/// point is, in some measure: its place on the page, in homogeneous coordinates, and in the scene.
/// Without `depth` there is no back and no front.
PlaneValues plane_values(const Box2& frame_mm, const std::optional<VolumeDepth>& depth,
                         const Vec3& page, ProfilePoint scene);

/// How far a panorama's bent lines may be off: far below what simplification may move, and below
/// the page's step where nothing is simplified.
constexpr double panorama_bend_mm(double simplify_mm) {
  constexpr double kLeast_mm = 5e-7, kShareOfSimplification = 1e-3;
  return std::max(kLeast_mm, kShareOfSimplification * simplify_mm);
}

/// Of one width less of a line isn't worth its own stroke.
constexpr double kShortWidth_mm = 1;

struct StrokeSettings {
  Homography to_page; ///< visibility plane to page
  /// Instead of it: from the scene to the page, on which straight lines are bent. They get points
  /// between, so that nowhere more than `bend_mm` is lost.
  std::optional<PanoramaPage> panorama = std::nullopt;
  double bend_mm = 0;
  Box2 frame_mm;                    ///< strokes end here
  std::optional<VolumeDepth> depth; ///< and at the front and back plane, where there are any
  double simplify_mm = 0.02;
  double min_stroke_mm = 0;                 ///< shorter strokes are left out
  std::function<Vec3(ProfilePoint)> to_map; ///< empty where the output isn't tied to the ground
  bool keeps_depths = false;                ///< `Layer::depths_m` is filled
  bool keeps_widths = false;                ///< however short: lines go on elsewhere

  bool keeps_scene() const { return to_map || keeps_depths; }
};

/// Takes one polyline after another, clips it to the frame and between the planes, simplifies what
/// is inside and appends it to a layer. Memory: one polyline.
class StrokeBuilder {
public:
  /// REQUIRES that both outlive the builder.
  StrokeBuilder(const StrokeSettings& settings, Layer& layer)
      : settings_(settings), layer_(layer) {}

  /// A new polyline begins; `profile` and `depth_m` as in Stroke.
  void begin(std::int32_t profile, double depth_m);
  /// From the last point on the polyline is this wide: another stroke, which begins where the one
  /// before it ends. What comes out of the frame less than a millimetre before its end, or ends so
  /// soon, keeps its width, unless the settings say otherwise. 0: the layer's pen.
  void widen(double width_mm);
  void add(const StrokePoint& point) {
    if (settings_.panorama)
      add_bent(point.scene);
    else
      add_straight(point);
  }
  /// The same of many points at once, in order along the polyline: a quarter of the time.
  void add(const PointsAtDepth& depth, std::span<const double> u_m, std::span<const double> z_m);
  void end();

  /// Length of the strokes that were too short.
  double left_out_mm() const { return left_out_mm_; }

private:
  struct Last {
    StrokePoint point;
    bool inside; ///< in the view volume
  };
  void add_straight(const StrokePoint& point) {
    // From inside to inside, as nearly always: there is nothing to clip.
    const Vec3 page = settings_.to_page.of(point.plane);
    if (!settings_.depth && last_ && last_->inside && is_in_frame(page)) {
      append(point, page);
      last_->point = point;
      return;
    }
    add_clipped(point, page);
  }
  void add_bent(ProfilePoint scene);
  void add_bent_at(ProfilePoint scene, double azimuth);
  void bend_to(ProfilePoint scene, double azimuth);
  void bend_part_to(ProfilePoint scene, double azimuth, double most_tangent);
  // In homogeneous page coordinates; what is in a side's plane, to rounding, is inside.
  bool is_in_frame(const Vec3& page) const {
    const auto& [x, y, w] = page;
    const auto& [low, high] = settings_.frame_mm;
    const double slack = kInPlane * w;
    return w > 0 && x - low.x * w >= -slack && high.x * w - x >= -slack &&
           y - low.y * w >= -slack && high.y * w - y >= -slack;
  }
  PlaneValues values_of(const StrokePoint& point, const Vec3& page) const {
    return plane_values(settings_.frame_mm, settings_.depth, page, point.scene);
  }
  void add_clipped(const StrokePoint& point, const Vec3& page);
  void append(const StrokePoint& point) { append(point, settings_.to_page.of(point.plane)); }
  void append(const StrokePoint& point, const Vec3& page) {
    if (!(page.z > 0)) return; // the eye itself
    // A point cut at the frame may round to just outside of it.
    const Box2& frame = settings_.frame_mm;
    page_mm_.push_back({std::clamp(page.x / page.z, frame.low.x, frame.high.x),
                        std::clamp(page.y / page.z, frame.low.y, frame.high.y)});
    if (settings_.keeps_scene()) scene_.push_back(point.scene);
  }
  bool append_inside(const PointsAtDepth& depth, std::span<const double> u_m,
                     std::span<const double> z_m);
  bool is_long_enough();
  double depth_m(ProfilePoint scene) const;
  void drop_short_widenings();
  void append_stroke(std::size_t first, std::size_t last);
  void flush();

  const StrokeSettings& settings_;
  Layer& layer_;
  Stroke stroke_;
  std::optional<Last> last_;
  struct Bent {
    ProfilePoint scene;
    double azimuth;
  };
  std::optional<Bent> bent_; ///< the last point, of a panorama
  std::vector<Vec2> page_mm_;
  std::vector<ProfilePoint> scene_;
  std::vector<std::uint32_t> kept_;
  struct Widening {
    std::size_t point; ///< of page_mm_, where it begins
    double width_mm;
  };
  double width_mm_ = 0;             ///< at the last point
  std::vector<Widening> widenings_; ///< behind the first point
  double left_out_mm_ = 0;
};

} // namespace orograph
