// SPDX-License-Identifier: GPL-3.0-or-later
// Walking along a straight line in whole numbers.
#pragma once

#include <cstdint>

namespace orograph {

/// from + i * rise / count for i = 0, 1, … as a whole number and a rest, exactly.
class WholeSteps {
public:
  /// REQUIRES count > 0.
  WholeSteps(int from, int rise, int count)
      : whole_(from), step_(rise / count), rest_step_(rise % count), count_(count) {
    if (rest_step_ < 0) {
      --step_;
      rest_step_ += count;
    }
  }

  void next() {
    whole_ += step_;
    rest_ += rest_step_;
    if (rest_ >= count_) {
      rest_ -= count_;
      ++whole_;
    }
  }

  int floor() const { return whole_; }
  int ceiling() const { return whole_ + (rest_ > 0 ? 1 : 0); }
  bool is_whole() const { return rest_ == 0; }
  /// What is beyond the floor, from 0 to below 1.
  double share() const { return static_cast<double>(rest_) / static_cast<double>(count_); }

private:
  int whole_, step_;
  std::int64_t rest_ = 0, rest_step_, count_;
};

} // namespace orograph
