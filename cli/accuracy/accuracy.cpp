// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/accuracy/accuracy.hpp"

#include "cli/accuracy/accuracy_report.hpp"
#include "cli/progress.hpp"
#include "cli/report/measurements.hpp"
#include "cli/tell_map.hpp"
#include "dem/read/read_terrain.hpp"
#include "geometry/error.hpp"
#include "write/output_file.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <filesystem>

namespace orograph {
void check_promises(const std::vector<AccuracyRow>& rows) {
  for (const AccuracyRow& row : rows)
    if (const std::string broken = broken_promise(row); !broken.empty())
      throw Error(fmt::format("the row '{}' breaks its promise, {}", name_of(row), broken),
                  "please report it with the terrain and the command");
}

void accuracy(const AccuracySettings& settings) {
  const RenderSettings& render = settings.render;
  const std::string csv = settings.prefix + ".csv", json = settings.prefix + ".json",
                    svg = settings.prefix + ".svg";
  if (!settings.prefix.empty()) {
    check_gnuplot("the curve");
    for (const std::string& path : {csv, json, svg}) check_writable(path, render.write);
  }

  const MeasuredTerrain terrain{render.inputs, render.reading,
                                read_terrain(render.inputs, render.reading)};
  const std::string& source = terrain.whole.source;
  if (!render.quiet) tell_doubts(terrain.whole);
  std::vector<AccuracyRow> rows = accuracy_rows(settings, terrain);
  ProgressBar bar(shows_progress(render.quiet, render.progress));
  for (std::size_t i = 0; i < rows.size(); ++i) {
    bar.show(static_cast<double>(i) / static_cast<double>(rows.size()));
    measure_row(rows[i], settings, terrain, render.map);
  }
  bar.finish();

  const std::string table = accuracy_table(rows);
  std::fwrite(table.data(), 1, table.size(), stdout);
  if (!settings.prefix.empty()) {
    write_text(accuracy_csv(rows), csv, render.write.overwrite);
    write_text(accuracy_json(rows, source), json, render.write.overwrite);
    OutputFile curve(svg, render.write.overwrite);
    const std::string name = !render.map.title.empty()
                                 ? render.map.title
                                 : std::filesystem::path(source).filename().string();
    plot_accuracy(rows, name, curve.temporary_path());
    curve.commit();
  }
  check_promises(rows);
}

} // namespace orograph
