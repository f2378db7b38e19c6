// SPDX-License-Identifier: GPL-3.0-or-later
// What is changed, watched and timed of a run, beyond what a user may ask for.
#pragma once

#include "hidden_lines/line_pictures.hpp"
#include "hidden_lines/strips.hpp"
#include "horizon/clip.hpp"
#include "profiles/profile.hpp"

#include <chrono>
#include <cstdint>
#include <vector>

namespace orograph {

/// A profile as it was clipped. REQUIRES that all outlive it.
struct SeenProfile {
  const Sector& sector;
  XRange clipped; ///< what lies beside it may be visible or not
  const Profile& profile;
  const std::vector<Segment>& segments;
  const std::vector<Piece>& visible; ///< pieces of `segments`, in order
};

/// All other lines of a sector as they were clipped. REQUIRES that all outlive it.
struct SeenLines {
  const Sector& sector;
  XRange clipped;
  const LinePictures& lines;
  const std::vector<LinePart>& visible; ///< by line
  /// Of the lines that are listed, not found, those that may reach into the range, where that isn't
  /// all of them.
  const std::vector<std::uint32_t>* listed = nullptr;
};

/// Is told of every line of a drawing as it is clipped, before anything is laid out: the whole line
/// and what of it is visible. What it does counts as the stage `check`.
class LineObserver {
public:
  virtual ~LineObserver() = default;
  virtual void see(const SeenProfile& profile) = 0;
  /// The same profile with what shows the surface's underside, where it has one.
  virtual void see_underside(const SeenProfile&) {}
  /// Whether it wants to see lines, which have to be listed for it, hidden ones too.
  virtual bool asks_lines() const { return true; }
  virtual void see(const SeenLines& lines) = 0;
  /// The horizon behind the profile that was seen last; only where it is kept in one list.
  virtual void see_horizon(const Sector&, const Horizon&) {}
};

struct Instruments {
  std::vector<LineObserver*> observers = {}; ///< are told one after another
  bool collapse = true;                      ///< join horizon pieces of one source
  bool single_precision = false; ///< round projected profiles to float before they are clipped
  bool one_list = false;         ///< keep the horizon in one list, so that it can be seen
  bool beyond_page = false;      ///< look at what is beside the page as well
  bool hidden_ground = false;    ///< look at ground that is hidden as a whole as well
  bool ground_always = false;    ///< find hidden ground where that doesn't pay, too
  bool order_always = false;     ///< take grids in the lattice's order where it doesn't pay, too
  double vertices_a_strip = kVerticesAStrip;
  /// Lines of overlays that one pass takes. They have some 100 bytes each while they are in work; a
  /// pass of its own costs about as much as a tenth of them.
  std::size_t most_draped = std::size_t{1} << 21U;
  /// Gets every occluder but profiles, hidden ones too, before the profile that it stands in front
  /// of is seen.
  std::vector<HorizonPiece>* occluders = nullptr;

  /// Whether the horizon is to be kept in one list, profile after profile.
  bool needs_list() const { return one_list || !collapse || single_precision || occluders; }
  /// Whether ground that is hidden or beside the page has its lines. (Profiles are whole for an
  /// observer anyway.)
  bool looks_everywhere() const { return needs_list() || beyond_page || hidden_ground; }
};

/// Adds the time since the last mark, or since it was made, to a stage.
class Stopwatch {
public:
  void mark(double& stage_s) {
    const auto now = std::chrono::steady_clock::now();
    stage_s += std::chrono::duration<double>(now - last_).count();
    last_ = now;
  }

private:
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

} // namespace orograph
