// SPDX-License-Identifier: GPL-3.0-or-later
#include "draw/library_versions.hpp"

#include <cairo.h>
#include <gdal.h>

namespace orograph {

std::map<std::string, std::string> library_versions() {
  return {{"gdal", GDALVersionInfo("RELEASE_NAME")}, {"cairo", cairo_version_string()}};
}

} // namespace orograph
