// SPDX-License-Identifier: GPL-3.0-or-later
// Paper sizes, and the picture's place on the paper.
#include "draw/page.hpp"

#include "geometry/error.hpp"
#include "text/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

namespace orograph {
namespace {

constexpr double kLargestSide_mm = 10000; // twice what PDF viewers show
constexpr double kSmallestInner_mm = 1;

// ISO 216 and ANSI/ASME Y14.1.
constexpr std::array<std::pair<std::string_view, Vec2>, 17> kPapers{{
    {"a0", {841, 1189}},
    {"a1", {594, 841}},
    {"a2", {420, 594}},
    {"a3", {297, 420}},
    {"a4", {210, 297}},
    {"a5", {148, 210}},
    {"a6", {105, 148}},
    {"b0", {1000, 1414}},
    {"b1", {707, 1000}},
    {"b2", {500, 707}},
    {"b3", {353, 500}},
    {"b4", {250, 353}},
    {"b5", {176, 250}},
    {"b6", {125, 176}},
    {"letter", {215.9, 279.4}},
    {"legal", {215.9, 355.6}},
    {"tabloid", {279.4, 431.8}},
}};

constexpr double kMmPerMetre = 1000;
constexpr double kRounding = 1e-9; // of a size that was made to measure

Box2 room_mm(const Page& page, const PageRequest& request) {
  Box2 room = page.inner_mm();
  room.low = room.low + Vec2{request.room_mm.left, request.room_mm.top};
  room.high = room.high - Vec2{request.room_mm.right, request.room_mm.bottom};
  return room;
}

// What has no length fits at any scale.
double fitting_scale(double room_mm, double length) {
  const double scale = room_mm / length;
  return std::isfinite(scale) ? scale : std::numeric_limits<double>::infinity();
}

// Largest scale (mm for a unit of the picture plane) at which the window fits inside.
double fitting_scale(const Box2& window, const Box2& inner) {
  const double scale = std::min(fitting_scale(inner.width(), window.width()),
                                fitting_scale(inner.height(), window.height()));
  return std::isfinite(scale) ? scale : 1;
}

// Written so that a NaN fails.
bool leaves_room(double side_mm, double margin_mm) {
  return margin_mm >= 0 && side_mm - 2 * margin_mm >= kSmallestInner_mm;
}

std::string size_text(const PageRequest& request) {
  return request.height_mm ? fmt::format("{} x {} mm", request.width_mm, *request.height_mm)
                           : fmt::format("{} mm by its picture's height", request.width_mm);
}

void check(const PageRequest& request) {
  const double height_mm = request.height_mm.value_or(request.width_mm);
  if (!leaves_room(request.width_mm, request.margin_mm) ||
      !leaves_room(height_mm, request.margin_mm))
    throw UsageError(fmt::format("margins of {} mm leave no room on a page of {}",
                                 request.margin_mm, size_text(request)),
                     "margins from 0 up to what leaves 1 mm each way");
  const Sides& room = request.room_mm;
  const bool is_narrow = !leaves_room(request.width_mm - room.left - room.right, request.margin_mm),
             is_low =
                 !leaves_room(request.height_mm.value_or(kLargestSide_mm) - room.top - room.bottom,
                              request.margin_mm);
  if (is_narrow || is_low)
    throw UsageError(fmt::format("what stands around the picture needs {:.0f} x {:.0f} mm and "
                                 "leaves no room on a page of {}",
                                 room.left + room.right, room.top + room.bottom,
                                 size_text(request)),
                     "a larger `page`, smaller letters, or less `furniture`");
  if (std::max(request.width_mm, height_mm) > kLargestSide_mm)
    throw UsageError(fmt::format("a page of {} is too large", size_text(request)),
                     fmt::format("sides of at most {} mm", kLargestSide_mm));
}

Page oriented_page(const Box2& window, const PageRequest& request) {
  if (!request.height_mm) return {request.width_mm, kLargestSide_mm, request.margin_mm};
  const Page given{request.width_mm, *request.height_mm, request.margin_mm};
  const Page turned{*request.height_mm, request.width_mm, request.margin_mm};
  const bool given_is_upright = given.width_mm <= given.height_mm;
  switch (request.orientation) {
  case Orientation::as_given:
    return given;
  case Orientation::portrait:
    return given_is_upright ? given : turned;
  case Orientation::landscape:
    return given_is_upright ? turned : given;
  case Orientation::by_picture:
    break;
  }
  return fitting_scale(window, room_mm(turned, request)) >
                 fitting_scale(window, room_mm(given, request))
             ? turned
             : given;
}

// The next larger with two digits that aren't zeros.
double rounded_up(double scale) {
  const double step = std::pow(10, std::floor(std::log10(scale)) - 1);
  return step * std::ceil(scale / step);
}

// mm for a metre at the scale asked for.
double scale_as_asked(const Box2& window, const Page& page, const PageRequest& request) {
  const Box2 inner = room_mm(page, request);
  const double fitting = fitting_scale(window, inner), scale = kMmPerMetre / *request.scale;
  if (scale <= fitting * (1 + kRounding)) return scale;
  const double width_mm = scale * window.width(), height_mm = scale * window.height();
  const Sides& room = request.room_mm;
  const double page_width_mm = std::ceil(width_mm + 2 * page.margin_mm + room.left + room.right),
               page_height_mm = std::ceil(height_mm + 2 * page.margin_mm + room.top + room.bottom);
  std::string right =
      fmt::format("give `scale` 1:{:.0f} or smaller", rounded_up(kMmPerMetre / fitting));
  if (std::max(page_width_mm, page_height_mm) <= kLargestSide_mm)
    right += fmt::format(", or a `page` of {}x{}", page_width_mm, page_height_mm);
  throw UsageError(
      fmt::format("at 1:{} the picture is {:.0f} x {:.0f} mm, and the page has room for {:.0f} x "
                  "{:.0f} mm",
                  *request.scale, width_mm, height_mm, inner.width(), inner.height()),
      right);
}

// As large as the picture and its margins.
void end_with_picture(Page& page, const Box2& window, double scale, const PageRequest& request) {
  const Sides& room = request.room_mm;
  const double height_mm = 2 * page.margin_mm + (room.top + room.bottom) +
                           std::max(scale * window.height(), kSmallestInner_mm);
  page.height_mm = std::min(page.height_mm, height_mm);
  if (!request.crop) return;
  const double width_mm = 2 * page.margin_mm + (room.left + room.right) +
                          std::max(scale * window.width(), kSmallestInner_mm);
  page.width_mm = std::min(page.width_mm, width_mm);
}

} // namespace

std::optional<Vec2> paper_size_mm(std::string_view name) {
  const std::string lower = in_lower_case(name);
  const auto* const paper =
      std::ranges::find(kPapers, lower, &std::pair<std::string_view, Vec2>::first);
  if (paper == kPapers.end()) return {};
  return paper->second;
}

const std::vector<std::string>& paper_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    for (const auto& [name, size_mm] : kPapers) all.emplace_back(name);
    return all;
  }();
  return names;
}

Placement place_on_page(const Box2& window, const PageRequest& request) {
  check(request);
  Page page = oriented_page(window, request);
  const double scale = request.scale ? scale_as_asked(window, page, request)
                                     : fitting_scale(window, room_mm(page, request));
  const double wide_mm = scale * window.width();
  if (!request.height_mm && !request.scale && wide_mm > 0 &&
      wide_mm < (1 - kRounding) * room_mm(page, request).width())
    throw UsageError(fmt::format("a page {} mm wide would be over {} mm high for this picture",
                                 request.width_mm, kLargestSide_mm),
                     "a narrower page, or one with a height");
  if (request.ends_with_picture()) end_with_picture(page, window, scale, request);
  const Vec2 centre = window.centre();
  const Sides& room = request.room_mm;
  const Vec2 middle_mm{page.width_mm / 2 + 0.5 * (room.left - room.right),
                       page.height_mm / 2 + 0.5 * (room.top - room.bottom)};
  return {page,
          room_mm(page, request),
          {{scale, 0, middle_mm.x - scale * centre.x,  //
            0, -scale, middle_mm.y + scale * centre.y, //
            0, 0, 1}}};
}

} // namespace orograph
