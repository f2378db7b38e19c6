// SPDX-License-Identifier: GPL-3.0-or-later
#include "map/describe_map.hpp"

#include "dem/extent.hpp"
#include "dem/frame/local_frame.hpp"
#include "dem/height_at.hpp"
#include "dem/read/lonlat.hpp"
#include "draw/drawing.hpp"
#include "map/error_budget.hpp"
#include "placing/view_in_frame.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace orograph {
namespace {

std::string projection_name(Projection projection) {
  switch (projection) {
  case Projection::perspective:
    return "perspective";
  case Projection::orthographic:
    return "orthographic";
  case Projection::oblique:
    return "oblique";
  case Projection::cylindrical:
    return "cylindrical";
  case Projection::equirectangular:
    return "equirectangular";
  }
  return "perspective";
}

std::string spacing_text(const PlanRequest& plan) {
  if (const auto* page = std::get_if<PageSpacing>(&plan)) return fmt::format("{}mm", page->mm);
  if (const auto* ground = std::get_if<GroundSpacing>(&plan)) return fmt::format("{}m", ground->m);
  return fmt::format("{} profiles", std::get<ProfileCount>(plan).count);
}

Vec3 eye_on_map(const View& view, const MapFrame& map) {
  return map.to_map(
      {view.depth_origin_m.x, view.depth_origin_m.y, view.eye_z_m / view.exaggeration});
}

CurvatureFacts describe_curvature(const PlacedView& placed, Curvature setting) {
  const EarthCurvature& curvature = placed.curvature;
  CurvatureFacts out;
  out.setting = setting == Curvature::automatic ? "auto" : setting == Curvature::on ? "on" : "off";
  out.applied = curvature.applied;
  out.on_ellipsoid = curvature.on_ellipsoid;
  out.would_move_mm = curvature.would_move_mm;
  out.refraction = curvature.refraction;
  out.curvature_coefficient = 1 - curvature.refraction;
  const Vec2 along = placed.view.forward; // Euler: 1 / R is cos^2 / M + sin^2 / N
  const double per_m = along.y * along.y / curvature.radii.meridian_m +
                       along.x * along.x / curvature.radii.prime_vertical_m;
  if (curvature.refraction != 1) out.effective_radius_m = 1 / (per_m * (1 - curvature.refraction));
  return out;
}

std::optional<Vec3> lonlat_of(const MapFrame& map, const std::optional<Vec3>& place) {
  if (!place) return std::nullopt;
  const auto lonlat = lonlat_of_map(map.crs_wkt, {place->x, place->y});
  if (!lonlat) return std::nullopt;
  return Vec3{lonlat->x, lonlat->y, place->z};
}

// Clockwise from true north, at the eye or in a parallel view at the point looked at.
double true_azimuth_deg(const View& view, const MapFrame& map) {
  const Vec2 origin = view.depth_origin_m;
  const Vec3 at = map.to_map({origin.x, origin.y, 0});
  std::optional<Angle> azimuth;
  if (map.earth) {
    constexpr double kStep_m = 100; // positions are within nanometres
    const Vec2 ahead = origin + kStep_m * view.forward;
    const LocalFrame& frame = map.earth->local;
    azimuth = distance_and_azimuth(frame.to_geodetic({origin.x, origin.y, 0}),
                                   frame.to_geodetic({ahead.x, ahead.y, 0}), frame.ellipsoid())
                  .azimuth;
  } else {
    azimuth = true_azimuth(map.crs_wkt, {at.x, at.y}, atan2_angle(view.forward.x, view.forward.y));
  }
  if (!azimuth) return kNotMeasured;
  const double deg = azimuth->in_degrees();
  return deg < 0 ? deg + 360 : deg;
}

double eye_height_m(const View& view, const Surface& surface) {
  const auto ground_m = height_at(surface, view.depth_origin_m);
  return ground_m ? view.eye_z_m - *ground_m * view.exaggeration : kNotMeasured;
}

PanoramaFacts describe_panorama(const Panorama& panorama, double middle_deg) {
  return {middle_deg - 0.5 * panorama.width_deg,
          middle_deg + 0.5 * panorama.width_deg,
          panorama.altitude_deg(panorama.low_tangent),
          panorama.altitude_deg(panorama.high_tangent),
          panorama.page.radius_mm,
          std::max(1, static_cast<int>(panorama.strips.size()))};
}

InputFacts describe_input(const TerrainData& terrain) {
  const MapFrame& map = terrain.map;
  InputFacts out;
  out.paths = terrain.paths;
  out.crs_name = map.crs_name;
  out.crs_wkt = map.crs_wkt;
  out.vertical_crs_name = map.vertical_crs_name;
  out.unit_name = map.unit_name;
  out.height_unit_name = map.height_unit_name;
  if (map.earth)
    out.unit_deg = map.earth->unit_deg;
  else
    out.unit_m = map.unit_m;
  out.height_unit_m = map.height_unit_m;
  if (const Grid* grid = std::get_if<Grid>(&terrain.surface)) {
    out.columns = static_cast<std::uint64_t>(grid->columns);
    out.rows = static_cast<std::uint64_t>(grid->rows);
    const GridSteps steps = steps_of(*grid);
    out.column_step_m = length(steps.column_m);
    out.row_step_m = length(steps.row_m);
    if (const auto& read = terrain.larger_cells) { // what is in memory isn't what the file has
      out.column_step_m *= (grid->columns - 1.0) / (read->columns - 1);
      out.row_step_m *= (grid->rows - 1.0) / (read->rows - 1);
      out.columns = static_cast<std::uint64_t>(read->columns);
      out.rows = static_cast<std::uint64_t>(read->rows);
    }
  } else if (has_ground(terrain.surface)) {
    const Tin& tin = std::get<Tin>(terrain.surface);
    out.vertices = tin.vertices_m.size();
    out.triangles = tin.triangles.size();
  }
  out.triangulation = terrain.triangulation;
  out.surface_error_m = terrain.surface_error_m;
  out.notes = terrain.notes;
  return out;
}

} // namespace

ViewFacts describe_view(const PlacedView& placed, const TerrainData& terrain, const MapSpec& spec) {
  const View& view = placed.view;
  const MapFrame& map = terrain.map;
  const std::optional<ViewFile>& given = spec.view.file;
  ViewFacts out;
  out.projection = projection_name(placed.panorama ? spec.view.projection : view.projection);
  out.look_azimuth_deg = azimuth_deg(view.forward);
  out.view_from_azimuth_deg = azimuth_deg(-1.0 * view.forward);
  out.view_from_auto = placed.chosen_view.has_value();
  out.elevation_deg = view.elevation.in_degrees();
  out.look_azimuth_true_deg = true_azimuth_deg(view, map);
  if (!spec.view.look_azimuth && !placed.framed_by_skyline && !placed.panorama) {
    out.look_at = map.to_map(view.look_at_m);
    out.look_at_lonlat = lonlat_of(map, out.look_at);
  }
  if (view.is_perspective()) {
    out.eye = eye_on_map(view, map);
    out.eye_lonlat = lonlat_of(map, out.eye);
    out.eye_height_m = eye_height_m(view, terrain.surface);
    if (out.look_at) out.distance_m = view.distance_m;
    if (out.eye_lonlat && out.look_at_lonlat) {
      const auto [distance_m, azimuth] =
          distance_and_azimuth({out.eye_lonlat->x, out.eye_lonlat->y, 0},
                               {out.look_at_lonlat->x, out.look_at_lonlat->y, 0});
      out.geodesic = Geodesic{distance_m, azimuth.in_degrees()};
    }
    out.field_of_view_deg = atan2_angle(view.window.high.x, 1).in_degrees() -
                            atan2_angle(view.window.low.x, 1).in_degrees();
  }
  if (placed.panorama) {
    const double middle_deg =
        std::isnan(out.look_azimuth_true_deg) ? out.look_azimuth_deg : out.look_azimuth_true_deg;
    out.panorama = describe_panorama(*placed.panorama, middle_deg);
    out.field_of_view_deg = placed.panorama->width_deg;
  }
  // On the ellipsoid what is under the eye along the frame's upright depends on its height.
  const Vec3 origin =
      out.eye ? *out.eye : map.to_map({view.depth_origin_m.x, view.depth_origin_m.y, 0});
  out.depth_origin = {origin.x, origin.y};
  out.forward = view.forward;
  if (view.projection == Projection::oblique)
    out.oblique = Vec2{std::hypot(view.x_per_v, view.y_per_v),
                       atan2_angle(view.y_per_v, view.x_per_v).in_degrees()};
  out.roll_deg = view.roll.in_degrees();
  out.exaggeration = placed.exaggeration;
  out.exaggeration_auto = placed.exaggeration_chosen;
  out.homography = placed.to_page;
  out.phigs = given ? *given : view_file_of(view, map);
  out.phigs.exaggeration = placed.exaggeration;
  return out;
}

void entitle(Drawing& drawing, const TerrainData& terrain, const PlacedView& placed,
             const std::string& title) {
  const View& view = placed.view;
  const Panorama* panorama = placed.panorama ? &*placed.panorama : nullptr;
  drawing.title =
      !title.empty() ? title : std::filesystem::path(terrain.source).filename().string();
  drawing.description =
      panorama
          ? fmt::format("{} panorama of {:.6g} degrees, radius {:.6g} mm; exaggeration {:.6g}; "
                        "{} profiles; CRS {}",
                        panorama->kind == PanoramaKind::cylindrical ? "cylindrical"
                                                                    : "equirectangular",
                        panorama->width_deg, panorama->page.radius_mm, placed.exaggeration,
                        placed.depths_m.size(), terrain.map.crs_name)
          : fmt::format("{} view from azimuth {:.6g}, elevation {:.6g} degrees; "
                        "exaggeration {:.6g}; {} profiles; CRS {}",
                        projection_name(view.projection), azimuth_deg(-1.0 * view.forward),
                        view.elevation.in_degrees(), placed.exaggeration, placed.depths_m.size(),
                        terrain.map.crs_name);
}

void describe_map(Map& map, const TerrainOfView& of_view, const PlacedView& placed,
                  const MapSpec& spec) {
  const TerrainData& terrain = *of_view;
  MapFacts& facts = map.facts;
  facts.input = describe_input(of_view.without_level());
  facts.view = describe_view(placed, terrain, spec);
  facts.view.curvature = describe_curvature(placed, spec.view.curvature);
  facts.profiles = {spacing_text(placed.plan), placed.depths_m};
  facts.error_budget = error_budget(terrain, placed, spec, facts.level);
  if (facts.level) facts.level->greatest_mm = level_of_detail_mm(terrain, placed, facts.level);
  const auto [travel, by_layer] = pen_travels(map.drawing);
  facts.layers.clear();
  for (std::size_t i = 0; i < by_layer.size(); ++i) {
    const Layer& layer = map.drawing.layers[i];
    facts.layers.push_back({layer.name, layer.strokes.size(), by_layer[i].down_mm,
                            by_layer[i].up_mm, by_layer[i].lifts});
  }
  facts.pen_down_mm = travel.down_mm;
  facts.pen_up_mm = travel.up_mm;
  facts.pen_lifts = travel.lifts;
}

} // namespace orograph
