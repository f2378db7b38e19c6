// SPDX-License-Identifier: GPL-3.0-or-later
// Where a picture is seen from, and how: the eye, where it looks, the projection, the earth's
// effects.
#include "cli/options/option_group.hpp"
#include "cli/options/option_groups.hpp"
#include "cli/options/option_values.hpp"
#include "geometry/error.hpp"
#include "text/quantities.hpp"
#include "text/words.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>

namespace orograph {
namespace {

const Angle kDefaultElevation = ViewSpec().from_elevation;
constexpr auto kMapPlace = "coordinates of the terrain's CRS; Z, above the datum of the file's "
                           "heights in their unit, may be left out";
constexpr auto kLonLatPlace =
    "degrees on WGS 84, longitude first, LON from -180 to 360, LAT from -90 to 90; H, above the "
    "datum of the file's heights in their unit and not converted, may be left out";

// What latitude and longitude of the option may be.
OptionGroup::Take lonlat(const char* option, std::optional<GivenPlace>& into) {
  return [option, &into](const std::string& text) {
    const auto place = parse_place(text);
    if (!place) return false;
    if (std::abs(place->y) > 90)
      throw UsageError(
          fmt::format("{} '{}' can't be used: {} is no latitude", option, text, place->y),
          std::abs(place->x) <= 90
              ? fmt::format("longitude comes first: {},{}", place->y, place->x)
              : std::string("latitudes are from -90 to 90, and longitude comes first"));
    if (place->x < -180 || place->x > 360) return false;
    into = place;
    return true;
  };
}

void add_eye_options(OptionGroup& group, ViewSpec& view) {
  group.parsed(
      "--eye X,Y[,Z]",
      "Stand at this point, without Z on the ground there; in perspective and for panoramas",
      kMapPlace, "", parse_place, view.eye_map);
  group.value("--eye-lonlat LON,LAT[,H]",
              "The same by longitude and latitude, without H on the ground there", kLonLatPlace, "",
              lonlat("--eye-lonlat", view.eye_lonlat));
  group.number("--eye-height M", "Of an eye without Z or H: how high above the ground it is",
               {.unit = "metres", .low = 0, .low_excluded = true}, view.eye_height_m,
               fmt::format("{}", kEyeHeight_m));
  group
      .number("--eye-summit [M]",
              "Put the eye on the highest ground within M metres of its place, 50 without M, as "
              "high above it as it was, and say where that is",
              {.unit = "metres", .low = 0, .high = 100000, .low_excluded = true}, view.eye_summit_m)
      .if_alone("50");
  group.parsed("--look-at X,Y[,Z]", "Look at this point, without Z at the ground there", kMapPlace,
               "the terrain's centre; from an eye level towards it, the window shifted so that "
               "skyline and foreground fill the page",
               parse_place, view.look_at_map);
  group.value("--look-at-lonlat LON,LAT[,H]",
              "The same by longitude and latitude, without H at the ground there", kLonLatPlace, "",
              lonlat("--look-at-lonlat", view.look_at_lonlat));
  group.number(
      "--look-azimuth DEG",
      "With an eye, look in this direction instead of at a point: clockwise from true north, as a "
      "compass rose has it, which differs from the map's by the convergence of meridians (from the "
      "map's own north where the terrain has no CRS, or a local one)",
      {.unit = "degrees"}, view.look_azimuth);
  group.number("--pitch DEG",
               "With --look-azimuth, look up by this, or down where it is negative; 0 keeps the "
               "eye's height in the middle of the page",
               {.unit = "degrees", .low = -90, .high = 90}, view.pitch,
               "level, the window shifted so that skyline and foreground fill the page");
}

} // namespace

void add_view_options(std::vector<Option>& options, RenderSettings& s) {
  ViewSpec& view = s.map.view;
  OptionGroup group(options, "View");
  group
      .value("--view-from AZ/EL|NAME|auto",
             "Where the viewer stands, seen from the terrain: azimuth clockwise from north and "
             "elevation above the horizontal; auto tries 16 azimuths at 10 to 45 degrees on a "
             "coarse copy, takes what shows most ground with most relief, and says which",
             "degrees, EL from 0 to 90, or from -90 with --underside draw; AZ may be N, NNE, NE, … "
             "NNW, and stand alone then; or auto",
             fmt::format("{}/{}", view.from_azimuth.in_degrees(), view.from_elevation.in_degrees()),
             [&view](const std::string& text) {
               view.from_auto = in_lower_case(text) == "auto";
               if (view.from_auto) return true;
               const auto name = parse_compass_deg(text);
               const auto from = name ? ViewFrom{Angle::degrees(*name), kDefaultElevation}
                                      : parse_view_from(text);
               if (!from) return false;
               view.from_azimuth = from->azimuth;
               view.from_elevation = from->elevation;
               return true;
             })
      .between('/');
  group.choice("--elevation-above",
               "Whose horizontal the elevation of --view-from is above, where the earth's "
               "curvature is drawn in perspective: the target's slopes towards the eye, by 0.4 "
               "degrees on a map of 12 km and 16 on one of New Zealand",
               {{"target", Horizontal::of_target}, {"eye", Horizontal::of_eye}},
               view.elevation_above);
  group.choice("--projection",
               "Kind of picture; the last two are panoramas from an eye, with azimuths to the "
               "right and upwards the tangents of altitudes, as on a cylinder, or altitudes",
               {{"perspective", Projection::perspective},
                {"orthographic", Projection::orthographic},
                {"oblique", Projection::oblique},
                {"cylindrical", Projection::cylindrical},
                {"equirectangular", Projection::equirectangular}},
               view.projection);
  options.back().take = [take = options.back().take](const std::string& text) {
    if (text == "panorama")
      throw UsageError("--projection panorama is one of two",
                       "cylindrical, as panoramas are drawn, or equirectangular");
    return take(text);
  };
  group.parsed("--oblique cavalier|cabinet|military|L,ALPHA",
               "Oblique picture: what lies across the view is true, and lines away from the viewer "
               "are L times as long as they are, ALPHA degrees above the horizontal",
               "a name, or L above 0 and ALPHA from 0 to 180 (90 is straight up)",
               "cavalier (1,45) with --projection oblique", parse_oblique, view.oblique);
  group.value("--axonometric isometric|dimetric|trimetric",
              "Orthographic picture from where the three axes of the map are shortened alike, two "
              "alike and the one in depth by half, or each otherwise",
              "", "", [&view](const std::string& text) {
                const auto from = axonometric_view(text);
                if (!from) return false;
                view.from_azimuth = from->azimuth;
                view.from_elevation = from->elevation;
                view.projection = Projection::orthographic;
                return true;
              });
  group
      .name("--view FILE",
            "Picture by all the parameters of PHIGS: view plane, projection reference point, "
            "window, front and back plane (docs/pipeline.md)",
            "a view in TOML, or the report of a run (.json)", "", view.file_name)
      .files({"toml", "json"});
  group.number("--distance M", "From the eye to the point looked at, in space; perspective only",
               {.unit = "metres", .low = 0, .low_excluded = true}, view.distance_m,
               "so far that the terrain fills --fov");
  group.number("--fov DEG",
               "Horizontal field of view, less than 180 in perspective, and of a panorama up to "
               "360, which it has by default; no parallel view has one",
               {.unit = "degrees", .low = 0, .high = 360, .low_excluded = true}, view.field_of_view,
               "30");
  add_eye_options(group, view);
  group.number("--roll DEG", "Turn the picture clockwise", {.unit = "degrees"}, view.roll, "0");
  group.choice("--curvature",
               "Draw the earth's curvature: auto does so in perspective where it would show, and "
               "the report says by how much; of the map plane otherwise",
               {{"auto", Curvature::automatic}, {"on", Curvature::on}, {"off", Curvature::off}},
               view.curvature);
  group.number("--refraction K",
               "Share of the earth's curvature that rays of light follow; perspective only",
               {.low = -1, .high = 1}, view.refraction);
  group.number("--curvature-coefficient C",
               "The same as gdal_viewshed has it: 1 less --refraction, as 0.85714 for 1/7",
               {.low = 0, .high = 2}, [&view](double c) { view.refraction = 1 - c; });
  constexpr NumberRange kFactors{.low = 0, .high = 1000, .low_excluded = true};
  group.value("--exaggeration K|auto",
              "Multiply all heights, the eye's and the target's too (an eye --eye-height above the "
              "ground stays as high above it); 1 is true, auto takes 1, 1.5 or 2 by the terrain's "
              "relief and says which",
              "a factor, " + kFactors.describe() + ", or auto", "auto; 1 with an eye",
              [&view, kFactors](const std::string& text) {
                view.exaggeration = parse_number(text);
                return text == "auto" || (view.exaggeration && kFactors.holds(*view.exaggeration));
              });
}

} // namespace orograph
