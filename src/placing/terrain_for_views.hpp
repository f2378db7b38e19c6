// SPDX-License-Identifier: GPL-3.0-or-later
// A terrain that several views are drawn of, and what one of them finds out for the others.
#pragma once

#include "dem/levels/departure.hpp"
#include "dem/levels/summits.hpp"
#include "dem/terrain.hpp"
#include "geometry/box.hpp"
#include "geometry/vec.hpp"
#include "placing/map_spec.hpp"
#include "placing/terrain_facts.hpp"

#include <condition_variable>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

namespace orograph {

/// Where the origin of the ground frame of a terrain in degrees is put, and by how much heights are
/// exaggerated before the earth curves them away.
struct GroundOrigin {
  Vec2 place_map;
  double exaggeration = 1;

  bool operator==(const GroundOrigin&) const = default;
};

/// Of a terrain in degrees: puts the origin of its ground frame below the eye, where no eye is
/// given below the target, else in the terrain's middle, and exaggerates its heights, before the
/// earth curves them away. A view in a file has its directions in the frame below its own eye, of a
/// parallel view at its VRP. Other terrains are left as they are. Throws the Errors of `place_eye`
/// and of `reframe`.
void stand_on_earth(TerrainData& terrain, const ViewSpec& view);

/// A level of a terrain, and what is known of it, which refers to it.
struct TerrainLevel {
  TerrainData terrain;
  TerrainFacts facts;
};

/// A level that views of any place may show, and how far it is from the file's surface.
struct MadeLevel {
  double step = 1; ///< of the file's cells to one
  std::shared_ptr<const TerrainLevel> level;
  Departure departure;
  std::vector<Summit> summits;
};

/// A terrain in one ground frame. Several threads may use it at a time.
class TerrainInFrame {
public:
  explicit TerrainInFrame(std::shared_ptr<const TerrainData> terrain,
                          std::shared_ptr<const TerrainFacts> facts = nullptr)
      : terrain_(std::move(terrain)), facts_(std::move(facts)) {}

  const TerrainData& terrain() const { return *terrain_; }
  /// They are found by the first view that asks; others that come meanwhile wait for them, and the
  /// next one finds them where that one is stopped.
  const TerrainFacts& facts();
  /// The level that was made last, which other views mostly want as well: it is a third of what
  /// drawing a view of mountains takes. None where it isn't of this step.
  std::shared_ptr<const MadeLevel> level_of_step(double step) const;
  void keep(std::shared_ptr<const MadeLevel> made);

private:
  const std::shared_ptr<const TerrainData> terrain_;
  mutable std::mutex mutex_;
  std::condition_variable sought_;
  bool are_sought_ = false; ///< facts
  std::shared_ptr<const TerrainFacts> facts_;
  std::shared_ptr<const MadeLevel> made_;
};

/// On a map plane all views have one frame. On the earth the last one is kept: those that are seen
/// from outside of the terrain, or from one eye, mostly have the same. Several threads may use it
/// at a time.
class TerrainForViews {
public:
  /// `facts`: of the terrain on its map plane, where they are known.
  explicit TerrainForViews(std::shared_ptr<const TerrainData> whole,
                           std::shared_ptr<const TerrainFacts> facts = nullptr)
      : whole_(std::move(whole)),
        on_plane_(std::make_shared<TerrainInFrame>(whole_, std::move(facts))) {}

  const TerrainData& whole() const { return *whole_; }
  /// Throws as `stand_on_earth` does.
  std::shared_ptr<TerrainInFrame> in_frame_of(const ViewSpec& view);

private:
  const std::shared_ptr<const TerrainData> whole_;
  const std::shared_ptr<TerrainInFrame> on_plane_;
  std::mutex mutex_;
  std::optional<Box3> true_box_; ///< of heights as they are, on the earth
  std::optional<GroundOrigin> last_origin_;
  std::shared_ptr<TerrainInFrame> last_on_earth_;
};

} // namespace orograph
