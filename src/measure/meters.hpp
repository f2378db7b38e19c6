// SPDX-License-Identifier: GPL-3.0-or-later
// What is wrong with a drawing on paper, by the ray walk. Ink error: how much of its lines is drawn
// but hidden, or visible but missing. Displacement: how far the ends of drawn pieces are from where
// the line truly disappears.
#pragma once

#include "hidden_lines/instruments.hpp"
#include "map/check.hpp"
#include "map/line_on_page.hpp"
#include "placing/placed_view.hpp"
#include "reference/judge.hpp"

#include <cstdint>
#include <optional>
#include <random>
#include <vector>

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

struct EndSample {
  std::uint64_t asked = 0;
  std::uint64_t tied = 0;   ///< there the line is within the tolerance of what is in front
  std::uint64_t astray = 0; ///< no true end within kFarthestEnd_mm: the ink around is wrong
  double largest_mm = 0;    ///< of the others
};

constexpr double kFarthestEnd_mm = 10;

/// From ends of drawn pieces, taken at random where a line goes on but is hidden, looks for the
/// true end nearest along the line, by the ray walk and bisection. Where line and horizon cross at
/// so small an angle that they stay closer to each other than that, their distance counts
/// (docs/how-it-works.md).
class EndMeter : public LineObserver {
public:
  /// At most so many ends of each profile, and of the other lines.
  struct Wanted {
    std::uint64_t of_profile, of_lines;
  };
  /// REQUIRES that all outlive the meter.
  EndMeter(const Surface& surface, const PlacedView& scene, const MapSpec& spec, Wanted wanted);

  void see(const SeenProfile& profile) override;
  void see(const SeenLines& lines) override;

  const EndSample& ends() const { return ends_; }

private:
  // A straight stretch of a path; a path goes on from stretch to stretch up to `run_end`.
  struct Stretch {
    ProfileLine line;
    LineOnPage picture;
    double start_mm;
    std::size_t run_begin, run_end;
  };
  struct End {
    std::size_t stretch;
    double at_mm;   ///< from the beginning of the run
    double forward; ///< 1 where the drawn piece lies farther along the path, else -1
  };
  void trace(const Profile& profile, const std::vector<Segment>& segments);
  void add_end(std::size_t stretch, double t, double forward);
  void measure_some(std::uint64_t count, bool on_edge);
  void measure(const End& end, bool on_edge);
  ProfilePoint at(const Stretch& of_run, double mm) const;
  double above_mm(ProfilePoint p, bool on_edge) const;

  const PlacedView& scene_;
  const Sector* sector_ = nullptr; ///< that is being seen
  double tolerance_mm_;
  bool draws_level_;
  std::vector<Judge> judges_; ///< by sector
  Wanted wanted_;
  std::mt19937_64 engine_{20240302}; ///< always the same: a measurement can be made again
  std::vector<Stretch> path_;
  std::vector<std::size_t> stretch_of_; ///< segment to stretch
  std::vector<End> found_;
  EndSample ends_;
};

} // namespace orograph
