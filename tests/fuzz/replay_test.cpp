// SPDX-License-Identifier: GPL-3.0-or-later
// Each target on the files of its folder in corpus/: seeds, and what once showed a fault.
#include "tests/catch.hpp"
#include "tests/fuzz/fuzz_targets.hpp"

#include <cstddef>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

namespace orograph::replay_test {

TEST_CASE("what fuzzing has kept shows no fault") {
  const std::filesystem::path corpus = OROGRAPH_SOURCE_DIR "/tests/fuzz/corpus";
  for (const FuzzTarget& target : fuzz_targets()) {
    std::size_t files = 0;
    for (const auto& entry : std::filesystem::directory_iterator(corpus / target.name)) {
      std::ifstream file(entry.path(), std::ios::binary);
      const std::vector<char> bytes(std::istreambuf_iterator<char>(file), {});
      INFO(entry.path());
      try {
        target.run({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()});
      } catch (const std::exception& error) {
        FAIL_CHECK(error.what());
      }
      ++files;
    }
    INFO(target.name);
    CHECK(files > 0);
  }
}

} // namespace orograph::replay_test
