// SPDX-License-Identifier: GPL-3.0-or-later
// The progress bar, on a stderr that is a file for the while.
#include "cli/progress.hpp"
#include "tests/catch.hpp"

#include <unistd.h>

#include <array>
#include <cstdio>
#include <functional>
#include <string>

using namespace orograph;

namespace {

std::string drawn_on_stderr(const std::function<void()>& draw) {
  std::FILE* const file = std::tmpfile();
  REQUIRE(file != nullptr);
  std::fflush(stderr);
  const int kept = ::dup(STDERR_FILENO);
  ::dup2(::fileno(file), STDERR_FILENO);
  draw();
  std::fflush(stderr);
  ::dup2(kept, STDERR_FILENO);
  ::close(kept);
  std::rewind(file);
  std::array<char, 1000> text{};
  const auto length = std::fread(text.data(), 1, text.size(), file);
  std::fclose(file);
  return {text.data(), length};
}

} // namespace

TEST_CASE("a bar grows to its end, however the fractions come") {
  const std::string whole = "0...10...20...30...40...50...60...70...80...90...100 - done.\n";
  CHECK(drawn_on_stderr([] { ProgressBar(true).finish(); }) == whole);
  CHECK(drawn_on_stderr([] {
          ProgressBar bar(true);
          for (int i = 0; i <= 1000; ++i) bar.show(i / 1000.0);
          bar.show(0.2); // never back
          bar.show(7);
          bar.finish();
          bar.finish();
        }) == whole);
}

TEST_CASE("an unfinished bar ends its line") {
  CHECK(drawn_on_stderr([] {
          ProgressBar bar(true);
          bar.show(0.13);
        }) == "0...10.\n");
  CHECK(drawn_on_stderr([] { ProgressBar bar(true); }) == "");
}

TEST_CASE("a bar that isn't shown draws nothing") {
  CHECK(drawn_on_stderr([] {
          ProgressBar bar(false);
          bar.show(0.5);
          bar.finish();
        }) == "");
  CHECK_FALSE(shows_progress(true, std::nullopt));
  CHECK_FALSE(shows_progress(false, false));
  CHECK(shows_progress(false, true));
}
