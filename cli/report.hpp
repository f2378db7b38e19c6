// SPDX-License-Identifier: GPL-3.0-or-later
// The run report: what was drawn, how exactly and in which time, as JSON (docs/how-it-works.md).
#pragma once

#include "cli/view_file.hpp"
#include "dem/triangulate/triangulate.hpp"
#include "geometry/homography.hpp"
#include "geometry/vec.hpp"

#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace orograph {

constexpr double kNotMeasured = std::numeric_limits<double>::quiet_NaN();

/// Numbers that are NaN, and optionals that hold nothing, become null unless said otherwise.
struct InputReport {
  std::vector<std::string> paths;                   ///< as given
  std::string crs_name, crs_wkt, vertical_crs_name; ///< as in MapFrame
  std::string unit_name, height_unit_name;
  double unit_m = kNotMeasured, unit_deg = kNotMeasured; ///< the one that there is
  double height_unit_m = 1;
  std::optional<std::uint64_t> columns, rows;                     ///< of a grid
  double column_step_m = kNotMeasured, row_step_m = kNotMeasured; ///< lengths; of a grid
  std::optional<std::uint64_t> vertices, triangles;               ///< of a TIN
  std::string scene_path;                                         ///< empty: no solids
  std::optional<TriangulationCounts> triangulation;               ///< of points
  double surface_error_m = 0;                                     ///< as in Terrain
  std::vector<std::string> notes;
};

struct CurvatureReport {
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
struct GeodesicReport {
  double distance_m, azimuth_deg; ///< at the eye, from true north
};

/// Points are in map coordinates with true heights, whatever the exaggeration.
struct ViewReport {
  std::string projection;
  double view_from_azimuth_deg = kNotMeasured; ///< where the viewer stands
  double look_azimuth_deg = kNotMeasured;      ///< where the eye looks
  double elevation_deg = kNotMeasured;         ///< of the viewer above the target's horizontal
  std::optional<Vec3> eye;                     ///< none in a parallel view
  std::optional<Vec3> look_at;                 ///< none where the eye looks in a direction
  double look_azimuth_true_deg = kNotMeasured; ///< where the eye looks, from true north; null where
                                               ///< the CRS doesn't tell it
  std::optional<Vec3> eye_lonlat, look_at_lonlat; ///< longitude, latitude, and height as above
  double eye_height_m = kNotMeasured; ///< above the ground, in the exaggerated scene; null where
                                      ///< there is no ground
  double distance_m = kNotMeasured;   ///< eye to look_at, in the exaggerated scene
  std::optional<GeodesicReport> geodesic; ///< where both are at a place of the earth
  Vec2 depth_origin;                      ///< where depth is 0
  Vec2 forward;                           ///< unit, horizontal
  double field_of_view_deg = kNotMeasured;
  std::optional<Vec2> oblique; ///< length and rise in degrees of lines away from the viewer
  double roll_deg = 0;
  double exaggeration = 1;
  bool exaggeration_auto = false;
  CurvatureReport curvature;
  Homography homography; ///< visibility plane to page mm
  ViewFile phigs;        ///< the same view, as `--view` takes it
};

struct ProfilesReport {
  std::string spacing; ///< what was asked for: "0.6mm", "100m" or "150 profiles"
  std::vector<double> depths_m;
};

struct CountsReport {
  std::uint64_t cut_vertices = 0, segments = 0;
  std::uint64_t pieces_before_collapse = 0, pieces_after_collapse = 0, largest_horizon = 0;
  std::uint64_t strokes = 0, points = 0, ties = 0, dropped_strokes = 0;
  std::uint64_t turned_over = 0; ///< triangles that the ellipsoid turns over in plan
  double looked_at = 1;          ///< share of the ground that wasn't passed over as a whole
  std::uint64_t solids = 0, solid_edges = 0; ///< instances, and edges of all of them
};

/// Random points asked of the ray walk (`--check`).
struct CheckReport {
  std::uint64_t asked = 0;
  std::uint64_t ties = 0;    ///< within the visibility tolerance and rounding: not judged
  std::uint64_t hidden = 0;  ///< drawn, but hidden
  std::uint64_t missing = 0; ///< visible, but not drawn
};

inline CheckReport operator+(const CheckReport& a, const CheckReport& b) {
  return {a.asked + b.asked, a.ties + b.ties, a.hidden + b.hidden, a.missing + b.missing};
}

/// Visible ink that was left out on purpose, mm on the page.
struct LeftOutReport {
  double silhouette_jump_mm = 0, min_stroke_mm = 0;
};

struct SecondsReport {
  double read = kNotMeasured, place = kNotMeasured, facing = kNotMeasured, cut = kNotMeasured,
         project = kNotMeasured, clip = kNotMeasured, check = kNotMeasured, layout = kNotMeasured,
         write = kNotMeasured, total = kNotMeasured;
};

/// Largest displacement on paper by cause, in mm. The report adds their sum as "total", the
/// drawing's bound.
struct ErrorBudget {
  // None: "unknown", and so is the total.
  std::optional<double> level_of_detail_mm = 0, geodesy_mm = 0;
  double simplification_mm = 0, visibility_tolerance_mm = 0, arithmetic_mm = 0, rounding_mm = 0;

  /// None where a cause isn't known.
  std::optional<double> total_mm() const {
    if (!level_of_detail_mm || !geodesy_mm) return std::nullopt;
    return simplification_mm + visibility_tolerance_mm + arithmetic_mm + *geodesy_mm + rounding_mm +
           *level_of_detail_mm;
  }
};

struct DrawingReport {
  std::string path, format;
  double page_width_mm = 0, page_height_mm = 0, margin_mm = 0;
  double pen_down_mm = kNotMeasured, pen_up_mm = kNotMeasured;
};

struct RunReport {
  InputReport input;
  ViewReport view;
  ProfilesReport profiles;
  CountsReport counts;
  SecondsReport seconds;
  std::uint64_t peak_memory_bytes = 0;
  ErrorBudget error_budget;
  LeftOutReport left_out;
  std::optional<CheckReport> check; ///< where one was asked for
  DrawingReport drawing;
  std::map<std::string, std::string> libraries; ///< name to version
};

/// The JSON text, `"schema": 1`, with the program's version and commit.
std::string report_text(const RunReport& report);

/// Writes it whole or not at all; to a path that ends in ".toml" only the view, as `--view` takes
/// it. Throws Error where it can't be written, or exists and
/// `overwrite` is off.
void write_report(const RunReport& report, const std::string& path, bool overwrite);

} // namespace orograph
