// SPDX-License-Identifier: GPL-3.0-or-later
// Names of places, and labels of lines on the ground.
#include "cli/options/check_settings.hpp"
#include "cli/options/option_group.hpp"
#include "cli/options/option_groups.hpp"
#include "cli/options/option_values.hpp"
#include "geometry/error.hpp"
#include "text/quantities.hpp"

#include <fmt/format.h>

#include <string>
#include <utility>
#include <vector>

namespace orograph {
namespace {

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

void add_which(OptionGroup& group, RenderSettings& s) {
  LabelSpec& labels = s.map.labels;
  group.value("--labels FILE[:LAYER]",
              "Print the names of points: summits that are seen, the best of those that have room",
              "a vector file of points that GDAL reads, its layer where it has several, or CSV "
              "with columns lon and lat, or x and y",
              "", [&s](const std::string& text) {
                if (text.empty()) return false;
                s.labels = parse_overlay(text);
                return true;
              });
  group.name("--label-field FIELD", "Which field of the points is their name",
             "a field's name, in any letter case", "name", labels.field);
  group.name("--label-weight FIELD",
             "A field with numbers that say how much a point counts; else it is how far its summit "
             "stands out",
             "a field's name, in any letter case", "", labels.weight_field);
  group.name("--label-where CONDITION", "Only points that meet it, as SQL has it behind WHERE",
             "as in \"ele > 3000\"", "", s.labels_where);
  group.whole("--label-max N", "At most so many names", 0, 100000, labels.most,
              "as many as have room; on maps those that cover a sixteenth of the picture");
  group.parsed("--label-range KM", "From an eye, no names farther than this",
               "kilometres, above 0, as in 80 or 80km", "three times --label-haze", parse_km,
               labels.range_m);
  group.parsed("--label-haze KM",
               "From an eye, the distance over which a summit comes to count e times less",
               "kilometres, above 0, as in 120 or 120km", fmt::format("{}km", labels.haze_m / 1000),
               parse_km, labels.haze_m);
}

void add_looks(OptionGroup& group, LabelSpec& labels) {
  group.parsed("--label-angle DEG",
               "Of a panorama, how steeply names climb above it; 0: they are level, in rows",
               "degrees, 0 or 15 to 90", fmt::format("{}", labels.angle.in_degrees()),
               parse_name_angle, labels.angle);
  group.whole("--label-rows N", "Of level names above a panorama, how many rows", 1, 20,
              labels.rows);
  group.choice(
      "--label-elevation", "Print heights behind names: the file's, or else the terrain's",
      {{"m", LabelElevation::metres}, {"ft", LabelElevation::feet}, {"none", LabelElevation::none}},
      labels.elevation);
  group.number("--label-size MM", "How large letters are: their em, of which capitals are 0.7 high",
               {.unit = "millimetres", .low = 0.5, .high = 50}, labels.size_mm);
  group.number("--label-halo MM", "Lines of the terrain end so far from letters that stand on them",
               {.unit = "millimetres", .low = 0, .high = 20}, labels.halo_mm);
  group.flag("--contour-labels", "Heights on index contours, which end beside them",
             labels.contours);
  group.flag("--coordinate-labels", "Numbers at the ends of the lines of --graticule and --grid",
             labels.coordinates);
}

} // namespace

void add_label_options(std::vector<Option>& options, RenderSettings& settings) {
  OptionGroup group(options, "Names and labels");
  add_which(group, settings);
  add_looks(group, settings.map.labels);
}

void check_labels(RenderSettings& settings, const GivenOptions& given) {
  const Style& style = settings.map.style;
  const bool is_round = is_panorama(settings.map.view.projection);
  settings.labels.where = settings.labels_where;
  settings.labels.allow_network = settings.reading.allow_network;
  if (settings.labels.path.empty())
    refuse(given,
           "--label-field --label-weight --label-where --label-max --label-range --label-haze "
           "--label-angle --label-rows --label-elevation",
           "without names", "give --labels FILE too");
  if (!is_round)
    refuse(given, "--label-angle --label-rows", "but in a panorama",
           "leave it out: on a map names stand beside summits");
  if (settings.map.labels.angle != Angle())
    refuse(given, "--label-rows", "for names that climb", "give --label-angle 0 too");
  if (!settings.map.view.has_eye())
    refuse(given, "--label-range --label-haze", "without an eye",
           "leave it out, or give --eye X,Y");
  if (!style.draws_index_contours())
    refuse(given, "--contour-labels", "without index contours", "give --contours INTERVAL too");
  if (is_round || !(style.asks_for("graticule") || style.asks_for("grid")))
    refuse(given, "--coordinate-labels",
           is_round ? "in a panorama" : "without lines that have coordinates",
           is_round ? "leave it out" : "give --graticule or --grid too");
  if (settings.map.ground_points)
    refuse(given, "--labels --contour-labels --coordinate-labels",
           "in formats for a GIS, which have no page",
           "leave it out, or write a format such as svg or pdf");
}

} // namespace orograph
