// SPDX-License-Identifier: GPL-3.0-or-later
// The header of a classic netCDF, looked at before its library reads it.
#pragma once

#include <string>

namespace orograph {

/// Throws Error where a file is a classic netCDF whose header tells of more names, numbers or
/// attributes than its bytes could hold, for which the library makes room first, 1.5 GB and nine
/// seconds for one of 680 bytes; and where it isn't such a header at all, on which the library may
/// break off. Any other file passes, and so does what is no file; of a pipe nothing is read.
/// Cost: a few reads.
void check_netcdf_header(const std::string& path);

} // namespace orograph
