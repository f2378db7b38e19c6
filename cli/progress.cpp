// SPDX-License-Identifier: GPL-3.0-or-later
// The bar 0...10...20 on stderr.
#include "cli/progress.hpp"

#include "cli/say.hpp"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace orograph {

namespace {
constexpr int kMarks = 40, kMarksToNumber = 4;
constexpr double kLong_s = 2; // shorter work tells nothing of its time
} // namespace

bool shows_progress(bool quiet, std::optional<bool> asked) {
  return !quiet && asked.value_or(isatty(::fileno(told_stream())) == 1);
}

ProgressBar::~ProgressBar() {
  if (marks_ >= 0 && !line_ended_) std::fputc('\n', told_stream());
}

void ProgressBar::show(double fraction) {
  if (!shown_ || line_ended_) return;
  const int reached = static_cast<int>(std::clamp(fraction, 0.0, 1.0) * kMarks);
  if (reached <= marks_) return;
  while (marks_ < reached) {
    ++marks_;
    if (marks_ % kMarksToNumber == 0) {
      std::fprintf(told_stream(), "%d", marks_ / kMarksToNumber * 10);
      if (marks_ == reached) tell_time_left(fraction);
    } else
      std::fputc('.', told_stream());
  }
  std::fflush(told_stream());
}

void ProgressBar::tell_time_left(double fraction) const {
  const double gone_s =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  if (gone_s < kLong_s || fraction >= 1) return;
  const double left_s = gone_s * (1 - fraction) / fraction;
  std::fprintf(told_stream(), " (%.0f s left)", std::ceil(left_s));
}

void ProgressBar::finish() {
  show(1);
  if (!shown_ || line_ended_) return;
  std::fputs(" - done.\n", told_stream());
  line_ended_ = true;
}

} // namespace orograph
