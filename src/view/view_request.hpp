// SPDX-License-Identifier: GPL-3.0-or-later
// What a user asks of a view, before it meets a terrain.
#pragma once

#include "geometry/angle.hpp"
#include "geometry/vec.hpp"
#include "view/projection.hpp"

#include <optional>

namespace orograph {

/// How far ground sinks below the map plane with the square of its distance, north and east of the
/// eye (of the point looked at in a parallel view), per metre: half the earth's curvature, less
/// what refraction lifts. Not exaggerated.
struct EarthDrop {
  double per_north = 0, per_east = 0;
  bool operator==(const EarthDrop&) const = default;
};

/// Azimuth clockwise from the ground frame's north; pitch upwards, -90 to 90 degrees, of the camera
/// in the exaggerated scene.
struct LookDirection {
  Angle azimuth, pitch;
};

struct ViewRequest {
  Projection projection = Projection::perspective;
  Oblique oblique; ///< oblique only
  /// Where the viewer stands, seen from the target: azimuth clockwise from north, elevation above
  /// the horizontal, 0 to 90 degrees, and from -90 where both sides are looked at. Not looked at
  /// where `eye_m` is given; the elevation not in an oblique view.
  Angle from_azimuth = Angle::degrees(180), from_elevation = Angle::degrees(25);
  Horizontal elevation_above = Horizontal::of_target; ///< without an eye; perspective only
  /// Horizontal field, perspective only. Without an eye or a distance, the eye goes where the
  /// terrain fills this field (30 degrees by default). With a distance and a field, or with an eye
  /// (again 30 degrees by default), the page shows just this field. With a distance alone, the
  /// page shows the whole terrain.
  std::optional<Angle> field_of_view;
  std::optional<double> distance_m; ///< eye to target in space; perspective only
  std::optional<Vec3> eye_m;        ///< ground frame, true height
  std::optional<Vec3> look_at_m;    ///< ground frame, true height; else the terrain's centre
  /// Goes before `look_at_m`, where `eye_m` is given; perspective only. The view's target is then
  /// a metre ahead of the eye.
  std::optional<LookDirection> look;
  Angle roll; ///< the picture turns clockwise by it
  EarthDrop drop;
  bool both_sides = false; ///< the underside is part of the picture, too
  double exaggeration = 1; ///< multiplies all heights, the eye's and the target's too
};

} // namespace orograph
