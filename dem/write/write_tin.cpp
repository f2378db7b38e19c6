// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/write/write_tin.hpp"

#include "dem/write/tin_writers.hpp"
#include "geometry/words.hpp"

#include <utility>

namespace orograph {

std::optional<TinFormat> tin_format_of(const std::string& path) {
  const std::string extension = extension_of(path);
  for (const auto& [of_format, format] :
       {std::pair(".gpkg", TinFormat::gpkg), std::pair(".off", TinFormat::off),
        std::pair(".ply", TinFormat::ply), std::pair(".obj", TinFormat::obj)})
    if (extension == of_format) return format;
  return std::nullopt;
}

void write_tin(const Terrain& terrain, const std::string& path, TinFormat format,
               const std::string& name) {
  const std::string& called = name.empty() ? path : name;
  if (format == TinFormat::gpkg)
    write_tin_geopackage(terrain, path, called);
  else
    write_mesh_text(terrain, path, format, called);
}

} // namespace orograph
