// SPDX-License-Identifier: GPL-3.0-or-later
// The only place that runs gnuplot.
#pragma once

#include <string>

namespace orograph {

/// Quoted for gnuplot: nothing inside single quotes has a meaning but they themselves. Control
/// characters are left out.
std::string quoted_for_gnuplot(const std::string& text);

/// Runs a script that writes to `path`, an existing file or a new one. Throws Error where gnuplot
/// is missing or fails; `what` is what it draws ("the curve").
void run_gnuplot(const std::string& script, const std::string& path, const std::string& what);

} // namespace orograph
