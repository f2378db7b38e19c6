// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/fragmentation/fragmentation.hpp"

#include "cli/fragmentation/fragmentation_report.hpp"
#include "cli/progress.hpp"
#include "cli/report/measurements.hpp"
#include "cli/tell_map.hpp"
#include "dem/read/read_terrain.hpp"
#include "geometry/error.hpp"
#include "measure/worst_cases.hpp"
#include "placing/terrain_of_view.hpp"
#include "write/output_file.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <filesystem>

namespace orograph {

void check_promises(const std::vector<FragmentationRow>& rows) {
  for (const FragmentationRow& row : rows)
    if (const std::string broken = broken_promise(row); !broken.empty())
      throw Error(fmt::format("collapse doesn't keep the horizon at its least size in the row "
                              "'{}': {}",
                              name_of(row), broken),
                  "please report it with the terrain and the command");
}

void fragmentation(const FragmentationSettings& settings) {
  const RenderSettings& render = settings.render;
  const std::string csv = settings.prefix + ".csv", series = settings.prefix + "-series.csv",
                    json = settings.prefix + ".json", svg = settings.prefix + ".svg";
  if (!settings.prefix.empty()) {
    check_gnuplot("the plots");
    for (const std::string& path : {csv, series, json, svg}) check_writable(path, render.write);
  }

  const TerrainData whole = read_terrain(render.inputs, render.reading);
  if (!render.quiet) tell_doubts(whole);
  const TerrainOfView of_view(whole, render.map.view);
  const TerrainData& terrain = *of_view;
  std::vector<FragmentationRow> rows = fragmentation_rows(settings);
  for (const FragmentationRow& row : worst_case_rows(settings)) rows.push_back(row);
  ProgressBar bar(shows_progress(render.quiet, render.progress));
  for (std::size_t i = 0; i < rows.size(); ++i) {
    bar.show(static_cast<double>(i) / static_cast<double>(rows.size()));
    if (rows[i].scene == "terrain")
      measure_row(rows[i], settings, terrain, render.map);
    else
      measure_row(rows[i], settings, worst_case_terrain(rows[i]), render.map);
  }
  bar.finish();

  std::string tables = fragmentation_table(rows);
  if (const std::string growth = growth_table(rows); !growth.empty()) tables += "\n" + growth;
  std::fwrite(tables.data(), 1, tables.size(), stdout);
  if (!settings.prefix.empty()) {
    write_text(fragmentation_csv(rows), csv, render.write.overwrite);
    write_text(series_csv(rows), series, render.write.overwrite);
    write_text(fragmentation_json(rows, terrain.source), json, render.write.overwrite);
    OutputFile plots(svg, render.write.overwrite);
    plot_fragmentation(rows, std::filesystem::path(terrain.source).filename().string(),
                       plots.temporary_path());
    plots.commit();
  }
  check_promises(rows);
}

} // namespace orograph
