// SPDX-License-Identifier: GPL-3.0-or-later
// Small vector files for the tests of the readers, written through OGR.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace orograph {

struct VectorFeature {
  std::string wkt; ///< a height of -12345 becomes NaN; empty for no geometry
  std::optional<double> height{}, surface_error_m{};
};

struct VectorFile {
  std::vector<VectorFeature> features;
  std::string crs = "EPSG:32632"; ///< anything that OGR takes, empty for none
  std::string driver = "GPKG";
  std::string layer = "survey";
  std::string height_type = "Real"; ///< of the field `height`; or String
  bool append = false;              ///< as another layer of a file that is there
};

/// Throws std::runtime_error if GDAL doesn't do as asked.
void write_vector(const VectorFile& file, const std::string& path);

} // namespace orograph
