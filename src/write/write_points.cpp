// SPDX-License-Identifier: GPL-3.0-or-later
#include "write/write_points.hpp"

#include "text/csv_text.hpp"
#include "text/words.hpp"
#include "write/byte_sink.hpp"
#include "write/format_text.hpp"
#include "write/ogr_writing.hpp"
#include "write/output_file.hpp"
#include "write/sink_filesystem.hpp"

#include <cpl_string.h>
#include <fmt/format.h>
#include <ogrsf_frmts.h>

#include <algorithm>
#include <map>
#include <memory>
#include <variant>

namespace orograph {
namespace {

using PointValue = decltype(Attribute::value);

const PointValue* value_in(const Attributes& values, const std::string& field) {
  const auto found = std::ranges::find(values, field, &Attribute::name);
  return found == values.end() ? nullptr : &found->value;
}

std::string cell_of(const PointValue& value) {
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
      if (const PointValue* value = value_in(row.values, field)) line += cell_of(*value);
    }
    if (!out.append(line + "\n")) return; // `finish` tells
  }
}

// The type that holds all of a field's values.
OGRFieldType field_type(const PointTable& table, const std::string& field) {
  OGRFieldType type = OFTInteger64;
  for (const PointTable::Row& row : table.rows) {
    const PointValue* value = value_in(row.values, field);
    if (value && std::holds_alternative<std::string>(*value)) return OFTString;
    if (value && std::holds_alternative<double>(*value)) type = OFTReal;
  }
  return type;
}

OGRLayer* add_point_layer(GDALDataset& dataset, const PointTable& table) {
  OGRSpatialReference crs;
  crs.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  if (!table.crs_wkt.empty() && crs.importFromWkt(table.crs_wkt.c_str()) != OGRERR_NONE)
    return nullptr;
  CPLStringList options;
  options.SetNameValue("RFC7946", "NO"); // RFC 7946 would have it reprojected to degrees
  options.SetNameValue("SIGNIFICANT_FIGURES", "15");
  OGRLayer* const layer = dataset.CreateLayer(
      table.name.c_str(), table.crs_wkt.empty() ? nullptr : &crs, wkbPoint, options.List());
  if (layer == nullptr) return nullptr;
  for (const std::string& name : table.fields) {
    OGRFieldDefn field(name.c_str(), field_type(table, name));
    if (layer->CreateField(&field) != OGRERR_NONE) return nullptr;
  }
  return layer;
}

void set_point_value(OGRFeature& feature, int field, const PointValue& value) {
  if (const auto* whole = std::get_if<std::int64_t>(&value))
    feature.SetField(field, static_cast<GIntBig>(*whole));
  else if (const auto* real = std::get_if<double>(&value))
    feature.SetField(field, *real);
  else
    feature.SetField(field, clean_utf8(std::get<std::string>(value)).c_str());
}

// Whether all went well, up to and including the closing.
bool write_point_rows(const PointTable& table, const std::string& path,
                      const GdalMessages& messages) {
  Dataset dataset = create_dataset("GeoJSON", path);
  if (!dataset) return false;
  OGRLayer* const layer = add_point_layer(*dataset, table);
  if (layer == nullptr) return false;
  for (const PointTable::Row& row : table.rows) {
    OGRFeature feature(layer->GetLayerDefn());
    for (std::size_t i = 0; i < table.fields.size(); ++i)
      if (const PointValue* value = value_in(row.values, table.fields[i]))
        set_point_value(feature, static_cast<int>(i), *value);
    if (row.place)
      feature.SetGeometryDirectly(std::make_unique<OGRPoint>(row.place->x, row.place->y).release());
    if (layer->CreateFeature(&feature) != OGRERR_NONE) return false;
  }
  dataset.reset();
  return !messages.has_failure();
}

void write_geojson_points(const PointTable& table, ByteSink& out) {
  const OnOneDay day;
  const GdalMessages messages;
  const SinkFilesystem filesystem(out);
  const std::string path = std::string(SinkFilesystem::kFolder) + "points.geojson";
  if (!write_point_rows(table, path, messages) && out.append({}))
    throw gdal_error(out.name(), messages);
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
