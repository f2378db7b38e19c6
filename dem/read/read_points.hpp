// SPDX-License-Identifier: GPL-3.0-or-later
// Reading points from text.
#pragma once

#include "dem/read/map_shapes.hpp"

#include <array>
#include <string>

namespace orograph {

/// Points in lines of text with a first line that names the columns: separated by semicolons, tabs,
/// commas or blanks, whichever the first line has (in this order). Names may be in quotes and in
/// upper or lower case. Of the columns `columns` are taken; by default ("x", "y", "z") those with
/// other usual names are found too (easting, northing, elevation, height). Without a first line of
/// names there must be three columns, taken as x, y, z, with a note. Lines that begin with '#' and
/// empty lines are passed over.
///
/// Throws Error, with the number of the line: a value that isn't a finite number, more or fewer
/// columns than the first line has, no such column, columns in degrees, no text.
/// A line at a time is held in memory beside the points.
MapShapes read_points(const std::string& path, const std::array<std::string, 3>& columns);

} // namespace orograph
