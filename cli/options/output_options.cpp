// SPDX-License-Identifier: GPL-3.0-or-later
// The paper and the pen; what a drawing is written as, and what is told of it.
#include "cli/options/option_groups.hpp"
#include "cli/options/option_values.hpp"
#include "draw/page.hpp"
#include "write/write_drawing.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

namespace orograph {
namespace {

constexpr auto kPage = "Page";

} // namespace

void add_page_options(std::vector<Option>& options, RenderSettings& s) {
  options.push_back(
      {.group = kPage,
       .name = "--page",
       .value = "NAME|WxH|Wxauto",
       .help = "Paper; a named one is turned to the picture's shape, and auto is as "
               "high as the picture needs (an eye's has sky above the skyline, and "
               "ground a quarter of the width below it)",
       .allowed = fmt::format("one of {}, or width x height in mm such as 400x250 "
                              "or 400xauto, each 1 to 10000",
                              fmt::join(paper_names(), ", ")),
       .by_default = "a4",
       .words = paper_names(),
       .between = 'x',
       .take = [&page = s.map.page](const std::string& text) {
         const auto named = paper_size_mm(text);
         const auto size = named ? PageSize{named->x, named->y} : parse_page_size(text);
         if (!size) return false;
         page.width_mm = size->width_mm;
         page.height_mm = size->height_mm;
         if (!named && page.orientation == Orientation::by_picture)
           page.orientation = Orientation::as_given;
         return true;
       }});
  options.push_back({.group = kPage,
                     .name = "--crop",
                     .help = "End the paper, on the sides where there is some to spare, a margin "
                             "from the picture",
                     .take = set_to(s.map.page.crop, true)});
  options.push_back({.group = kPage,
                     .name = "--scale",
                     .value = "1:N",
                     .help = "Draw a parallel view at this scale. True to it are in an "
                             "orthographic picture lengths across the view, in an oblique one "
                             "those and (exaggerated) heights too",
                     .allowed = "a scale such as 1:25000",
                     .by_default = "as large as fits",
                     .between = ':',
                     .take = stored(parse_scale, s.map.page.scale)});
  options.push_back({.group = kPage,
                     .name = "--portrait",
                     .help = "Page upright",
                     .take = set_to(s.map.page.orientation, Orientation::portrait)});
  options.push_back({.group = kPage,
                     .name = "--landscape",
                     .help = "Page on its side",
                     .take = set_to(s.map.page.orientation, Orientation::landscape)});
  options.push_back(with_number({.group = kPage,
                                 .name = "--margin",
                                 .value = "MM",
                                 .help = "Empty paper on each side",
                                 .by_default = fmt::format("{}", s.map.page.margin_mm)},
                                {.unit = "mm", .low = 0},
                                [&s](double mm) { s.map.page.margin_mm = mm; }));
  options.push_back(
      {.group = kPage,
       .name = "--pen-width",
       .value = "MM|MIN:MAX",
       .help =
           "Width of the pen that draws the profiles; with light they are from MIN to MAX wide, "
           "or from half to double",
       .allowed = "mm, 0.01 to 10, MIN below MAX",
       .by_default = fmt::format("{}", s.map.style.pen_width_mm),
       .between = ':',
       .take = [&s](const std::string& text) {
         const auto widths = parse_pen_width(text);
         if (!widths) return false;
         s.map.style.light_widths = std::nullopt;
         s.map.style.pen_width_mm = widths->least_mm;
         if (widths->least_mm == widths->greatest_mm) return true;
         s.map.style.light_widths = widths;
         s.map.style.pen_width_mm = std::sqrt(widths->least_mm * widths->greatest_mm);
         return true;
       }});
  options.push_back({.group = kPage,
                     .name = "--title",
                     .value = "TEXT",
                     .help = "Title in the file's metadata, and where --furniture has one",
                     .by_default = "INPUT's file name",
                     .take = [&s](const std::string& text) {
                       s.map.title = text;
                       return true;
                     }});
}

void add_output_options(std::vector<Option>& options, RenderSettings& s) {
  const std::string formats = fmt::format("{}", fmt::join(format_names(), ", "));
  options.push_back({.group = kOutput,
                     .name = "--of",
                     .value = "FORMAT",
                     .help = "Format of OUTPUT",
                     .allowed = "one of " + formats,
                     .by_default = "by OUTPUT's extension",
                     .words = format_names(),
                     .take = [&s](const std::string& text) {
                       s.write.format = format_of_name(text);
                       return true;
                     }});
  options.push_back({.group = kOutput,
                     .name = "--device",
                     .value = "NAME|FILE.toml",
                     .help = fmt::format("What reads hpgl or gcode: {}, or one that a file tells "
                                         "(docs/plotters.md); what it can't reach is refused",
                                         fmt::join(device_names(), ", ")),
                     .allowed = "a device's name, or a file such as plotter.toml",
                     .by_default = "generic for hpgl, grbl-servo for gcode",
                     .words = device_names(),
                     .extensions = {"toml"},
                     .take = stored_name(s.device)});
  options.push_back(
      {.group = kOutput,
       .name = "--pen-order",
       .value = "drawing|sorted|best",
       .help = "Order of a layer's strokes: front to back as found; each time the nearest end; or "
               "shorter still, in seconds. Ink is the same",
       .by_default = "sorted in formats that a pen may draw, else drawing",
       .take = [&s](const std::string& text) {
         if (text == "drawing") s.pen_order = PenOrder::drawing;
         if (text == "sorted") s.pen_order = PenOrder::sorted;
         if (text == "best") s.pen_order = PenOrder::best;
         return text == "drawing" || text == "sorted" || text == "best";
       }});
  options.push_back(with_number({.group = kOutput,
                                 .name = "--dpi",
                                 .value = "N",
                                 .help = "Resolution of PNG",
                                 .by_default = fmt::format("{}", s.write.dpi)},
                                {.unit = "dots per inch", .low = 10, .high = 4800},
                                [&s](double dpi) { s.write.dpi = dpi; }));
  options.push_back({.group = kOutput,
                     .name = "--overwrite",
                     .help = "Replace OUTPUT and the report where they exist",
                     .take = set_to(s.write.overwrite, true)});
  options.push_back(
      {.group = kOutput,
       .name = "--report",
       .value = "FILE.json|FILE.toml",
       .help = "Write what was drawn, how exactly and in which time; to a .toml the view alone, "
               "as --view takes it",
       .allowed = "a file name",
       .extensions = {"json", "toml"},
       .take = stored_name(s.report)});
  options.push_back(
      {.group = kOutput,
       .name = "--check",
       .value = "N[,file]|file",
       .help =
           "Ask N random points of the drawing, 100000 without N, of a ray walk over the terrain "
           "as it is drawn, and tell how many are drawn wrongly; with file ask points that are "
           "drawn of the file's own surface too",
       .allowed = "a whole number from 0 to 100000000, and file behind a comma or alone",
       .by_default = "0",
       .words = {"file"},
       .take = [&s](const std::string& text) {
         constexpr std::string_view kFile = "file", kBehind = ",file";
         std::string_view number = text;
         const bool of_file = text == kFile || text.ends_with(kBehind);
         if (of_file) number.remove_suffix(text == kFile ? kFile.size() : kBehind.size());
         const auto points =
             number.empty() && of_file ? std::optional(100000) : parse_integer(number);
         if (!points || *points < 0 || *points > 100000000) return false;
         s.map.check = static_cast<unsigned>(*points);
         s.map.check_of_file = of_file ? s.map.check : 0;
         return true;
       }});
}

void add_pen_time_options(std::vector<Option>& options, RenderSettings& s) {
  const auto speed = [](std::optional<double>& into) {
    return [&into](double value) { into = value; };
  };
  const NumberRange mm_s{.unit = "mm/s", .low = 0, .low_excluded = true};
  options.push_back(with_number({.group = kOutput,
                                 .name = "--pen-speed",
                                 .value = "MM/S",
                                 .help = "Tell how many minutes a pen of this speed draws; what it "
                                         "takes to speed up and slow down comes on top",
                                 .by_default = "no minutes"},
                                mm_s, speed(s.pen_speed_mm_s)));
  options.push_back(with_number({.group = kOutput,
                                 .name = "--pen-up-speed",
                                 .value = "MM/S",
                                 .help = "Speed between strokes",
                                 .by_default = "as fast as --pen-speed"},
                                mm_s, speed(s.pen_up_speed_mm_s)));
  options.push_back(with_number({.group = kOutput,
                                 .name = "--pen-lift-s",
                                 .value = "S",
                                 .help = "What lifting the pen and setting it down takes",
                                 .by_default = "no time"},
                                {.unit = "seconds", .low = 0}, speed(s.pen_lift_s)));
}

} // namespace orograph
