// SPDX-License-Identifier: GPL-3.0-or-later
// DXF through OGR: the page's polylines, in millimetres.
#include "draw/colour.hpp"
#include "draw/round_drawing.hpp"
#include "geometry/on_all_cores.hpp"
#include "write/format_text.hpp"
#include "write/ogr_writing.hpp"
#include "write/writers.hpp"

#include <cpl_vsi.h>
#include <fmt/format.h>
#include <ogrsf_frmts.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <new>
#include <span>
#include <string>
#include <string_view>

namespace orograph {
namespace {

// The nearest of the line weights that DXF knows, in 1/100 mm.
int dxf_weight(double width_mm) {
  constexpr int weights[] = {5,  9,  13, 15, 18,  20,  25,  30,  35,  40,  50, 53,
                             60, 70, 80, 90, 100, 106, 120, 140, 158, 200, 211};
  return *std::ranges::min_element(weights, {},
                                   [&](int weight) { return std::abs(weight - 100 * width_mm); });
}

// As CAD has them: Y up, a layer, a colour and a weight for each line.
OGRFeatureUniquePtr polyline_of(const Stroke& stroke, const Layer& from, double height_mm,
                                OGRLayer& to) {
  OGRFeatureUniquePtr feature(OGRFeature::CreateFeature(to.GetLayerDefn()));
  if (!feature) throw std::bad_alloc(); // its constructor would leave the fields out
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
  const Dataset dataset = create_dataset("DXF", path);
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
  if (!is_all_grey(drawing)) return append_with_true_colours(text, drawing, out);
  out.append(text);
}

} // namespace

// GDAL puts a second file beside it and goes back in the first, so it is made in memory.
void write_dxf(const Drawing& drawing, ByteSink& out) {
  const OnOneDay day;
  const GdalMessages messages;
  const MemoryFile file;
  if (!write_polylines(file.path(), drawing) || messages.has_failure())
    throw gdal_error(out.name(), messages);
  // Where the end of its template can't be read GDAL goes on without it, and says nothing.
  if (!file.text().ends_with("  0\nEOF\n")) throw gdal_error(out.name(), messages);
  append_in_mm(file.text(), drawing, out);
}

} // namespace orograph
