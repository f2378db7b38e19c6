// SPDX-License-Identifier: GPL-3.0-or-later
// GeoJSON and GeoPackage through OGR: one layer of line strings with heights, in the terrain's CRS.
// DXF: the page's polylines.
#include "draw/round_drawing.hpp"
#include "geometry/on_all_cores.hpp"
#include "write/byte_sink.hpp"
#include "write/format_text.hpp"
#include "write/sink_filesystem.hpp"
#include "write/writers.hpp"

#include <cpl_conv.h>
#include <cpl_error.h>
#include <cpl_string.h>
#include <cpl_vsi.h>
#include <fmt/format.h>
#include <gdal_priv.h>
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

// As long as it lives, GDAL's messages in this thread come here and go nowhere else. The last error
// that the program may still want to ask GDAL for is put back.
class OgrMessages {
public:
  OgrMessages()
      : last_(CPLGetLastErrorType()), last_number_(CPLGetLastErrorNo()),
        last_text_(CPLGetLastErrorMsg()) {
    CPLPushErrorHandlerEx(keep, this);
    CPLErrorReset();
  }
  ~OgrMessages() {
    CPLPopErrorHandler();
    CPLErrorSetState(last_, last_number_, last_text_.c_str());
  }
  OgrMessages(const OgrMessages&) = delete;
  OgrMessages& operator=(const OgrMessages&) = delete;

  bool has_failure() const { return has_failure_; }
  // The first failure (later ones follow from it), or else the last warning; on one line and
  // without the SQL statement that met it; empty where there was none.
  const std::string& reason() const { return reason_; }
  void take(bool is_failure, const char* text);

private:
  static void keep(CPLErr level, CPLErrorNum, const char* text);

  CPLErr last_;
  CPLErrorNum last_number_;
  std::string last_text_;
  bool has_failure_ = false;
  std::string reason_;
};

void OgrMessages::keep(CPLErr level, CPLErrorNum, const char* text) {
  if (level >= CE_Warning)
    static_cast<OgrMessages*>(CPLGetErrorHandlerUserData())->take(level >= CE_Failure, text);
}

void OgrMessages::take(bool is_failure, const char* text) {
  constexpr std::string_view before_reason = " failed: ";
  if (has_failure_) return;
  has_failure_ = is_failure;
  reason_ = text;
  if (const std::size_t found = reason_.rfind(before_reason); found != std::string::npos)
    reason_.erase(0, found + before_reason.size());
  std::ranges::replace(reason_, '\n', ' ');
}

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

// As long as it lives, an option of GDAL's has a value in this thread; then what it had before.
class ThreadOption {
public:
  ThreadOption(const char* name, const char* value) : name_(name) {
    if (const char* before = CPLGetThreadLocalConfigOption(name, nullptr)) before_ = before;
    CPLSetThreadLocalConfigOption(name, value);
  }
  ~ThreadOption() { CPLSetThreadLocalConfigOption(name_, before_ ? before_->c_str() : nullptr); }
  ThreadOption(const ThreadOption&) = delete;
  ThreadOption& operator=(const ThreadOption&) = delete;

private:
  const char* name_;
  std::optional<std::string> before_;
};

// The same bytes on any day, and nothing beside the file.
struct WritingOptions {
  ThreadOption date{"OGR_CURRENT_DATE", "2000-01-01T00:00:00.000Z"};
  ThreadOption nothing_beside{"GDAL_PAM_ENABLED", "NO"};
};

struct CloseDataset {
  void operator()(GDALDataset* dataset) const { GDALClose(dataset); }
};
using Dataset = std::unique_ptr<GDALDataset, CloseDataset>;

Error gdal_error(const std::string& name, const OgrMessages& messages) {
  const std::string reason = messages.reason().empty() ? "GDAL gives no reason" : messages.reason();
  return {fmt::format("{} can't be written ({})", name, reason),
          "a disk with room for it, and a folder that you may write to"};
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
std::string field_name(const std::string& attribute, bool has_colours) {
  const auto is_called = [&](const char* name) { return EQUAL(name, attribute.c_str()); };
  const bool is_own =
      std::ranges::any_of(kFields, [&](const auto& field) { return is_called(field.first); }) ||
      is_called("fid") || is_called("geom") || (has_colours && is_called(kColourField));
  return is_own ? attribute + "_" : attribute;
}

MoreFields fields_of(const Drawing& drawing) {
  const bool has_colours = tells_colours(drawing);
  MoreFields out;
  for (const Layer& layer : drawing.layers)
    for (const Attributes& attributes : layer.features)
      for (const auto& [name, value] : attributes) {
        const OGRFieldType type = std::holds_alternative<std::int64_t>(value) ? OFTInteger64
                                  : std::holds_alternative<double>(value)     ? OFTReal
                                                                              : OFTString;
        const auto [field, is_new] = out.emplace(field_name(name, has_colours), type);
        if (is_new || field->second == type) continue;
        field->second = field->second != OFTString && type != OFTString ? OFTReal : OFTString;
      }
  return out;
}

void set_attributes(const Attributes& attributes, bool has_colours, OGRFeature& feature) {
  for (const auto& [name, value] : attributes) {
    const int field = feature.GetFieldIndex(field_name(name, has_colours).c_str());
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

std::unique_ptr<OGRFeature> feature_of(const Stroke& stroke, const Layer& from, bool has_colours,
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
    set_attributes(from.features[static_cast<std::size_t>(stroke.feature)], has_colours, *feature);
  if (has_colours) feature->SetField(kColourField, hex_colour(from).c_str());
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
  const bool has_colours = tells_colours(drawing);
  std::size_t count = 0;
  if (!start()) return false;
  for (const Layer& from : drawing.layers)
    for (const Stroke& stroke : from.strokes) {
      if (layer.CreateFeature(feature_of(stroke, from, has_colours, layer).get()) != OGRERR_NONE)
        return false;
      if (++count % kStrokesInTransaction == 0 && !(commit() && start())) return false;
    }
  return commit();
}

// Whether all went well, up to and including the closing.
bool write(const char* driver_name, const std::string& path, const Drawing& drawing,
           const CPLStringList& layer_options, const OgrMessages& messages) {
  GDALAllRegister();
  GDALDriver* const driver = GetGDALDriverManager()->GetDriverByName(driver_name);
  if (driver == nullptr)
    throw Error(fmt::format("GDAL has no {} here", driver_name), "a GDAL that has it",
                ErrorCode::output);
  Dataset dataset(driver->Create(path.c_str(), 0, 0, 0, GDT_Unknown, nullptr));
  if (!dataset) return false;
  OGRLayer* const layer = add_layer(*dataset, drawing, layer_options);
  if (layer == nullptr || !add_strokes(*dataset, drawing, *layer)) return false;
  dataset.reset();
  return !messages.has_failure();
}

void set_text(CPLStringList& options, const char* name, const std::string& text) {
  if (!text.empty()) options.SetNameValue(name, clean_utf8(text).c_str());
}

// The nearest of the line weights that DXF knows, in 1/100 mm.
int dxf_weight(double width_mm) {
  constexpr int weights[] = {5,  9,  13, 15, 18,  20,  25,  30,  35,  40,  50, 53,
                             60, 70, 80, 90, 100, 106, 120, 140, 158, 200, 211};
  return *std::ranges::min_element(weights, {},
                                   [&](int weight) { return std::abs(weight - 100 * width_mm); });
}

// As CAD has them: Y up, a layer, a colour and a weight for each line.
std::unique_ptr<OGRFeature> polyline_of(const Stroke& stroke, const Layer& from, double height_mm,
                                        OGRLayer& to) {
  auto feature = std::make_unique<OGRFeature>(to.GetLayerDefn());
  feature->SetField("Layer", clean_utf8(from.name).c_str());
  const double width_mm = stroke.width_mm > 0 ? stroke.width_mm : from.pen_width_mm;
  feature->SetStyleString(
      fmt::format("PEN(c:{},w:{:.2f}g)", hex_colour(from), 0.01 * dxf_weight(width_mm)).c_str());
  auto line = std::make_unique<OGRLineString>();
  const std::span<const Vec2> points = from.points(stroke);
  line->setNumPoints(static_cast<int>(points.size()), FALSE);
  for (std::size_t i = 0; i < points.size(); ++i)
    line->setPoint(static_cast<int>(i), points[i].x, rounded_to_page_step(height_mm - points[i].y));
  feature->SetGeometryDirectly(line.release());
  return feature;
}

bool write_polylines(const std::string& path, const Drawing& drawing) {
  GDALAllRegister();
  GDALDriver* const driver = GetGDALDriverManager()->GetDriverByName("DXF");
  if (driver == nullptr)
    throw Error("GDAL has no DXF here", "a GDAL that has it", ErrorCode::output);
  Dataset dataset(driver->Create(path.c_str(), 0, 0, 0, GDT_Unknown, nullptr));
  OGRLayer* const layer = dataset ? dataset->CreateLayer("entities") : nullptr;
  if (layer == nullptr) return false;
  std::size_t step = 0;
  for (const Layer& from : drawing.layers)
    for (const Stroke& stroke : from.strokes) {
      throw_if_stopped(step++);
      const auto feature = polyline_of(stroke, from, drawing.page.height_mm, *layer);
      if (layer->CreateFeature(feature.get()) != OGRERR_NONE) return false;
    }
  return true;
}

// A file in memory, that goes with it.
class MemoryFile {
public:
  MemoryFile() : path_(fmt::format("/vsimem/orograph-{}.dxf", fmt::ptr(this))) {}
  ~MemoryFile() { VSIUnlink(path_.c_str()); }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;

  const std::string& path() const { return path_; }
  std::string_view text() const {
    vsi_l_offset size = 0;
    const auto* bytes = VSIGetMemFileBuffer(path_.c_str(), &size, FALSE);
    return {reinterpret_cast<const char*>(bytes), bytes == nullptr ? 0 : size};
  }

private:
  std::string path_;
};

bool has_colours(const Drawing& drawing) {
  return std::ranges::any_of(drawing.layers, [](const Layer& layer) {
    const auto ink = layer.ink();
    return ink && !is_grey(*ink);
  });
}

// Up to and including the next of such places; false where there is none.
bool append_up_to(std::string_view place, std::string_view& text, ByteSink& out) {
  const std::size_t found = text.find(place);
  if (found == std::string_view::npos) return false;
  out.append(text.substr(0, found + place.size()));
  text.remove_prefix(found + place.size());
  return true;
}

// With the colours themselves behind the nearest of AutoCAD's table, which is all that GDAL writes.
// Greys have none: black of the table is white on a black screen, and should be.
void append_with_true_colours(std::string_view text, const Drawing& drawing, ByteSink& out) {
  std::size_t step = 0;
  for (const Layer& layer : drawing.layers) {
    const Colour ink = layer.ink().value_or(Colour{});
    const std::string true_colour =
        is_grey(ink) ? "" : fmt::format("420\n{:>9}\n", ink[0] << 16 | ink[1] << 8 | ink[2]);
    for (std::size_t i = 0; i < layer.strokes.size(); ++i) {
      throw_if_stopped(step++);
      // No layer's name, which is free, can hold these lines.
      if (append_up_to("  0\nLWPOLYLINE\n", text, out) && !true_colour.empty() &&
          append_up_to("100\nAcDbPolyline\n", text, out) && append_up_to("\n 62\n", text, out) &&
          append_up_to("\n", text, out))
        out.append(true_colour);
    }
  }
  out.append(text);
}

// GDAL's header says inches.
void append_in_mm(std::string_view text, const Drawing& drawing, ByteSink& out) {
  constexpr std::string_view unit = "$INSUNITS\n 70\n", mm = "     4\n";
  const std::size_t found = text.find(unit);
  if (found != std::string_view::npos) {
    out.append(text.substr(0, found + unit.size()));
    out.append(mm);
    text.remove_prefix(text.find('\n', found + unit.size()) + 1);
  }
  if (has_colours(drawing)) return append_with_true_colours(text, drawing, out);
  out.append(text);
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
  const WritingOptions fixed;
  const OgrMessages messages;
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
  const WritingOptions fixed;
  const OgrMessages messages;
  CPLStringList options;
  set_text(options, "IDENTIFIER", drawing.title);
  set_text(options, "DESCRIPTION", drawing.description);
  ::unlink(path.c_str()); // the driver creates it and nothing else
  if (!write("GPKG", path, drawing, options, messages)) throw gdal_error(name, messages);
}

// GDAL puts a second file beside it and goes back in the first, so it is made in memory.
void write_dxf(const Drawing& drawing, ByteSink& out) {
  const WritingOptions fixed;
  const OgrMessages messages;
  const MemoryFile file;
  if (!write_polylines(file.path(), drawing) || messages.has_failure())
    throw gdal_error(out.name(), messages);
  append_in_mm(file.text(), drawing, out);
}

void prove_geojson(const Drawing& drawing, const std::string& path, const std::string& name) {
  const OgrMessages messages;
  const char* const drivers[] = {"GeoJSON", nullptr};
  const Dataset dataset(GDALDataset::Open(path.c_str(), GDAL_OF_VECTOR, drivers));
  OGRLayer* const layer = dataset ? dataset->GetLayer(0) : nullptr;
  const auto expected = static_cast<GIntBig>(stroke_count(drawing));
  if (layer == nullptr || layer->GetFeatureCount() != expected || messages.has_failure())
    throw gdal_error(name, messages);
}

void prove_geopackage(const Drawing& drawing, const std::string& path, const std::string& name) {
  const WritingOptions fixed;
  const OgrMessages messages;
  const char* const drivers[] = {"GPKG", nullptr};
  const Dataset dataset(GDALDataset::Open(path.c_str(), GDAL_OF_VECTOR, drivers));
  const std::string expected = fmt::format("{}", stroke_count(drawing));
  if (!dataset || first_value(*dataset, "PRAGMA quick_check(1)") != "ok" ||
      first_value(*dataset, "SELECT COUNT(*) FROM strokes") != expected || messages.has_failure())
    throw gdal_error(name, messages);
}

} // namespace orograph
