// SPDX-License-Identifier: GPL-3.0-or-later
#include "placing/furniture_room.hpp"

#include <algorithm>

namespace orograph {
namespace {

double height_mm(const std::vector<FurnitureRow>& rows) {
  double sum = 0;
  for (const FurnitureRow& row : rows) sum += row.height_mm;
  return sum;
}

bool has_eye(const MapSpec& spec) {
  return spec.view.has_eye();
}

// Seen from afar, as a whole.
bool is_framed(const MapSpec& spec) {
  return !has_eye(spec) && !spec.view.file;
}

} // namespace

std::vector<FurnitureRow> rows_above(const MapSpec& spec) {
  const FurnitureSpec& furniture = spec.furniture;
  std::vector<FurnitureRow> rows;
  if (furniture.has(Furniture::title) && !spec.title.empty())
    rows.push_back({Furniture::title, kRowOfEm * furniture.title_mm});
  if (furniture.has(Furniture::subtitle) && !furniture.subtitle.empty())
    rows.push_back({Furniture::subtitle, kRowOfEm * furniture.subtitle_mm});
  return rows;
}

std::vector<FurnitureRow> rows_beneath(const MapSpec& spec) {
  const FurnitureSpec& furniture = spec.furniture;
  const double row_mm = kRowOfEm * furniture.text_mm;
  std::vector<FurnitureRow> rows;
  if (furniture.has(Furniture::scale)) {
    const bool has_bar = !spec.view.file && spec.view.projection != Projection::perspective;
    rows.push_back({Furniture::scale, has_bar ? row_mm + kTick_mm + 2 * kTickGap_mm : row_mm});
  }
  if (furniture.has(Furniture::viewpoint) && has_eye(spec))
    rows.push_back({Furniture::viewpoint, row_mm});
  if (furniture.has(Furniture::caption)) rows.push_back({Furniture::caption, row_mm});
  if (furniture.has(Furniture::source) && !(furniture.source.empty() && furniture.date.empty()))
    rows.push_back({Furniture::source, row_mm});
  return rows;
}

double neatline_gap_mm(const MapSpec& spec) {
  return spec.furniture.has(Furniture::neatline) && is_framed(spec) ? kNeatline_mm : 0;
}

PageRequest page_with_room(const MapSpec& spec) {
  const FurnitureSpec& furniture = spec.furniture;
  PageRequest page = spec.page;
  if (!furniture.any() || spec.ground_points) return page;
  const double pad_mm = neatline_gap_mm(spec);
  const double above_mm = height_mm(rows_above(spec)),
               beneath_mm = std::max(height_mm(rows_beneath(spec)),
                                     furniture.has(Furniture::north) ? kNorth_mm : 0);
  Sides& room = page.room_mm;
  room = {room.left + pad_mm, room.top + pad_mm + (above_mm > 0 ? above_mm + furniture.gap_mm : 0),
          room.right + pad_mm,
          room.bottom + pad_mm + (beneath_mm > 0 ? beneath_mm + furniture.gap_mm : 0)};
  Sides& strip = page.strip_room_mm;
  if (furniture.has(Furniture::azimuths)) { // degrees, and directions beneath them
    strip.bottom += kTick_mm + kTickGap_mm + 2 * kRowOfEm * furniture.text_mm;
    strip.right += 0.5 * kAzimuthOfEm * furniture.text_mm;
  }
  if (furniture.has(Furniture::altitudes)) {
    strip.left += 2 * (kTick_mm + kTickGap_mm) + (kAltitudeOfEm + kDipOfEm) * furniture.text_mm;
    // The lowest and the highest text reach beyond the strip by half of their height.
    strip.top += 0.5 * kRowOfEm * furniture.text_mm;
    if (!furniture.has(Furniture::azimuths)) strip.bottom += 0.5 * kRowOfEm * furniture.text_mm;
  }
  return page;
}

} // namespace orograph
