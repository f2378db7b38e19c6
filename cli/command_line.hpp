// SPDX-License-Identifier: GPL-3.0-or-later
// The whole of the program: commands, and exceptions to messages and exit codes.
#pragma once

namespace orograph {

/// What `main` does, and what it returns: 0, 1 for what can't be done, 2 for a wrong command line.
/// Once in a process: it sets the handling of signals and GDAL's settings.
int run_command_line(int argc, char** argv);

} // namespace orograph
