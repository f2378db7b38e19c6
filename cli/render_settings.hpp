// SPDX-License-Identifier: GPL-3.0-or-later
// Everything that `orograph render` is told, checked and in its own types.
#pragma once

#include "cli/options/option.hpp"
#include "draw/assign_pens.hpp"
#include "draw/drawing.hpp"
#include "draw/sheets.hpp"
#include "map/pen_work.hpp"
#include "placing/grounds.hpp"
#include "placing/map_spec.hpp"
#include "write/write_drawing.hpp"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace orograph {

struct RenderSettings : GroundFiles {
  std::string output;
  std::string scene_file;     ///< that `solids` are of; empty: none
  std::string overlays_where; ///< of all of them
  std::string labels_where;

  MapSpec map;
  // Layers that switches of their own add to those of `map`.
  bool void_edges = false;
  std::vector<std::string> added_layers;
  std::optional<bool> dashes_hidden;      ///< none: if there are names of layers
  std::vector<std::string> hidden_layers; ///< whose hidden lines are dashed; empty: solids
  std::vector<std::pair<std::string, Colour>> colours; ///< of layers, by their names

  std::string template_file;         ///< of furniture and letters; empty: none
  std::optional<LetterKind> text;    ///< none: as format, pens and sheets want
  std::optional<PenOrder> pen_order; ///< none: as the format wants
  PenSpeeds pen_speeds;              ///< of the pen that will draw
  std::string pens_file;             ///< empty: none
  std::vector<PenOfLayers> pens;
  bool pause_between_pens = false;
  std::optional<Vec2> clip_to_mm;
  std::optional<SheetsRequest> sheets; ///< then `map.page` is of all of them together
  double overlap_mm = 10;              ///< of sheets
  Page sheet;                          ///< where there are several
  /// Of strokes that are cut or given to pens first; none: as they are drawn.
  std::optional<PenOrder> finishing_order;
  std::string device; ///< its name, or its file's; empty: the format's own
  WriteOptions write;
  std::string report;        ///< path of the JSON report; empty: none
  std::string skyline_table; ///< path of the table of the skyline; empty: none
  double skyline_step_deg = 1;
  std::string settings_file; ///< whose options are among these; empty: none
  NamedValues options;       ///< those in force that decide what is drawn, for the report
  int jobs = 0;              ///< cores to use; 0: all
  bool quiet = false;
  std::optional<bool> progress; ///< none: where stderr is a terminal

  /// Whether layers have colours of their own, those beside pens too.
  bool has_colours() const { return map.style.palette != Palette::mono || !colours.empty(); }
};

} // namespace orograph
