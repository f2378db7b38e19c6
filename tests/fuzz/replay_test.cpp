// SPDX-License-Identifier: GPL-3.0-or-later
// Each target on the files of its folder in corpus/, and on what was kept in gathered/.
#include "tests/catch.hpp"
#include "tests/fuzz/fuzz_targets.hpp"
#include "tests/support/slow_build.hpp"

#include <cstddef>
#include <cstdint>
#include <exception>
#include <filesystem>
#include <fstream>
#include <ios>
#include <iterator>
#include <string>
#include <vector>

namespace orograph::replay_test {
namespace {

const std::filesystem::path kHere = OROGRAPH_SOURCE_DIR "/tests/fuzz";

std::string bytes_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

// The cases of a file that scripts/fuzz-cases has kept.
std::vector<std::string> kept_cases(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::vector<std::string> cases;
  for (std::size_t length = 0; file >> length;) {
    file.get(); // the newline
    file.read(cases.emplace_back(length, '\0').data(), static_cast<std::streamsize>(length));
    REQUIRE(file);
  }
  return cases;
}

void run(const FuzzTarget& target, const std::string& bytes) {
  try {
    target.run({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()});
  } catch (const std::exception& error) {
    FAIL_CHECK(error.what());
  }
}

} // namespace

TEST_CASE("seeds of fuzzing, and what once showed a fault, show none") {
  for (const FuzzTarget& target : fuzz_targets()) {
    std::size_t files = 0;
    for (const auto& entry : std::filesystem::directory_iterator(kHere / "corpus" / target.name)) {
      INFO(entry.path());
      run(target, bytes_of(entry.path()));
      ++files;
    }
    INFO(target.name);
    CHECK(files > 0);
  }
}

// All of it where a sanitizer looks on, which is what it was gathered for; elsewhere a fourth.
TEST_CASE("what fuzzing has gathered shows no fault") {
  const std::size_t step = is_slow_build() ? 1 : 4;
  for (const FuzzTarget& target : fuzz_targets()) {
    const std::vector<std::string> cases = kept_cases(kHere / "gathered" / target.name);
    for (std::size_t i = 0; i < cases.size(); i += step) {
      INFO(target.name << ", case " << i << " of " << cases.size());
      run(target, cases[i]);
    }
    INFO(target.name);
    CHECK(!cases.empty());
  }
}

} // namespace orograph::replay_test
