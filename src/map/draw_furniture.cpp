// SPDX-License-Identifier: GPL-3.0-or-later
#include "map/draw_furniture.hpp"

#include "map/describe_map.hpp"
#include "map/furniture_words.hpp"
#include "map/layer_table.hpp"
#include "map/map_scale.hpp"
#include "map/panorama_scales.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace orograph {
namespace {

// Texts run no wider than their picture, which may be narrow where it is drawn to scale: then they
// have this, if the page has.
constexpr double kLeastColumn_mm = 120;

// Across the page, around the picture's middle.
Box2 column_of(const Box2& picture, const Box2& inner) {
  const double width_mm = std::min(inner.width(), std::max(picture.width(), kLeastColumn_mm));
  const double low = std::clamp(picture.centre().x - 0.5 * width_mm, inner.low.x,
                                std::max(inner.low.x, inner.high.x - width_mm));
  if (width_mm <= picture.width()) return {{picture.low.x, 0}, {picture.high.x, 0}};
  return {{low, 0}, {low + width_mm, 0}};
}

// The picture with its neatline, or a panorama's strips with their scales.
Box2 whole_picture(const PlacedView& placed, const MapSpec& spec) {
  if (!placed.panorama) {
    const double pad_mm = neatline_gap_mm(spec);
    const Sides& room = spec.page.room_mm; // of what is printed along the picture's border
    return {placed.frame_mm.low - Vec2{room.left + pad_mm, room.top + pad_mm},
            placed.frame_mm.high + Vec2{room.right + pad_mm, room.bottom + pad_mm}};
  }
  const Sides strip = page_with_room(spec).strip_room_mm;
  const Box2 strips = placed.panorama->strips_mm();
  return {strips.low - Vec2{strip.left, strip.top}, strips.high + Vec2{strip.right, strip.bottom}};
}

class AroundPicture {
public:
  AroundPicture(FurniturePen& pen, const TerrainData& terrain, const PlacedView& placed,
                const MapSpec& spec)
      : pen_(pen), placed_(placed), spec_(spec), facts_(describe_view(placed, terrain, spec)),
        height_unit_m_(terrain.map.height_unit_m), picture_(whole_picture(placed, spec)),
        column_(column_of(picture_, placed.page.inner_mm())) {}

  void draw() {
    draw_window();
    draw_above();
    draw_beneath();
    if (placed_.panorama) draw_scales(*placed_.panorama);
  }

private:
  const FurnitureSpec& furniture() const { return spec_.furniture; }

  void draw_window() {
    std::vector<Box2> windows{placed_.frame_mm};
    if (placed_.panorama) windows = placed_.panorama->strip_boxes_mm();
    for (const Box2& window : windows) pen_.tell("window", window);
    if (!furniture().has(Furniture::neatline)) return;
    // Around a terrain that is shown whole, and its labels; else along the picture's own border.
    if (!placed_.panorama && neatline_gap_mm(spec_) > 0) windows = {picture_};
    if (placed_.panorama) // around names too, which stand above strips
      for (Box2& strip : windows) {
        const Sides& room = spec_.page.strip_room_mm;
        strip = {strip.low - Vec2{room.left, room.top}, strip.high + Vec2{room.right, room.bottom}};
      }
    for (const auto& [low, high] : windows)
      pen_.line({low, {high.x, low.y}, high, {low.x, high.y}, low});
  }

  void draw_above() {
    const std::vector<FurnitureRow> rows = rows_above(spec_);
    double y = picture_.low.y - furniture().gap_mm;
    for (const FurnitureRow& row : rows) y -= row.height_mm;
    for (const FurnitureRow& row : rows) {
      const bool is_title = row.piece == Furniture::title;
      tell(is_title ? "title" : "subtitle",
           pen_.row(is_title ? spec_.title : furniture().subtitle,
                    is_title ? furniture().title_mm : furniture().subtitle_mm, {column_.low.x, y},
                    column_.width(), is_title));
      y += row.height_mm;
    }
  }

  void draw_beneath() {
    const auto level = placed_.panorama ? std::nullopt : level_at_middle(placed_);
    const double text_mm = furniture().text_mm;
    Vec2 at{column_.low.x, picture_.high.y + furniture().gap_mm};
    double room_mm = column_.width();
    if (furniture().has(Furniture::north)) {
      const bool has_room = room_mm > 2 * kNorth_mm;
      if (has_room) room_mm -= kNorth_mm + furniture().gap_mm;
      const Vec2 corner{column_.high.x - kNorth_mm, at.y};
      if (has_room && level &&
          draw_north(pen_, placed_, level->at, north_deg(), text_mm, corner, kNorth_mm))
        pen_.tell("north", {corner, corner + Vec2{kNorth_mm, kNorth_mm}});
      else
        pen_.leave_out("north");
    }
    for (const FurnitureRow& row : rows_beneath(spec_)) {
      draw_row(row.piece, level, at, room_mm);
      at.y += row.height_mm;
    }
  }

  void draw_row(Furniture piece, const std::optional<LevelAtMiddle>& level, Vec2 at,
                double room_mm) {
    const double text_mm = furniture().text_mm;
    const auto write = [&](const char* name, std::string text) {
      tell(name, pen_.row(std::move(text), text_mm, at, room_mm));
    };
    switch (piece) {
    case Furniture::scale: {
      if (!level) return pen_.leave_out("scale");
      const double mm_per_m = placed_.mm_per_step(level->at, {1, 0, 0});
      if (!placed_.view.is_perspective() && !spec_.view.file)
        tell("scale", draw_scale_bar(pen_, mm_per_m, text_mm, at, room_mm));
      else
        write("scale", fmt::format("1:{} {}", scale_number(1000 / mm_per_m),
                                   !placed_.view.is_perspective() ? "across the view"
                                   : level->is_in_middle ? "across the view in the picture’s middle"
                                                         : "across the view in the foreground"));
      return;
    }
    case Furniture::viewpoint:
      return write("viewpoint", viewpoint_words(facts_, height_unit_m_));
    case Furniture::caption:
      return write("caption", caption_words(placed_, facts_, spec_.view));
    case Furniture::source:
      return write("source", source_words(furniture()));
    default:
      return;
    }
  }

  void draw_scales(const Panorama& panorama) {
    const bool has_line = !furniture().has(Furniture::neatline);
    const double text_mm = furniture().text_mm;
    if (furniture().has(Furniture::azimuths))
      draw_azimuths(pen_, panorama, facts_.panorama->azimuth_from_deg, text_mm,
                    placed_.page.inner_mm(), has_line);
    if (!furniture().has(Furniture::altitudes)) return;
    std::optional<double> dip;
    if (placed_.curvature.applied && facts_.eye)
      dip = dip_deg(
          facts_.eye->z * height_unit_m_,
          std::sqrt(placed_.curvature.radii.meridian_m * placed_.curvature.radii.prime_vertical_m),
          placed_.curvature.refraction);
    draw_altitudes(pen_, panorama, dip, text_mm, has_line);
  }

  // In the frame; of a terrain without a place on the earth its map's own.
  double north_deg() const {
    return std::isnan(facts_.look_azimuth_true_deg)
               ? 0
               : facts_.look_azimuth_deg - facts_.look_azimuth_true_deg;
  }
  void tell(const char* piece, const Box2& box) {
    if (box.width() > 0)
      pen_.tell(piece, box);
    else
      pen_.leave_out(piece);
  }

  FurniturePen& pen_;
  const PlacedView& placed_;
  const MapSpec& spec_;
  ViewFacts facts_;
  double height_unit_m_;
  Box2 picture_, column_;
};

} // namespace

Layer draw_furniture(const TerrainData& terrain, const PlacedView& placed, const MapSpec& spec,
                     Lettering& lettering, std::vector<FurnitureFacts>& facts) {
  Layer layer = layer_of_lettering("furniture", spec.style);
  FurniturePen pen(layer, lettering, facts);
  AroundPicture(pen, terrain, placed, spec).draw();
  return layer;
}

} // namespace orograph
