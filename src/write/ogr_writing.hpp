// SPDX-License-Identifier: GPL-3.0-or-later
// What all writers through OGR share.
#pragma once

#include "geometry/error.hpp"

#include <string>

#include "gdal/gdal.hpp"

namespace orograph {

/// As long as it lives, this thread writes the same bytes on any day.
struct OnOneDay {
  GdalThreadOption date{"OGR_CURRENT_DATE", "2000-01-01T00:00:00.000Z"};
};

/// A new dataset without layers at `path`; null where the driver fails. Throws Error where this
/// GDAL has no such driver.
Dataset create_dataset(const char* driver_name, const std::string& path);

/// That the file called `name` can't be written, and why: the first failure, from which later ones
/// follow, or else the last warning, without the SQL statement that met it.
Error gdal_error(const std::string& name, const GdalMessages& messages);

} // namespace orograph
