// SPDX-License-Identifier: GPL-3.0-or-later
// The web page of a sweep, one file that needs no other and no network.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace orograph {

/// The previews of a sweep's rows as JSON: all of them, or, where they would make the page slow to
/// open, every second, fourth and so on, with null for the others.
class RowPreviews {
public:
  /// That of the next row, as JSON.
  void add(std::string preview);
  std::string json() const;

private:
  std::vector<std::string> previews_;
  std::size_t bytes_ = 0, every_ = 1;
};

/// The files of cli/sweep/page as one text, written into the program when it is built: HTML with
/// the style and the script in it, and {{table}} and {{previews}}, in this order, where the data
/// goes.
std::string_view sweep_page_template();

/// The page as HTML, with both texts inside it: `table_json` is that of `sweep.json`,
/// `previews_json` an array in the order of its views, each null or
/// {"size_mm": [297, 210], "layers": [{"name", "pen_mm", "grey", "path"}]}, where `path` is SVG
/// path data in tenths of a millimetre, and a layer may have a "colour". A table of some of a
/// sweep's views may say as `views_planned` how many it has in all; without it the page counts the
/// gaps that it can see. Both are valid JSON; nothing in their strings can end the script that
/// holds them.
std::string sweep_page(const std::string& table_json, const std::string& previews_json);

} // namespace orograph
