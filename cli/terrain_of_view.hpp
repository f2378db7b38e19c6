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

  const Terrain& operator*() const { return own_ ? *own_ : whole_; }
  const Terrain* operator->() const { return &**this; }

private:
  const Terrain& whole_;
  std::optional<Terrain> own_;
};

} // namespace orograph
