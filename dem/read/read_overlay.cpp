// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/read/read_overlay.hpp"

#include "dem/read/crs_frame.hpp"
#include "dem/read/network.hpp"
#include "dem/read/vector_layer.hpp"
#include "geometry/error.hpp"
#include "geometry/on_all_cores.hpp"
#include "text/words.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gdal_priv.h>
#include <ogr_geometry.h>
#include <ogrsf_frmts.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "gdal/gdal.hpp"

namespace orograph {
namespace {

using Transformation = std::unique_ptr<OGRCoordinateTransformation>;

[[noreturn]] void refuse_condition(OGRLayer& layer, const OverlayInput& input,
                                   const GdalMessages& messages) {
  const std::vector<std::string> fields = field_names(layer);
  throw Error(fmt::format("'{}' is no condition for {} ({})", input.where, input.path,
                          messages.last_failure()),
              fields.empty() ? "it has no fields"
                             : fmt::format("its fields are {}, and a condition is like \"{} = 1\"",
                                           fmt::join(fields, ", "), fields.front()));
}

// Coordinates in columns of a CSV: longitudes and latitudes go before others, which are the
// terrain's.
struct CoordinateColumns {
  std::vector<std::string> x, y; ///< names, the likeliest first
  bool are_degrees;
};
const std::array<CoordinateColumns, 2>& coordinate_columns() {
  static const std::array<CoordinateColumns, 2> columns{
      {{{"lon", "long", "lng", "longitude"}, {"lat", "latitude"}, true},
       {{"x", "east", "easting", "e"}, {"y", "north", "northing", "n"}, false}}};
  return columns;
}

// The likeliest of the names that a column has; none where no column has any.
std::optional<std::string> column_named(const std::vector<std::string>& names,
                                        const std::vector<std::string>& columns,
                                        const std::string& path) {
  for (const std::string& name : names) {
    const auto count = std::ranges::count(columns, name, in_lower_case);
    if (count > 1)
      throw Error(fmt::format("{} has {} columns named {}", path, count, name),
                  "name them differently, so that one tells the place");
    if (count == 1) return name;
  }
  return std::nullopt;
}

struct OpenedOverlay {
  Dataset dataset;
  bool in_degrees = false; ///< as its columns say, without a CRS
};

bool has_geometries(GDALDataset& dataset) {
  for (OGRLayer* layer : dataset.GetLayers())
    if (layer->GetGeomType() != wkbNone) return true;
  return false;
}

OpenedOverlay open_overlay(const std::string& path) {
  if (extension_of(path) != ".csv") return {open_vector(path, {})};
  Dataset plain = open_vector(path, {"AUTODETECT_TYPE=YES"});
  if (!plain || has_geometries(*plain)) return {std::move(plain), true};
  std::vector<std::string> columns;
  for (OGRLayer* layer : plain->GetLayers()) columns = field_names(*layer);
  for (const auto& [x_names, y_names, are_degrees] : coordinate_columns()) {
    const auto x = column_named(x_names, columns, path), y = column_named(y_names, columns, path);
    if (!x || !y) continue;
    // In the terrain's CRS columns would only say again where a point is. Each is named alone: GDAL
    // reads through a null pointer where it keeps none of several that might be meant.
    return {open_vector(path, {"X_POSSIBLE_NAMES=" + *x, "Y_POSSIBLE_NAMES=" + *y,
                               are_degrees ? "KEEP_GEOM_COLUMNS=YES" : "KEEP_GEOM_COLUMNS=NO",
                               "AUTODETECT_TYPE=YES"}),
            are_degrees};
  }
  throw Error(path + " has no columns of coordinates",
              "name them lon and lat, or x and y in the terrain's CRS");
}

// The one that is meant: named, the only one, or the only one that isn't empty, as GPX has.
std::string layer_meant(GDALDataset& dataset, const OverlayInput& input) {
  if (!input.layer.empty() || dataset.GetLayerCount() < 2) return input.layer;
  std::string found;
  for (OGRLayer* layer : dataset.GetLayers()) {
    if (layer->GetGeomType() == wkbNone || layer->GetFeatureCount() == 0) continue;
    if (!found.empty()) return {};
    found = layer->GetName();
  }
  return found;
}

Crs plane_of_layer(OGRLayer& layer, bool in_degrees) {
  if (const OGRSpatialReference* given = layer.GetSpatialRef(); tells_place(given))
    return plane_of(Crs(given->Clone()));
  return in_degrees ? plane_of(crs_from_text("EPSG:4326")) : nullptr;
}

// From a layer's plane to the terrain's; null where coordinates are the same.
class Way {
public:
  Way(OGRLayer& layer, bool in_degrees, const OverlayInput& input, const MapFrame& map,
      Overlay& overlay) {
    const Crs from = plane_of_layer(layer, in_degrees);
    const bool has_place = from != nullptr, map_has = !map.crs_wkt.empty();
    if (!has_place || !map_has) {
      if (has_place != map_has)
        overlay.notes.push_back(fmt::format("{} has no CRS: coordinates of {} are taken as the "
                                            "terrain's.",
                                            has_place ? "The terrain" : input.path, input.path));
      return;
    }
    const Crs to = plane_of(crs_from_text(map.crs_wkt));
    if (from->IsSame(to.get())) return;
    there_.reset(OGRCreateCoordinateTransformation(from.get(), to.get()));
    if (there_) back_.reset(there_->GetInverse());
    if (!there_ || !back_)
      throw Error(fmt::format("there is no way from the CRS of {} to that of the terrain, {}",
                              input.path, map.crs_name),
                  "bring it there: ogr2ogr -t_srs CRS there.gpkg " + input.path);
  }

  bool is_needed() const { return there_ != nullptr; }
  std::optional<Vec2> there(Vec2 place) const { return !there_ ? place : moved(*there_, place); }
  std::optional<Vec2> back(Vec2 place) const { return !back_ ? place : moved(*back_, place); }

private:
  Transformation there_, back_;
};

// The terrain's box in the layer's plane, from places all along its sides.
std::optional<Box2> box_there(const Box2& map, const Way& way) {
  constexpr int kASide = 32;
  Box2 out;
  for (int i = 0; i <= kASide; ++i)
    for (int j = 0; j <= kASide; ++j) {
      const double x = static_cast<double>(i) / kASide, y = static_cast<double>(j) / kASide;
      const auto place = way.back(
          {map.low.x + x * (map.high.x - map.low.x), map.low.y + y * (map.high.y - map.low.y)});
      if (!place) return std::nullopt;
      out.include(*place);
    }
  const Vec2 beside = 0.05 * (out.high - out.low);
  return Box2{out.low - beside, out.high + beside};
}

class OverlayReader {
public:
  OverlayReader(const Way& way, const Box2& bounds, double cell, std::optional<double> turn,
                bool everywhere, Overlay& out)
      : way_(way), bounds_(bounds), cell_(cell), turn_(turn), everywhere_(everywhere), out_(out) {}

  void add(const OGRFeature& feature) {
    const std::size_t first = out_.lines.size();
    if (const OGRGeometry* geometry = feature.GetGeometryRef()) add(*geometry, feature.GetFID());
    if (out_.lines.size() > first || everywhere_)
      out_.features.push_back({attributes_of(feature), first, out_.lines.size() - first});
  }
  bool is_over_terrain() const { return over_terrain_; }

private:
  static Attributes attributes_of(const OGRFeature& feature) {
    Attributes out;
    for (int i = 0; i < feature.GetFieldCount(); ++i) {
      if (!feature.IsFieldSetAndNotNull(i)) continue;
      const OGRFieldDefn& field = *feature.GetFieldDefnRef(i);
      Attribute attribute{field.GetNameRef(), std::string()};
      switch (field.GetType()) {
      case OFTInteger:
      case OFTInteger64:
        attribute.value = static_cast<std::int64_t>(feature.GetFieldAsInteger64(i));
        break;
      case OFTReal:
        attribute.value = feature.GetFieldAsDouble(i);
        break;
      default:
        attribute.value = std::string(feature.GetFieldAsString(i));
      }
      out.push_back(std::move(attribute));
    }
    return out;
  }

  void add(const OGRGeometry& geometry, std::int64_t id) {
    if (geometry.IsEmpty()) return;
    switch (wkbFlatten(geometry.getGeometryType())) {
    case wkbPoint: {
      const OGRPoint& point = *geometry.toPoint();
      begin_line();
      add_place({point.getX(), point.getY()}, id);
      return;
    }
    case wkbLineString:
    case wkbLinearRing:
      return add_line(*geometry.toLineString(), id);
    case wkbPolygon:
    case wkbTriangle:
      for (const OGRLinearRing* ring : *geometry.toPolygon()) add_line(*ring, id);
      return;
    case wkbPolyhedralSurface:
    case wkbTIN:
      for (const OGRPolygon* patch : *geometry.toPolyhedralSurface()) add(*patch, id);
      return;
    case wkbMultiPoint:
    case wkbMultiLineString:
    case wkbMultiPolygon:
    case wkbGeometryCollection:
      for (const OGRGeometry* part : *geometry.toGeometryCollection()) add(*part, id);
      return;
    default: { // curves
      const std::unique_ptr<OGRGeometry> straight(geometry.getLinearGeometry());
      if (straight && !straight->hasCurveGeometry()) add(*straight, id);
    }
    }
  }

  void begin_line() { out_.lines.push_back({out_.places.size(), 0}); }

  void add_line(const OGRSimpleCurve& line, std::int64_t id) {
    begin_line();
    for (int i = 0; i < line.getNumPoints(); ++i) {
      throw_if_stopped(static_cast<std::size_t>(i));
      add_place({line.getX(i), line.getY(i)}, id);
    }
  }

  void add_place(Vec2 given, std::int64_t id) {
    if (!std::isfinite(given.x) || !std::isfinite(given.y))
      throw Error(
          fmt::format("feature {} of {} has a place at {}, {}", id, out_.source, given.x, given.y),
          "coordinates must be finite numbers");
    const auto on_map = way_.there(given);
    if (!on_map) { // a place that the terrain's CRS doesn't have parts the line
      if (out_.lines.back().place_count > 0) begin_line();
      return;
    }
    Vec2 place = *on_map;
    if (turn_) place.x -= *turn_ * std::round((place.x - bounds_.centre().x) / *turn_);
    if (out_.lines.back().place_count > 0 && way_.is_needed())
      add_between(last_given_, out_.places.back(), given, place, 0);
    store(place);
    last_given_ = given;
  }

  // Places between two wherever the straight line between their images is too far from the line's.
  void add_between(Vec2 from, Vec2 from_on_map, Vec2 to, Vec2 to_on_map, int depth) {
    // A line of few cells doesn't bend by a tenth of one in any CRS that one makes maps in.
    constexpr double kStraight = 10, kMostBend = 0.1; // cells
    constexpr int kDeepest = 12;
    if (depth == kDeepest || length(to_on_map - from_on_map) <= kStraight * cell_) return;
    const Vec2 middle = 0.5 * (from + to);
    const auto on_map = way_.there(middle);
    if (!on_map) return;
    Vec2 place = *on_map;
    if (turn_) place.x -= *turn_ * std::round((place.x - from_on_map.x) / *turn_);
    if (length(place - 0.5 * (from_on_map + to_on_map)) <= kMostBend * cell_) return;
    add_between(from, from_on_map, middle, place, depth + 1);
    store(place);
    add_between(middle, place, to, to_on_map, depth + 1);
  }

  void store(Vec2 place) {
    Box2 reached; // a line may go over the terrain between two places beside it
    reached.include(place);
    if (out_.lines.back().place_count > 0) reached.include(out_.places.back());
    over_terrain_ =
        over_terrain_ || (reached.low.x <= bounds_.high.x && reached.high.x >= bounds_.low.x &&
                          reached.low.y <= bounds_.high.y && reached.high.y >= bounds_.low.y);
    out_.places.push_back(place);
    ++out_.lines.back().place_count;
  }

  const Way& way_;
  Box2 bounds_;
  double cell_;
  std::optional<double> turn_;
  bool everywhere_;
  Overlay& out_;
  Vec2 last_given_{};
  bool over_terrain_ = false;
};

std::string text_of(const Box2& box) {
  return fmt::format("{:.10g},{:.10g} and {:.10g},{:.10g}", box.low.x, box.low.y, box.high.x,
                     box.high.y);
}

} // namespace

Overlay read_overlay(const OverlayInput& input, const MapFrame& map, const Box2& bounds,
                     double cell) {
  const NetworkGate gate({input.path}, input.allow_network);
  const GdalMessages messages;
  const auto [dataset, in_degrees] = open_overlay(input.path);
  if (!dataset)
    throw Error(fmt::format("{} can't be opened as a vector file ({})", input.path,
                            messages.last_failure()),
                "give layers that GDAL reads, such as GeoPackage, Shapefile or GeoJSON");
  OGRLayer& layer = layer_of(*dataset, input.path, layer_meant(*dataset, input),
                             fmt::format("name one, as in {}:LAYER", input.path));
  Overlay out;
  out.notes = gate.doubts();
  out.source = fmt::format("{} ({})", input.path, layer.GetName());
  OGRFeatureDefn& kind = *layer.GetLayerDefn();
  for (int i = 0; i < kind.GetFieldCount(); ++i)
    out.fields.emplace_back(kind.GetFieldDefn(i)->GetNameRef());
  if (!input.where.empty() && layer.SetAttributeFilter(input.where.c_str()) != OGRERR_NONE)
    refuse_condition(layer, input, messages);
  const Way way(layer, in_degrees, input, map, out);
  const std::optional<double> turn = whole_turn(map.crs_wkt);
  if (const auto box = box_there(bounds, way); box && !turn && !input.everywhere)
    layer.SetSpatialFilterRect(box->low.x, box->low.y, box->high.x, box->high.y);
  OverlayReader reader(way, bounds, cell, turn, input.everywhere, out);
  layer.ResetReading();
  for (const auto& feature : layer) {
    throw_if_stopped();
    reader.add(*feature);
  }
  // Databases take any condition, and fail when they are asked.
  if (messages.has_failure() && !input.where.empty()) refuse_condition(layer, input, messages);
  if (messages.has_failure())
    throw Error(
        fmt::format("{} can't be read to its end ({})", input.path, messages.last_failure()),
        "check it with 'ogrinfo -al'");
  add_doubts(messages, input.path, out.notes);
  if (reader.is_over_terrain()) return out;
  layer.SetSpatialFilter(nullptr);
  if (layer.GetFeatureCount() == 0)
    throw Error(fmt::format("there is nothing in {}{}", out.source,
                            input.where.empty() ? "" : fmt::format(" where {}", input.where)),
                input.where.empty() ? "it must hold features" : "widen the condition");
  OGREnvelope all;
  if (layer.GetExtent(&all, TRUE) != OGRERR_NONE)
    throw Error(fmt::format("no feature of {} has a geometry", out.source),
                "give a layer of points, lines or areas");
  const std::string where =
      "between " + text_of({{all.MinX, all.MinY}, {all.MaxX, all.MaxY}}) + " in its own CRS";
  throw Error(fmt::format("nothing of {} is on the terrain: it lies {}", out.source, where),
              fmt::format("features between {} in the terrain's CRS, or a layer that tells its CRS",
                          text_of(bounds)));
}

} // namespace orograph
