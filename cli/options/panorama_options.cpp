// SPDX-License-Identifier: GPL-3.0-or-later
// What of the horizon a panorama shows, and in how many strips.
#include "cli/options/check_settings.hpp"
#include "cli/options/option_group.hpp"
#include "cli/options/option_groups.hpp"
#include "cli/options/option_values.hpp"
#include "geometry/error.hpp"

#include <fmt/format.h>

#include <optional>
#include <utility>

namespace orograph {
namespace {

constexpr double kMostAltitude_deg = 80;
constexpr int kMostStrips = 20;

std::optional<AzimuthRange> azimuth_range(const std::string& text) {
  const auto range = parse_range(text);
  if (!range) return std::nullopt;
  const auto [from, to] = *range;
  if (from == to)
    throw UsageError(fmt::format("--azimuth-range {} has no width", text),
                     fmt::format("all of the horizon is {}:{}", from, from + 360));
  if (to < from)
    throw UsageError(fmt::format("--azimuth-range {} runs backwards", text),
                     to + 360 > from
                         ? fmt::format("clockwise from {} it is {}:{}", from, from, to + 360)
                         : fmt::format("give the lesser first, {}:{}", to, from));
  if (to - from > 360)
    throw UsageError(fmt::format("--azimuth-range {} is more than a turn", text),
                     fmt::format("at most 360 degrees, {}:{}", from, from + 360));
  return AzimuthRange{Angle::degrees(from), Angle::degrees(to)};
}

std::optional<AltitudeRange> altitude_range(const std::string& text) {
  const auto range = parse_range(text);
  if (!range) return std::nullopt;
  const auto [low, high] = *range;
  if (!(low < high))
    throw UsageError(fmt::format("--altitude-range {} doesn't rise", text),
                     low == high ? std::string("the lower altitude first, as -20:10")
                                 : fmt::format("the lower altitude first, {}:{}", high, low));
  if (low < -kMostAltitude_deg || high > kMostAltitude_deg) return std::nullopt;
  return AltitudeRange{Angle::degrees(low), Angle::degrees(high)};
}

} // namespace

void add_panorama_options(std::vector<Option>& options, RenderSettings& s) {
  OptionGroup group(options, "Panorama");
  group.parsed("--azimuth-range A:B",
               "From the left side to the right one, clockwise from true north as --look-azimuth "
               "is; instead of --fov and a direction",
               "degrees, A less than B by at most 360; 350:370 goes across north",
               "--fov, which is 360 here, about --look-azimuth or --look-at; without a direction "
               "from north to north",
               azimuth_range, s.map.view.azimuth_range);
  group.parsed("--altitude-range A:B", "From the lower side to the upper one, above the horizontal",
               fmt::format("degrees from -{0} to {0}, A less than B", kMostAltitude_deg),
               "what is seen: the highest skyline and a little sky, ground down to 25 degrees "
               "below the lowest skyline or as the page has room",
               altitude_range, s.map.view.altitude_range);
  group.whole("--strips N",
              "Cut a long panorama into so many strips of equal azimuths, one beneath the other on "
              "the page",
              1, kMostStrips, s.map.page.strips, "all in one");
}

void check_panorama(const RenderSettings& settings, const GivenOptions& given) {
  const ViewSpec& view = settings.map.view;
  if (!is_panorama(view.projection)) {
    refuse(given, "--azimuth-range --altitude-range --strips", "but in a panorama",
           "leave it out, or use --projection cylindrical");
    if (view.field_of_view && view.field_of_view->in_degrees() >= 180)
      throw UsageError(
          fmt::format("--fov {} is too wide for perspective", view.field_of_view->in_degrees()),
          "less than 180, or --projection cylindrical, which goes all round");
    return;
  }
  if (!view.has_eye())
    throw UsageError("a panorama needs an eye", "give --eye X,Y or --eye-lonlat LON,LAT too");
  if (settings.report.ends_with(".toml"))
    throw UsageError(fmt::format("--report {}: a view file can't hold a panorama", settings.report),
                     "give the report a name that ends in .json");
  const auto refuse_here = [&](const char* option, const char* right) {
    refuse(given, option, "in a panorama", right);
  };
  refuse_here("--view-from", "leave it out: the eye is where it stands");
  refuse_here("--distance", "leave it out");
  refuse_here("--pitch", "leave it out, or give --altitude-range");
  refuse_here("--roll", "leave it out: uprights are upright");
  refuse_here("--scale", "leave it out, or give --page a width");
}

} // namespace orograph
