// SPDX-License-Identifier: GPL-3.0-or-later
// Paper sizes, and the picture's place on the paper.
#include "draw/page.hpp"

#include "geometry/error.hpp"
#include "text/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
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

// Largest scale (mm for a unit of the picture plane) at which the window fits inside.
double fitting_scale(const Box2& window, const Page& page) {
  const Box2 inner = page.inner_mm();
  const double by_width = inner.width() / window.width();
  const double by_height = inner.height() / window.height();
  const double scale = std::min(by_width, by_height);
  return std::isfinite(scale) ? scale : 1; // a window that is one point
}

// Written so that a NaN fails.
bool leaves_room(double side_mm, double margin_mm) {
  return margin_mm >= 0 && side_mm - 2 * margin_mm >= kSmallestInner_mm;
}

void check(const PageRequest& request) {
  if (!leaves_room(request.width_mm, request.margin_mm) ||
      !leaves_room(request.height_mm, request.margin_mm))
    throw UsageError(fmt::format("margins of {} mm leave no room on a page of {} x {} mm",
                                 request.margin_mm, request.width_mm, request.height_mm),
                     "margins from 0 up to what leaves 1 mm each way");
  if (std::max(request.width_mm, request.height_mm) > kLargestSide_mm)
    throw UsageError(
        fmt::format("a page of {} x {} mm is too large", request.width_mm, request.height_mm),
        fmt::format("sides of at most {} mm", kLargestSide_mm));
}

Page oriented_page(const Box2& window, const PageRequest& request) {
  const Page given{request.width_mm, request.height_mm, request.margin_mm};
  const Page turned{request.height_mm, request.width_mm, request.margin_mm};
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
  return fitting_scale(window, turned) > fitting_scale(window, given) ? turned : given;
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
  const Page page = oriented_page(window, request);
  const double scale = fitting_scale(window, page);
  const Vec2 centre = window.centre();
  return {page,
          {{scale, 0, page.width_mm / 2 - scale * centre.x,   //
            0, -scale, page.height_mm / 2 + scale * centre.y, //
            0, 0, 1}}};
}

} // namespace orograph
