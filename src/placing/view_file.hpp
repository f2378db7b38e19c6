// SPDX-License-Identifier: GPL-3.0-or-later
// A view of plane projection in a file, with every parameter that PHIGS gives it.
#pragma once

#include "geometry/api.hpp"
#include "geometry/box.hpp"
#include "geometry/vec.hpp"
#include "view/projection.hpp"

#include <optional>
#include <string>
#include <vector>

namespace orograph {

/// A view as a file gives it: points in the terrain's CRS with heights in the file's unit above its
/// datum; lengths in metres.
struct ViewFile {
  PhigsProjection projection = PhigsProjection::perspective;
  Vec3 vrp_map;                          ///< view reference point, map coordinates, true height
  Vec3 vpn{0, -1, 0}, vup{0, 0, 1};      ///< directions: east, north, up; of any length
  Vec3 prp_m{0, 0, 1};                   ///< projection reference point (u, v, n)
  Box2 window_m{{-1, -1}, {1, 1}};       ///< umin, vmin, umax, vmax
  std::optional<double> front_m, back_m; ///< n of the planes; none: nothing is cut there
  double exaggeration = 1; ///< all heights are multiplied by it first, that of vrp too

  bool cuts() const { return front_m || back_m; }
};

/// TOML with the keys projection, vrp, vpn, vup (default [0, 0, 1]), prp, window, front, back and
/// exaggeration, the last three optional.
///
/// Throws Error, one line that begins with the file's name, and line where there is one: no such
/// file, a folder, too large; not TOML; a key that is unknown, missing, of the wrong type, with the
/// wrong count of numbers or with one that is not finite; a view that the stages of the pipeline
/// refuse (view_orientation, canonical_volume), or an eye (PRP) not in front of the back plane.
OROGRAPH_API ViewFile read_view_file(const std::string& path);

/// A view of a list, by name where it has one.
struct NamedView {
  std::string name;
  ViewFile view;
};

/// TOML with a table [[view]] for each view: the keys of a view file, and `name`, which may be left
/// out. Throws Error as `read_view_file` does, and where there is no view, where a name is empty or
/// can't be a part of a file's name, and where there are other keys beside the views.
OROGRAPH_API std::vector<NamedView> read_view_list(const std::string& path);

/// TOML that reads back to the very same numbers, bit for bit. REQUIRES finite numbers.
OROGRAPH_API std::string view_file_text(const ViewFile& view);

} // namespace orograph
