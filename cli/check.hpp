// SPDX-License-Identifier: GPL-3.0-or-later
// `--check N`: random points of a drawing, asked of the ray walk, which shares no code with the
// clip.
#pragma once

#include "cli/judge.hpp"
#include "cli/line_sweep.hpp"
#include "cli/report.hpp"
#include "horizon/clip.hpp"
#include "profiles/profile.hpp"

#include <cstdint>
#include <random>
#include <vector>

namespace orograph {

/// Asks points of profiles and of lines, drawn or not, before anything is laid out on the page.
/// Half of them are anywhere, half close to where a drawn piece ends.
class Check {
public:
  /// REQUIRES that surface and view outlive the check.
  Check(const Surface& surface, const View& view, const TieTolerance& tolerance);

  /// `count` points of a profile, of which `visible` pieces of `segments` are drawn.
  void ask(const Profile& profile, const std::vector<Segment>& segments,
           const std::vector<Piece>& visible, std::uint64_t count);
  /// `count` points of the drawn lines, of which `visible` (by line) is drawn; within a range of X.
  void ask(const LineSweep& lines, const std::vector<LinePart>& visible, XRange range,
           std::uint64_t count);

  const CheckReport& counts() const { return counts_; }

private:
  double share();
  std::size_t below(std::size_t count);
  double near_end(double begin, double end);
  void judge(const ProfileLine& line, double t, bool on_edge, bool drawn);

  const View& view_;
  Judge judge_;
  std::mt19937_64 engine_{20240229}; ///< always the same: a check can be run again
  CheckReport counts_;
};

} // namespace orograph
