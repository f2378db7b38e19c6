// SPDX-License-Identifier: GPL-3.0-or-later
// The bar 0...10...20 on stderr.
#include "cli/progress.hpp"

#include <unistd.h>

#include <algorithm>
#include <cstdio>

namespace orograph {

namespace {
constexpr int kMarks = 40, kMarksToNumber = 4;
}

bool shows_progress(bool quiet, std::optional<bool> asked) {
  return !quiet && asked.value_or(isatty(STDERR_FILENO) == 1);
}

ProgressBar::~ProgressBar() {
  if (marks_ >= 0 && !line_ended_) std::fputc('\n', stderr);
}

void ProgressBar::show(double fraction) {
  if (!shown_ || line_ended_) return;
  const int reached = static_cast<int>(std::clamp(fraction, 0.0, 1.0) * kMarks);
  if (reached <= marks_) return;
  while (marks_ < reached) {
    ++marks_;
    if (marks_ % kMarksToNumber == 0)
      std::fprintf(stderr, "%d", marks_ / kMarksToNumber * 10);
    else
      std::fputc('.', stderr);
  }
  std::fflush(stderr);
}

void ProgressBar::finish() {
  show(1);
  if (!shown_ || line_ended_) return;
  std::fputs(" - done.\n", stderr);
  line_ended_ = true;
}

} // namespace orograph
