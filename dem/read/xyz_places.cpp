// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/read/xyz_places.hpp"

#include "geometry/error.hpp"
#include "text/words.hpp"

#include <cpl_conv.h>
#include <cpl_vsi.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <memory>
#include <string_view>
#include <vector>

namespace orograph {
namespace {

struct CloseText {
  void operator()(VSILFILE* file) const { VSIFCloseL(file); }
};

// As the driver parts them: several marks in a row are one.
std::vector<std::string> columns_of(std::string_view line) {
  std::vector<std::string> columns;
  constexpr std::string_view kBetween = " \t,;\r";
  for (std::size_t begin = 0; (begin = line.find_first_not_of(kBetween, begin)) != line.npos;) {
    const std::size_t end = std::min(line.find_first_of(kBetween, begin), line.size());
    columns.emplace_back(line.substr(begin, end - begin));
    begin = end;
  }
  return columns;
}

bool names(const std::string& column, std::string_view letter, std::string_view a,
           std::string_view b) {
  const std::string lower = in_lower_case(column);
  return lower == letter || lower.starts_with(a) || lower.starts_with(b);
}

// "-1.#QNAN" and the like are what other systems write; GDAL reads them.
bool is_finite(const std::string& number) {
  return number.find('#') == number.npos && std::isfinite(std::strtod(number.c_str(), nullptr));
}

} // namespace

void check_xyz_places(const std::string& path) {
  const std::unique_ptr<VSILFILE, CloseText> file(VSIFOpenL(path.c_str(), "rb"));
  if (!file) return;
  std::size_t x = 0, y = 1, number = 0;
  while (const char* const line = CPLReadLine2L(file.get(), 10000, nullptr)) {
    const std::vector<std::string> columns = columns_of(line);
    if (++number == 1)
      for (std::size_t i = 0; i < columns.size(); ++i) {
        if (names(columns[i], "x", "lon", "east")) x = i;
        if (names(columns[i], "y", "lat", "north")) y = i;
      }
    for (const std::size_t i : {x, y})
      if (i < columns.size() && !is_finite(columns[i]))
        throw Error(fmt::format("{}, line {}: a place is '{}'", path, number, columns[i]),
                    "it must be a finite number");
  }
}

} // namespace orograph
