// SPDX-License-Identifier: GPL-3.0-or-later
// One layer of line strings with heights, in the terrain's CRS.
#include "write/format_text.hpp"
#include "write/ogr_writing.hpp"
#include "write/stroke_attributes.hpp"
#include "write/writers.hpp"

#include <cpl_string.h>
#include <ogrsf_frmts.h>
#include <unistd.h>

#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <new>
#include <string>

#include "gdal/whole_geopackage.hpp"

namespace orograph {
namespace {

constexpr const char* kLayerName = "strokes";
constexpr std::size_t kStrokesInTransaction = 100000;

constexpr std::array<OGRFieldType, kStrokeFields.size()> kStrokeFieldTypes{
    OFTString, OFTInteger, OFTReal, OFTInteger, OFTInteger, OFTReal};

struct IgnoresCase {
  bool operator()(const std::string& a, const std::string& b) const {
    return STRCASECMP(a.c_str(), b.c_str()) < 0;
  }
};
// The fields of all things that strokes are lines of: a name each, in whatever case, since OGR and
// SQL don't tell cases apart; and the type that holds every value.
using MoreFields = std::map<std::string, OGRFieldType, IgnoresCase>;

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

void set_attributes(const Attributes& attributes, OGRFeature& feature) {
  for (const auto& [name, value] : attributes) {
    const int field = feature.GetFieldIndex(name.c_str());
    if (const auto* whole = std::get_if<std::int64_t>(&value))
      feature.SetField(field, static_cast<GIntBig>(*whole));
    else if (const auto* text = std::get_if<std::string>(&value))
      feature.SetField(field, text->c_str());
    else if (const double real = std::get<double>(value); std::isnan(real))
      feature.SetFieldNull(field);
    else
      feature.SetField(field, real);
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
  for (std::size_t i = 0; i < kStrokeFields.size(); ++i) {
    OGRFieldDefn field(kStrokeFields[i].data(), kStrokeFieldTypes[i]);
    if (layer->CreateField(&field) != OGRERR_NONE) return nullptr;
  }
  if (tells_colours(drawing)) {
    OGRFieldDefn field(kColourField.data(), OFTString);
    if (layer->CreateField(&field) != OGRERR_NONE) return nullptr;
  }
  for (const auto& [name, type] : fields_of(drawing)) {
    OGRFieldDefn field(name.c_str(), type);
    if (layer->CreateField(&field) != OGRERR_NONE) return nullptr;
  }
  return layer;
}

OGRFeatureUniquePtr feature_of(const Stroke& stroke, const Layer& from, bool with_colour,
                               OGRLayer& to) {
  OGRFeatureUniquePtr feature(OGRFeature::CreateFeature(to.GetLayerDefn()));
  if (!feature) throw std::bad_alloc(); // its constructor would leave the fields out
  set_attributes(attributes_of(stroke, from, with_colour), *feature);
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

// Whether all went well. Transactions make it quick, and their size bounds what is kept.
bool add_strokes(GDALDataset& dataset, const Drawing& drawing, OGRLayer& layer) {
  const auto start = [&] { return dataset.StartTransaction() == OGRERR_NONE; };
  const auto commit = [&] { return dataset.CommitTransaction() == OGRERR_NONE; };
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
bool write(const std::string& path, const Drawing& drawing, const CPLStringList& layer_options,
           const GdalMessages& messages) {
  Dataset dataset = create_dataset("GPKG", path);
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

} // namespace

void write_geopackage(const Drawing& drawing, const std::string& path, const std::string& name) {
  const OnOneDay day;
  const GdalMessages messages;
  CPLStringList options;
  set_text(options, "IDENTIFIER", drawing.title);
  set_text(options, "DESCRIPTION", drawing.description);
  ::unlink(path.c_str()); // the driver creates it and nothing else
  if (!write(path, drawing, options, messages)) throw gdal_error(name, messages);
}

void prove_geopackage(const Drawing& drawing, const std::string& path, const std::string& name) {
  const OnOneDay day;
  const GdalMessages messages;
  if (!is_whole_geopackage(path, "SELECT COUNT(*) FROM strokes",
                           std::to_string(stroke_count(drawing))) ||
      messages.has_failure())
    throw gdal_error(name, messages);
}

} // namespace orograph
