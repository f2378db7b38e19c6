// SPDX-License-Identifier: GPL-3.0-or-later
// Whether what is written would replace what is read.
#pragma once

#include <filesystem>
#include <string>

namespace orograph {

/// Whether both are one file: by inode where both exist; by name, links resolved, where one is
/// still to be written.
bool same_file(const std::filesystem::path& a, const std::filesystem::path& b);

/// Whether writing `output` would replace a file that `input` is read from: the same file by any
/// spelling or link, also behind GDAL's /vsi prefixes ("/vsizip/a.zip/b.tif") and subdataset names
/// ("NETCDF:\"a.nc\":band").
bool replaces_input(const std::string& input, const std::string& output);

} // namespace orograph
