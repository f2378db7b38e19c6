// SPDX-License-Identifier: GPL-3.0-or-later
#include "hidden_lines/sector_in_work.hpp"

namespace orograph {

std::vector<Segment> near_cut(const SectorInWork& work) {
  const View& view = work.sector.view;
  std::vector<Segment> segments, uprights;
  if (!view.is_perspective()) return segments;
  constexpr std::uint32_t kNumber = 0x7fffffff; // no profile has it
  Profile cut;
  work.cutter.cut(view.near_m, cut);
  project_profile(cut, kNumber, view, segments, uprights);
  return segments;
}

} // namespace orograph
