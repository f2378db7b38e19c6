// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/on_all_cores.hpp"
#include "tests/catch.hpp"

#include <atomic>
#include <chrono>
#include <stdexcept>
#include <thread>
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
  using std::chrono::milliseconds;
  const auto wait_for = [](const auto& is_so) { // a second at most: there may be one core only
    for (int i = 0; i < 1000 && !is_so(); ++i) std::this_thread::sleep_for(milliseconds(1));
  };
  for (int round = 0; round < 3; ++round) {
    std::atomic<int> begun = 0, done = 0;
    std::atomic<bool> failed = false;
    const auto view = [&](std::size_t i) {
      ++begun;
      if (i == 0) {
        wait_for([&] { return begun > 1; });
        failed = true;
        throw std::runtime_error("the disk is full");
      }
      on_all_cores(100, [&](std::size_t) {
        wait_for([&] { return failed.load(); });
        std::this_thread::sleep_for(milliseconds(1)); // for the error to be told
        ++done;
      });
    };
    CHECK_THROWS_AS(on_all_cores(4, view), std::runtime_error);
    // Those after the error may not have begun; what has begun is done as a whole.
    CHECK(done == 100 * (begun - 1));
  }
}
