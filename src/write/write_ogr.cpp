// SPDX-License-Identifier: GPL-3.0-or-later
// GeoJSON and GeoPackage through OGR: one layer of line strings with heights, in the terrain's CRS.
#include "write/byte_sink.hpp"
#include "write/format_text.hpp"
#include "write/ogr_writing.hpp"
#include "write/sink_filesystem.hpp"
#include "write/writers.hpp"

#include <cpl_string.h>
#include <fmt/format.h>
#include <ogrsf_frmts.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>

namespace orograph {
namespace {

constexpr const char* kLayerName = "strokes";
constexpr std::size_t kStrokesInTransaction = 100000;

constexpr auto kFields =
    std::to_array<std::pair<const char*, OGRFieldType>>({{"layer", OFTString},
                                                         {"profile", OFTInteger},
                                                         {"depth", OFTReal},
                                                         {"visible", OFTInteger},
                                                         {"level", OFTInteger},
                                                         {"darkness", OFTReal}});

// As simplestyle calls it, and programs that show GeoJSON: "#rrggbb". It is there where a layer has
// a colour of its own.
constexpr const char* kColourField = "stroke";

bool tells_colours(const Drawing& drawing) {
  return std::ranges::any_of(drawing.layers,
                             [](const Layer& layer) { return layer.ink().has_value(); });
}

struct IgnoresCase {
  bool operator()(const std::string& a, const std::string& b) const {
    return STRCASECMP(a.c_str(), b.c_str()) < 0;
  }
};
// The fields of all things that strokes are lines of: a name each, in whatever case, since OGR and
// SQL don't tell cases apart; and the type that holds every value.
using MoreFields = std::map<std::string, OGRFieldType, IgnoresCase>;

// Names that strokes' own fields have, or GeoPackage's, get a mark.
std::string field_name(const std::string& attribute, bool with_colour) {
  const auto is_called = [&](const char* name) { return EQUAL(name, attribute.c_str()); };
  const bool is_own =
      std::ranges::any_of(kFields, [&](const auto& field) { return is_called(field.first); }) ||
      is_called("fid") || is_called("geom") || (with_colour && is_called(kColourField));
  return is_own ? attribute + "_" : attribute;
}

MoreFields fields_of(const Drawing& drawing) {
  const bool with_colour = tells_colours(drawing);
  MoreFields out;
  for (const Layer& layer : drawing.layers)
    for (const Attributes& attributes : layer.features)
      for (const auto& [name, value] : attributes) {
        const OGRFieldType type = std::holds_alternative<std::int64_t>(value) ? OFTInteger64
                                  : std::holds_alternative<double>(value)     ? OFTReal
                                                                              : OFTString;
        const auto [field, is_new] = out.emplace(field_name(name, with_colour), type);
        if (is_new || field->second == type) continue;
        field->second = field->second != OFTString && type != OFTString ? OFTReal : OFTString;
      }
  return out;
}

void set_attributes(const Attributes& attributes, bool with_colour, OGRFeature& feature) {
  for (const auto& [name, value] : attributes) {
    const int field = feature.GetFieldIndex(field_name(name, with_colour).c_str());
    if (const auto* whole = std::get_if<std::int64_t>(&value))
      feature.SetField(field, static_cast<GIntBig>(*whole));
    else if (const auto* real = std::get_if<double>(&value))
      feature.SetField(field, *real);
    else
      feature.SetField(field, std::get<std::string>(value).c_str());
  }
}

OGRLayer* add_layer(GDALDataset& dataset, const Drawing& drawing, CPLStringList options) {
  OGRSpatialReference crs;
  crs.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  if (!drawing.crs_wkt.empty() && crs.importFromWkt(drawing.crs_wkt.c_str()) != OGRERR_NONE)
    return nullptr;
  OGRLayer* const layer = dataset.CreateLayer(kLayerName, drawing.crs_wkt.empty() ? nullptr : &crs,
                                              wkbLineString25D, options.List());
  if (layer == nullptr) return nullptr;
  for (const auto& [name, type] : kFields) {
    OGRFieldDefn field(name, type);
    if (layer->CreateField(&field) != OGRERR_NONE) return nullptr;
  }
  if (tells_colours(drawing)) {
    OGRFieldDefn field(kColourField, OFTString);
    if (layer->CreateField(&field) != OGRERR_NONE) return nullptr;
  }
  for (const auto& [name, type] : fields_of(drawing)) {
    OGRFieldDefn field(name.c_str(), type);
    if (layer->CreateField(&field) != OGRERR_NONE) return nullptr;
  }
  return layer;
}

std::unique_ptr<OGRFeature> feature_of(const Stroke& stroke, const Layer& from, bool with_colour,
                                       OGRLayer& to) {
  auto feature = std::make_unique<OGRFeature>(to.GetLayerDefn());
  feature->SetField("layer", from.name.c_str());
  feature->SetField("profile", stroke.profile);
  if (std::isnan(stroke.depth_m))
    feature->SetFieldNull(feature->GetFieldIndex("depth"));
  else
    feature->SetField("depth", stroke.depth_m);
  feature->SetField("visible", from.is_hidden ? 0 : 1);
  if (stroke.feature >= 0)
    set_attributes(from.features[static_cast<std::size_t>(stroke.feature)], with_colour, *feature);
  if (with_colour) feature->SetField(kColourField, hex_colour(from).c_str());
  if (stroke.profile < 0)
    feature->SetFieldNull(feature->GetFieldIndex("level"));
  else
    feature->SetField("level", stroke.level);
  if (std::isnan(stroke.darkness))
    feature->SetFieldNull(feature->GetFieldIndex("darkness"));
  else
    feature->SetField("darkness", std::round(1e4 * static_cast<double>(stroke.darkness)) / 1e4);
  auto line = std::make_unique<OGRLineString>();
  const auto count = static_cast<int>(stroke.point_count);
  line->setNumPoints(count, FALSE);
  for (int i = 0; i < count; ++i) {
    const Vec3 p = from.map[stroke.first_point + static_cast<std::size_t>(i)];
    line->setPoint(i, p.x, p.y, p.z);
  }
  feature->SetGeometryDirectly(line.release());
  return feature;
}

// Whether all went well. Transactions make GeoPackage quick, and their size bounds what it keeps;
// GeoJSON has none and says so, which is no failure.
bool add_strokes(GDALDataset& dataset, const Drawing& drawing, OGRLayer& layer) {
  const bool in_transactions = dataset.TestCapability(ODsCTransactions) != FALSE;
  const auto start = [&] { return !in_transactions || dataset.StartTransaction() == OGRERR_NONE; };
  const auto commit = [&] {
    return !in_transactions || dataset.CommitTransaction() == OGRERR_NONE;
  };
  const bool with_colour = tells_colours(drawing);
  std::size_t count = 0;
  if (!start()) return false;
  for (const Layer& from : drawing.layers)
    for (const Stroke& stroke : from.strokes) {
      if (layer.CreateFeature(feature_of(stroke, from, with_colour, layer).get()) != OGRERR_NONE)
        return false;
      if (++count % kStrokesInTransaction == 0 && !(commit() && start())) return false;
    }
  return commit();
}

// Whether all went well, up to and including the closing.
bool write(const char* driver_name, const std::string& path, const Drawing& drawing,
           const CPLStringList& layer_options, const GdalMessages& messages) {
  Dataset dataset = create_dataset(driver_name, path);
  if (!dataset) return false;
  OGRLayer* const layer = add_layer(*dataset, drawing, layer_options);
  if (layer == nullptr || !add_strokes(*dataset, drawing, *layer)) return false;
  dataset.reset();
  return !messages.has_failure();
}

void set_text(CPLStringList& options, const char* name, const std::string& text) {
  if (!text.empty()) options.SetNameValue(name, clean_utf8(text).c_str());
}

std::size_t stroke_count(const Drawing& drawing) {
  std::size_t count = 0;
  for (const Layer& layer : drawing.layers) count += layer.strokes.size();
  return count;
}

std::string first_value(GDALDataset& dataset, const char* sql) {
  OGRLayer* const rows = dataset.ExecuteSQL(sql, nullptr, nullptr);
  if (rows == nullptr) return {};
  std::string value;
  if (const OGRFeatureUniquePtr row(rows->GetNextFeature()); row) value = row->GetFieldAsString(0);
  dataset.ReleaseResultSet(rows);
  return value;
}

} // namespace

void write_geojson(const Drawing& drawing, ByteSink& out) {
  const OnOneDay day;
  const GdalMessages messages;
  const SinkFilesystem filesystem(out);
  CPLStringList options;
  options.SetNameValue("RFC7946", "NO"); // RFC 7946 would have it reprojected to degrees
  options.SetNameValue("SIGNIFICANT_FIGURES", "17"); // reads back to the same number
  set_text(options, "DESCRIPTION", drawing.title);
  const std::string path = std::string(SinkFilesystem::kFolder) + "strokes.geojson";
  if (!write("GeoJSON", path, drawing, options, messages) && out.append({}))
    throw gdal_error(out.name(), messages);
}

void write_geopackage(const Drawing& drawing, const std::string& path, const std::string& name) {
  const OnOneDay day;
  const GdalMessages messages;
  CPLStringList options;
  set_text(options, "IDENTIFIER", drawing.title);
  set_text(options, "DESCRIPTION", drawing.description);
  ::unlink(path.c_str()); // the driver creates it and nothing else
  if (!write("GPKG", path, drawing, options, messages)) throw gdal_error(name, messages);
}

void prove_geojson(const Drawing& drawing, const std::string& path, const std::string& name) {
  const GdalMessages messages;
  const char* const drivers[] = {"GeoJSON", nullptr};
  const Dataset dataset(GDALDataset::Open(path.c_str(), GDAL_OF_VECTOR, drivers));
  OGRLayer* const layer = dataset ? dataset->GetLayer(0) : nullptr;
  const auto expected = static_cast<GIntBig>(stroke_count(drawing));
  if (layer == nullptr || layer->GetFeatureCount() != expected || messages.has_failure())
    throw gdal_error(name, messages);
}

void prove_geopackage(const Drawing& drawing, const std::string& path, const std::string& name) {
  const OnOneDay day;
  const GdalMessages messages;
  const char* const drivers[] = {"GPKG", nullptr};
  const Dataset dataset(GDALDataset::Open(path.c_str(), GDAL_OF_VECTOR, drivers));
  const std::string expected = fmt::format("{}", stroke_count(drawing));
  if (!dataset || first_value(*dataset, "PRAGMA quick_check(1)") != "ok" ||
      first_value(*dataset, "SELECT COUNT(*) FROM strokes") != expected || messages.has_failure())
    throw gdal_error(name, messages);
}

} // namespace orograph
