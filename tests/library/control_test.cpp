// SPDX-License-Identifier: GPL-3.0-or-later
// Progress, stop and jobs: they end a call or tell of it, and never change what comes back.
#include "tests/catch.hpp"
#include "tests/library/made_ground.hpp"

#include <time.h>

#include <algorithm>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace orograph::control_test {

namespace {

double seconds_of(clockid_t clock) {
  timespec at{};
  ::clock_gettime(clock, &at);
  return static_cast<double>(at.tv_sec) + 1e-9 * static_cast<double>(at.tv_nsec);
}

const int kSmallSide = made_side(80);

Session small_session() {
  return Session(Terrain::of(borrowed(rough_heights(kSmallSide), kSmallSide)));
}

// Ends with ErrorCode::cancelled.
void check_cancelled(const Session& session, const MapSpec& spec, const Control& control) {
  try {
    session.draw(spec, control);
    FAIL("it wasn't stopped");
  } catch (const Error& error) {
    CHECK(error.code() == ErrorCode::cancelled);
    CHECK(error.wrong() == "the work was stopped");
  }
}

} // namespace

TEST_CASE("progress rises from 0 to 1, told by one thread at a time") {
  const Session session = small_session();
  for (const MapSpec& spec : enough_specs(kSmallSide)) {
    std::vector<double> told;
    bool is_telling = false, overlapped = false;
    Control control;
    control.progress = [&](double share) {
      overlapped = overlapped || is_telling;
      is_telling = true;
      told.push_back(share);
      is_telling = false;
    };
    session.draw(spec, control);
    REQUIRE(told.size() > 5);
    CHECK(std::is_sorted(told.begin(), told.end()));
    CHECK(told.front() > 0);
    CHECK(told.back() == Approx(1));
    CHECK(!overlapped);
  }
}

TEST_CASE("the number of threads never changes a drawing", "[unsanitized]") {
  const Session session = small_session();
  for (const MapSpec& spec : enough_specs(kSmallSide)) {
    const std::string drawn = drawn_bytes(session, spec);
    for (const int jobs : {1, 2, 99}) CHECK((drawn_bytes(session, spec, {.jobs = jobs}) == drawn));
  }
  CHECK_THROWS_AS(session.draw({}, {.jobs = -1}), Error);
}

TEST_CASE("one job is the caller's thread") {
  constexpr int kLarge = 700;
  const Session session(Terrain::of(borrowed(rough_heights(kLarge), kLarge)));
  const double all_s = seconds_of(CLOCK_PROCESS_CPUTIME_ID);
  const double own_s = seconds_of(CLOCK_THREAD_CPUTIME_ID);
  session.draw({}, {.jobs = 1});
  const double by_all_s = seconds_of(CLOCK_PROCESS_CPUTIME_ID) - all_s;
  const double by_own_s = seconds_of(CLOCK_THREAD_CPUTIME_ID) - own_s;
  CHECK(by_own_s > 0.01);
  CHECK(by_all_s < 1.2 * by_own_s); // others' threads go to sleep
}

TEST_CASE("what is stopped before it begins does nothing") {
  std::stop_source stop;
  stop.request_stop();
  int told = 0;
  const Control control{.progress = [&](double) { ++told; }, .stop = stop.get_token()};
  check_cancelled(small_session(), {}, control);
  CHECK(told == 0);
  const std::string dem = std::string(OROGRAPH_SOURCE_DIR) + "/data_samples/volcano.tif";
  try {
    Terrain::read({dem}, {}, control);
    FAIL("it wasn't stopped");
  } catch (const Error& error) {
    CHECK(error.code() == ErrorCode::cancelled);
  }
}

TEST_CASE("stopped in the midst of the profiles, a session draws as before", "[unsanitized]") {
  const Session session = small_session();
  for (const MapSpec& spec : enough_specs(kSmallSide)) {
    const std::string drawn = drawn_bytes(session, spec);
    for (const double at : {0.0, 0.9})
      for (const int jobs : {0, 1}) {
        std::stop_source stop;
        double last = 0;
        Control control{.stop = stop.get_token(), .jobs = jobs};
        control.progress = [&](double share) {
          last = share;
          if (share > at) stop.request_stop();
        };
        check_cancelled(session, spec, control);
        CHECK(last > at);
        CHECK((drawn_bytes(session, spec) == drawn));
      }
  }
}

TEST_CASE("what progress throws comes out as it is, and the session draws as before",
          "[unsanitized]") {
  const Session session = small_session();
  for (const MapSpec& spec : enough_specs(kSmallSide)) {
    const std::string drawn = drawn_bytes(session, spec);
    for (const int jobs : {0, 1}) {
      const Control control{.progress =
                                [](double share) {
                                  if (share > 0.5) throw std::out_of_range("the window is closed");
                                },
                            .jobs = jobs};
      CHECK_THROWS_WITH(session.draw(spec, control), "the window is closed");
      CHECK_THROWS_AS(session.draw(spec, control), std::out_of_range);
      CHECK((drawn_bytes(session, spec) == drawn));
    }
  }
}

} // namespace orograph::control_test
