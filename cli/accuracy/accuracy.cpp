// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/accuracy/accuracy.hpp"

#include "cli/accuracy/accuracy_report.hpp"
#include "cli/accuracy/plot_accuracy.hpp"
#include "cli/progress.hpp"
#include "cli/text_file.hpp"
#include "dem/read/read_terrain.hpp"
#include "write/output_file.hpp"

#include <cstdio>
#include <filesystem>

#include "placing/terrain_of_view.hpp"

namespace orograph {

void accuracy(const AccuracySettings& settings) {
  const RenderSettings& render = settings.render;
  const std::string csv = settings.prefix + ".csv", json = settings.prefix + ".json",
                    svg = settings.prefix + ".svg";
  for (const std::string& path : {csv, json, svg}) check_writable(path, render.write);

  const TerrainData whole = read_terrain(render.inputs, render.reading);
  const TerrainOfView of_view(whole, render.map.view);
  const TerrainData& terrain = *of_view;
  std::vector<AccuracyRow> rows = accuracy_rows(settings);
  ProgressBar bar(shows_progress(render.quiet, render.progress));
  for (std::size_t i = 0; i < rows.size(); ++i) {
    bar.show(static_cast<double>(i) / static_cast<double>(rows.size()));
    measure_row(rows[i], settings, terrain);
  }
  bar.finish();

  const std::string table = accuracy_table(rows);
  std::fwrite(table.data(), 1, table.size(), stdout);
  write_text(accuracy_csv(rows), csv, render.write.overwrite);
  write_text(accuracy_json(rows, terrain.source), json, render.write.overwrite);
  OutputFile curve(svg, render.write.overwrite);
  const std::string name = !render.map.title.empty()
                               ? render.map.title
                               : std::filesystem::path(terrain.source).filename().string();
  plot_accuracy(rows, name, curve.temporary_path());
  curve.commit();
  check_promises(rows);
}

} // namespace orograph
