// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace orograph {

/// Whether the GeoPackage at `path` is what was written: it opens, its pages are whole, the query
/// gives what was expected, and nothing is missing that keeps the layer's count. Closing one
/// doesn't tell of all that was lost on a full disk. REQUIRES a GdalMessages that lives. Cost:
/// reads all of it once.
bool is_whole_geopackage(const std::string& path, const std::string& query,
                         const std::string& expected);

} // namespace orograph
