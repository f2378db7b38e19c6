// SPDX-License-Identifier: GPL-3.0-or-later
// What comes of calls to the system that fail, one after another.
#include "tests/catch.hpp"
#include "tests/faults/walked_commands.hpp"

#include <algorithm>
#include <cstdlib>
#include <iostream>

namespace orograph::faults_test {
namespace {

// A word of the environment, so that the walk of docs/stability.md can be taken in parts.
std::string asked(const char* name, const char* otherwise) {
  const char* const value = std::getenv(name);
  return value ? value : otherwise;
}

} // namespace

TEST_CASE("a call that fails leaves a right file, or one line and none") {
  std::size_t faults = 0, refused = 0;
  for (const WalkedCommand& command : walked_commands()) {
    const bool is_exact = command.name == "fragmentation"; // GMP's memory, above all
    if (!is_exact && command.name != "svg over an older one" && command.name != "gpkg" &&
        command.name != "sweep")
      continue;
    const Walk found =
        walk(command, is_exact ? std::vector<std::string>{"memory"} : fault_kinds(), 2);
    faults += found.faults;
    refused += found.refused;
    for (const std::string& wrong : found.wrong) FAIL_CHECK(wrong);
  }
  CHECK(faults > 30);
  CHECK(refused > faults / 3);
}

TEST_CASE("no memory right behind any open leaves a right file, or one line and none") {
  for (const WalkedCommand& command : walked_commands()) {
    if (command.name != "a report") continue;
    const Walk found = walk(command, {"opened"}, 1000);
    CHECK(found.faults > 5);
    CHECK(found.refused > 1);
    for (const std::string& wrong : found.wrong) FAIL_CHECK(wrong);
  }
}

// The whole walk, by hand: OROGRAPH_WALK_EACH calls of each kind (50) of the commands whose names
// hold OROGRAPH_WALK_COMMAND (all).
TEST_CASE("the whole walk", "[.walk][slow]") {
  const std::size_t each = std::strtoul(asked("OROGRAPH_WALK_EACH", "50").c_str(), nullptr, 10);
  const std::string of = asked("OROGRAPH_WALK_COMMAND", ""),
                    kind_of = asked("OROGRAPH_WALK_KIND", "");
  std::size_t faults = 0, wrong = 0;
  for (const std::string& kind : fault_kinds()) {
    if (!kind_of.empty() && kind != kind_of) continue;
    Walk all;
    for (const WalkedCommand& command : walked_commands()) {
      if (command.name.find(of) == command.name.npos) continue;
      const Walk found = walk(command, {kind}, each);
      all.faults += found.faults;
      all.refused += found.refused;
      all.ended_by_others += found.ended_by_others;
      all.wrong.insert(all.wrong.end(), found.wrong.begin(), found.wrong.end());
      for (const std::string& one : found.wrong) std::cout << one << std::endl;
      std::cout << kind << ", " << command.name << ": " << found.faults << " faults, "
                << found.refused << " refused, " << found.ended_by_others << " ended by others, "
                << found.wrong.size() << " wrong" << std::endl;
    }
    std::cout << "| " << kind << " | " << all.faults << " | " << all.refused << " | "
              << all.ended_by_others << " | " << all.wrong.size() << " |" << std::endl;
    faults += all.faults;
    wrong += all.wrong.size();
  }
  CHECK(faults > 0);
  CHECK(wrong == 0);
}

} // namespace orograph::faults_test
