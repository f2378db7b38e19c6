// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/index.hpp"

#include "cli/progress.hpp"
#include "cli/say.hpp"
#include "dem/read/level_index.hpp"
#include "dem/read/raster_bands.hpp"
#include "geometry/error.hpp"
#include "write/output_file.hpp"
#include "write/write_drawing.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <system_error>

namespace orograph {

void index(const IndexSettings& settings) {
  const std::string path = index_path(settings.inputs);
  std::error_code ignored;
  if (std::filesystem::exists(path, ignored) && !is_index(path))
    throw Error(path + " is there, and is no index", "move it elsewhere");
  if (std::filesystem::is_regular_file(settings.inputs.front(), ignored))
    check_writable(path, {.overwrite = true});
  ProgressBar bar(shows_progress(settings.quiet, settings.progress));
  const RasterIndex made =
      index_of(settings.inputs, settings.reading, [&](double fraction) { bar.show(fraction); });
  OutputFile place(path, true);
  write_index(place.temporary_path(), made.state, made.levels);
  place.commit();
  bar.finish();
  if (settings.quiet) return;
  for (const std::string& doubt : made.doubts) say_line(doubt);
  say("{}: cells {} to {} times as large as the raster's, {:.3g} MB", path,
      made.levels.front().cells.step, made.levels.back().cells.step,
      1e-6 * static_cast<double>(std::filesystem::file_size(path)));
}

} // namespace orograph
