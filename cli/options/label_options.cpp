// SPDX-License-Identifier: GPL-3.0-or-later
// Names of places, and labels of lines on the ground.
#include "cli/options/check_labels.hpp"
#include "cli/options/option_groups.hpp"
#include "cli/options/option_values.hpp"
#include "geometry/error.hpp"

#include <fmt/format.h>

#include <string>
#include <utility>
#include <vector>

namespace orograph {
namespace {

constexpr auto kLabels = "Names and labels";

// "120", or "120km".
std::optional<double> parse_km(const std::string& text) {
  const bool has_unit = text.ends_with("km");
  const auto km = parse_number(text.substr(0, text.size() - (has_unit ? 2 : 0)));
  if (!km || !(*km > 0 && *km <= 20000)) return std::nullopt;
  return *km * 1000;
}

std::optional<Angle> parse_name_angle(const std::string& text) {
  const auto deg = parse_number(text);
  if (!deg || !(*deg == 0 || (*deg >= 15 && *deg <= 90))) return std::nullopt;
  return Angle::degrees(*deg);
}

void add_which(std::vector<Option>& options, RenderSettings& s) {
  LabelSpec& labels = s.map.labels;
  options.push_back({.group = kLabels,
                     .name = "--labels",
                     .value = "FILE[:LAYER]",
                     .help = "Print the names of points: summits that are seen, the best of those "
                             "that have room",
                     .allowed = "a vector file of points that GDAL reads, its layer where it has "
                                "several, or CSV with columns lon and lat, or x and y",
                     .take = [&s](const std::string& text) {
                       if (text.empty()) return false;
                       s.labels = parse_overlay(text);
                       return true;
                     }});
  options.push_back({.group = kLabels,
                     .name = "--label-field",
                     .value = "FIELD",
                     .help = "Which field of the points is their name",
                     .allowed = "a field's name, in any letter case",
                     .by_default = "name",
                     .take = stored_name(labels.field)});
  options.push_back({.group = kLabels,
                     .name = "--label-weight",
                     .value = "FIELD",
                     .help = "A field with numbers that say how much a point counts; else it is "
                             "how far its summit stands out",
                     .allowed = "a field's name, in any letter case",
                     .take = stored_name(labels.weight_field)});
  options.push_back({.group = kLabels,
                     .name = "--label-where",
                     .value = "CONDITION",
                     .help = "Only points that meet it, as SQL has it behind WHERE",
                     .allowed = "as in \"ele > 3000\"",
                     .take = stored_name(s.labels_where)});
  options.push_back(with_integer({.group = kLabels,
                                  .name = "--label-max",
                                  .value = "N",
                                  .help = "At most so many names",
                                  .by_default = "as many as have room; on maps those that cover "
                                                "a sixteenth of the picture"},
                                 0, 100000, [&labels](int most) { labels.most = most; }));
  options.push_back({.group = kLabels,
                     .name = "--label-range",
                     .value = "KM",
                     .help = "From an eye, no names farther than this",
                     .allowed = "kilometres, above 0, as in 80 or 80km",
                     .by_default = "three times --label-haze",
                     .take = stored(parse_km, labels.range_m)});
  options.push_back({.group = kLabels,
                     .name = "--label-haze",
                     .value = "KM",
                     .help = "From an eye, the distance over which a summit comes to count e times "
                             "less",
                     .allowed = "kilometres, above 0, as in 120 or 120km",
                     .by_default = fmt::format("{}km", labels.haze_m / 1000),
                     .take = stored(parse_km, labels.haze_m)});
}

void add_looks(std::vector<Option>& options, RenderSettings& s) {
  LabelSpec& labels = s.map.labels;
  options.push_back({.group = kLabels,
                     .name = "--label-angle",
                     .value = "DEG",
                     .help = "Of a panorama, how steeply names climb above it; 0: they are level, "
                             "in rows",
                     .allowed = "degrees, 0 or 15 to 90",
                     .by_default = fmt::format("{}", labels.angle.in_degrees()),
                     .take = stored(parse_name_angle, labels.angle)});
  options.push_back(with_integer({.group = kLabels,
                                  .name = "--label-rows",
                                  .value = "N",
                                  .help = "Of level names above a panorama, how many rows",
                                  .by_default = fmt::format("{}", labels.rows)},
                                 1, 20, [&labels](int rows) { labels.rows = rows; }));
  options.push_back(with_choice<LabelElevation>(
      {.group = kLabels,
       .name = "--label-elevation",
       .help = "Print heights behind names: the file's, or else the terrain's",
       .by_default = "none"},
      {{"m", LabelElevation::metres}, {"ft", LabelElevation::feet}, {"none", LabelElevation::none}},
      labels.elevation));
  options.push_back(with_number({.group = kLabels,
                                 .name = "--label-size",
                                 .value = "MM",
                                 .help = "How large letters are: their em, of which capitals are "
                                         "0.7 high",
                                 .by_default = fmt::format("{}", labels.size_mm)},
                                {.unit = "millimetres", .low = 0.5, .high = 50},
                                [&labels](double mm) { labels.size_mm = mm; }));
  options.push_back(with_number({.group = kLabels,
                                 .name = "--label-halo",
                                 .value = "MM",
                                 .help = "Lines of the terrain end so far from letters that stand "
                                         "on them",
                                 .by_default = fmt::format("{}", labels.halo_mm)},
                                {.unit = "millimetres", .low = 0, .high = 20},
                                [&labels](double mm) { labels.halo_mm = mm; }));
  options.push_back({.group = kLabels,
                     .name = "--contour-labels",
                     .help = "Heights on index contours, which end beside them",
                     .take = set_to(labels.contours, true)});
  options.push_back({.group = kLabels,
                     .name = "--coordinate-labels",
                     .help = "Numbers at the ends of the lines of --graticule and --grid",
                     .take = set_to(labels.coordinates, true)});
}

} // namespace

void add_label_options(std::vector<Option>& options, RenderSettings& settings) {
  add_which(options, settings);
  add_looks(options, settings);
}

void check_labels(RenderSettings& settings, const GivenOptions& given) {
  const Style& style = settings.map.style;
  const bool is_round = is_panorama(settings.map.view.projection);
  settings.labels.where = settings.labels_where;
  settings.labels.allow_network = settings.reading.allow_network;
  const auto refuse = [&](const char* option, const char* without, const char* right) {
    if (insists_on(given, option))
      throw UsageError(fmt::format("{} has no meaning {}", option, without), right);
  };
  if (settings.labels.path.empty())
    for (const char* option :
         {"--label-field", "--label-weight", "--label-where", "--label-max", "--label-range",
          "--label-haze", "--label-angle", "--label-rows", "--label-elevation"})
      refuse(option, "without names", "give --labels FILE too");
  if (!is_round)
    for (const char* option : {"--label-angle", "--label-rows"})
      refuse(option, "but in a panorama", "leave it out: on a map names stand beside summits");
  if (settings.map.labels.angle != Angle())
    refuse("--label-rows", "for names that climb", "give --label-angle 0 too");
  if (!settings.map.view.has_eye())
    for (const char* option : {"--label-range", "--label-haze"})
      refuse(option, "without an eye", "leave it out, or give --eye X,Y");
  if (!style.draws_index_contours())
    refuse("--contour-labels", "without index contours", "give --contours INTERVAL too");
  if (is_round || !(style.asks_for("graticule") || style.asks_for("grid")))
    refuse("--coordinate-labels",
           is_round ? "in a panorama" : "without lines that have coordinates",
           is_round ? "leave it out" : "give --graticule or --grid too");
  if (settings.map.ground_points)
    for (const char* option : {"--labels", "--contour-labels", "--coordinate-labels"})
      refuse(option, "in formats for a GIS, which have no page",
             "leave it out, or write a format such as svg or pdf");
}

} // namespace orograph
