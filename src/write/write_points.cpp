// SPDX-License-Identifier: GPL-3.0-or-later
#include "write/write_points.hpp"

#include "text/csv_text.hpp"
#include "text/words.hpp"
#include "write/byte_sink.hpp"
#include "write/geojson_text.hpp"
#include "write/output_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <variant>

namespace orograph {
namespace {

const AttributeValue* value_in(const Attributes& values, const std::string& field) {
  const auto found = std::ranges::find(values, field, &Attribute::name);
  return found == values.end() ? nullptr : &found->value;
}

std::string cell_of(const AttributeValue& value) {
  if (const auto* whole = std::get_if<std::int64_t>(&value)) return fmt::format("{}", *whole);
  if (const auto* real = std::get_if<double>(&value)) return fmt::format("{:.15g}", *real);
  return csv_text(std::get<std::string>(value));
}

void write_csv_points(const PointTable& table, ByteSink& out) {
  std::string line = "x,y";
  for (const std::string& field : table.fields) line += "," + csv_text(field);
  out.append(line + "\n");
  for (const PointTable::Row& row : table.rows) {
    line = row.place ? fmt::format("{:.15g},{:.15g}", row.place->x, row.place->y) : ",";
    for (const std::string& field : table.fields) {
      line += ',';
      if (const AttributeValue* value = value_in(row.values, field)) line += cell_of(*value);
    }
    if (!out.append(line + "\n")) return; // `finish` tells
  }
}

void write_geojson_points(const PointTable& table, ByteSink& out) {
  GeojsonText text({.name = table.name, .description = {}, .crs_wkt = table.crs_wkt}, 15, out);
  for (const PointTable::Row& row : table.rows) {
    for (const std::string& field : table.fields)
      if (const AttributeValue* value = value_in(row.values, field)) text.property(field, *value);
    if (!text.point(row.place)) return; // `finish` tells
  }
  text.finish();
}

void write_to(const PointTable& table, PointFormat format, ByteSink& out) {
  (format == PointFormat::csv ? write_csv_points : write_geojson_points)(table, out);
  out.finish();
}

} // namespace

std::optional<PointFormat> point_format_of(std::string_view path) {
  const std::string extension = extension_of(std::string(path));
  if (extension == ".csv") return PointFormat::csv;
  if (extension == ".geojson" || extension == ".json") return PointFormat::geojson;
  return std::nullopt;
}

void write_points(const PointTable& table, PointFormat format, const std::string& path,
                  bool overwrite) {
  if (path == "-") {
    ByteSink out = ByteSink::standard_output();
    return write_to(table, format, out);
  }
  OutputFile place(path, overwrite);
  ByteSink out(place.temporary_path(), path);
  write_to(table, format, out);
  place.commit();
}

} // namespace orograph
