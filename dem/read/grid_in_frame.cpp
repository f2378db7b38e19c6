// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/read/grid_in_frame.hpp"

#include "dem/read/asked_window.hpp"
#include "dem/read/read_options.hpp"
#include "geometry/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace orograph {
namespace {

DegreeLattice degree_lattice(const GridOrder& order, double unit_deg,
                             const std::vector<std::string>& paths) {
  const std::string path = in_brief(paths);
  if (order.column_step.y != 0 || order.row_step.x != 0)
    throw Error(
        fmt::format("{} is turned against meridians and parallels", path),
        fmt::format("bring it to their order first: gdalwarp {} degrees.tif", in_command(paths)));
  const DegreeLattice lattice{
      order.first.x * unit_deg, order.column_step.x * unit_deg, order.columns,
      order.first.y * unit_deg, order.row_step.y * unit_deg,    order.rows};
  const double south_deg = lattice.lat_deg(order.rows - 1);
  // A row at a pole itself may be off it by rounding, and is no surface.
  if (!(lattice.first_lat_deg < 90 && south_deg > -90))
    throw Error(
        fmt::format("{} reaches from latitude {:.10g} to {:.10g} degrees", path, south_deg,
                    lattice.first_lat_deg),
        "latitudes are within -90 to 90, the poles themselves left out; `bbox` keeps a part");
  if (std::abs(lattice.lon_step_deg) * (order.columns - 1) > 360)
    throw Error(fmt::format("{} goes round the earth more than once", path),
                "`bbox` keeps a part of it");
  return lattice;
}

} // namespace

Grid empty_grid(const GridOrder& order, const MapFrame& map,
                const std::vector<std::string>& paths) {
  Grid grid;
  grid.columns = order.columns;
  grid.rows = order.rows;
  if (map.earth)
    grid.lattice =
        EarthLattice(degree_lattice(order, map.earth->unit_deg, paths), map.earth->local);
  else
    grid.lattice = PlaneLattice{{}, map.unit_m * order.column_step, map.unit_m * order.row_step};
  return grid;
}

bool has_height(const Grid& grid) {
  return std::visit(
      [](const auto& heights) {
        return std::any_of(heights.begin(), heights.end(), [](auto h) { return !std::isnan(h); });
      },
      grid.heights_m);
}

} // namespace orograph
