// SPDX-License-Identifier: GPL-3.0-or-later
// `orograph tin`: a TIN as a file.
#pragma once

#include "dem/read/read_options.hpp"
#include "dem/write/write_tin.hpp"

#include <optional>
#include <string>
#include <vector>

namespace orograph {

struct TinSettings {
  std::vector<std::string> inputs; ///< as in RenderSettings
  std::string output;
  ReadOptions reading;
  std::optional<double> max_error_m; ///< how far from a grid the TIN may be; for rasters
  std::optional<TinFormat> format;   ///< none: by the output's extension
  bool overwrite = false;
  int jobs = 0; ///< as in RenderSettings
  bool quiet = false;
};

/// Reads a terrain, triangulates it if it is points, approximates it if it is a grid, and writes
/// the TIN; says on stderr what was made. Throws Error.
void tin(const TinSettings& settings);

} // namespace orograph
