// SPDX-License-Identifier: GPL-3.0-or-later
// The values of options that are more than quantities, from text. Nothing here knows which option
// it reads.
#pragma once

#include "dem/read/overlay_input.hpp"
#include "draw/sheets.hpp"
#include "geometry/angle.hpp"
#include "geometry/box.hpp"
#include "geometry/vec.hpp"
#include "placing/map_spec.hpp"
#include "profiles/plan_request.hpp"
#include "view/view_request.hpp"

#include <optional>
#include <string>
#include <string_view>

namespace orograph {

// Each of these reads the whole text as those of text/quantities.hpp do.

/// "X,Y" or "X,Y,Z".
std::optional<GivenPlace> parse_place(std::string_view text);
/// "XMIN,YMIN,XMAX,YMAX" with XMIN < XMAX and YMIN < YMAX.
std::optional<Box2> parse_box(std::string_view text);

/// "W,S,E,N" in degrees, longitudes from -360 to 360 and less than a turn apart or just one,
/// latitudes S < N. W above E goes across 180 degrees: the box's high x is beyond then.
std::optional<Box2> parse_lonlat_box(std::string_view text);

/// "A:B".
std::optional<Vec2> parse_range(std::string_view text);

struct ViewFrom {
  Angle azimuth, elevation;
};
/// "AZ/EL", an azimuth as above and the elevation in degrees, 0 to 90.
std::optional<ViewFrom> parse_view_from(std::string_view text);

/// "cavalier", "cabinet", "military", or "L,ALPHA" with L > 0 and ALPHA from 0 to 180 degrees.
std::optional<Oblique> parse_oblique(std::string_view text);
/// "isometric", "dimetric" (1 : 1 : 1/2, ISO 5456-3) or "trimetric" (from 210/25).
std::optional<ViewFrom> axonometric_view(std::string_view text);

/// "0.6mm" on the page or "100m" on the ground, above 0.
std::optional<PlanRequest> parse_spacing(std::string_view text);

/// "0.15", or "0.1:0.3", each from 0.01 to 10.
std::optional<LineWidths> parse_pen_width(std::string_view text);

/// "AZ/ALT" in degrees, clockwise from north and above the horizontal, ALT 0 to 90; or "picture".
std::optional<LightSpec> parse_light(std::string_view text);

/// "WxH" or "Wxauto" in millimetres, each 1 to 10000.
struct PageSize {
  double width_mm;
  std::optional<double> height_mm; ///< none: auto
};
std::optional<PageSize> parse_page_size(std::string_view text);

/// "2x3": columns and rows of sheets, each 1 to 20.
std::optional<SheetsRequest> parse_sheets(std::string_view text);

/// "FILE" or "FILE:LAYER".
OverlayInput parse_overlay(const std::string& text);

} // namespace orograph
