// SPDX-License-Identifier: GPL-3.0-or-later
// The layer of a vector file that is meant.
#pragma once

#include <string>
#include <vector>

class GDALDataset;
class OGRLayer;

namespace orograph {

/// The one that is wanted, or the only one with geometries where none is. Throws Error where there
/// is no such layer, none with geometries, or, with `right` as the way out, several.
OGRLayer& layer_of(GDALDataset& dataset, const std::string& path, const std::string& wanted,
                   const std::string& right);

std::vector<std::string> field_names(OGRLayer& layer);

} // namespace orograph
