// SPDX-License-Identifier: GPL-3.0-or-later
// What one stage costs, while others run in between.
#pragma once

#include "bench/stages/allocations.hpp"

#include <chrono>

namespace orograph {

/// Adds up seconds and allocations of what is between `start` and `stop`.
class Meter {
public:
  void start() {
    allocated_ = allocations_so_far();
    started_ = Clock::now();
  }
  void stop() {
    seconds += std::chrono::duration<double>(Clock::now() - started_).count();
    const Allocations more = allocations_so_far() - allocated_;
    allocations.count += more.count;
    allocations.bytes += more.bytes;
  }
  template <class Act>
  void measure(const Act& act) {
    start();
    act();
    stop();
  }

  double seconds = 0;
  Allocations allocations;

private:
  using Clock = std::chrono::steady_clock;

  Clock::time_point started_;
  Allocations allocated_;
};

} // namespace orograph
