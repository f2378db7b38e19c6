// SPDX-License-Identifier: GPL-3.0-or-later
// Terrains, their views and drawings as the Python module has them: the command's settings from
// named options, given to the library. Nothing here knows Python.
#pragma once

#include "cli/options/option.hpp"
#include "cli/render_settings.hpp"
#include "orograph.hpp"

#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace orograph {

struct NamedTerrain {
  Terrain terrain;
  std::vector<std::string> paths; ///< of its files; of heights in memory their name
};

/// With options of `orograph render` that read a terrain, and `jobs`. Throws Error.
NamedTerrain read_terrain_files(const std::vector<std::string>& paths, const NamedValues& options,
                                const Control& control);

/// A drawing, with the settings that it was drawn by.
struct Drawn {
  RenderSettings settings;
  Map map;
};

/// What is drawn and written of one terrain. Safe from several threads.
class Views {
public:
  explicit Views(NamedTerrain terrain) : terrain_(std::move(terrain)) {}

  const NamedTerrain& terrain() const { return terrain_; }
  /// What `orograph render` draws by the same options, strokes in the pen's order and with its
  /// pens. Throws Error, also where nothing of the terrain is on the page.
  Drawn draw(const NamedValues& options, const Control& control);
  /// Writes the drawing as `orograph render` does, by the options that it was drawn by and others
  /// that change nothing of its lines. REQUIRES `draws_alike` of the two formats.
  void save(const Drawn& drawn, const std::string& path, const NamedValues& options) const;

  /// What `orograph visible` says of places in the terrain's CRS, or by longitude and latitude
  /// (those that the CRS doesn't have are outside, without a bearing), and of the skyline. Throws
  /// Error.
  std::vector<PlaceSight> sights(const NamedValues& options, std::vector<Vec2> places, bool lonlat,
                                 const Control& control);
  Skyline skyline(const NamedValues& options, const Control& control);

private:
  Session session_of_ground();
  Session session_for(const RenderSettings& settings, const Control& control);
  RenderSettings settings_for(const NamedValues& options, const std::string& output) const;

  NamedTerrain terrain_;
  std::mutex mutex_;
  // The session of the last view, by the files that lie on the terrain.
  std::string scene_file_, overlays_;
  std::optional<Session> session_;
};

/// Whether what is drawn for one format is drawn for the other as well.
bool draws_alike(Format one, Format other);

/// A drawing's strokes one behind the other, layer by layer in drawing order.
struct FlatStrokes {
  std::vector<Vec2> page_mm;
  std::vector<Vec3> map;             ///< beside them, or none
  std::vector<std::int64_t> offsets; ///< of each stroke's first point, and behind all points
  // One for each stroke.
  std::vector<std::int32_t> layer, profile, level, feature;
  std::vector<double> depth_m, width_mm;
  std::vector<float> darkness;
};
FlatStrokes flat_strokes(const Drawing& drawing);

} // namespace orograph
