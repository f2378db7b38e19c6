// SPDX-License-Identifier: GPL-3.0-or-later
// The room that furniture needs on a page, known before there is a picture: it depends on texts'
// sizes alone.
#pragma once

#include "placing/map_spec.hpp"

#include <vector>

namespace orograph {

/// Of letters' sizes: a row of text, and what stands for its baseline below the row's upper side.
constexpr double kRowOfEm = 1.4, kBaselineOfEm = 1.03;
/// Marks of scales, how far a mark is from its text, and the side of the square that the north
/// arrow has.
constexpr double kTick_mm = 2.4, kTickGap_mm = 0.8, kNorth_mm = 13;
/// Widths of an azimuth, "360°", of an altitude, "−20°", and of the horizon's, "dip 1.4°", in ems;
/// the last, with a mark behind it, is to the left of altitudes.
constexpr double kAzimuthOfEm = 2.6, kAltitudeOfEm = 3, kDipOfEm = 4.6;
/// A neatline's distance from a terrain that is shown whole; else lines run up to it.
constexpr double kNeatline_mm = 4;

/// A row above or below the picture.
struct FurnitureRow {
  Furniture piece;
  double height_mm;
};

/// Those above the picture and those beneath it, from above, that have something to say; beneath it
/// the north arrow stands beside them.
std::vector<FurnitureRow> rows_above(const MapSpec& spec);
std::vector<FurnitureRow> rows_beneath(const MapSpec& spec);

/// Between a neatline and what the picture may cover; 0 without one.
double neatline_gap_mm(const MapSpec& spec);

/// The spec's page, with the room that its furniture needs around the picture and around each strip
/// of a panorama: none where lines keep their places on the ground.
PageRequest page_with_room(const MapSpec& spec);

} // namespace orograph
