// SPDX-License-Identifier: GPL-3.0-or-later
#include "map/panorama_scales.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <initializer_list>
#include <string>

namespace orograph {
namespace {

constexpr double kLeastBetweenTicks_mm = 0.8;

constexpr std::array<const char*, 16> kDirections{"N", "NNE", "NE", "ENE", "E", "ESE", "SE", "SSE",
                                                  "S", "SSW", "SW", "WSW", "W", "WNW", "NW", "NNW"};

double radians(double deg) {
  return Angle::degrees(deg).in_radians();
}

// The first step that is `least_mm` wide, or the last.
double step_of(std::initializer_list<double> steps_deg, double mm_per_deg, double least_mm) {
  for (const double step : steps_deg)
    if (step * mm_per_deg >= least_mm) return step;
  return *(steps_deg.end() - 1);
}

bool divides(double step, double deg) {
  return std::abs(std::remainder(deg, step)) < 1e-9;
}

double tick_mm(double deg) {
  return (divides(30, deg) || divides(45, deg) ? 1.0
          : divides(10, deg)                   ? 0.75
          : divides(5, deg)                    ? 0.55
                                               : 0.35) *
         kTick_mm;
}

double in_turn(double deg) {
  const double rest = std::fmod(deg, 360);
  return (rest < 0 ? rest + 360 : rest) + 0.0; // no -0
}

// Where it has room between the page's margins.
void add_within(FurniturePen& pen, PageText text, const Box2& inner_mm) {
  text = pen.set(std::move(text));
  const Box2 box = text.box_mm();
  if (box.low.x >= inner_mm.low.x && box.high.x <= inner_mm.high.x) pen.add(std::move(text));
}

} // namespace

std::optional<double> dip_deg(double eye_height_m, double radius_m, double refraction) {
  const double square = 2 * eye_height_m * (1 - refraction) / radius_m;
  if (!(square > 0)) return std::nullopt;
  return atan2_angle(std::sqrt(square), 1).in_degrees();
}

void draw_azimuths(FurniturePen& pen, const Panorama& panorama, double from_deg, double text_mm,
                   const Box2& inner_mm, bool has_line) {
  const double mm_per_deg = panorama.page.radius_mm * radians(1);
  const double tick_deg = step_of({1, 5, 10, 30}, mm_per_deg, kLeastBetweenTicks_mm);
  const double figure_deg = step_of({1, 5, 10, 30, 90}, mm_per_deg, 3.6 * text_mm);
  const double name_deg = step_of({22.5, 45, 90}, mm_per_deg, 4.5 * text_mm);
  const std::vector<Box2> strips = panorama.strip_boxes_mm();
  const double width_deg = panorama.width_deg / static_cast<double>(strips.size());
  for (std::size_t i = 0; i < strips.size(); ++i) {
    const Box2& strip = strips[i];
    const double left_deg = from_deg + width_deg * static_cast<double>(i);
    const auto x_mm = [&](double deg) { return strip.low.x + (deg - left_deg) * mm_per_deg; };
    const double y = strip.high.y;
    if (has_line) pen.line({{strip.low.x, y}, {strip.high.x, y}});
    constexpr double kRounding_deg = 1e-6;
    const auto each = [&](double step_deg, auto draw) {
      for (double k = std::ceil((left_deg - kRounding_deg) / step_deg);
           k * step_deg <= left_deg + width_deg + kRounding_deg; ++k)
        draw(k * step_deg);
    };
    each(tick_deg, [&](double deg) { pen.line({{x_mm(deg), y}, {x_mm(deg), y + tick_mm(deg)}}); });
    const double figures_mm = y + kTick_mm + kTickGap_mm + kBaselineOfEm * text_mm;
    each(figure_deg, [&](double deg) {
      add_within(pen,
                 {.text = fmt::format("{:.0f}°", in_turn(std::round(deg))),
                  .at_mm = {x_mm(deg), figures_mm},
                  .size_mm = text_mm,
                  .anchor = TextAnchor::middle},
                 inner_mm);
    });
    each(name_deg, [&](double deg) {
      const auto direction = static_cast<std::size_t>(std::lround(in_turn(deg) / 22.5)) % 16;
      add_within(pen,
                 {.text = kDirections[direction],
                  .at_mm = {x_mm(deg), figures_mm + kRowOfEm * text_mm},
                  .size_mm = text_mm,
                  .anchor = TextAnchor::middle,
                  .is_bold = true},
                 inner_mm);
    });
    pen.tell("azimuths", {{strip.low.x, y},
                          {strip.high.x, y + kTick_mm + kTickGap_mm + 2 * kRowOfEm * text_mm}});
  }
}

void draw_altitudes(FurniturePen& pen, const Panorama& panorama, std::optional<double> dip,
                    double text_mm, bool has_line) {
  const PanoramaPage& page = panorama.page;
  const double mm_per_deg = page.radius_mm * radians(1);
  const double tick_deg = step_of({1, 5, 10, 30}, mm_per_deg, kLeastBetweenTicks_mm);
  const double figure_deg = step_of({1, 5, 10, 30}, mm_per_deg, 1.6 * text_mm);
  const double middle_mm = 0.36 * text_mm; // half of a figure's height
  for (const Box2& strip : panorama.strip_boxes_mm()) {
    const double shift_mm = strip.low.y - panorama.frame_mm.low.y;
    const auto y_mm = [&](double deg) { return shift_mm + page.y_mm(tan(Angle::degrees(deg))); };
    const double low_deg = panorama.altitude_deg(panorama.low_tangent),
                 high_deg = panorama.altitude_deg(panorama.high_tangent), x = strip.low.x;
    if (has_line) pen.line({strip.low, {x, strip.high.y}});
    for (double k = std::ceil(low_deg / tick_deg); k * tick_deg <= high_deg; ++k) {
      const double deg = k * tick_deg, y = y_mm(deg);
      pen.line({{x, y}, {x - tick_mm(deg), y}});
      if (!divides(figure_deg, deg)) continue;
      pen.add(pen.set_within({.text = fmt::format("{}{:.0f}°", deg < 0 ? "−" : "", std::abs(deg)),
                              .at_mm = {x - kTick_mm - kTickGap_mm, y + middle_mm},
                              .size_mm = text_mm,
                              .anchor = TextAnchor::end},
                             kAltitudeOfEm * text_mm));
    }
    double left_mm = x - kTick_mm - kTickGap_mm - kAltitudeOfEm * text_mm;
    if (dip && -*dip >= low_deg && -*dip <= high_deg) {
      // Beside the figures, which a mark on the scale itself would meet.
      const double y = y_mm(-*dip), mark_mm = left_mm - kTick_mm;
      pen.line({{mark_mm, y}, {mark_mm + 0.75 * kTick_mm, y}});
      pen.add(pen.set_within({.text = fmt::format("dip {:.1f}°", *dip),
                              .at_mm = {mark_mm - kTickGap_mm, y + middle_mm},
                              .size_mm = text_mm,
                              .anchor = TextAnchor::end},
                             kDipOfEm * text_mm));
      left_mm = mark_mm - kTickGap_mm - kDipOfEm * text_mm;
    }
    pen.tell("altitudes", {{left_mm, strip.low.y}, {x, strip.high.y}});
  }
}

} // namespace orograph
