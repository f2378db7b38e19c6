// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/profile_point.hpp"

#include <cstdint>

namespace orograph {

/// A vertex of a grid or a TIN in the profile frame.
struct MeshVertex {
  std::uint32_t index;
  ProfilePoint at;
};

} // namespace orograph
