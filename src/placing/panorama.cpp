// SPDX-License-Identifier: GPL-3.0-or-later
#include "placing/panorama.hpp"

#include "geometry/blocked_points.hpp"
#include "geometry/error.hpp"
#include "placing/frame_eye_view.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace orograph {
namespace {

// Profiles are polygons about the eye, whose corners are seen in the foreground as bends: with
// sectors of 15 degrees of 7 degrees where one looks 25 degrees down, with these of 2, a tenth of a
// millimetre high. A 360 degree view takes 22 % longer with 72 than with 24.
constexpr int kSectors = 72;
constexpr double kSector_deg = 360.0 / kSectors;

constexpr double kColumn_deg = 5;       // between directions in which the skyline is looked for
constexpr double kForeground_deg = 25;  // under the lowest skyline
constexpr double kSkylineShare = 0.75;  // of the height, in which the skyline is to be
constexpr double kSteepest_deg = 80;    // up or down; on a cylinder they run to infinity
constexpr double kBetweenStrips = 0.08; // share of a strip's height
constexpr double kRounding_deg = 1e-9;

double radians(double deg) {
  return Angle::degrees(deg).in_radians();
}
double tangent(double deg) {
  return tan(Angle::degrees(deg));
}

// How high a tangent is on the page, in radii.
double height_of(PanoramaKind kind, double tangent) {
  return kind == PanoramaKind::cylindrical ? tangent : std::atan(tangent);
}
double tangent_of(PanoramaKind kind, double height) {
  return kind == PanoramaKind::cylindrical ? height : std::tan(height);
}

// Azimuths in degrees of the frame, rising from the left side.
struct Slice {
  double axis_deg, from_deg, to_deg;
};

std::vector<Slice> slices(const Panorama& panorama) {
  const double from = panorama.middle_deg - 0.5 * panorama.width_deg,
               to = panorama.middle_deg + 0.5 * panorama.width_deg;
  std::vector<Slice> out;
  for (double k = std::floor(from / kSector_deg + 0.5); (k - 0.5) * kSector_deg < to; ++k) {
    const double axis = k * kSector_deg;
    const Slice slice{axis, std::max(from, axis - 0.5 * kSector_deg),
                      std::min(to, axis + 0.5 * kSector_deg)};
    if (slice.to_deg - slice.from_deg > kRounding_deg) out.push_back(slice);
  }
  return out;
}

View view_of(const Slice& slice, const Panorama& panorama, const View& ahead) {
  View view = ahead;
  view.forward = direction_of_azimuth(Angle::degrees(std::remainder(slice.axis_deg, 360)));
  view.right = {view.forward.y, 0 - view.forward.x};
  view.drop = drop_in_frame(panorama.drop, view.forward);
  const double left = tangent(slice.from_deg - slice.axis_deg),
               right = tangent(slice.to_deg - slice.axis_deg);
  // Altitudes are higher in Y beside the axis.
  const double aside = std::hypot(1, std::max(std::abs(left), std::abs(right)));
  view.window = {{left, panorama.low_tangent * (panorama.low_tangent < 0 ? aside : 1)},
                 {right, panorama.high_tangent * (panorama.high_tangent > 0 ? aside : 1)}};
  return view;
}

// The tangent of a point's altitude, and of all in a box no less.
struct Altitude {
  const View& view;
  double most_turn; // from the middle; radians

  double operator()(Vec3 ground) const {
    const ProfilePoint p = to_profile_frame(view, ground);
    const double away = std::hypot(p.u, p.v);
    if (away < view.near_m || std::abs(PanoramaPage::azimuth(p)) > most_turn) return -kInfinity;
    return (p.z - view.eye_z_m) / away;
  }
  double bound(const Box3& box) const {
    if (is_aside(box)) return -kInfinity;
    const Vec2 at = view.depth_origin_m;
    const double nearest = std::hypot(std::max({box.low.x - at.x, at.x - box.high.x, 0.0}),
                                      std::max({box.low.y - at.y, at.y - box.high.y, 0.0}));
    const double farthest =
        std::hypot(std::max(std::abs(box.low.x - at.x), std::abs(box.high.x - at.x)),
                   std::max(std::abs(box.low.y - at.y), std::abs(box.high.y - at.y)));
    // What sinks is a quadratic form, of any sign where rays bend more than the earth.
    const double least = std::min({0.0, view.drop.per_uu - std::abs(view.drop.per_uv),
                                   view.drop.per_vv - std::abs(view.drop.per_uv)});
    const double above =
        box.high.z * view.exaggeration - least * farthest * farthest - view.eye_z_m;
    return above / (above > 0 ? std::max(nearest, view.near_m) : farthest);
  }

private:
  // Whether all of a box is turned farther from the middle than is shown: beyond the same side of a
  // slice, or, where that is wider than a half-plane, beyond both.
  bool is_aside(const Box3& box) const {
    if (!std::isfinite(most_turn)) return false;
    bool beyond_left = true, beyond_right = true;
    for (const double x : {box.low.x, box.high.x})
      for (const double y : {box.low.y, box.high.y}) {
        const ProfilePoint p = to_profile_frame(view, {x, y, 0});
        const double right = p.u * std::cos(most_turn), ahead = p.v * std::sin(most_turn);
        const double rounding = kRounding_deg * (std::abs(p.u) + std::abs(p.v));
        beyond_right = beyond_right && right - ahead > rounding;
        beyond_left = beyond_left && -right - ahead > rounding;
      }
    return 2 * most_turn <= std::numbers::pi ? beyond_left || beyond_right
                                             : beyond_left && beyond_right;
  }
};

double greatest_tangent(const BlockedPoints& points, const Panorama& panorama, const View& ahead) {
  const Altitude altitude{ahead,
                          panorama.width_deg < 360 ? radians(0.5 * panorama.width_deg) : kInfinity};
  return greatest(points, altitude, [&](const Box3& box, double) { return altitude.bound(box); },
                  {})
      .value;
}

double tangent_at(const GroundAhead& column, const View& ahead, std::size_t i) {
  return column.y(ahead, i) / std::hypot(1, column.x);
}

// Of all that are given, the one under which, no farther than `room`, most others are; the highest
// of such.
double top_of_most(std::vector<double> heights, double room, double otherwise) {
  std::ranges::sort(heights);
  std::size_t most = 0, first = 0;
  for (std::size_t i = 0; i < heights.size(); ++i) {
    while (heights[first] < heights[i] - room) ++first;
    if (i + 1 - first < most) continue;
    most = i + 1 - first;
    otherwise = heights[i];
  }
  return otherwise;
}

// Of all strips together, a strip's height being 1.
double heights_of_strips(int strips) {
  return strips + (strips - 1) * kBetweenStrips;
}

// With what strips leave to what stands around each; all of that in height beneath the picture.
Sides room_of_strips(const PageRequest& page) {
  const Sides &room = page.room_mm, &strip = page.strip_room_mm;
  return {room.left + strip.left, room.top, room.right + strip.right,
          room.bottom + page.strips * (strip.top + strip.bottom)};
}

} // namespace

double Panorama::whole_sector_mm() const {
  return radians(kSector_deg) * page.radius_mm;
}

double whole_sector_half_width() {
  return tangent(0.5 * kSector_deg);
}

double Panorama::altitude_deg(double tangent) const {
  return atan2_angle(tangent, 1).in_degrees();
}

std::vector<Box2> Panorama::strip_boxes_mm() const {
  if (strips.empty()) return {frame_mm};
  std::vector<Box2> boxes;
  double begin_mm = frame_mm.low.x;
  for (const PanoramaStrip& strip : strips) {
    boxes.push_back({Vec2{begin_mm, frame_mm.low.y} + strip.shift_mm,
                     Vec2{strip.end_mm, frame_mm.high.y} + strip.shift_mm});
    begin_mm = strip.end_mm;
  }
  return boxes;
}

Box2 Panorama::strips_mm() const {
  Box2 all;
  for (const Box2& strip : strip_boxes_mm()) {
    all.include(strip.low);
    all.include(strip.high);
  }
  return all;
}

ViewSpec looking_to_middle(ViewSpec view) {
  const bool is_whole = !view.field_of_view || view.field_of_view->in_degrees() >= 360;
  if (view.azimuth_range)
    view.look_azimuth = 0.5 * (view.azimuth_range->from + view.azimuth_range->to);
  else if (is_whole && !view.look_azimuth && !view.look_at_map && !view.look_at_lonlat)
    view.look_azimuth = Angle::degrees(180);
  return view;
}

Panorama panorama_asked(const ViewSpec& view, const ViewRequest& request) {
  Panorama out;
  out.kind = view.projection == Projection::cylindrical ? PanoramaKind::cylindrical
                                                        : PanoramaKind::equirectangular;
  out.drop = request.drop;
  out.width_deg = view.azimuth_range
                      ? view.azimuth_range->to.in_degrees() - view.azimuth_range->from.in_degrees()
                      : view.field_of_view.value_or(Angle::degrees(360)).in_degrees();
  out.middle_deg = request.look->azimuth.in_degrees();
  return out;
}

std::vector<Sector> sectors_of(const Panorama& panorama, const View& ahead) {
  const PanoramaPage& page = panorama.page;
  std::vector<Sector> sectors;
  for (const Slice& slice : slices(panorama)) {
    Sector& sector = sectors.emplace_back();
    sector.view = view_of(slice, panorama, ahead);
    sector.to_view = {dot(sector.view.forward, ahead.forward),
                      dot(sector.view.forward, ahead.right)};
    const auto x_mm = [&](double deg) { return page.x_mm(radians(deg - panorama.middle_deg)); };
    sector.azimuth = radians(slice.axis_deg - panorama.middle_deg);
    sector.to_page = {{page.radius_mm, 0, x_mm(slice.axis_deg), //
                       0, -page.radius_mm, page.ahead_mm.y,     //
                       0, 0, 1}};
    sector.frame_mm = panorama.frame_mm;
    sector.frame_mm->low.x = x_mm(slice.from_deg);
    sector.frame_mm->high.x = x_mm(slice.to_deg);
  }
  return sectors;
}

std::vector<GroundAhead> ground_about(const Panorama& panorama, const View& ahead,
                                      const CutSurface& of) {
  std::vector<GroundAhead> out;
  for (const Slice& slice : slices(panorama)) {
    const int columns =
        1 + std::max(1, static_cast<int>(std::ceil((slice.to_deg - slice.from_deg) / kColumn_deg)));
    std::vector<GroundAhead> some =
        ground_ahead(view_of(slice, panorama, ahead), panorama.drop, of, columns);
    std::move(some.begin(), some.end(), std::back_inserter(out));
  }
  return out;
}

void frame_panorama(Panorama& panorama, const View& ahead, const TerrainShape& terrain,
                    const std::vector<GroundAhead>& about, bool stands_over_ground,
                    const std::optional<AltitudeRange>& asked, const PageRequest& page) {
  if (asked) {
    panorama.low_tangent = tan(asked->low);
    panorama.high_tangent = tan(asked->high);
    return;
  }
  std::vector<double> skylines;
  double highest = greatest_tangent(terrain.points, panorama, ahead);
  double lowest_skyline = kInfinity, lowest = stands_over_ground ? -kInfinity : kInfinity;
  for (const GroundAhead& column : about) {
    const auto at = column.skyline(ahead);
    if (at < 0) continue;
    const double skyline = tangent_at(column, ahead, static_cast<std::size_t>(at));
    skylines.push_back(height_of(panorama.kind, skyline));
    highest = std::max(highest, skyline);
    lowest_skyline = std::min(lowest_skyline, skyline);
    if (!stands_over_ground) lowest = std::min(lowest, tangent_at(column, ahead, 0));
  }
  const double steepest = tangent(kSteepest_deg);
  const double solids = greatest_tangent(terrain.beside, panorama, ahead);
  if (!(highest > -kInfinity)) highest = lowest_skyline = solids;
  if (!(highest > -kInfinity))
    throw Error("there is no terrain in the directions of this panorama",
                "turn it towards the terrain, widen it, or move the eye");
  if (solids > highest && solids <= highest + tangent(kForeground_deg)) highest = solids;
  highest = std::clamp(highest, -steepest, steepest);
  lowest_skyline = std::min(lowest_skyline, highest);
  const double foreground =
      std::max(-kSteepest_deg, panorama.altitude_deg(lowest_skyline) - kForeground_deg);
  double bottom = std::max(tangent(foreground), lowest);
  if (!(bottom < highest)) bottom = tangent(std::max(-kSteepest_deg, foreground));

  const auto height = [&](double t) { return height_of(panorama.kind, t); };
  const double wanted = (height(highest) - height(bottom)) / (1 - kSkyShare);
  const double width = radians(panorama.width_deg) / page.strips,
               strips = heights_of_strips(page.strips);
  // No foreground is worth more than a square; on a page whatever it has room for.
  double most = width;
  if (page.height_mm) {
    const Sides room = room_of_strips(page);
    const double aspect = (*page.height_mm - 2 * page.margin_mm - room.top - room.bottom) /
                          (page.width_mm - 2 * page.margin_mm - room.left - room.right);
    const double upright = std::max(aspect, 1 / aspect);
    const bool is_upright =
        page.orientation == Orientation::portrait ||
        (page.orientation == Orientation::by_picture && wanted * strips > width);
    most = width * (page.orientation == Orientation::as_given ? aspect
                    : is_upright                              ? upright
                                                              : 1 / upright);
  }
  const double high = std::min(wanted, most / strips), steep = height(steepest);
  const double room = (kSkylineShare - kSkyShare) * high;
  const double skyline = height(highest) - height(lowest_skyline) <= room
                             ? height(highest)
                             : top_of_most(std::move(skylines), room, height(highest));
  const double top = std::min(skyline + kSkyShare * high, steep);
  panorama.high_tangent = tangent_of(panorama.kind, top);
  panorama.low_tangent = tangent_of(panorama.kind, std::max(top - high, -steep));
}

Page place_panorama_on_page(Panorama& panorama, const View& ahead, const PageRequest& request) {
  const double high = height_of(panorama.kind, panorama.high_tangent),
               height = high - height_of(panorama.kind, panorama.low_tangent),
               width = radians(panorama.width_deg);
  const Box2 window{{0, 0}, {width / request.strips, height * heights_of_strips(request.strips)}};
  PageRequest roomy = request;
  roomy.room_mm = room_of_strips(request);
  const Placement placement = place_on_page(window, roomy);
  const double radius_mm = placement.to_page.m[0];
  const Sides& of_strip = request.strip_room_mm;
  const Vec2 upper_left_mm = placement.to_page({0, window.high.y}) + Vec2{0, of_strip.top};
  panorama.page = {panorama.kind, radius_mm, upper_left_mm + radius_mm * Vec2{0.5 * width, high},
                   ahead.eye_z_m};
  panorama.frame_mm = {{panorama.page.x_mm(-0.5 * width), upper_left_mm.y},
                       {panorama.page.x_mm(0.5 * width), upper_left_mm.y + radius_mm * height}};
  panorama.strips.clear();
  for (int i = 0; i < request.strips && request.strips > 1; ++i)
    panorama.strips.push_back(
        {upper_left_mm.x + radius_mm * width * (i + 1) / request.strips,
         radius_mm * Vec2{-width * i / request.strips, height * (1 + kBetweenStrips) * i} +
             Vec2{0, i * (of_strip.top + of_strip.bottom)}});
  return placement.page;
}

} // namespace orograph
