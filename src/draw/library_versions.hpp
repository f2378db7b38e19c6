// SPDX-License-Identifier: GPL-3.0-or-later
// Which libraries stand behind reading and writing, for the run report.
#pragma once

#include <map>
#include <string>

namespace orograph {

/// Name to version, of the libraries found at run time.
std::map<std::string, std::string> library_versions();

} // namespace orograph
