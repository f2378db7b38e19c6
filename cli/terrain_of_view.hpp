// SPDX-License-Identifier: GPL-3.0-or-later
// The terrain as one view needs it.
#pragma once

#include "cli/render_settings.hpp"
#include "dem/terrain.hpp"

#include <optional>

namespace orograph {

/// In the view's frame on the earth, if it is in degrees, and cut by the view's planes, if it has
/// any; else the whole terrain itself. Heights of a grid are shared, never copied.
class TerrainOfView {
public:
  /// REQUIRES that `whole` outlives it. Throws Error as `stand_on_earth` and `cut_by_view` do.
  TerrainOfView(const Terrain& whole, const RenderSettings& settings);
  TerrainOfView(const TerrainOfView&) = delete;
  TerrainOfView& operator=(const TerrainOfView&) = delete;

  const Terrain& operator*() const { return cut_ ? *cut_ : uncut(); }
  const Terrain* operator->() const { return &**this; }
  /// In the same frame, before the planes cut it.
  const Terrain& uncut() const { return on_earth_ ? *on_earth_ : whole_; }

private:
  const Terrain& whole_;
  std::optional<Terrain> on_earth_, cut_;
};

} // namespace orograph
