// SPDX-License-Identifier: GPL-3.0-or-later
// Through a file and back.
#pragma once

#include "dem/read/read_raster.hpp"
#include "tests/dem/read/raster_file.hpp"
#include "tests/dem/temp_folder.hpp"

#include <string>

namespace orograph {

inline TerrainData read_back(const RasterFile& raster, const ReadOptions& options = {}) {
  const TempFolder folder;
  write_raster(raster, folder.file("dem.tif"));
  return read_raster(folder.file("dem.tif"), options);
}

inline bool has_note(const TerrainData& terrain, const std::string& words) {
  for (const std::string& note : terrain.notes)
    if (note.find(words) != std::string::npos) return true;
  return false;
}

} // namespace orograph
