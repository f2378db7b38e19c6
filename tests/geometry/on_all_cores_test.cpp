// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/on_all_cores.hpp"
#include "tests/catch.hpp"

#include <atomic>
#include <stdexcept>
#include <vector>

using namespace orograph;

TEST_CASE("every task is done once, and what one throws comes out") {
  std::vector<std::atomic<int>> done(1000);
  on_all_cores(done.size(), [&](std::size_t i) { ++done[i]; });
  for (const auto& times : done) CHECK(times == 1);
  on_all_cores(0, [](std::size_t) { FAIL("there is none"); });
  const auto task = [](std::size_t i) {
    if (i == 7) throw std::runtime_error("seven");
  };
  CHECK_THROWS_AS(on_all_cores(10, task), std::runtime_error);
}

// As in a sweep of views, of which one fails while others are being drawn.
TEST_CASE("an error beside a loop doesn't take tasks from it") {
  for (int round = 0; round < 50; ++round) {
    std::atomic<int> begun = 0, done = 0;
    const auto view = [&](std::size_t i) {
      ++begun;
      if (i == 0) throw std::runtime_error("the disk is full");
      for (int k = 0; k < 20; ++k) {
        std::atomic<int> tasks = 0;
        on_all_cores(100, [&](std::size_t) { ++tasks; });
        done += tasks;
      }
    };
    CHECK_THROWS_AS(on_all_cores(8, view), std::runtime_error);
    // Those after the error may not have begun; what has begun is done as a whole.
    CHECK(done == 2000 * (begun - 1));
  }
}
