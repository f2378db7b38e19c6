// SPDX-License-Identifier: GPL-3.0-or-later
// orograph as a library: from a DEM or a TIN to a vector perspective map in which every line is one
// that the eye could see.
//
//   const orograph::Terrain terrain = orograph::Terrain::read({"dem.tif"});
//   const orograph::Session session(terrain);
//   orograph::MapSpec spec;
//   spec.view.from_azimuth = orograph::Angle::degrees(225);
//   orograph::write_drawing(session.draw(spec).drawing, "map.svg", {});
//
// What is asked for and what comes back are plain values; only Terrain, Solids and Session own
// something. Units stand in the names (_m metres, _mm millimetres on the page) or in the type
// (Angle). Everything here may be used from several threads at once; nothing is process-wide:
// GDAL's settings and error handlers are the program's own.
//
// Errors are of class Error: a code, what is wrong, and what would be right. Memory that can't be
// had is std::bad_alloc.
#pragma once

#include "dem/read/overlay_input.hpp"
#include "dem/read/read_options.hpp"
#include "dem/read/terrain_input.hpp"
#include "draw/assign_pens.hpp"
#include "draw/colour.hpp"
#include "draw/cut_drawing.hpp"
#include "draw/drawing.hpp"
#include "draw/pen_order.hpp"
#include "draw/sheets.hpp"
#include "geometry/api.hpp"
#include "geometry/error.hpp"
#include "map/map_facts.hpp"
#include "map/place_sight.hpp"
#include "placing/map_spec.hpp"
#include "write/device.hpp"
#include "write/pens_file.hpp"
#include "write/write_drawing.hpp"

#include <functional>
#include <memory>
#include <stop_token>
#include <string>
#include <vector>

namespace orograph {

struct TerrainData;
struct SceneFile;
struct Overlay;

/// How a call's work is done. It never changes what comes back.
struct Control {
  /// Is told the share done, 0 to 1, rising, by one thread at a time, which may be another than the
  /// caller's. What it throws ends the call and is thrown to the caller.
  std::function<void(double)> progress{};
  /// Once a stop is requested the call throws Error with ErrorCode::cancelled, within a tenth of a
  /// second.
  std::stop_token stop{};
  int jobs = 0; ///< threads to use, at most; 0: one for each core
};

/// A surface with one height at each ground point: a grid (DEM) or a TIN. It never changes; copies
/// share it, and cost nothing.
class OROGRAPH_API Terrain {
public:
  /// Of a file, or of several rasters that are joined: whatever GDAL reads as a raster, triangles
  /// in OFF, PLY, OBJ, STL, LandXML or vector layers, points in text or vector layers. Throws Error
  /// where one can't be read, isn't a terrain, or the options don't fit it. Memory: 4 bytes a
  /// height (8 of files in double precision); less of a raster of which `options.large` lets larger
  /// cells be read, of which `control` is told the progress.
  static Terrain read(const std::vector<std::string>& paths, const ReadOptions& options = {},
                      const Control& control = {});
  /// Of heights, or of triangles, in memory: to the bit the terrain of a file that holds the same.
  /// Heights with an owner are borrowed. Throws Error where they are no surface.
  static Terrain of(const GridInput& input);
  static Terrain of(const TinInput& input);

  const std::string& crs_wkt() const; ///< empty where it has none
  const std::string& name() const;    ///< what it was read from, in brief
  /// What its reader assumed, a sentence each.
  const std::vector<std::string>& notes() const;

private:
  friend class Overlays;
  friend class Session;
  explicit Terrain(std::shared_ptr<const TerrainData> data);
  std::shared_ptr<const TerrainData> data_;
};

/// Houses, towers, masts and the like, to be put on a terrain (docs/scenes.md). They never change;
/// copies share them.
class OROGRAPH_API Solids {
public:
  Solids() = default; ///< none
  /// Of a scene file in TOML. Throws Error, with file and line, where it isn't one.
  static Solids read(const std::string& path);

private:
  friend class Session;
  std::shared_ptr<const SceneFile> scene_;
};

/// Lines and points of vector files, to be laid on the ground of a terrain: in the layer `drape`.
/// They never change; copies share them.
class OROGRAPH_API Overlays {
public:
  Overlays() = default; ///< none
  /// Throws Error where one can't be read, or nothing of it is on the terrain.
  static Overlays read(const std::vector<OverlayInput>& inputs, const Terrain& terrain,
                       const Control& control = {});
  /// What its reader assumed, a sentence each.
  std::vector<std::string> notes() const;

private:
  friend class Session;
  std::shared_ptr<const std::vector<Overlay>> overlays_;
};

/// Draws views of one terrain, and keeps what holds for all of them, so that the second view costs
/// less than the first. Copies share what is kept.
class OROGRAPH_API Session {
public:
  /// `names` are points of one file, to be named on the page as `MapSpec::labels` says. REQUIRES
  /// overlays and names that were read for this terrain.
  explicit Session(Terrain terrain, Solids solids = {}, Overlays overlays = {},
                   Overlays names = {});

  /// The map that `spec` asks for: the same bytes whatever `control` says and whoever else draws. A
  /// view in which nothing of the terrain is seen gives a drawing without strokes. Throws Error
  /// where a number of `spec` is out of its range or two wishes exclude each other, where the view
  /// makes no sense on this terrain (an eye under the ground, a place that isn't there), and where
  /// it is stopped; the session stays as good as before.
  /// Cost: about 0.1 microseconds a vertex that profiles cut, more on rough ground.
  Map draw(const MapSpec& spec, const Control& control = {}) const;

  /// What the view's eye sees of each of these places, in map coordinates, `above_m` above the
  /// ground there (docs/visibility.md). Of `view` eye, its height and summit, curvature, refraction
  /// and exaggeration count; solids and overlays hide nothing. The same whatever `control` says.
  /// Throws Error where there is no eye, a number is out of its range, the eye is under the ground,
  /// and where it is stopped. Cost: some 10 nanoseconds for each triangle on the way to a place.
  std::vector<PlaceSight> sights(const ViewSpec& view, const std::vector<Vec2>& places,
                                 double above_m = 0, const Control& control = {}) const;

  /// The eye's skyline, from north clockwise every `step_deg` (0.001 to 90) below 360, and the most
  /// distant ground that it sees. Throws the same Errors.
  Skyline skyline(const ViewSpec& view, double step_deg = 1, const Control& control = {}) const;

private:
  struct Kept;
  std::shared_ptr<Kept> kept_;
};

} // namespace orograph
