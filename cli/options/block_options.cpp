// SPDX-License-Identifier: GPL-3.0-or-later
// A block: walls from the terrain's border down to a base.
#include "cli/options/option_group.hpp"
#include "cli/options/option_groups.hpp"
#include "cli/options/option_values.hpp"

#include <optional>
#include <string>

namespace orograph {

void add_block_options(std::vector<Option>& options, RenderSettings& s) {
  OptionGroup group(options, "Lines on the ground");
  BlockSpec& block = s.map.style.block;
  group
      .value("--block [BASE|auto]",
             "Draw the terrain as a block, with walls from its border and around voids down to a "
             "base; auto is 0.15 of the relief below the lowest height",
             "a height, 100m or 300ft or 100 in the unit of the file's heights, or auto", "",
             [&s, &block](const std::string& text) {
               block.base.reset();
               if (text != "auto") {
                 const auto heights = parse_heights(text);
                 if (!heights || heights->values.size() != 1) return false;
                 block.base = heights->values.front();
                 block.unit_m = heights->unit_m;
               }
               s.added_layers.emplace_back("block");
               return true;
             })
      .if_alone("auto");
  group.choice("--block-sides", "Whether a block's walls are hatched with upright lines",
               {{"lines", BlockSides::lines}, {"outline", BlockSides::outline}}, block.sides,
               "lines; outline where contours go across the walls");
}

} // namespace orograph
