// SPDX-License-Identifier: GPL-3.0-or-later
// The paper and the pen; what a drawing is written as, and what is told of it.
#include "cli/options/option_group.hpp"
#include "cli/options/option_groups.hpp"
#include "cli/options/option_values.hpp"
#include "draw/page.hpp"
#include "text/quantities.hpp"
#include "text/words.hpp"
#include "write/write_drawing.hpp"

#include <fmt/format.h>

#include <cmath>

namespace orograph {

void add_page_options(std::vector<Option>& options, RenderSettings& s) {
  OptionGroup group(options, "Page");
  group
      .value(
          "--page NAME|WxH|Wxauto",
          "Paper; a named one is turned to the picture's shape, and auto is as high as the picture "
          "needs (an eye's has sky above the skyline, and ground a quarter of the width below it)",
          fmt::format(
              "one of {}, or width x height in mm such as 400x250 or 400xauto, each 1 to 10000",
              joined(paper_names(), ", ")),
          "a4",
          [&page = s.map.page](const std::string& text) {
            const auto named = paper_size_mm(text);
            const auto size = named ? PageSize{named->x, named->y} : parse_page_size(text);
            if (!size) return false;
            page.width_mm = size->width_mm;
            page.height_mm = size->height_mm;
            if (!named && page.orientation == Orientation::by_picture)
              page.orientation = Orientation::as_given;
            return true;
          })
      .words(paper_names())
      .between('x');
  group.flag("--crop",
             "End the paper, on the sides where there is some to spare, a margin from the picture",
             s.map.page.crop);
  group
      .parsed("--scale 1:N",
              "Draw a parallel view at this scale. True to it are in an orthographic picture "
              "lengths across the view, in an oblique one those and (exaggerated) heights too",
              "a scale such as 1:25000", "as large as fits", parse_scale, s.map.page.scale)
      .between(':');
  group.flag("--portrait", "Page upright", s.map.page.orientation, Orientation::portrait);
  group.flag("--landscape", "Page on its side", s.map.page.orientation, Orientation::landscape);
  group.number("--margin MM", "Empty paper on each side", {.unit = "mm", .low = 0},
               s.map.page.margin_mm);
  group
      .value("--pen-width MM|MIN:MAX",
             "Width of the pen that draws the profiles; with light they are from MIN to MAX wide, "
             "or from half to double",
             "mm, 0.01 to 10, MIN below MAX", fmt::format("{}", s.map.style.pen_width_mm),
             [&s](const std::string& text) {
               const auto widths = parse_pen_width(text);
               if (!widths) return false;
               s.map.style.light_widths = std::nullopt;
               s.map.style.pen_width_mm = widths->least_mm;
               if (widths->least_mm == widths->greatest_mm) return true;
               s.map.style.light_widths = widths;
               s.map.style.pen_width_mm = std::sqrt(widths->least_mm * widths->greatest_mm);
               return true;
             })
      .between(':');
  group.text("--title TEXT", "Title in the file's metadata, and where --furniture has one",
             "INPUT's file name", s.map.title);
}

void add_output_options(std::vector<Option>& options, RenderSettings& s) {
  OptionGroup group(options, kOutput);
  const std::string formats = joined(format_names(), ", ");
  group
      .value("--of FORMAT", "Format of OUTPUT", "one of " + formats, "by OUTPUT's extension",
             [&s](const std::string& text) {
               s.write.format = format_of_name(text);
               return true;
             })
      .words(format_names());
  group
      .name("--device NAME|FILE.toml",
            fmt::format("What reads hpgl or gcode: {}, or one that a file tells "
                        "(docs/plotters.md); what it can't reach is refused",
                        joined(device_names(), ", ")),
            "a device's name, or a file such as plotter.toml",
            "generic for hpgl, grbl-servo for gcode", s.device)
      .words(device_names())
      .files({"toml"});
  group.choice(
      "--pen-order",
      "Order of a layer's strokes: front to back as found; each time the nearest end; or shorter "
      "still, in seconds. Ink is the same",
      {{"drawing", PenOrder::drawing}, {"sorted", PenOrder::sorted}, {"best", PenOrder::best}},
      s.pen_order, "sorted in formats that a pen may draw, else drawing");
  group.number("--dpi N", "Resolution of PNG", {.unit = "dots per inch", .low = 10, .high = 4800},
               s.write.dpi);
  group.flag("--overwrite", "Replace OUTPUT and the report where they exist", s.write.overwrite);
  group
      .name("--report FILE.json|FILE.toml",
            "Write what was drawn, how exactly and in which time; to a .toml the view alone, as "
            "--view takes it",
            "a file name", "", s.report)
      .files({"json", "toml"});
  group
      .value("--check N[,file]|file",
             "Ask N random points of the drawing, 100000 without N, of a ray walk over the terrain "
             "as it is drawn, and tell how many are drawn wrongly; with file ask points that are "
             "drawn of the file's own surface too",
             "a whole number from 0 to 100000000, and file behind a comma or alone", "0",
             [&s](const std::string& text) {
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
             })
      .words({"file"});
}

void add_pen_time_options(std::vector<Option>& options, RenderSettings& s) {
  OptionGroup group(options, kOutput);
  const NumberRange mm_s{.unit = "mm/s", .low = 0, .low_excluded = true};
  group.number("--pen-speed MM/S",
               "Tell how many minutes a pen of this speed draws; what it takes to speed up and "
               "slow down comes on top",
               mm_s, s.pen_speeds.down_mm_s, "no minutes");
  group.number("--pen-up-speed MM/S", "Speed between strokes", mm_s, s.pen_speeds.up_mm_s,
               "as fast as --pen-speed");
  group.number("--pen-lift-s S", "What lifting the pen and setting it down takes",
               {.unit = "seconds", .low = 0}, s.pen_speeds.lift_s, "no time");
}

} // namespace orograph
