// SPDX-License-Identifier: GPL-3.0-or-later
#include "view/visibility_homography.hpp"

#include "view/pipeline.hpp"

namespace orograph {

Homography homography_of(const PhigsView& view, const ProfileFrame& frame,
                         const Box2& viewport_mm) {
  const Eigen::Matrix4d page = compose(Eigen::Matrix4d::Identity(), view, viewport_mm);
  const Vec2 right = frame.right();
  const Vec3 origin = frame.origin_m;
  const Eigen::Vector4d across(right.x, right.y, 0, 0), up(0, 0, 1, 0),
      forward(frame.forward.x, frame.forward.y, 0, 0), start(origin.x, origin.y, origin.z, 1);

  Eigen::Matrix<double, 4, 3> columns;
  if (view.projection == PhigsProjection::perspective) {
    columns << across, up, forward;
  } else {
    columns << across, (is_vertical(direction_of_projection(view)) ? forward : up), start;
  }
  const Eigen::Matrix<double, 4, 3> image = page * columns;
  Homography homography;
  for (int column = 0; column < 3; ++column) {
    homography.m[column] = image(0, column);
    homography.m[3 + column] = image(1, column);
    homography.m[6 + column] = image(3, column);
  }
  return homography;
}

std::array<double, 4> volume_depth(const PhigsView& view, const ProfileFrame& frame) {
  const Eigen::Matrix4d page = compose(Eigen::Matrix4d::Identity(), view, {{0, 0}, {1, 1}});
  const auto of = [&](double x, double y, double z, double w) {
    return page.row(2).dot(Eigen::Vector4d(x, y, z, w));
  };
  const Vec2 right = frame.right();
  return {of(right.x, right.y, 0, 0), of(frame.forward.x, frame.forward.y, 0, 0), of(0, 0, 1, 0),
          of(frame.origin_m.x, frame.origin_m.y, 0, 1)};
}

} // namespace orograph
