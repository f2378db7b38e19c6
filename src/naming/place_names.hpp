// SPDX-License-Identifier: GPL-3.0-or-later
// Places with names, as a file tells them.
#pragma once

#include "dem/overlay.hpp"
#include "geometry/vec.hpp"
#include "placing/label_spec.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace orograph {

struct PlaceName {
  std::string text; ///< with its height, where that is asked for and the file has one
  Vec2 map;
  std::optional<double> height_m;     ///< the file's; for the text alone
  std::optional<double> prominence_m; ///< the file's
  std::optional<double> weight;       ///< where a field says it
};

struct PlaceNames {
  std::vector<PlaceName> places; ///< in an order that doesn't depend on the file's
  std::size_t unnamed = 0;       ///< features without a name
};

/// The points of an overlay that have a name. Heights are in fields such as ele or elevation_ft, in
/// metres unless name or value say feet; prominence is in a field of that name. Two points of one
/// place and one name are one. Throws Error where there is no such field, as the spec's or "name",
/// and where the overlay is of other things than points.
PlaceNames place_names(const Overlay& overlay, const LabelSpec& spec);

/// A name and its height, as it is printed; the name alone where no heights are asked for.
std::string text_with_height(const std::string& name, double height_m, LabelElevation elevation);

} // namespace orograph
