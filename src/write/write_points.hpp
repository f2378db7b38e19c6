// SPDX-License-Identifier: GPL-3.0-or-later
// Points with what is known of them, as a table or a layer.
#pragma once

#include "geometry/attributes.hpp"
#include "geometry/vec.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace orograph {

enum class PointFormat { csv, geojson };

struct PointTable {
  struct Row {
    std::optional<Vec2> place; ///< none: unknown
    Attributes values;         ///< some of the fields, each once
  };

  std::string name;                ///< of the layer
  std::string crs_wkt;             ///< of places; empty: none
  std::vector<std::string> fields; ///< in their order; different, whatever their letters' case
  std::vector<Row> rows;
};

/// By the path's extension; none where it is another.
std::optional<PointFormat> point_format_of(std::string_view path);

/// Writes a row each, in order, whole or not at all; path "-" is standard output. In CSV places are
/// the first two columns, x and y, and what isn't known is empty; numbers have up to 15 digits.
/// The same table gives the same bytes. Throws Error where it can't be written, or exists and
/// `overwrite` is off.
void write_points(const PointTable& table, PointFormat format, const std::string& path,
                  bool overwrite);

} // namespace orograph
