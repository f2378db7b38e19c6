// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/read/raster_parts.hpp"

#include "dem/read/network.hpp"
#include "dem/read/open_rasters.hpp"
#include "dem/read/read_rows.hpp"
#include "geometry/free_memory.hpp"
#include "geometry/on_all_cores.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <utility>
#include <variant>

namespace orograph {

std::vector<RasterPart> read_raster_parts(const std::vector<std::string>& paths,
                                          const ReadOptions& options,
                                          const std::vector<GridPart>& parts) {
  const NetworkGate gate(paths, options.allow_network);
  const GdalMessages unheard;
  RasterSet set = open_rasters(paths, options);
  std::uint64_t bytes = 0;
  for (const GridPart& part : parts)
    bytes += static_cast<std::uint64_t>(part.columns) * static_cast<std::uint64_t>(part.rows) *
             (set.are_floats() ? sizeof(float) : sizeof(double));
  check_memory(static_cast<double>(bytes), options.max_memory,
               fmt::format("what is near the eye in {}", set.terrain.source),
               "take an `overview`, ask for larger cells");
  HeightDifferences differences;
  std::vector<RasterPart> out;
  for (const GridPart& part : parts) {
    throw_if_stopped();
    ReadHeights heights = read_part_of_rows(set, part, options, differences);
    leave_in_box(set, part, heights);
    RasterPart& read = out.emplace_back(RasterPart{part, {part.columns, part.rows, {}, {}}});
    std::visit([&](auto& values) { read.cells.heights_m = Heights(std::move(values)); }, heights);
  }
  return out;
}

} // namespace orograph
