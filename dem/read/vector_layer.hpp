// SPDX-License-Identifier: GPL-3.0-or-later
// Vector files as they are opened, the layer of one that is meant, and what GDAL warns of.
#pragma once

#include <string>
#include <vector>

#include "gdal/gdal.hpp"

class GDALDataset;
class OGRLayer;

namespace orograph {

/// Null where GDAL doesn't take it for a vector file. Nothing is written beside it, as GDAL does
/// beside GML unless an option of `options` asks for that.
Dataset open_vector(const std::string& path, const std::vector<std::string>& options);

/// Adds to `doubts` what GDAL has warned of, and what it couldn't do and did without, such as an
/// unknown CRS: a sentence each that names the file. Each is there once; of more than a few, since
/// a warning may name its feature, only how many more there were.
void add_doubts(const GdalMessages& messages, const std::string& path,
                std::vector<std::string>& doubts);

/// The one that is wanted, or the only one with geometries where none is. Throws Error where there
/// is no such layer, none with geometries, or, with `right` as the way out, several.
OGRLayer& layer_of(GDALDataset& dataset, const std::string& path, const std::string& wanted,
                   const std::string& right);

std::vector<std::string> field_names(OGRLayer& layer);

} // namespace orograph
