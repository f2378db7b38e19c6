// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>

namespace orograph {

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
