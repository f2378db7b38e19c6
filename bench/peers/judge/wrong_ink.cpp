// SPDX-License-Identifier: GPL-3.0-or-later
// How much of a drawing's ink is wrong: a parallel view from the south, a line a grid row, made by
// any tool, read back and judged by the ray walk (src/reference), which shares no code with the
// clip. See bench/peers/README.md for how it is done and what it can't tell.
//
//   wrong_ink DEM DRAWING ELEVATION_DEG LEFT_OUT TOLERANCE_MM COUNT
//
// LEFT_OUT: rows at each end that the drawing leaves out.
// Prints `HIDDEN_% MISSING_% UNMATCHED_% FIT_MM ELEVATION_DEG`, or `-` five times where the drawing
// doesn't fit the terrain's outlines.
#include "dem/read/read_raster.hpp"
#include "geometry/error.hpp"

#include <cstdio>
#include <cstdlib>

#include "fit_drawing.hpp"
#include "match_lines.hpp"
#include "read_strokes.hpp"

using namespace orograph;

int main(int count, char** arguments) {
  if (count != 7) {
    std::fputs("usage: wrong_ink DEM DRAWING ELEVATION_DEG LEFT_OUT TOLERANCE_MM COUNT\n", stderr);
    return 2;
  }
  try {
    const TerrainData terrain = read_raster(arguments[1]);
    const ProfileLines lines{std::get<Grid>(terrain.surface), std::atoi(arguments[4])};
    const double tolerance_mm = std::atof(arguments[5]);
    const PlacedDrawing drawing = place_drawing(lines, read_strokes(arguments[2], STROKES_PS),
                                                Angle::degrees(std::atof(arguments[3])));
    const double elevation_deg = drawing.fit.elevation().in_degrees();
    if (!(drawing.fit.median_mm <= tolerance_mm)) {
      std::fprintf(stderr, "wrong_ink: %s is %g mm off the terrain's outlines at %g degrees\n",
                   arguments[2], drawing.fit.median_mm, elevation_deg);
      std::puts("- - - - -");
      return 0;
    }
    const InkCounts ink = match_lines(lines, drawing, tolerance_mm,
                                      static_cast<std::uint64_t>(std::atoll(arguments[6])));
    std::printf("%.4g %.4g %.4g %.3g %.6g\n", 100 * ink.hidden_share(), 100 * ink.missing_share(),
                100 * static_cast<double>(ink.unmatched) / static_cast<double>(ink.asked),
                drawing.fit.median_mm, elevation_deg);
  } catch (const Error& error) {
    std::fprintf(stderr, "wrong_ink: error: %s\n", error.what());
    return 1;
  }
}
