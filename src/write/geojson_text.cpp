// SPDX-License-Identifier: GPL-3.0-or-later
// Our own text instead of GDAL's driver, which leaves a value out without a word where json-c has
// no memory for it (docs/stability.md).
#include "write/geojson_text.hpp"

#include "write/format_text.hpp"
#include "write/ogr_writing.hpp"

#include <cpl_conv.h>
#include <fmt/format.h>
#include <ogr_spatialref.h>

#include <cmath>
#include <iterator>

namespace orograph {
namespace {

// With its quotes.
std::string json_text(std::string_view text) {
  std::string json = "\"";
  for (const char c : clean_utf8(text))
    if (c == '"' || c == '\\')
      (json += '\\') += c;
    else if (c == '\t' || c == '\n' || c == '\r')
      json += c == '\t' ? "\\t" : c == '\n' ? "\\n" : "\\r";
    else
      json += c; // no other control character is in clean text
  return json += '"';
}

// By GDAL, as its own driver tells it; empty where no authority has a name for the CRS.
std::string crs_urn(const std::string& wkt, const std::string& file_name) {
  if (wkt.empty()) return {};
  const GdalMessages messages;
  OGRSpatialReference crs;
  if (crs.importFromWkt(wkt.c_str()) != OGRERR_NONE) throw gdal_error(file_name, messages);
  char* const found = crs.GetOGCURN();
  const std::string urn = found == nullptr ? "" : found;
  CPLFree(found);
  if (messages.has_failure()) throw gdal_error(file_name, messages);
  // Degrees are told east before north here, which is another CRS than this one.
  return urn == "urn:ogc:def:crs:EPSG::4326" ? "urn:ogc:def:crs:OGC:1.3:CRS84" : urn;
}

} // namespace

GeojsonText::GeojsonText(const Head& head, std::optional<int> digits, ByteSink& out)
    : digits_(digits), out_(out) {
  const std::string urn = crs_urn(head.crs_wkt, out.name());
  std::string text =
      fmt::format("{{\n\"type\": \"FeatureCollection\",\n\"name\": {},\n", json_text(head.name));
  if (!head.description.empty())
    text += fmt::format("\"description\": {},\n", json_text(head.description));
  if (!urn.empty())
    text += fmt::format("\"crs\": {{ \"type\": \"name\", \"properties\": {{ \"name\": {} }} }},\n",
                        json_text(urn));
  text += "\"features\": [";
  out_.append(text);
}

void GeojsonText::append_number(double value, std::string& to) const {
  if (digits_)
    fmt::format_to(std::back_inserter(to), "{:.{}g}", value, *digits_);
  else
    fmt::format_to(std::back_inserter(to), "{}", value);
}

void GeojsonText::property(std::string_view name, const AttributeValue& value) {
  ((properties_ += ',') += json_text(name)) += ':';
  if (const auto* whole = std::get_if<std::int64_t>(&value)) {
    fmt::format_to(std::back_inserter(properties_), "{}", *whole);
  } else if (const auto* text = std::get_if<std::string>(&value)) {
    properties_ += json_text(*text);
  } else if (const double real = std::get<double>(value); std::isfinite(real)) {
    const std::size_t begin = properties_.size();
    append_number(real, properties_);
    // Readers take a column of numbers without a point for one of whole numbers.
    if (properties_.find_first_not_of("-0123456789", begin) == std::string::npos)
      properties_ += ".0";
  } else {
    properties_ += "null";
  }
}

bool GeojsonText::end_feature(std::string_view geometry) {
  out_.append(has_features_ ? ",\n" : "\n");
  out_.append(R"({"type":"Feature","properties":{)");
  if (!properties_.empty()) out_.append(std::string_view(properties_).substr(1)); // no comma first
  out_.append(R"(},"geometry":)");
  out_.append(geometry);
  has_features_ = true;
  properties_.clear();
  return out_.append("}");
}

bool GeojsonText::line(std::span<const Vec3> points) {
  std::string geometry = R"({"type":"LineString","coordinates":[)";
  for (const Vec3& p : points) {
    geometry += &p == points.data() ? "[" : ",[";
    append_number(p.x, geometry);
    geometry += ',';
    append_number(p.y, geometry);
    geometry += ',';
    append_number(p.z, geometry);
    geometry += ']';
  }
  return end_feature(geometry += "]}");
}

bool GeojsonText::point(const std::optional<Vec2>& place) {
  if (!place) return end_feature("null");
  std::string geometry = R"({"type":"Point","coordinates":[)";
  append_number(place->x, geometry);
  geometry += ',';
  append_number(place->y, geometry);
  return end_feature(geometry += "]}");
}

bool GeojsonText::finish() {
  return out_.append("\n]\n}\n");
}

} // namespace orograph
