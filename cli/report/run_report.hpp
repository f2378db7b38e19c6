// SPDX-License-Identifier: GPL-3.0-or-later
// The run report: what was drawn, how exactly and in which time, as JSON (docs/how-it-works.md);
// and the view and the settings that a report holds, to be drawn again.
#pragma once

#include "cli/options/option.hpp"
#include "draw/drawing.hpp"
#include "map/draw_map.hpp"
#include "map/place_sight.hpp"
#include "placing/view_file.hpp"

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace orograph {

/// One of several sheets, and what it takes to draw.
struct SheetFacts {
  std::string path;
  std::uint64_t strokes = 0;
  PenTravel travel;
  std::optional<double> minutes;
};

/// The facts of a run's map, and what the command adds to them. Numbers that are NaN, and optionals
/// that hold nothing, become null in JSON unless said otherwise.
struct RunReport : MapFacts {
  std::string path, format; ///< of the drawing
  std::string scene_path;   ///< empty: no solids
  NamedValues settings;     ///< options in force, as a settings file takes them
  Page page;
  std::vector<std::optional<double>> minutes_of_layers; ///< as many as layers
  std::vector<SheetFacts> sheets;                       ///< none: one page
  std::optional<Skyline> skyline;                       ///< where its table is asked for
  std::uint64_t peak_memory_bytes = 0;
  std::map<std::string, std::string> libraries; ///< name to version
};

struct RenderSettings;
struct Setting;

/// What a run of `settings` reports of its map: the facts, with the error budget of the drawing's
/// format, and the process's peak memory so far. Of several sheets the layers, strokes and the
/// pen's way are those of the sheets together.
RunReport run_report(const Map& map, const RenderSettings& settings,
                     std::span<const Drawing> sheets = {});

/// The JSON text, `"schema": 1`, with the program's version and commit.
std::string report_text(const RunReport& report);

/// Writes it whole or not at all; to a path that ends in ".toml" only the view, as `--view` takes
/// it. Throws Error where it can't be written, or exists and
/// `overwrite` is off.
void write_report(const RunReport& report, const std::string& path, bool overwrite);

/// A view file as `read_view_file` takes it. A file whose name ends in .json is a run report
/// instead: its object view.phigs holds the same keys, and null is as good as no front or back
/// plane. Throws the same Errors.
ViewFile read_view(const std::string& path);

/// The object `settings` of a run report, in its order. Throws Error, which begins with the path:
/// no such file, too large, no JSON, no settings in it.
std::vector<Setting> settings_of_report(const std::string& path);

} // namespace orograph
