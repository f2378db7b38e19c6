// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/tin.hpp"

#include "cli/say.hpp"
#include "dem/approximate/approximate_grid.hpp"
#include "dem/read/asked_window.hpp"
#include "dem/read/read_options.hpp"
#include "dem/read/read_terrain.hpp"
#include "geometry/error.hpp"
#include "write/output_file.hpp"
#include "write/write_drawing.hpp"

#include <fmt/format.h>

#include <utility>

namespace orograph {
namespace {

TinFormat format_of(const TinSettings& settings) {
  if (settings.format) return *settings.format;
  if (const auto format = tin_format_of(settings.output)) return *format;
  throw UsageError(fmt::format("OUTPUT '{}' names no format of a TIN", settings.output),
                   "end its name in .gpkg, .off, .ply or .obj, or give --of");
}

// The grid's approximation in its place; tells how many vertices it had.
void approximate_surface(TerrainData& terrain, const TinSettings& settings) {
  const Grid& grid = std::get<Grid>(terrain.surface);
  if (grid.is_on_earth())
    throw Error(terrain.source + " is in degrees, in which triangles aren't written",
                fmt::format("project it first: gdalwarp -t_srs CRS -r cubic {} projected.tif",
                            in_command(terrain.paths)));
  if (!settings.max_error_m)
    throw UsageError(terrain.source + " is a grid",
                     "say how far from it the TIN may be, as in --max-error 2m; 0m keeps every "
                     "triangle");
  ApproximatedGrid approximated = approximate(grid, *settings.max_error_m);
  terrain.surface_error_m = approximated.greatest_m;
  terrain.notes.push_back(fmt::format(
      "Of the grid's {} x {} vertices {} are left: {:.4g} m away from it at most, {:.4g} "
      "m at its vertices.",
      grid.columns, grid.rows, approximated.tin.vertices_m.size(), approximated.greatest_m,
      approximated.greatest_at_vertices_m));
  terrain.surface = std::move(approximated.tin);
}

std::string told(const TriangulationCounts& counts) {
  std::string text = fmt::format("{} points", counts.points);
  if (counts.merged > 0)
    text += fmt::format(", {} of them at the place of another (heights up to {:.3g} m apart)",
                        counts.merged, counts.greatest_merged_m);
  if (counts.breaklines > 0) text += fmt::format("; {} breaklines", counts.breaklines);
  if (counts.crossings > 0)
    text += fmt::format(", {} crossings between their vertices (heights up to {:.3g} m apart)",
                        counts.crossings, counts.greatest_crossing_m);
  if (counts.outside > 0) text += fmt::format("; {} triangles beyond the boundary", counts.outside);
  if (counts.beyond_max_edge > 0)
    text +=
        fmt::format("; {} triangles at the border with too long an edge", counts.beyond_max_edge);
  return text;
}

} // namespace

void tin(const TinSettings& settings) {
  const TinFormat format = format_of(settings);
  check_writable(settings.output, {.overwrite = settings.overwrite});
  TerrainData terrain = read_terrain(settings.inputs, settings.reading);
  if (std::holds_alternative<Grid>(terrain.surface))
    approximate_surface(terrain, settings);
  else if (settings.max_error_m)
    throw UsageError("--max-error is for rasters, and " + terrain.source + " is none",
                     "leave it out");
  OutputFile place(settings.output, settings.overwrite);
  write_tin(terrain, place.temporary_path(), format, settings.output);
  place.commit();
  if (settings.quiet) return;
  const Tin& made = std::get<Tin>(terrain.surface);
  if (terrain.triangulation) say_line(told(*terrain.triangulation));
  for (const std::string& note : terrain.notes) say_line(note);
  say("{} vertices and {} triangles in {}", made.vertices_m.size(), made.triangles.size(),
      settings.output);
}

} // namespace orograph
