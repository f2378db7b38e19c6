// SPDX-License-Identifier: GPL-3.0-or-later
// The visible silhouettes of a strip of X on their way to the drawing.
#pragma once

#include "hidden_lines/folds.hpp"
#include "hidden_lines/line_pictures.hpp"
#include "horizon/blocked_horizon.hpp"
#include "horizon/surface_line.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace orograph {

/// Tells ridges from folds as soon as it can be told, so that folds, of which rough ground has
/// millions, aren't kept. Of a line that is no longer part of the horizon nothing will be skyline;
/// and where all ground that was taken so far is within a fold's reach, what hides the line's ray
/// now is the ground that came up again. A fold's line is forgotten with it.
class Ridges {
public:
  /// `whole_ground`: no heights are missing. REQUIRES that both outlive it.
  Ridges(const Folds& folds, LinePictures& pictures, bool whole_ground)
      : folds_(folds), pictures_(pictures), whole_ground_(whole_ground) {}

  /// Takes the parts of a line, the last of `parts` from number `first` on; in `visible` they are
  /// shares of its picture. `stands`: all of them are part of the horizon.
  void take(const LinePicture& picture, std::span<const VisibleLinePart> visible, bool stands,
            std::vector<LinePart>& parts, std::size_t first);

  /// Ground was taken in front to back order, up to the depth `taken_to_m(x)` along the ray at an
  /// X. Judges what can be judged cheaply; it is to be called again and again.
  template <class TakenTo>
  void judge_early(const BlockedHorizon& horizon, const TakenTo& taken_to_m) {
    for (; next_ < waiting_.size(); ++next_) {
      Unjudged& unjudged = waiting_[next_];
      const double to_m = std::max(taken_to_m(unjudged.x_begin), taken_to_m(unjudged.x_end));
      if (to_m < unjudged.ask_at_m) break;
      const bool stands = this->stands(unjudged, horizon);
      const bool was_covered = unjudged.stood && !stands;
      // The ground in reach was taken a moment ago, and is at hand.
      unjudged.is_fold =
          (was_covered && whole_ground_ && to_m <= unjudged.reach_to_m) || is_fold(unjudged);
      if (stands)
        rest_.push_back(unjudged);
      else
        tell(unjudged, *unjudged.is_fold);
    }
    if (2 * next_ > waiting_.size()) {
      waiting_.erase(waiting_.begin(), waiting_.begin() + static_cast<std::ptrdiff_t>(next_));
      next_ = 0;
    }
    if (rest_.size() >= judge_at_) judge_rest(horizon);
  }
  /// Judges all that is no longer part of the horizon.
  void judge(const BlockedHorizon& horizon);

  const std::vector<LinePart>& ridges() const { return ridges_; }
  double folded_mm() const { return folded_mm_; } ///< length of the folds
  /// What isn't judged after `judge`.
  std::vector<LinePart> unjudged() const;

private:
  struct Unjudged {
    LinePart part;
    ProfilePoint middle;                        ///< of the part
    double x_begin, x_end;                      ///< of the line's picture
    double reach_to_m;                          ///< depth up to which ground makes it a fold
    double ask_at_m;                            ///< and from which on most folds are hidden
    double length_mm;                           ///< NaN: not reckoned yet
    bool is_all;                                ///< that is visible of its line
    bool stood;                                 ///< all of it, when it was taken
    std::optional<bool> is_fold = std::nullopt; ///< once it was asked
  };
  bool stands(const Unjudged& unjudged, const BlockedHorizon& horizon) const;
  bool is_fold(const Unjudged& unjudged) const;
  void tell(const Unjudged& judged, bool is_fold);
  void judge_rest(const BlockedHorizon& horizon);

  const Folds& folds_;
  LinePictures& pictures_;
  bool whole_ground_;
  std::vector<Unjudged> waiting_; ///< to be asked about early, about front to back
  std::size_t next_ = 0;          ///< of them
  std::vector<Unjudged> rest_;    ///< those that still stood
  std::size_t judge_at_ = 4096;   ///< how long the rest may get
  std::vector<LinePart> ridges_;
  double folded_mm_ = 0;
};

} // namespace orograph
