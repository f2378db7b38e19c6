// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solids/solid.hpp"

#include <cstdint>
#include <vector>

namespace orograph {

/// The advice for faces that look inwards.
extern const char* const list_counterclockwise;

/// Throws Error if a closed part of the solid, all that edges join, has no volume to rounding, or
/// is inside out. `face_of` is the face of each triangle, for messages; the part's first is named.
/// REQUIRES that every edge has its two triangles.
void require_outward(const Solid& solid, const std::vector<std::uint32_t>& face_of, double size_m);

} // namespace orograph
