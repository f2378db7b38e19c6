// SPDX-License-Identifier: GPL-3.0-or-later
// The terrain as one view needs it.
#pragma once

#include "dem/terrain.hpp"
#include "placing/map_spec.hpp"
#include "placing/terrain_facts.hpp"
#include "placing/terrain_for_views.hpp"

#include <memory>
#include <optional>
#include <utility>

namespace orograph {

/// The terrain without what is in front of the front plane or behind the back plane of the
/// view: a TIN, whose border runs along the planes. A note tells of it. Nothing where the
/// view has no such planes. Throws Error if nothing is left.
std::optional<TerrainData> cut_by_view(const TerrainData& terrain, const ViewSpec& view);

/// In the view's frame on the earth, if it is in degrees, and cut by the view's planes, if it has
/// any (docs/decisions/0010-sectors-and-planes.md); else the whole terrain itself. Heights of a
/// grid are shared, never copied. Where the page asks for larger cells it is a level of the terrain
/// (placing/level_of_detail.hpp).
class TerrainOfView {
public:
  /// With what other views have found out. REQUIRES that `whole` outlives it. Throws Error as
  /// `stand_on_earth` does, and where the view's planes leave nothing of the terrain.
  TerrainOfView(TerrainForViews& whole, const ViewSpec& view);
  /// The same for a view that is the only one. REQUIRES that `whole` outlives it. `facts` as of
  /// `TerrainForViews`.
  TerrainOfView(const TerrainData& whole, const ViewSpec& view,
                std::shared_ptr<const TerrainFacts> facts = nullptr);
  TerrainOfView(const TerrainOfView&) = delete;
  TerrainOfView& operator=(const TerrainOfView&) = delete;

  const TerrainData& operator*() const { return cut_ && !level_ ? *cut_ : uncut(); }
  const TerrainData* operator->() const { return &**this; }
  /// The same as the file's own surface, where it is a level.
  const TerrainData& without_level() const { return cut_ ? *cut_ : of_file(); }
  /// Whether it is the whole terrain itself.
  bool is_whole() const { return &**this == &whole_; }
  bool is_cut() const { return cut_.has_value(); }
  /// In the same frame, before the planes cut it.
  const TerrainData& uncut() const { return level_ ? level_->terrain : of_file(); }
  /// In the same frame, as the file has it.
  const TerrainData& of_file() const { return in_frame_->terrain(); }
  /// The same with what is found out about it, by other views as well.
  TerrainInFrame& in_frame() { return *in_frame_; }

  /// From now on it is this level. REQUIRES a terrain that isn't cut.
  void take_level(std::shared_ptr<const TerrainLevel> level) { level_ = std::move(level); }
  /// What is known of it as it stands. Null where the view's planes cut it.
  const TerrainFacts* facts() const;

private:
  const TerrainData& whole_;
  std::shared_ptr<TerrainInFrame> in_frame_;
  std::optional<TerrainData> cut_;
  std::shared_ptr<const TerrainLevel> level_;
};

} // namespace orograph
