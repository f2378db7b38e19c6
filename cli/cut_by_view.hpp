// SPDX-License-Identifier: GPL-3.0-or-later
// Front and back planes cut the terrain (docs/decisions/0010-sectors-and-planes.md).
#pragma once

#include "cli/render_settings.hpp"
#include "dem/terrain.hpp"

#include <optional>

namespace orograph {

/// The terrain without what is in front of the front plane or behind the back plane of the
/// settings' view: a TIN, whose border runs along the planes. A note tells of it. Nothing where the
/// view has no such planes. Throws Error if nothing is left.
std::optional<Terrain> cut_by_view(const Terrain& terrain, const RenderSettings& settings);

} // namespace orograph
