// SPDX-License-Identifier: GPL-3.0-or-later
// The ground under a plane of constant depth as the page's columns see it.
#pragma once

#include "geometry/homography.hpp"
#include "geometry/panorama_page.hpp"
#include "profiles/cut_surface.hpp"
#include "view/view.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "tone/page_columns.hpp"

namespace orograph {

/// One profile, a value a column.
struct SampledProfile {
  double depth_m = 0;
  int level = 0; ///< how often the number of lines is halved before this one goes; below 0: added
  int halvings = 0; ///< of the planned step, of what is between it and the one in front of it
  std::vector<double> z_m; ///< NaN where no ground is
  std::vector<std::uint8_t> is_level;
  std::vector<float> x_mm, y_mm; ///< on the page; likewise
};

/// What columns, one behind the other, see in one visibility plane.
struct SampledSector {
  const SurfaceCutter& cutter;
  const View& view;
  const Homography& to_page;
  PageColumns columns;
};

/// Cuts and samples. Safe from several threads.
class ProfileSampler {
public:
  /// REQUIRES that all outlive it.
  ProfileSampler(const SurfaceCutter& cutter, const View& view, const Homography& to_page,
                 const PageColumns& columns)
      : sectors_{{cutter, view, to_page, columns}} {}
  /// Of a panorama, left to right.
  ProfileSampler(std::vector<SampledSector> sectors, const PanoramaPage& page)
      : sectors_(std::move(sectors)), page_(page) {}

  /// As many as go well together.
  static constexpr std::size_t kAtOnce = 4;

  /// The memory that a profile's samples take.
  void make_room(SampledProfile& profile) const;
  /// Of profiles of which depths, levels and halvings are known fills the rest in. REQUIRES that
  /// they have room, and that there are no more than kAtOnce.
  void sample(std::span<SampledProfile* const> profiles) const;

private:
  void sample(const SampledSector& sector, std::size_t first,
              std::span<SampledProfile* const> profiles) const;

  std::vector<SampledSector> sectors_;
  std::optional<PanoramaPage> page_;
};

} // namespace orograph
