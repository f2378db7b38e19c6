// SPDX-License-Identifier: GPL-3.0-or-later
// Where a picture is seen from, and how.
#include "cli/options/option_groups.hpp"
#include "cli/options/option_kinds.hpp"
#include "cli/options/option_values.hpp"
#include "geometry/error.hpp"

#include <fmt/format.h>

#include <utility>

namespace orograph {
namespace {

constexpr auto kGroup = "View";

} // namespace

void add_view_options(std::vector<Option>& options, RenderSettings& s) {
  options.push_back({.group = kGroup,
                     .name = "--view-from",
                     .value = "AZ/EL",
                     .help = "Where the viewer stands, seen from the terrain: azimuth clockwise "
                             "from north and elevation above the horizontal",
                     .allowed = "degrees, EL from 0 to 90",
                     .by_default = fmt::format("{}/{}", s.map.view.from_azimuth.in_degrees(),
                                               s.map.view.from_elevation.in_degrees()),
                     .take = [&s](const std::string& text) {
                       const auto from = parse_view_from(text);
                       if (!from) return false;
                       s.map.view.from_azimuth = from->azimuth;
                       s.map.view.from_elevation = from->elevation;
                       return true;
                     }});
  Option projection = with_choice<Projection>({.group = kGroup,
                                               .name = "--projection",
                                               .help = "Kind of picture",
                                               .by_default = "perspective"},
                                              {{"perspective", Projection::perspective},
                                               {"orthographic", Projection::orthographic},
                                               {"oblique", Projection::oblique}},
                                              s.map.view.projection);
  projection.take = [take = projection.take](const std::string& text) {
    if (text == "panorama")
      throw UsageError("--projection panorama doesn't work yet",
                       "use perspective, orthographic or oblique");
    return take(text);
  };
  options.push_back(std::move(projection));
  options.push_back({.group = kGroup,
                     .name = "--oblique",
                     .value = "cavalier|cabinet|military|L,ALPHA",
                     .help = "Oblique picture: what lies across the view is true, and lines away "
                             "from the viewer are L times as long as they are, ALPHA degrees above "
                             "the horizontal",
                     .allowed = "a name, or L above 0 and ALPHA from 0 to 180 (90 is straight up)",
                     .by_default = "cavalier (1,45) with --projection oblique",
                     .take = stored(parse_oblique, s.map.view.oblique)});
  options.push_back({.group = kGroup,
                     .name = "--axonometric",
                     .value = "isometric|dimetric|trimetric",
                     .help = "Orthographic picture from where the three axes of the map are "
                             "shortened alike, two alike and the one in depth by half, or each "
                             "otherwise",
                     .take = [&s](const std::string& text) {
                       const auto from = axonometric_view(text);
                       if (!from) return false;
                       s.map.view.from_azimuth = from->azimuth;
                       s.map.view.from_elevation = from->elevation;
                       s.map.view.projection = Projection::orthographic;
                       return true;
                     }});
  options.push_back({.group = kGroup,
                     .name = "--view",
                     .value = "FILE",
                     .help = "Picture by all the parameters of PHIGS: view plane, projection "
                             "reference point, window, front and back plane (docs/pipeline.md)",
                     .allowed = "a view in TOML, or the report of a run (.json)",
                     .take = stored_name(s.map.view.file_name)});
  options.push_back(
      with_number({.group = kGroup,
                   .name = "--distance",
                   .value = "M",
                   .help = "From the eye to the point looked at, in space; perspective only",
                   .by_default = "so far that the terrain fills --fov"},
                  {.unit = "metres", .low = 0, .low_excluded = true},
                  [&s](double m) { s.map.view.distance_m = m; }));
  options.push_back(with_number(
      {.group = kGroup,
       .name = "--fov",
       .value = "DEG",
       .help = "Horizontal field of view; perspective only",
       .by_default = "30"},
      {.unit = "degrees", .low = 0, .high = 180, .low_excluded = true, .high_excluded = true},
      [&s](double deg) { s.map.view.field_of_view = Angle::degrees(deg); }));
  add_eye_options(options, s);
  options.push_back(with_number({.group = kGroup,
                                 .name = "--roll",
                                 .value = "DEG",
                                 .help = "Turn the picture clockwise",
                                 .by_default = "0"},
                                {.unit = "degrees"},
                                [&s](double deg) { s.map.view.roll = Angle::degrees(deg); }));
  options.push_back(with_choice<Curvature>(
      {.group = kGroup,
       .name = "--curvature",
       .help =
           "Draw the earth's curvature: auto does so in perspective where it would show, and the "
           "report says by how much; of the map plane otherwise",
       .by_default = "auto"},
      {{"auto", Curvature::automatic}, {"on", Curvature::on}, {"off", Curvature::off}},
      s.map.view.curvature));
  options.push_back(with_number(
      {.group = kGroup,
       .name = "--refraction",
       .value = "K",
       .help = "Share of the earth's curvature that rays of light follow; perspective only",
       .by_default = fmt::format("{}", s.map.view.refraction)},
      {.low = -1, .high = 1}, [&s](double k) { s.map.view.refraction = k; }));
  options.push_back(with_number(
      {.group = kGroup,
       .name = "--curvature-coefficient",
       .value = "C",
       .help = "The same as gdal_viewshed has it: 1 less --refraction, as 0.85714 for 1/7"},
      {.low = 0, .high = 2}, [&s](double c) { s.map.view.refraction = 1 - c; }));
  Option exaggeration = with_number(
      {.group = kGroup,
       .name = "--exaggeration",
       .value = "K|auto",
       .help =
           "Multiply all heights, the eye's and the target's too (an eye --eye-height above the "
           "ground stays as high above it); 1 is true, auto takes 1, 1.5 or 2 by the terrain's "
           "relief and says which",
       .by_default = "auto; 1 with an eye"},
      {.low = 0, .high = 1000, .low_excluded = true},
      [&s](double k) { s.map.view.exaggeration = k; });
  exaggeration.allowed = "a factor, " + exaggeration.allowed + ", or auto";
  exaggeration.take = [&s, number = exaggeration.take](const std::string& text) {
    if (text != "auto") return number(text);
    s.map.view.exaggeration.reset();
    return true;
  };
  options.push_back(std::move(exaggeration));
}

} // namespace orograph
