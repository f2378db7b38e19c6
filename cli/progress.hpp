// SPDX-License-Identifier: GPL-3.0-or-later
// The bar 0...10...20 that people know from GDAL's tools, on stderr.
#pragma once

#include <chrono>
#include <optional>

namespace orograph {

/// Whether to show a bar: never when quiet; as asked; else where stderr is a terminal.
bool shows_progress(bool quiet, std::optional<bool> asked);

/// A line on stderr that grows with the work: a mark for each 2.5 %, the number at each 10 %, with
/// the time that is left once two seconds have gone, and " - done." at the end. The destructor ends
/// an unfinished line, so that an error's line stands by itself.
class ProgressBar {
public:
  explicit ProgressBar(bool shown) : shown_(shown) {}
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  /// `fraction` of the work done, 0 to 1; one smaller than before changes nothing. Cheap enough for
  /// every profile.
  void show(double fraction);
  /// All is done.
  void finish();

private:
  void tell_time_left(double fraction) const;

  bool shown_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  int marks_ = -1; ///< drawn so far, the last; 40 is the whole
  bool line_ended_ = false;
};

} // namespace orograph
