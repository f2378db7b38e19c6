// SPDX-License-Identifier: GPL-3.0-or-later
// Random points of a drawing, asked of the ray walk, which shares no code with the clip.
#pragma once

#include "hidden_lines/instruments.hpp"
#include "map/map_facts.hpp"
#include "map/tied_with_drawn.hpp"
#include "reference/closed_block_judge.hpp"
#include "reference/judge.hpp"
#include "reference/sheet_judge.hpp"

#include <cstdint>
#include <optional>
#include <random>
#include <vector>

namespace orograph {

/// Asks points of profiles and of the other lines, drawn or not, half of them each, before anything
/// is laid out on the page. Half of them are anywhere, half close to where a drawn piece ends.
class Check : public LineObserver {
public:
  /// About `points` points of what will be seen of a placed view. REQUIRES that terrain and view
  /// outlive the check. `both_sides`: the surface is a sheet, or where it was placed as a block
  /// that is closed below.
  Check(const TerrainData& terrain, const PlacedView& placed, double tolerance_mm,
        std::uint64_t points, bool both_sides);
  /// From now on it asks what is drawn alone.
  void ask_drawn_alone() { drawn_alone_ = true; }

  void see(const SeenProfile& profile) override;
  void see_underside(const SeenProfile& profile) override;
  void see(const SeenLines& lines) override;

  const CheckCounts& counts() const { return counts_; }

private:
  void begin(const Sector& sector);
  double share();
  std::size_t below(std::size_t count);
  double near_end(double begin, double end);
  /// Whether there was anything to ask.
  bool ask_line(const SeenLines& seen, std::uint32_t line, double t);
  void judge(const ProfileLine& line, double t, bool on_edge, bool drawn);
  void judge(const ProfileLine& line, double t, const SheetJudge::Drawn& drawn);
  void ask_profile(const SeenProfile& profile, const std::vector<Piece>& upper);

  const TerrainData& terrain_;
  std::optional<double> block_base_m_;
  double tolerance_mm_;
  bool drawn_alone_ = false;
  std::uint64_t a_profile_, a_sector_; ///< points asked of each profile, and of a sector's lines
  std::uint64_t owed_ = 0;             ///< points that profiles haven't been asked yet
  const Sector* sector_ = nullptr;     ///< the one that is seen
  bool both_sides_;
  std::optional<Judge> judge_;                  ///< of that sector
  std::optional<SheetJudge> sheet_judge_;       ///< the same of a sheet
  std::optional<ClosedBlockJudge> block_judge_; ///< and of a closed block
  TieTolerance tolerance_;                      ///< in the sector
  TiedWithDrawn undrawn_;                       ///< what both sides show and isn't drawn
  std::vector<Piece> upper_; ///< of the sheet's profile: what shows the upper side
  std::mt19937_64 engine_;
  CheckCounts counts_;
};

/// One judge for each sector of a placed view, with this visibility tolerance. REQUIRES that both
/// outlive them.
std::vector<Judge> judges_of(const Surface& surface, const PlacedView& placed, double tolerance_mm);

} // namespace orograph
