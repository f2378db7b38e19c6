// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/options/check_settings.hpp"
#include "geometry/error.hpp"
#include "map/layer_table.hpp"
#include "write/pens_file.hpp"
#include "write/write_drawing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>
#include <vector>

namespace orograph {
namespace {

constexpr auto kTiedToGround = "in a format tied to the ground, which no pen draws";
constexpr auto kWritePicture = "leave it out, or write a picture, as in --of svg";

const std::string& name_of(Format format) {
  return format_names()[static_cast<std::size_t>(format)];
}

void check_pen_order(RenderSettings& settings, const GivenOptions& given) {
  const Format format = settings.write.format;
  settings.map.pen_order = settings.pen_order.value_or(pen_order_for(format));
  if (!is_tied_to_ground(format)) return;
  if (settings.map.pen_order != PenOrder::drawing)
    refuse(given, "--pen-order", kTiedToGround, kWritePicture);
  settings.map.pen_order = PenOrder::drawing;
  if (settings.map.style.asks_for("pen-up") && insists_on(given, "--layers"))
    throw UsageError("--layers has no pen-up in a format tied to the ground, which no pen draws",
                     kWritePicture);
  std::erase_if(settings.map.style.layers, [](const LayerSpec& of) { return of.name == "pen-up"; });
}

void check_device(RenderSettings& settings, const GivenOptions& given) {
  const Format format = settings.write.format;
  const auto language = language_of(format);
  if (!language) {
    refuse(given, "--device", fmt::format("in {}, which no device reads", name_of(format)),
           "leave it out, or give --of hpgl or --of gcode");
    return;
  }
  if (settings.device.empty()) {
    settings.write.device = device_of(settings.write); // the format's own
    return;
  }
  settings.write.device = read_device(settings.device);
  if (settings.write.device->language == language) return;
  const bool speaks_hpgl = settings.write.device->language == Device::Language::hpgl;
  throw UsageError(fmt::format("--device {} doesn't speak {}", settings.device, name_of(format)),
                   fmt::format("give --of {}, or another device", speaks_hpgl ? "hpgl" : "gcode"));
}

// Light is shown by what pens there are.
void check_light(RenderSettings& settings, const GivenOptions& given) {
  Style& style = settings.map.style;
  std::vector<double> widths_mm;
  for (const Pen& pen : pens_of("profiles", settings.pens)) widths_mm.push_back(pen.width_mm);
  std::sort(widths_mm.begin(), widths_mm.end());
  if (!widths_mm.empty()) {
    style.light_widths.reset();
    style.pen_width_mm = std::sqrt(widths_mm.front() * widths_mm.back());
    if (widths_mm.front() < widths_mm.back())
      style.light_widths = LineWidths{widths_mm.front(), widths_mm.back()};
  }
  const bool has_one = widths_mm.empty() ? has_one_width(settings.write.format)
                                         : widths_mm.front() == widths_mm.back();
  if (!style.light || style.light->by_density || !has_one) return;
  if (insists_on(given, "--light-by"))
    throw UsageError(widths_mm.empty()
                         ? fmt::format("--light-by width has no meaning in {} without pens of "
                                       "several widths",
                                       name_of(settings.write.format))
                         : "--light-by width needs profiles with pens of several widths",
                     "leave it out, or give --pens that have them");
  style.light->by_density = true;
}

void check_pens(RenderSettings& settings, const GivenOptions& given) {
  if (settings.pens_file.empty()) {
    refuse(given, "--pause-between-pens", "without pens", "give --pens FILE too");
    return;
  }
  if (is_tied_to_ground(settings.write.format)) {
    refuse(given, "--pens", kTiedToGround, kWritePicture);
    return;
  }
  if (!settings.has_colours())
    refuse(given, "--pen-width", "beside pens, which have widths of their own", "leave it out");
  std::vector<std::string_view> layers;
  for (const LayerRow& row : layer_table())
    if (row.source != LineSource::pen_way) layers.push_back(row.name);
  const auto& device = settings.write.device;
  settings.pens = read_pens(settings.pens_file, layers, device ? &*device : nullptr);
}

// A layer that comes with another, as index contours do, has no entry in the style's list.
void give_colour(Style& style, const std::string& layer, const Colour& colour,
                 const GivenOptions& given) {
  const auto asked = std::ranges::find(style.layers, layer, &LayerSpec::name);
  if (asked != style.layers.end()) {
    asked->colour = colour;
    return;
  }
  const auto row = std::ranges::find(layer_table(), layer, &LayerRow::name);
  if (row->source == LineSource::lettering || layer_of(*row, style))
    style.layers.emplace_back(layer).colour = colour;
  else if (insists_on(given, "--colour"))
    throw UsageError(fmt::format("--colour names the layer {}, which isn't drawn", layer),
                     "leave it out, or have the layer drawn, by --layers or an option of its own");
}

// Pens go before: colours are of layers that none draws.
void check_colours(RenderSettings& settings, const GivenOptions& given) {
  const Format format = settings.write.format;
  Style& style = settings.map.style;
  if (language_of(format)) {
    refuse(given, "--colour --palette",
           fmt::format("in {}, where colours are the pens' that are put in", name_of(format)),
           "leave it out, or say by --pens which pen draws which layers");
    style.palette = Palette::mono;
    settings.colours.clear();
    return;
  }
  const bool have_all = std::ranges::any_of(settings.pens, [](const PenOfLayers& one) {
    return one.layers.empty() && one.field.empty();
  });
  if (have_all)
    refuse(given, "--palette", "beside a pen for all layers that no other draws",
           fmt::format("leave it out, or give each pen of {} its layers", settings.pens_file));
  for (const auto& [layer, colour] : settings.colours) {
    if (pens_of(layer, settings.pens).empty())
      give_colour(style, layer, colour, given);
    else if (insists_on(given, "--colour"))
      throw UsageError(fmt::format("--colour names the layer {}, which a pen draws", layer),
                       fmt::format("leave it out, or change the pens of {}", settings.pens_file));
  }
}

void check_sheets(RenderSettings& settings, const GivenOptions& given) {
  const bool is_tied = is_tied_to_ground(settings.write.format);
  if (is_tied) {
    refuse(given, "--clip-to --sheets", "in a format tied to the ground", kWritePicture);
    settings.clip_to_mm.reset();
    settings.sheets.reset();
  }
  if (!settings.sheets) {
    refuse(given, "--overlap", "without sheets", "give --sheets 2x3 or the like");
    return;
  }
  PageRequest& page = settings.map.page;
  if (page.ends_with_picture())
    throw UsageError("--sheets are as large as they are, whatever the picture",
                     "leave --crop out, and give --page a height");
  if (settings.output == "-")
    throw UsageError("--sheets can't go to standard output, which is one file",
                     "give OUTPUT a file name");
  const bool turns =
      (page.orientation == Orientation::landscape && *page.height_mm > page.width_mm) ||
      (page.orientation == Orientation::portrait && *page.height_mm < page.width_mm);
  if (turns) std::swap(page.width_mm, *page.height_mm);
  page.orientation = Orientation::as_given;
  settings.sheet = {page.width_mm, *page.height_mm, page.margin_mm};
  settings.sheets->overlap_mm = settings.overlap_mm;
  const Page whole = page_of_sheets(settings.sheet, *settings.sheets);
  page.width_mm = whole.width_mm;
  page.height_mm = whole.height_mm;
}

void check_pen_time(const RenderSettings& settings, const GivenOptions& given) {
  const bool has_speed = std::any_of(settings.pens.begin(), settings.pens.end(),
                                     [](const auto& of) { return of.pen.speed_mm_s.has_value(); });
  if (settings.pen_speeds.down_mm_s || has_speed) return;
  refuse(given, "--pen-up-speed --pen-lift-s", "without --pen-speed", "give --pen-speed MM/S too");
}

} // namespace

void check_plotting(RenderSettings& settings, const GivenOptions& given) {
  check_pen_order(settings, given);
  check_device(settings, given);
  check_pens(settings, given);
  check_colours(settings, given);
  check_light(settings, given);
  check_sheets(settings, given);
  check_pen_time(settings, given);
  if (settings.pens.empty() && !settings.clip_to_mm && !settings.sheets) return;
  settings.finishing_order = settings.map.pen_order;
  settings.map.pen_order = PenOrder::drawing;
}

} // namespace orograph
