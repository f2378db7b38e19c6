// SPDX-License-Identifier: GPL-3.0-or-later
// How the horizon's measures grow with the number of profiles.
#pragma once

#include "measure/fragmentation.hpp"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace orograph {

/// How a horizon grows. Of rows that differ in the number of profiles alone: the exponent of the
/// power law through a measure, by least squares of the logarithms; none where fewer than two rows
/// have it.
struct Growth {
  FragmentationRow like;                                                ///< one of the rows
  std::vector<std::pair<std::string, std::optional<double>>> exponents; ///< by measure

  bool is_known() const;
};

/// REQUIRES that such rows follow each other.
std::vector<Growth> growth_of(const std::vector<FragmentationRow>& rows);

} // namespace orograph
