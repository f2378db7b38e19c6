// SPDX-License-Identifier: GPL-3.0-or-later
// Views for measuring, each drawn as `orograph render` does.
#pragma once

#include "cli/render_settings.hpp"
#include "map/map_facts.hpp"
#include "placing/placed_view.hpp"
#include "placing/terrain_of_view.hpp"

#include <string>
#include <vector>

namespace orograph {

/// A view's name and what `orograph render` is told of it.
struct ListedView {
  std::string name;
  RenderSettings settings;
};

/// Of a text with a line for each view: its name, the DEM and the options, apart by blanks. Empty
/// lines and those that begin with # count for nothing. Throws Error with the line's number.
std::vector<ListedView> view_list(const std::string& text);

/// A listed view on paper. Throws Error where its terrain isn't a grid on a map plane.
class ViewOnPage {
public:
  explicit ViewOnPage(const ListedView& listed);
  ViewOnPage(const ViewOnPage&) = delete;
  ViewOnPage& operator=(const ViewOnPage&) = delete;

  const Grid& grid() const { return std::get<Grid>(terrain_->surface); }
  const PlacedView& placed() const { return placed_; }
  const Drawing& drawing() const { return map_.drawing; }

private:
  TerrainData whole_;
  TerrainOfView terrain_;
  PlacedView placed_;
  Map map_;
};

} // namespace orograph
