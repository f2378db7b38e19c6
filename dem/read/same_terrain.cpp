// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/read/same_terrain.hpp"

#include "dem/read/crs_frame.hpp"
#include "dem/read/in_brief.hpp"
#include "geometry/error.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace orograph {
namespace {

[[noreturn]] void refuse_crs(const RasterSource& one, const RasterSource& other) {
  const auto is_in = [](const RasterSource& source) {
    return source.map.crs_wkt.empty()
               ? fmt::format("{} has no CRS", source.path)
               : fmt::format("{} is in {}", source.path, source.map.crs_name);
  };
  const RasterSource& known = one.map.crs_wkt.empty() ? other : one;
  const bool both = !one.map.crs_wkt.empty() && !other.map.crs_wkt.empty();
  const std::string crs = crs_for_command(known.map.crs_wkt);
  throw Error(fmt::format("{}, but {}", is_in(one), is_in(other)),
              both ? fmt::format("make one raster of them: gdalwarp -t_srs {} -r cubic {} {} "
                                 "joined.tif",
                                 crs, one.path, other.path)
                   : fmt::format("if it is the same, say so: gdal_edit.py -a_srs {} {}", crs,
                                 &known == &one ? other.path : one.path));
}

void check_datum(std::vector<RasterSource>& sources) {
  const RasterSource* told = nullptr;
  for (const RasterSource& source : sources) {
    const std::string& above = source.map.vertical_crs_name;
    if (above.empty()) continue;
    if (told && told->map.vertical_crs_name != above)
      throw Error(fmt::format("heights of {} are above {}, and those of {} above {}", told->path,
                              told->map.vertical_crs_name, source.path, above),
                  "bring them to one with gdalwarp -s_srs and -t_srs, which take vertical CRSs "
                  "too (EPSG:4326+5773)");
    told = told ? told : &source;
  }
  if (!told) return;
  for (RasterSource& source : sources)
    if (source.map.vertical_crs_name.empty())
      source.notes.push_back(
          fmt::format("The file doesn't say what its heights are above: {} is taken, as {} has it.",
                      told->map.vertical_crs_name, told->path));
}

} // namespace

void check_same_terrain(std::vector<RasterSource>& sources) {
  if (sources.size() < 2) return;
  const RasterSource& first = sources.front();
  for (const RasterSource& source : sources) {
    if (!source.has_place)
      throw Error(fmt::format("{} has no georeference, so its place among the other files isn't "
                              "known",
                              source.path),
                  fmt::format("set one: gdal_edit.py -a_ullr XMIN YMAX XMAX YMIN {}", source.path));
    if (!same_place(first.map.crs_wkt, source.map.crs_wkt)) refuse_crs(first, source);
  }
  check_datum(sources);
}

std::vector<std::string> notes_of(const std::vector<RasterSource>& sources) {
  struct Note {
    std::string text;
    std::vector<std::string> paths;
  };
  std::vector<Note> notes;
  for (const RasterSource& source : sources)
    for (const std::string& text : source.notes) {
      auto note =
          std::find_if(notes.begin(), notes.end(), [&](const Note& n) { return n.text == text; });
      if (note == notes.end()) note = notes.insert(notes.end(), {text, {}});
      if (note->paths.empty() || note->paths.back() != source.path)
        note->paths.push_back(source.path);
    }
  std::vector<std::string> texts;
  for (const Note& note : notes)
    texts.push_back(note.paths.size() == sources.size()
                        ? note.text
                        : fmt::format("{}: {}", in_brief(note.paths), note.text));
  return texts;
}

} // namespace orograph
