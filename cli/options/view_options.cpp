// SPDX-License-Identifier: GPL-3.0-or-later
// Where a picture is seen from, and how: the eye, where it looks, the projection, the earth's
// effects.
#include "cli/options/option_groups.hpp"
#include "cli/options/option_values.hpp"
#include "geometry/error.hpp"
#include "text/words.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>

namespace orograph {
namespace {

constexpr auto kView = "View";
const Angle kDefaultElevation = ViewSpec().from_elevation;
constexpr auto kMapPlace = "coordinates of the terrain's CRS; Z, above the datum of the file's "
                           "heights in their unit, may be left out";
constexpr auto kLonLatPlace =
    "degrees on WGS 84, longitude first, LON from -180 to 360, LAT from -90 to 90; H, above the "
    "datum of the file's heights in their unit and not converted, may be left out";

Option with_lonlat(Option option, std::optional<GivenPlace>& into) {
  option.group = kView;
  option.value = "LON,LAT[,H]";
  option.allowed = kLonLatPlace;
  option.take = [name = option.name, &into](const std::string& text) {
    const auto place = parse_place(text);
    if (!place) return false;
    if (std::abs(place->y) > 90)
      throw UsageError(
          fmt::format("{} '{}' can't be used: {} is no latitude", name, text, place->y),
          std::abs(place->x) <= 90
              ? fmt::format("longitude comes first: {},{}", place->y, place->x)
              : std::string("latitudes are from -90 to 90, and longitude comes first"));
    if (place->x < -180 || place->x > 360) return false;
    into = place;
    return true;
  };
  return option;
}

void add_eye_options(std::vector<Option>& options, RenderSettings& s) {
  options.push_back({.group = kView,
                     .name = "--eye",
                     .value = "X,Y[,Z]",
                     .help = "Stand at this point, without Z on the ground there; in perspective "
                             "and for panoramas",
                     .allowed = kMapPlace,
                     .take = stored(parse_place, s.map.view.eye_map)});
  options.push_back(
      with_lonlat({.name = "--eye-lonlat",
                   .help = "The same by longitude and latitude, without H on the ground there"},
                  s.map.view.eye_lonlat));
  options.push_back(
      with_number({.group = kView,
                   .name = "--eye-height",
                   .value = "M",
                   .help = "Of an eye without Z or H: how high above the ground it is",
                   .by_default = fmt::format("{}", kEyeHeight_m)},
                  {.unit = "metres", .low = 0, .low_excluded = true},
                  [&s](double m) { s.map.view.eye_height_m = m; }));
  options.push_back(with_number(
      {.group = kView,
       .name = "--eye-summit",
       .value = "[M]",
       .if_alone = "50",
       .help = "Put the eye on the highest ground within M metres of its place, 50 without M, as "
               "high above it as it was, and say where that is"},
      {.unit = "metres", .low = 0, .high = 100000, .low_excluded = true},
      [&s](double m) { s.map.view.eye_summit_m = m; }));
  options.push_back({.group = kView,
                     .name = "--look-at",
                     .value = "X,Y[,Z]",
                     .help = "Look at this point, without Z at the ground there",
                     .allowed = kMapPlace,
                     .by_default = "the terrain's centre; from an eye level towards it, the window "
                                   "shifted so that skyline and foreground fill the page",
                     .take = stored(parse_place, s.map.view.look_at_map)});
  options.push_back(
      with_lonlat({.name = "--look-at-lonlat",
                   .help = "The same by longitude and latitude, without H at the ground there"},
                  s.map.view.look_at_lonlat));
  options.push_back(with_number(
      {.group = kView,
       .name = "--look-azimuth",
       .value = "DEG",
       .help = "With an eye, look in this direction instead of at a point: clockwise "
               "from true north, as a compass rose has it, which differs from the "
               "map's by the convergence of meridians (from the map's own north where "
               "the terrain has no CRS, or a local one)"},
      {.unit = "degrees"}, [&s](double deg) { s.map.view.look_azimuth = Angle::degrees(deg); }));
  options.push_back(
      with_number({.group = kView,
                   .name = "--pitch",
                   .value = "DEG",
                   .help = "With --look-azimuth, look up by this, or down where it is "
                           "negative; 0 keeps the eye's height in the middle of the page",
                   .by_default = "level, the window shifted so that skyline and foreground fill "
                                 "the page"},
                  {.unit = "degrees", .low = -90, .high = 90},
                  [&s](double deg) { s.map.view.pitch = Angle::degrees(deg); }));
}

} // namespace

void add_view_options(std::vector<Option>& options, RenderSettings& s) {
  options.push_back({.group = kView,
                     .name = "--view-from",
                     .value = "AZ/EL|NAME|auto",
                     .help = "Where the viewer stands, seen from the terrain: azimuth clockwise "
                             "from north and elevation above the horizontal; auto tries 16 "
                             "azimuths at 10 to 45 degrees on a coarse copy, takes what shows most "
                             "ground with most relief, and says which",
                     .allowed = "degrees, EL from 0 to 90, or from -90 with --underside draw; AZ "
                                "may be N, NNE, NE, … NNW, and stand alone then; or auto",
                     .by_default = fmt::format("{}/{}", s.map.view.from_azimuth.in_degrees(),
                                               s.map.view.from_elevation.in_degrees()),
                     .between = '/',
                     .take = [&s](const std::string& text) {
                       s.map.view.from_auto = in_lower_case(text) == "auto";
                       if (s.map.view.from_auto) return true;
                       const auto name = parse_compass_deg(text);
                       const auto from = name ? ViewFrom{Angle::degrees(*name), kDefaultElevation}
                                              : parse_view_from(text);
                       if (!from) return false;
                       s.map.view.from_azimuth = from->azimuth;
                       s.map.view.from_elevation = from->elevation;
                       return true;
                     }});
  options.push_back(with_choice<Horizontal>(
      {.group = kView,
       .name = "--elevation-above",
       .help =
           "Whose horizontal the elevation of --view-from is above, where the earth's curvature "
           "is drawn in perspective: the target's slopes towards the eye, by 0.4 degrees on a "
           "map of 12 km and 16 on one of New Zealand",
       .by_default = "target"},
      {{"target", Horizontal::of_target}, {"eye", Horizontal::of_eye}},
      s.map.view.elevation_above));
  Option projection = with_choice<Projection>({.group = kView,
                                               .name = "--projection",
                                               .help = "Kind of picture; the last two are "
                                                       "panoramas from an eye, with azimuths to "
                                                       "the right and upwards the tangents of "
                                                       "altitudes, as on a cylinder, or altitudes",
                                               .by_default = "perspective"},
                                              {{"perspective", Projection::perspective},
                                               {"orthographic", Projection::orthographic},
                                               {"oblique", Projection::oblique},
                                               {"cylindrical", Projection::cylindrical},
                                               {"equirectangular", Projection::equirectangular}},
                                              s.map.view.projection);
  projection.take = [take = projection.take](const std::string& text) {
    if (text == "panorama")
      throw UsageError("--projection panorama is one of two",
                       "cylindrical, as panoramas are drawn, or equirectangular");
    return take(text);
  };
  options.push_back(std::move(projection));
  options.push_back({.group = kView,
                     .name = "--oblique",
                     .value = "cavalier|cabinet|military|L,ALPHA",
                     .help = "Oblique picture: what lies across the view is true, and lines away "
                             "from the viewer are L times as long as they are, ALPHA degrees above "
                             "the horizontal",
                     .allowed = "a name, or L above 0 and ALPHA from 0 to 180 (90 is straight up)",
                     .by_default = "cavalier (1,45) with --projection oblique",
                     .take = stored(parse_oblique, s.map.view.oblique)});
  options.push_back({.group = kView,
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
  options.push_back({.group = kView,
                     .name = "--view",
                     .value = "FILE",
                     .help = "Picture by all the parameters of PHIGS: view plane, projection "
                             "reference point, window, front and back plane (docs/pipeline.md)",
                     .allowed = "a view in TOML, or the report of a run (.json)",
                     .extensions = {"toml", "json"},
                     .take = stored_name(s.map.view.file_name)});
  options.push_back(
      with_number({.group = kView,
                   .name = "--distance",
                   .value = "M",
                   .help = "From the eye to the point looked at, in space; perspective only",
                   .by_default = "so far that the terrain fills --fov"},
                  {.unit = "metres", .low = 0, .low_excluded = true},
                  [&s](double m) { s.map.view.distance_m = m; }));
  options.push_back(with_number(
      {.group = kView,
       .name = "--fov",
       .value = "DEG",
       .help = "Horizontal field of view, less than 180 in perspective, and of a panorama up to "
               "360, which it has by default; no parallel view has one",
       .by_default = "30"},
      {.unit = "degrees", .low = 0, .high = 360, .low_excluded = true},
      [&s](double deg) { s.map.view.field_of_view = Angle::degrees(deg); }));
  add_eye_options(options, s);
  options.push_back(with_number({.group = kView,
                                 .name = "--roll",
                                 .value = "DEG",
                                 .help = "Turn the picture clockwise",
                                 .by_default = "0"},
                                {.unit = "degrees"},
                                [&s](double deg) { s.map.view.roll = Angle::degrees(deg); }));
  options.push_back(with_choice<Curvature>(
      {.group = kView,
       .name = "--curvature",
       .help =
           "Draw the earth's curvature: auto does so in perspective where it would show, and the "
           "report says by how much; of the map plane otherwise",
       .by_default = "auto"},
      {{"auto", Curvature::automatic}, {"on", Curvature::on}, {"off", Curvature::off}},
      s.map.view.curvature));
  options.push_back(with_number(
      {.group = kView,
       .name = "--refraction",
       .value = "K",
       .help = "Share of the earth's curvature that rays of light follow; perspective only",
       .by_default = fmt::format("{}", s.map.view.refraction)},
      {.low = -1, .high = 1}, [&s](double k) { s.map.view.refraction = k; }));
  options.push_back(with_number(
      {.group = kView,
       .name = "--curvature-coefficient",
       .value = "C",
       .help = "The same as gdal_viewshed has it: 1 less --refraction, as 0.85714 for 1/7"},
      {.low = 0, .high = 2}, [&s](double c) { s.map.view.refraction = 1 - c; }));
  Option exaggeration = with_number(
      {.group = kView,
       .name = "--exaggeration",
       .value = "K|auto",
       .help =
           "Multiply all heights, the eye's and the target's too (an eye --eye-height above the "
           "ground stays as high above it); 1 is true, auto takes 1, 1.5 or 2 by the terrain's "
           "relief and says which",
       .by_default = "auto; 1 with an eye"},
      {.low = 0, .high = 1000, .low_excluded = true},
      [&s](double k) { s.map.view.exaggeration = k; });
  exaggeration.range.reset(); // or a word
  exaggeration.allowed = "a factor, " + exaggeration.allowed + ", or auto";
  exaggeration.take = [&s, number = exaggeration.take](const std::string& text) {
    if (text != "auto") return number(text);
    s.map.view.exaggeration.reset();
    return true;
  };
  options.push_back(std::move(exaggeration));
}

} // namespace orograph
