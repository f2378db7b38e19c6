// SPDX-License-Identifier: GPL-3.0-or-later
// Hachures: lines down the slope.
#include "cli/options/option_group.hpp"
#include "cli/options/option_groups.hpp"
#include "cli/options/option_values.hpp"

#include <string>

namespace orograph {

void add_hachure_options(std::vector<Option>& options, RenderSettings& s) {
  OptionGroup group(options, "Lines on the ground");
  HachureSpec& hachures = s.map.style.hachures;
  group.value("--hachures", "Draw lines down the slope, heavier where it is steeper", "", "",
              [&s](const std::string&) {
                s.added_layers.emplace_back("hachures");
                return true;
              });
  group.value("--hachure-spacing Wmm", "How far apart hachures are on the page",
              "a length from 0.1mm to 100mm", "0.8mm", [&hachures](const std::string& text) {
                const auto plan = parse_spacing(text);
                const auto* spacing = plan ? std::get_if<PageSpacing>(&*plan) : nullptr;
                if (!spacing || spacing->mm < 0.1 || spacing->mm > 100) return false;
                hachures.spacing_mm = spacing->mm;
                return true;
              });
  group
      .value("--hachure-slope FROM:TO",
             "From which slope on there are hachures, and from which on they are as wide as half "
             "their spacing",
             "degrees from 0 to below 90, the second more than the first, as in 5:45", "5:45",
             [&hachures](const std::string& text) {
               const auto range = parse_range(text);
               if (!range || !(range->x >= 0 && range->x < range->y && range->y < 90)) return false;
               hachures.from_deg = range->x;
               hachures.heaviest_from_deg = range->y;
               return true;
             })
      .between(':');
}

} // namespace orograph
