// SPDX-License-Identifier: GPL-3.0-or-later
// The web page of a sweep: one file that needs no other and no network.
#pragma once

#include <string>

namespace orograph {

/// The page as HTML, with both texts inside it: `table_json` is that of `sweep.json`,
/// `previews_json` an array in the order of its views, each null or
/// {"size_mm": [297, 210], "layers": [{"name", "pen_mm", "grey", "path"}]}, where `path` is SVG
/// path data in tenths of a millimetre. A table of some of a sweep's views may say as
/// `views_planned` how many it has in all; without it the page counts the gaps that it can see.
/// Both are valid JSON; nothing in their strings can end the script that holds them.
std::string sweep_page(const std::string& table_json, const std::string& previews_json);

} // namespace orograph
