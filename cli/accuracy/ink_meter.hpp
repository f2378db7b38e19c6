// SPDX-License-Identifier: GPL-3.0-or-later
// Ink error: how much of a drawing's lines is drawn but hidden, or visible but missing.
#pragma once

#include "reference/judge.hpp"

#include <cstdint>
#include <optional>
#include <random>

#include "hidden_lines/instruments.hpp"
#include "map/check.hpp"
#include "map/line_on_page.hpp"
#include "placing/placed_view.hpp"

namespace orograph {

/// Random points of lines, as many to each millimetre on the page.
struct InkSample {
  std::uint64_t asked = 0, ties = 0;
  std::uint64_t visible = 0;             ///< truly
  std::uint64_t hidden = 0, missing = 0; ///< drawn but hidden, visible but not drawn
  double length_mm = 0;                  ///< of the lines, visible or not

  /// Length that is wrong over length truly visible; 0 where nothing is visible.
  double error() const;
  /// Of `error`, one standard deviation.
  double standard_error() const;
  /// Where no point is wrong: the error that 95 of 100 such samples would have shown.
  double smallest_seen() const;
};

InkSample operator+(const InkSample& a, const InkSample& b);

/// Asks the ray walk of a point at random in every `stride_mm` of the lines that a view shows,
/// their hidden parts included. Where it is given full heights, the lines stand for theirs: each
/// point is asked of the full heights' surface above the same ground, in the same view, and how far
/// the two are apart on the page is measured as well. Only profiles are asked of then, since a
/// silhouette of other heights is another line.
class InkMeter : public LineObserver {
public:
  /// REQUIRES that all outlive the meter. A stride of infinity only measures lengths.
  InkMeter(const Surface& surface, const PlacedView& scene, const MapSpec& spec, double stride_mm,
           const Surface* full_heights);

  void see(const SeenProfile& profile) override;
  void see(const SeenLines& lines) override;

  const InkSample& profiles() const { return profiles_; }
  const InkSample& lines() const { return lines_; }
  /// The farthest that a drawn profile's point was from its place by full heights, mm.
  double farthest_mm() const { return farthest_mm_; }

private:
  template <class IsDrawn>
  void ask(const Sector& sector, const ProfileLine& line, bool on_edge, const IsDrawn& is_drawn,
           InkSample& sample);
  void judge(const Sector& sector, const ProfileLine& line, double t, bool on_edge, bool drawn,
             InkSample& sample);
  double share();
  const Judge& judge_of(const Sector& sector) const { return judges_[sector.behind ? 1 : 0]; }

  const PlacedView& scene_;
  const Surface* full_;
  bool draws_level_;
  std::vector<Judge> judges_;        ///< by sector
  std::mt19937_64 engine_{20240301}; ///< always the same: a measurement can be made again
  double stride_mm_, to_next_mm_, rest_of_stride_mm_;
  InkSample profiles_, lines_;
  double farthest_mm_ = 0;
};

} // namespace orograph
