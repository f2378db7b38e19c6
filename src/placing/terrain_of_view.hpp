// SPDX-License-Identifier: GPL-3.0-or-later
// The terrain as one view needs it.
#pragma once

#include "dem/terrain.hpp"
#include "placing/map_spec.hpp"

#include <optional>

namespace orograph {

/// Of a terrain in degrees: puts the origin of its ground frame below the eye, where no eye is
/// given below the target, else in the terrain's middle, and exaggerates its heights, before the
/// earth curves them away. A view in a file has its directions in the frame below its own eye, of a
/// parallel view at its VRP. Other terrains are left as they are. Throws the Errors of `place_eye`
/// and of `reframe`.
void stand_on_earth(TerrainData& terrain, const ViewSpec& view);

/// The terrain without what is in front of the front plane or behind the back plane of the
/// view: a TIN, whose border runs along the planes. A note tells of it. Nothing where the
/// view has no such planes. Throws Error if nothing is left.
std::optional<TerrainData> cut_by_view(const TerrainData& terrain, const ViewSpec& view);

/// In the view's frame on the earth, if it is in degrees, and cut by the view's planes, if it has
/// any (docs/decisions/0010-sectors-and-planes.md); else the whole terrain itself. Heights of a
/// grid are shared, never copied.
class TerrainOfView {
public:
  /// REQUIRES that `whole` outlives it. Throws Error as `stand_on_earth` does, and where the view's
  /// planes leave nothing of the terrain.
  TerrainOfView(const TerrainData& whole, const ViewSpec& view);
  TerrainOfView(const TerrainOfView&) = delete;
  TerrainOfView& operator=(const TerrainOfView&) = delete;

  const TerrainData& operator*() const { return cut_ ? *cut_ : uncut(); }
  const TerrainData* operator->() const { return &**this; }
  /// Whether it is the whole terrain itself.
  bool is_whole() const { return !cut_ && !on_earth_; }
  /// In the same frame, before the planes cut it.
  const TerrainData& uncut() const { return on_earth_ ? *on_earth_ : whole_; }

private:
  const TerrainData& whole_;
  std::optional<TerrainData> on_earth_, cut_;
};

} // namespace orograph
