// SPDX-License-Identifier: GPL-3.0-or-later
// Files that hold what a series of maps has in common: furniture, letters, texts.
#pragma once

#include "draw/page_text.hpp"
#include "geometry/api.hpp"
#include "placing/furniture_spec.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace orograph {

/// "title", "subtitle" …, in the order of the enumeration.
const std::vector<std::string>& furniture_names();

/// Of "none", or of names with commas between, "map" and "panorama" among them, which stand for
/// what those mostly have. Throws UsageError, whose message begins with `place`, for another name.
OROGRAPH_API std::vector<Furniture> furniture_of(std::string_view text, const std::string& place);

/// What a template says; what it leaves out stays.
struct Template {
  std::optional<std::vector<Furniture>> pieces;
  std::optional<std::string> title, subtitle, source, date, font;
  std::optional<LetterKind> letters;
  std::optional<double> title_mm, subtitle_mm, text_mm, gap_mm;
};

/// Of a TOML file. Throws Error with file and line.
OROGRAPH_API Template read_template(const std::string& path);

} // namespace orograph
