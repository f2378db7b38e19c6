// SPDX-License-Identifier: GPL-3.0-or-later
// A view given as a file, or as the report of a run that drew it.
#pragma once

#include <string>

#include "placing/view_file.hpp"

namespace orograph {

/// A view file as `read_view_file` takes it. A file whose name ends in .json is a run report
/// instead: its object view.phigs holds the same keys, and null is as good as no front or back
/// plane. Throws the same Errors.
ViewFile read_view(const std::string& path);

} // namespace orograph
