// SPDX-License-Identifier: GPL-3.0-or-later
// What stands on the terrain.
#include "cli/options/option_groups.hpp"
#include "cli/options/option_kinds.hpp"

namespace orograph {

void add_scene_options(std::vector<Option>& options, RenderSettings& s) {
  constexpr auto kGroup = "Solids";
  options.push_back({.group = kGroup,
                     .name = "--scene",
                     .value = "FILE",
                     .help = "Huts, towers, masts and the like on the terrain (docs/scenes.md); a "
                             "scene as INPUT is drawn alone",
                     .allowed = "a scene in TOML",
                     .take = stored_name(s.scene_file)});
  options.push_back(with_choice<bool>(
      {.group = kGroup,
       .name = "--hidden",
       .help = "Edges of solids that aren't seen: leave them out, or dash them in the layer hidden",
       .by_default = "omit"},
      {{"omit", false}, {"dash", true}}, s.dashes_hidden));
}

} // namespace orograph
