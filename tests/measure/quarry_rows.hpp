// SPDX-License-Identifier: GPL-3.0-or-later
// What the sample quarry's horizons are made of, measured once for all tests.
#pragma once

#include "dem/read/read_terrain.hpp"
#include "measure/fragmentation.hpp"

#include <string>
#include <vector>

namespace orograph {

inline const std::string kQuarry = OROGRAPH_SOURCE_DIR "/data_samples/quarry_points.csv";

/// Of 15 and of 60 profiles, from 180/25.
inline const std::vector<FragmentationRow>& quarry_rows() {
  static const std::vector<FragmentationRow> rows = [] {
    FragmentationSpec spec;
    spec.profiles = {15, 60};
    spec.elevations_deg = {25};
    spec.azimuths_deg = {180};
    const TerrainData terrain = read_terrain({kQuarry}, {});
    std::vector<FragmentationRow> out = fragmentation_rows(spec);
    for (FragmentationRow& row : out) measure_row(row, spec, terrain, {});
    return out;
  }();
  return rows;
}

} // namespace orograph
