// SPDX-License-Identifier: GPL-3.0-or-later
// What is asked of profiles' tone: how close lines lie on the page, and how light falls on them.
#pragma once

#include "geometry/vec.hpp"

#include <optional>

namespace orograph {

/// How lines show what light falls on the ground: by their widths; by their distances, with a pen
/// of one width; or not at all, so that it is only told.
enum class LightShownBy { width, density, nothing };

/// Light from one direction on ground that reflects it evenly. The darkness of ground with the unit
/// normal n is least + (greatest - least) (1 - max(0, n . towards))^1.2, as a share of black, at a
/// contrast of 1.
struct GroundLight {
  Vec3 towards;           ///< unit; in the profile frame: right, away from the viewer, up
  double least, greatest; ///< darkness where light falls squarely, and where none falls
  double contrast = 1;    ///< factor of how far it is from that of level ground
  double smooth_mm = 1;   ///< normals are means over about this, on the page
  LightShownBy shown_by = LightShownBy::width;
  bool stands = false; ///< in a panorama: towards that of its middle, else of each column
};

struct ToneRequest {
  double spacing_mm;   ///< between lines, on the page, wherever the ground is
  bool is_even = true; ///< else profiles stay where they were planned, and are drawn as a whole
  double pen_width_mm; ///< of lines without light
  double least_width_mm, greatest_width_mm; ///< of lines that carry light
  std::optional<GroundLight> light;
  double haze = 0;           ///< share of their darkness that the farthest lines lose
  bool draws_level = false;  ///< whether level ground has lines
  bool both_sides = false;   ///< the underside is seen as well
  bool keeps_unseen = false; ///< planned profiles stay where nothing of them would be drawn

  bool is_shown_by(LightShownBy way) const { return light && light->shown_by == way; }
};

} // namespace orograph
