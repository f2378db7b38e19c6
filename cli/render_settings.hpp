// SPDX-License-Identifier: GPL-3.0-or-later
// Everything that `orograph render` is told, checked and in its own types.
#pragma once

#include "cli/given_place.hpp"
#include "cli/view_file.hpp"
#include "dem/read/read_options.hpp"
#include "draw/page.hpp"
#include "draw/write_drawing.hpp"
#include "geometry/angle.hpp"
#include "profiles/plan_request.hpp"
#include "solids/scene_file.hpp"
#include "view/view_request.hpp"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace orograph {

/// Of a standing person, above the ground.
constexpr double kEyeHeight_m = 2;

enum class Occluder { surface, profiles };
enum class Curvature { automatic, on, off };
enum class FlatGround { shore, draw };

struct RenderSettings {
  std::vector<std::string> inputs; ///< one at least; several are joined
  std::string output;
  ReadOptions reading;

  std::string scene_file;                  ///< its path; empty: no solids
  std::shared_ptr<const SceneFile> solids; ///< what it holds
  bool dashes_hidden = false;              ///< hidden edges of solids in a layer of their own

  std::string view_file;        ///< its path; empty: the view is as the following say
  std::optional<ViewFile> view; ///< what it holds
  Projection projection = Projection::perspective;
  Oblique oblique = kCavalier;
  Angle from_azimuth = Angle::degrees(180), from_elevation = Angle::degrees(25);
  std::optional<Angle> field_of_view;
  std::optional<double> distance_m;
  std::optional<GivenPlace> eye_map, look_at_map;       ///< in map coordinates
  std::optional<GivenPlace> eye_lonlat, look_at_lonlat; ///< longitude and latitude, WGS 84
  std::optional<double> eye_height_m;                   ///< none: kEyeHeight_m
  std::optional<Angle> look_azimuth;                    ///< from true north where it is known
  Angle pitch;
  Angle roll;
  Curvature curvature = Curvature::automatic;
  double refraction = 0.13;           ///< K: share of the earth's curvature that rays follow
  std::optional<double> exaggeration; ///< none: chosen from the terrain

  std::optional<PlanRequest> plan; ///< none: four pen widths on the page
  Occluder occluder = Occluder::surface;
  double visibility_tolerance_mm = 1e-4;
  double simplify_mm = 0.02;
  double silhouette_jump = 0.003; ///< share of the depth by which the ground behind is farther
  double min_stroke_mm = 0;
  FlatGround flat = FlatGround::shore;
  std::vector<std::string> layers{"profiles",    "shores",  "border",
                                  "silhouettes", "skyline", "solids"};
  bool void_edges = false; ///< the layer `voids` as well

  PageRequest page;
  double pen_width_mm = 0.15;
  std::string title; ///< empty: the input's file name, or the first's and how many more

  WriteOptions write;
  std::uint64_t check = 0; ///< points to ask of the ray walk
  std::string report;      ///< path of the JSON report; empty: none
  bool quiet = false;
  std::optional<bool> progress; ///< none: where stderr is a terminal

  bool has_eye() const { return eye_map || eye_lonlat; }
};

} // namespace orograph
