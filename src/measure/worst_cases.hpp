// SPDX-License-Identifier: GPL-3.0-or-later
// Terrains on which horizons fragment as badly as they can, made to be measured.
#pragma once

#include "dem/terrain.hpp"
#include "measure/fragmentation.hpp"

#include <string>
#include <vector>

namespace orograph {

/// Ridges across the view, one behind the other, seen through a gate between two tall posts: each
/// ridge is higher on the page than the one before, and its edges lie elsewhere in X. The true
/// horizon is the last ridge in the gate and the posts, whatever `ridges` is; without collapse
/// every ridge leaves the places of its edges. A grid of 16 columns and two rows a ridge.
TerrainData gate_before_ridges(int ridges);

/// A comb of `teeth` across the view in front of a slope of two triangles: each profile on the
/// slope shows in every gap of the comb, so what is visible is the square of what is there.
TerrainData comb_before_slope(int teeth);

/// Rows of both in growing sizes up to `spec.worst_case`, with as many profiles as there are
/// ridges or teeth.
std::vector<FragmentationRow> worst_case_rows(const FragmentationSpec& spec);
/// The terrain of such a row.
TerrainData worst_case_terrain(const FragmentationRow& row);

} // namespace orograph
