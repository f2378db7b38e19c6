// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/report/closing_lines.hpp"

#include "cli/finish_drawing.hpp"
#include "cli/report/pen_time.hpp"
#include "draw/drawing.hpp"
#include "geometry/angle.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace orograph {
namespace {

std::string grouped(std::uint64_t count) {
  std::string digits = std::to_string(count);
  for (std::size_t at = digits.size(); at > 3; at -= 3) digits.insert(at - 3, ",");
  return digits;
}

// "from 180/25 in perspective", which --view-from and --projection would take.
std::string view_in_words(const PlacedView& placed, const ViewSpec& asked) {
  if (asked.file) return "by " + asked.file_name;
  const View& view = placed.view;
  const auto azimuth = [](Vec2 towards) {
    const double deg = std::round(10 * atan2_angle(towards.x, towards.y).in_degrees()) / 10;
    return deg < 0 ? deg + 360 : deg;
  };
  if (placed.panorama)
    return fmt::format("{} panorama of {:.6g} degrees",
                       asked.projection == Projection::cylindrical ? "cylindrical"
                                                                   : "equirectangular",
                       placed.panorama->width_deg);
  if (asked.has_eye()) return fmt::format("from the eye towards azimuth {}", azimuth(view.forward));
  const double from_azimuth = azimuth(-1.0 * view.forward);
  const Angle elevation = placed.chosen_view      ? placed.chosen_view->elevation
                          : view.is_perspective() ? asked.from_elevation
                                                  : view.elevation;
  const std::string from = fmt::format("from {}/{:.3g}", from_azimuth, elevation.in_degrees());
  switch (view.projection) {
  case Projection::perspective:
    return from + " in perspective";
  case Projection::orthographic:
    return from + ", orthographic";
  case Projection::oblique:
    return fmt::format("from azimuth {}, oblique", from_azimuth);
  case Projection::cylindrical: // whose view is one in perspective
  case Projection::equirectangular:
    break;
  }
  return from;
}

std::string heights_in_words(const PlacedView& placed) {
  if (placed.exaggeration == 1) return "true heights";
  return fmt::format("heights {} times{}", placed.exaggeration,
                     placed.exaggeration_chosen ? " (--exaggeration 1 draws them true)" : "");
}

// Straight down in a parallel picture heights move nothing: profiles are straight lines.
std::optional<std::string> of_plan(const PlacedView& placed, const MapSpec& spec) {
  const bool is_plan = !placed.view.is_perspective() && placed.view.y_per_z == 0;
  if (!is_plan || placed.depths_m.empty() || !spec.style.asks_for("profiles")) return std::nullopt;
  const char* what =
      spec.ground_points ? ": --view-from with less than 90 shows relief, and --contours do"
      : spec.style.light
          ? ", and only light on them (--light) and contours (--contours) show relief"
          : ": --light shows relief by their widths, --view-from with "
            "less than 90 by their shapes, --contours without them";
  return fmt::format("from straight {} profiles are straight lines{}",
                     placed.view.y_per_v < 0 ? "below" : "above", what);
}

} // namespace

std::vector<std::string> closing_lines(const Map& map, std::span<const Drawing> sheets,
                                       const PlacedView& placed, const RenderSettings& settings,
                                       double seconds) {
  const PenWork work = pen_work(sheets.empty() ? std::span(&map.drawing, 1) : sheets, settings);
  const auto known = sum_of(work.minutes);
  const std::string minutes =
      known ? fmt::format(", {:.0f} minutes for the pen", std::ceil(*known)) : "";
  const std::vector<std::string> names = output_names(settings);
  const std::string written = settings.output == "-" ? "standard output"
                              : names.size() <= 2 // a single sheet has an overview too
                                  ? names.front()
                                  : fmt::format("{} to {}", names.front(), names[names.size() - 2]);
  std::vector<std::string> lines;
  if (auto plan = of_plan(placed, settings.map)) lines.push_back(std::move(*plan));
  lines.push_back(
      fmt::format("{}: {} {}, {:.1f} m of ink{}, {}, {}, {:.1f} s", written, grouped(work.strokes),
                  work.strokes == 1 ? "stroke" : "strokes", 1e-3 * work.travel().down_mm, minutes,
                  view_in_words(placed, settings.map.view), heights_in_words(placed), seconds));
  return lines;
}

} // namespace orograph
