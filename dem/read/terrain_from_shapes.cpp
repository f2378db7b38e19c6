// SPDX-License-Identifier: GPL-3.0-or-later
// From what files hold to a Terrain.
#include "dem/mesh/tin_from_triangles.hpp"
#include "dem/read/asked_window.hpp"
#include "dem/read/crs_frame.hpp"
#include "dem/read/map_shapes.hpp"
#include "dem/triangulate/triangulate.hpp"
#include "geometry/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

namespace orograph {
namespace {

constexpr std::uint32_t unused = 0xffffffff;

Vec2 plan(Vec3 p) {
  return {p.x, p.y};
}

bool inside(const Box2& box, Vec3 p) {
  return p.x >= box.low.x && p.x <= box.high.x && p.y >= box.low.y && p.y <= box.high.y;
}

// Heights that are no numbers are those of rings without heights.
void check_places(const std::vector<Vec3>& points, const std::string& path) {
  constexpr double farthest = 1e9;
  for (const Vec3& p : points)
    if (!(std::abs(p.x) <= farthest && std::abs(p.y) <= farthest) || std::abs(p.z) > farthest)
      throw Error(
          fmt::format("{} has a point at {:.10g}, {:.10g} with height {:.10g}", path, p.x, p.y,
                      p.z),
          "no place on earth is beyond 1e9; check for numbers that stand for missing values");
}

void check_places(const MapShapes& shapes) {
  check_places(shapes.points, shapes.path);
  for (const auto& line : shapes.breaklines) check_places(line, shapes.path);
  for (const auto& ring : shapes.rings) check_places(ring, shapes.path);
}

Box2 box_of(const std::vector<Vec3>& points) {
  Box2 box;
  for (const Vec3& p : points) box.include(plan(p));
  return box;
}

// Only what the triangles use: a stray vertex would move the origin.
void keep_used_points(MapShapes& shapes) {
  std::vector<std::uint32_t> moved(shapes.points.size(), unused);
  for (const auto& triangle : shapes.triangles)
    for (const std::uint32_t corner : triangle) moved[corner] = 0;
  std::uint32_t kept = 0;
  for (std::size_t i = 0; i < moved.size(); ++i) {
    if (moved[i] == unused) continue;
    moved[i] = kept;
    shapes.points[kept++] = shapes.points[i];
  }
  shapes.points.resize(kept);
  for (auto& triangle : shapes.triangles)
    for (std::uint32_t& corner : triangle) corner = moved[corner];
}

void cut_triangles(MapShapes& shapes, const Box2& window) {
  const Box2 extent = box_of(shapes.points);
  check_window(window, extent);
  std::erase_if(shapes.triangles, [&](const auto& triangle) {
    return !std::all_of(triangle.begin(), triangle.end(),
                        [&](std::uint32_t i) { return inside(window, shapes.points[i]); });
  });
  if (shapes.triangles.empty()) refuse_window(window, extent, shapes.path);
  keep_used_points(shapes);
}

// Of a line, the stretches whose points are all inside; a single one is a point.
void add_inside(const std::vector<Vec3>& line, const Box2& window, MapShapes& to) {
  std::vector<Vec3> stretch;
  const auto end = [&] {
    if (stretch.size() == 1) to.points.push_back(stretch[0]);
    if (stretch.size() > 1) to.breaklines.push_back(stretch);
    stretch.clear();
  };
  for (const Vec3& p : line) {
    if (inside(window, p))
      stretch.push_back(p);
    else
      end();
  }
  end();
}

void note_units(const MapFrame& map, bool known, std::vector<std::string>& notes) {
  if (map.crs_wkt.empty())
    notes.push_back(known ? fmt::format("The file has no CRS; its coordinates are in units of one "
                                        "{}, heights of one {}.",
                                        map.unit_name, map.height_unit_name)
                          : "The file has no CRS: its coordinates and heights are taken as "
                            "metres.");
}

void finish_frame(MapFrame& map, const Box2& extent) {
  if (map.crs_wkt.empty()) map.crs_name = "none";
  set_centre(map, extent.centre());
  map.origin = {extent.low.x, extent.high.y};
}

void to_ground(const MapFrame& map, std::vector<Vec3>& points) {
  for (Vec3& p : points) p = map.to_ground_m(p);
}

// Puts a file's lines beside the points: says what one tells the other of the CRS, and brings the
// lines' heights to the points' unit.
void bring_together(MapShapes& points, MapShapes& other, const char* role) {
  const bool here = !points.map.crs_wkt.empty(), there = !other.map.crs_wkt.empty();
  if (here && there && !same_place(points.map.crs_wkt, other.map.crs_wkt))
    throw Error(fmt::format("{} is in {} but its {}, {}, in {}", points.path, points.map.crs_name,
                            role, other.path, other.map.crs_name),
                fmt::format("bring both to one CRS: ogr2ogr -t_srs {} same.gpkg {}",
                            crs_for_command(points.map.crs_wkt), other.path));
  if (here && !there)
    points.notes.push_back(fmt::format("{} has no CRS: that of {} is taken, {}.", other.path,
                                       points.path, points.map.crs_name));
  if (!here && there) {
    points.notes.push_back(fmt::format("{} has no CRS: that of {} is taken, {}.", points.path,
                                       other.path, other.map.crs_name));
    points.map = other.map;
    points.units_known = other.units_known;
  }
  for (auto told : {&MapShapes::notes, &MapShapes::doubts})
    for (const std::string& note : other.*told)
      if (std::ranges::find(points.*told, note) == (points.*told).end())
        (points.*told).push_back(note);
  const double ratio = there ? other.map.height_unit_m / points.map.height_unit_m : 1;
  if (ratio == 1) return;
  for (auto* lines : {&other.breaklines, &other.rings})
    for (auto& line : *lines)
      for (Vec3& p : line) p.z *= ratio;
}

// A ring that leaves the window only cuts; what it has of heights inside is a breakline still.
void cut_survey(MapShapes& shapes, const Box2& window, const Box2& extent) {
  check_window(window, extent);
  std::erase_if(shapes.points, [&](Vec3 p) { return !inside(window, p); });
  const std::vector<std::vector<Vec3>> lines = std::exchange(shapes.breaklines, {});
  for (const auto& line : lines) add_inside(line, window, shapes);
  for (auto& ring : shapes.rings) {
    if (std::all_of(ring.begin(), ring.end(), [&](Vec3 p) { return inside(window, p); })) continue;
    if (std::isnan(ring.front().z)) continue;
    ring.push_back(ring.front());
    add_inside(ring, window, shapes);
    ring.pop_back();
    for (Vec3& p : ring) p.z = std::numeric_limits<double>::quiet_NaN();
  }
  if (shapes.points.empty() && shapes.breaklines.empty())
    refuse_window(window, extent, shapes.path);
}

Box2 box_of_survey(const MapShapes& shapes) {
  Box2 box = box_of(shapes.points);
  for (const auto& line : shapes.breaklines)
    for (const Vec3& p : line) box.include(plan(p));
  for (const auto& ring : shapes.rings)
    for (const Vec3& p : ring)
      if (!std::isnan(p.z)) box.include(plan(p));
  return box;
}

Survey survey_of(MapShapes shapes, const MapFrame& map, std::optional<double> max_edge_m) {
  Survey survey;
  to_ground(map, shapes.points);
  for (auto& line : shapes.breaklines) to_ground(map, line);
  survey.points_m = std::move(shapes.points);
  survey.breaklines_m = std::move(shapes.breaklines);
  for (auto& ring : shapes.rings) {
    to_ground(map, ring);
    survey.boundary.push_back({std::move(ring)});
  }
  survey.max_edge_m = max_edge_m;
  return survey;
}

void append(std::vector<std::vector<Vec3>>& to, std::vector<std::vector<Vec3>>& from) {
  std::move(from.begin(), from.end(), std::back_inserter(to));
}

} // namespace

TerrainData terrain_from_triangles(MapShapes shapes, const ReadOptions& options) {
  keep_used_points(shapes);
  check_places(shapes);
  if (const auto window = wanted_window(options, shapes.map, shapes.path))
    cut_triangles(shapes, *window);
  TerrainData terrain;
  terrain.map = shapes.map;
  terrain.source = shapes.path;
  terrain.notes = std::move(shapes.notes);
  terrain.doubts = std::move(shapes.doubts);
  terrain.surface_error_m = shapes.surface_error_m;
  note_units(terrain.map, shapes.units_known, terrain.notes);
  finish_frame(terrain.map, box_of(shapes.points));
  to_ground(terrain.map, shapes.points);
  TinFromTriangles made = tin_from_triangles(
      {std::move(shapes.points), std::move(shapes.triangles)}, options.repair, shapes.path);
  terrain.surface = std::move(made.tin);
  terrain.notes.insert(terrain.notes.end(), made.notes.begin(), made.notes.end());
  return terrain;
}

TerrainData terrain_from_points(MapShapes shapes, std::optional<MapShapes> lines,
                                std::optional<MapShapes> boundary, const ReadOptions& options) {
  if (lines) {
    bring_together(shapes, *lines, "breaklines");
    append(shapes.breaklines, lines->breaklines);
  }
  if (boundary) {
    bring_together(shapes, *boundary, "boundary");
    append(shapes.rings, boundary->rings);
  }
  check_places(shapes);
  if (const auto window = wanted_window(options, shapes.map, shapes.path))
    cut_survey(shapes, *window, box_of_survey(shapes));
  TerrainData terrain;
  terrain.map = shapes.map;
  terrain.source = shapes.path;
  terrain.notes = std::move(shapes.notes);
  terrain.doubts = std::move(shapes.doubts);
  note_units(terrain.map, shapes.units_known, terrain.notes);
  finish_frame(terrain.map, box_of_survey(shapes));
  try {
    Triangulated made = triangulate(survey_of(std::move(shapes), terrain.map, options.max_edge_m));
    terrain.surface = std::move(made.tin);
    terrain.triangulation = made.counts;
  } catch (const Error& error) {
    throw Error(terrain.source, error.what(), error.code());
  }
  return terrain;
}

} // namespace orograph
