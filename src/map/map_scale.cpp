// SPDX-License-Identifier: GPL-3.0-or-later
#include "map/map_scale.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace orograph {
namespace {

constexpr double kLongestBar_mm = 60, kShareOfRow = 0.6;

// The point of a level plane that is drawn at a place of the page. Places are linear in u and v
// times their last coordinate.
std::optional<ProfilePoint> on_level(const PlacedView& placed, double z_m, Vec2 page_mm) {
  const Vec3 origin = placed.on_page({0, 0, z_m}), of_u = placed.on_page({1, 0, z_m}) - origin,
             of_v = placed.on_page({0, 1, z_m}) - origin;
  const auto offset = [&](Vec3 h) { return Vec2{h.x - page_mm.x * h.z, h.y - page_mm.y * h.z}; };
  const Vec2 a = offset(of_u), b = offset(of_v), c = offset(origin);
  const double determinant = a.x * b.y - a.y * b.x;
  if (determinant == 0) return std::nullopt;
  const ProfilePoint at{(b.x * c.y - b.y * c.x) / determinant,
                        (a.y * c.x - a.x * c.y) / determinant, z_m};
  const Vec3 image = placed.on_page(at);
  if (!(image.z > 0) || !std::isfinite(at.u) || !std::isfinite(at.v)) return std::nullopt;
  const double reach_m = 2 * std::max(std::abs(placed.farthest_m), std::abs(placed.nearest_m));
  if (std::hypot(at.u, at.v) > reach_m && placed.view.is_perspective()) return std::nullopt;
  return at;
}

// How the page changes along a horizontal step of a metre.
Vec2 mm_along(const PlacedView& placed, ProfilePoint at, Vec2 ground) {
  const View& view = placed.view;
  const double u = dot(ground, view.right), v = dot(ground, view.forward);
  const Vec3 here = placed.on_page(at), moved = placed.on_page({at.u + u, at.v + v, at.z}) - here;
  return {(moved.x - here.x / here.z * moved.z) / here.z,
          (moved.y - here.y / here.z * moved.z) / here.z};
}

// The largest of 1, 2 and 5 times a power of ten that isn't above.
double round_below(double value) {
  const double power = std::pow(10, std::floor(std::log10(value)));
  for (const double digit : {5.0, 2.0})
    if (digit * power <= value) return digit * power;
  return power;
}

} // namespace

std::optional<LevelAtMiddle> level_at_middle(const PlacedView& placed) {
  const double z_m = placed.extent.mean_height_m * placed.view.exaggeration;
  const Box2& frame = placed.frame_mm;
  for (const double share : {0.5, 0.6, 0.7, 0.8, 0.9}) {
    const Vec2 page_mm{frame.centre().x, frame.low.y + share * frame.height()};
    if (const auto at = on_level(placed, z_m, page_mm)) return LevelAtMiddle{*at, share == 0.5};
  }
  return std::nullopt;
}

std::string scale_number(double number) {
  const double step = std::pow(10, std::floor(std::log10(number)) - 2);
  std::string digits = fmt::format("{:.0f}", std::round(number / step) * step);
  for (std::size_t at = digits.size(); at > 3; at -= 3) digits.insert(at - 3, "\u00a0");
  return digits;
}

Box2 draw_scale_bar(FurniturePen& pen, double mm_per_m, double text_mm, Vec2 upper_left_mm,
                    double most_mm) {
  const double longest_mm = std::min(kLongestBar_mm, kShareOfRow * most_mm);
  const double length_m = round_below(longest_mm / mm_per_m), length_mm = length_m * mm_per_m;
  const bool in_km = length_m >= 2000;
  const double row_mm = kRowOfEm * text_mm;
  // The bar stands beneath its figures, the first of which is in the middle over its end.
  const double left_mm = upper_left_mm.x + 0.4 * text_mm;
  const double bar_mm = upper_left_mm.y + row_mm + kTickGap_mm + kTick_mm;
  double right_mm = left_mm + length_mm;
  pen.line({{left_mm, bar_mm}, {right_mm, bar_mm}});
  for (const double share : {0.0, 0.25, 0.5, 0.75, 1.0}) {
    const double x = left_mm + share * length_mm;
    const bool is_marked = share == 0 || share == 0.5 || share == 1;
    pen.line({{x, bar_mm}, {x, bar_mm - (is_marked ? 0.8 : 0.45) * kTick_mm}});
    if (!is_marked) continue;
    const std::string figure = fmt::format("{:.10g}", share * length_m / (in_km ? 1000 : 1));
    const double y = upper_left_mm.y + kBaselineOfEm * text_mm;
    PageText text = pen.set(
        {.text = figure, .at_mm = {x, y}, .size_mm = text_mm, .anchor = TextAnchor::middle});
    if (share == 1) { // the unit stands behind the figure
      PageText with = pen.set({.text = figure + (in_km ? " km" : " m"),
                               .at_mm = {x - 0.5 * text.extent.width_mm, y},
                               .size_mm = text_mm});
      right_mm = std::max(right_mm, with.box_mm().high.x);
      text = with;
    }
    pen.add(text);
  }
  const double gap_mm = 2 * text_mm;
  const double rest_mm = upper_left_mm.x + most_mm - right_mm - gap_mm;
  Box2 box{upper_left_mm, {right_mm, bar_mm}};
  if (rest_mm > 8 * text_mm) {
    const Box2 note = pen.row("1:" + scale_number(1000 / mm_per_m), text_mm,
                              {right_mm + gap_mm, upper_left_mm.y}, rest_mm);
    box.include({note.high.x, bar_mm});
  }
  return box;
}

bool draw_north(FurniturePen& pen, const PlacedView& placed, ProfilePoint at, double north_deg,
                double text_mm, Vec2 upper_left_mm, double side_mm) {
  const Vec2 north = direction_of_azimuth(Angle::degrees(north_deg)), east{north.y, -north.x};
  const Vec2 up = mm_along(placed, at, north), across = mm_along(placed, at, east);
  constexpr double kThinnest = 0.03; // of its width: a line
  if (std::abs(up.x * across.y - up.y * across.x) < kThinnest * dot(across, across)) return false;
  constexpr std::array<Vec2, 4> kNeedle{Vec2{0, 1}, {0.36, -0.85}, {0, -0.5}, {-0.36, -0.85}};
  const auto placed_at = [&](Vec2 p) { return p.x * across + p.y * up; };
  const double em_mm = 1.3 * text_mm, letter_mm = 0.62 * em_mm, gap_mm = 0.9;
  Box2 shape;
  for (const Vec2 p : kNeedle) shape.include(placed_at(p));
  // The letter stands beyond the tip, however that lies.
  const double largest = std::max(shape.width(), shape.height());
  const double scale = (side_mm - 2 * letter_mm - gap_mm) / largest;
  const Vec2 tip = scale * placed_at(kNeedle[0]), tail = scale * placed_at(kNeedle[2]);
  const Vec2 letter = tip + (letter_mm + gap_mm) / length(tip - tail) * (tip - tail);
  Box2 all{scale * shape.low, scale * shape.high};
  all.include(letter - Vec2{letter_mm, letter_mm});
  all.include(letter + Vec2{letter_mm, letter_mm});
  const Vec2 shift = upper_left_mm + 0.5 * Vec2{side_mm, side_mm} - all.centre();
  const auto on_page = [&](Vec2 p) { return shift + scale * placed_at(p); };
  pen.line({on_page(kNeedle[0]), on_page(kNeedle[1]), on_page(kNeedle[2]), on_page(kNeedle[3]),
            on_page(kNeedle[0])});
  pen.line({on_page(kNeedle[0]), on_page(kNeedle[2])});
  PageText n{.text = "N", .at_mm = shift + letter, .size_mm = em_mm, .anchor = TextAnchor::middle};
  n.at_mm.y += 0.36 * em_mm; // half a capital's height
  pen.add(pen.set(n));
  return true;
}

} // namespace orograph
