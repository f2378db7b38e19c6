// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace orograph {

/// From now on SIGINT and SIGTERM remove temporary files and exit with 130 and 143; SIGXFSZ and
/// SIGPIPE are ignored, so that a file-size limit or a closed pipe shows as a write error.
void remove_output_files_on_signals();

} // namespace orograph
