// SPDX-License-Identifier: GPL-3.0-or-later
// From visible polylines in the visibility plane to strokes on the page.
#pragma once

#include "draw/drawing.hpp"
#include "geometry/homography.hpp"
#include "geometry/profile_point.hpp"

#include <cstdint>
#include <functional>
#include <vector>

namespace orograph {

struct StrokePoint {
  Vec2 plane; ///< in the visibility plane
  ProfilePoint scene;
};

struct StrokeSettings {
  Homography to_page; ///< visibility plane to page
  Box2 frame_mm;      ///< strokes end here
  double simplify_mm = 0.02;
  double min_stroke_mm = 0; ///< shorter strokes are left out
  bool perspective = true;  ///< depth is linear in 1/v along a projected line, not in v
  std::function<Vec3(ProfilePoint)> to_map; ///< empty where the output isn't tied to the ground
};

/// Takes one polyline after another, cuts it at the frame, simplifies what is inside and appends it
/// to a layer. Memory: one polyline.
class StrokeBuilder {
public:
  /// REQUIRES that both outlive the builder.
  StrokeBuilder(const StrokeSettings& settings, Layer& layer)
      : settings_(settings), layer_(layer) {}

  /// A new polyline begins; `profile` and `depth_m` as in Stroke.
  void begin(std::int32_t profile, double depth_m);
  void add(const StrokePoint& point);
  void end();

  /// Length of the strokes that were too short.
  double left_out_mm() const { return left_out_mm_; }

private:
  struct PagePoint {
    double x, y, w; ///< homogeneous page coordinates
  };
  PagePoint page_of(Vec2 plane) const;
  bool is_inside(const PagePoint& p) const;
  StrokePoint between(const StrokePoint& a, const StrokePoint& b, double share) const;
  void append(const StrokePoint& point);
  bool is_long_enough();
  void flush();

  const StrokeSettings& settings_;
  Layer& layer_;
  Stroke stroke_;
  bool has_last_ = false, last_inside_ = false;
  StrokePoint last_;
  PagePoint last_page_{};
  std::vector<Vec2> page_mm_;
  std::vector<ProfilePoint> scene_;
  std::vector<std::uint32_t> kept_;
  double left_out_mm_ = 0;
};

} // namespace orograph
