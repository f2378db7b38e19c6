// SPDX-License-Identifier: GPL-3.0-or-later
// What is known of a map beside its lines: what it was drawn from, how it is seen, how exactly.
#pragma once

#include "dem/levels/level_of_detail.hpp"
#include "dem/triangulate/triangulation_counts.hpp"
#include "draw/drawing.hpp"
#include "geometry/homography.hpp"
#include "geometry/vec.hpp"
#include "hidden_lines/counts.hpp"
#include "map/name_facts.hpp"
#include "placing/view_file.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace orograph {

/// Random points asked of the ray walk (`MapSpec::check`).
struct CheckCounts {
  std::uint64_t asked = 0;
  std::uint64_t ties = 0;    ///< within the visibility tolerance and rounding: not judged
  std::uint64_t hidden = 0;  ///< drawn, but hidden
  std::uint64_t missing = 0; ///< visible, but not drawn
};

inline CheckCounts operator+(const CheckCounts& a, const CheckCounts& b) {
  return {a.asked + b.asked, a.ties + b.ties, a.hidden + b.hidden, a.missing + b.missing};
}

/// What is drawn of a level of the file's surface, asked of that surface
/// (`MapSpec::check_of_file`). A level that is off by no more than `within_mm` hides, or shows, no
/// more than twice that.
struct CheckOfFile {
  double within_mm = 0; ///< on the page, as the error budget has it
  CheckCounts counts;   ///< `hidden` is what lies behind the file's surface by more than twice that
};

/// Where a terrain comes from, as its readers know it.
struct InputFacts {
  std::vector<std::string> paths;                   ///< as given
  std::string crs_name, crs_wkt, vertical_crs_name; ///< as in MapFrame
  std::string unit_name, height_unit_name;
  double unit_m = kNotMeasured, unit_deg = kNotMeasured; ///< the one that there is
  double height_unit_m = 1;
  std::optional<std::uint64_t> columns, rows;                     ///< of a grid
  double column_step_m = kNotMeasured, row_step_m = kNotMeasured; ///< lengths; of a grid
  std::optional<std::uint64_t> vertices, triangles;               ///< of a TIN
  std::optional<TriangulationCounts> triangulation;               ///< of points
  double surface_error_m = 0;                                     ///< as in Terrain
  std::vector<std::string> notes;
};

struct CurvatureFacts {
  std::string setting;              ///< as asked for: "auto", "on" or "off"
  bool applied = false;             ///< drawn or left out
  bool on_ellipsoid = false;        ///< drawn by the places of vertices themselves, of
                                    ///< degrees; then would_move_mm is what refraction moves
  double would_move_mm = 0;         ///< on the page, at most
  double refraction = 0;            ///< K
  double curvature_coefficient = 1; ///< 1 - K, GDAL's notation
  double effective_radius_m = kNotMeasured; ///< R / (1 - K), surveyors' notation; of Euler's radius
                                            ///< along the view; NaN where K is 1
};

/// Along the ellipsoid, from the eye to the point looked at.
struct Geodesic {
  double distance_m, azimuth_deg; ///< at the eye, from true north
};

/// What a panorama shows of the horizon, and how large.
struct PanoramaFacts {
  /// From its left side to its right one, from less to more; from true north, or from the map's
  /// where the CRS doesn't tell it.
  double azimuth_from_deg = 0, azimuth_to_deg = 360;
  double altitude_low_deg = 0, altitude_high_deg = 0;
  double radius_mm = 0; ///< a radian of azimuth on the page
  int strips = 1;
};

/// Points are in map coordinates with true heights, whatever the exaggeration.
struct ViewFacts {
  std::string projection;
  double view_from_azimuth_deg = kNotMeasured; ///< where the viewer stands
  bool view_from_auto = false;                 ///< chosen, and so is the elevation
  double look_azimuth_deg = kNotMeasured;      ///< where the eye looks
  double elevation_deg = kNotMeasured;         ///< of the viewer above the target's horizontal
  std::optional<Vec3> eye;                     ///< none in a parallel view
  std::optional<Vec3> look_at;                 ///< none where the eye looks in a direction
  double look_azimuth_true_deg = kNotMeasured; ///< where the eye looks, from true north; null where
                                               ///< the CRS doesn't tell it
  std::optional<Vec3> eye_lonlat, look_at_lonlat; ///< longitude, latitude, and height as above
  double eye_height_m = kNotMeasured; ///< above the ground, heights exaggerated; null where
                                      ///< there is no ground
  double distance_m = kNotMeasured;   ///< eye to look_at, heights exaggerated
  std::optional<Geodesic> geodesic;   ///< where both are at a place of the earth
  Vec2 depth_origin;                  ///< where depth is 0
  Vec2 forward;                       ///< unit, horizontal
  double field_of_view_deg = kNotMeasured;
  std::optional<PanoramaFacts> panorama;
  std::optional<Vec2> oblique; ///< length and rise in degrees of lines away from the viewer
  double roll_deg = 0;
  double exaggeration = 1;
  bool exaggeration_auto = false;
  CurvatureFacts curvature;
  Homography homography; ///< visibility plane to page mm; of a panorama near its middle
  ViewFile phigs;        ///< the same view, as a file holds it; not of a panorama
};

struct ProfileFacts {
  std::string spacing; ///< what was asked for: "0.6mm", "100m" or "150 profiles"
  std::vector<double> depths_m;
};

/// A layer of the drawing, and the pen's way to draw it, from where the layer before it ends.
struct LayerFacts {
  std::string name;
  std::uint64_t strokes = 0;
  double ink_mm = 0, pen_up_mm = 0;
  std::uint64_t pen_lifts = 0;
};

/// Visible ink that was left out on purpose, mm on the page.
struct InkLeftOut {
  double silhouette_jump_mm = 0, min_stroke_mm = 0;
};

/// Largest displacement on paper by cause, in mm. The report adds their sum as "total", the
/// drawing's bound.
struct ErrorBudget {
  // None: "unknown", and so is the total.
  std::optional<double> level_of_detail_mm = 0, geodesy_mm = 0;
  double simplification_mm = 0, joining_mm = 0, shore_smoothing_mm = 0, visibility_tolerance_mm = 0,
         arithmetic_mm = 0, rounding_mm = 0;

  /// None where a cause isn't known.
  std::optional<double> total_mm() const {
    if (!level_of_detail_mm || !geodesy_mm) return std::nullopt;
    return simplification_mm + joining_mm + shore_smoothing_mm + visibility_tolerance_mm +
           arithmetic_mm + *geodesy_mm + rounding_mm + *level_of_detail_mm;
  }
};

/// A piece of furniture; "window": the picture, or a strip of it.
struct FurnitureFacts {
  std::string piece;
  std::optional<Box2> box_mm = {};     ///< none: it has no room, or no meaning in this picture
  std::vector<std::string> texts = {}; ///< as they are printed
  std::vector<std::string> cut = {};   ///< those of them that are longer, whole
};

struct MapFacts {
  InputFacts input;
  ViewFacts view;
  std::optional<LevelOfDetail> level; ///< none: the file's own surface is drawn
  ProfileFacts profiles;
  Counts counts;
  std::vector<LayerFacts> layers; ///< in drawing order
  StageSeconds seconds;
  ErrorBudget error_budget; ///< of the drawing in memory; a file's format may add its rounding
  InkLeftOut left_out;
  std::optional<CheckCounts> check; ///< where one was asked for
  std::optional<CheckOfFile> check_of_file;
  double pen_down_mm = kNotMeasured, pen_up_mm = kNotMeasured;
  std::uint64_t pen_lifts = 0;
  std::optional<NamesFacts> names; ///< none: none were given
  std::vector<FurnitureFacts> furniture;
  std::vector<std::string> lettering; ///< a sentence each: what letters there were none of
};

struct Map {
  Drawing drawing;
  MapFacts facts;
};

} // namespace orograph
