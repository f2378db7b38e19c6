// SPDX-License-Identifier: GPL-3.0-or-later
// Which names stand on one line: the best of all sets.
#include "tests/catch.hpp"
#include "tests/support/random.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "naming/choose_names.hpp"
#include "naming/rank_names.hpp"

namespace orograph::choose_names_test {
namespace {

NameWeight sum_of(const std::vector<NameOnLine>& names, const std::vector<std::size_t>& chosen) {
  NameWeight sum;
  for (const std::size_t i : chosen) sum = sum + names[i].weight;
  return sum;
}

// The greatest sum over all subsets.
NameWeight best_sum(const std::vector<NameOnLine>& names, double pitch_mm, std::size_t most) {
  NameWeight best;
  for (std::size_t set = 0; set < std::size_t{1} << names.size(); ++set) {
    std::vector<std::size_t> chosen;
    for (std::size_t i = 0; i < names.size(); ++i)
      if (set >> i & 1U) chosen.push_back(i);
    if (chosen.size() > most) continue;
    bool fits = true;
    for (std::size_t a = 0; a < chosen.size() && fits; ++a)
      for (std::size_t b = 0; b < a && fits; ++b)
        fits = std::abs(names[chosen[a]].x_mm - names[chosen[b]].x_mm) >= pitch_mm;
    if (fits) best = std::max(best, sum_of(names, chosen));
  }
  return best;
}

} // namespace

TEST_CASE("the names on a line are the best of all sets") {
  std::mt19937 engine(20261125);
  const auto below = [&](unsigned count) { return static_cast<int>(engine() % count); };
  for (int round = 0; round < rounds(2000); ++round) {
    // Most are small; some have all of 18 names.
    const int count = round % 100 == 0 ? 18 : below(12);
    const double pitch_mm = 0.25 * (1 + below(24));
    std::vector<NameOnLine> names;
    for (int i = 0; i < count; ++i) // places and weights that are often equal
      names.push_back({0.25 * below(100), {below(6), 1 + below(20)}});
    const bool has_most = round % 3 == 0;
    const auto most = static_cast<std::size_t>(below(6));
    const auto chosen =
        choose_on_line(names, pitch_mm, has_most ? std::optional(most) : std::nullopt);
    CAPTURE(round, count, pitch_mm, has_most, most);
    CHECK(sum_of(names, chosen) == best_sum(names, pitch_mm, has_most ? most : names.size()));
    if (has_most) CHECK(chosen.size() <= most);
    for (std::size_t i = 1; i < chosen.size(); ++i)
      CHECK(names[chosen[i]].x_mm - names[chosen[i - 1]].x_mm >= pitch_mm);
  }
}

TEST_CASE("ranks and the choice don't depend on the order in which names come") {
  std::mt19937 engine(7);
  std::vector<std::string> texts;
  for (int i = 0; i < 60; ++i) texts.push_back("summit " + std::to_string(i % 20));
  std::vector<NamedSummit> summits;
  for (std::size_t i = 0; i < texts.size(); ++i)
    summits.push_back({texts[i], 100.0 * static_cast<double>(engine() % 5), static_cast<double>(i),
                       0, static_cast<double>(engine() % 7) - 2,
                       1000.0 * static_cast<double>(1 + engine() % 3)});
  const auto chosen_of = [](const std::vector<NamedSummit>& given) {
    const RankedNames ranks = ranked(given, 120e3);
    std::vector<NameOnLine> names;
    for (std::size_t i = 0; i < given.size(); ++i)
      names.push_back({std::fmod(given[i].east * 7, 60), ranks.weights[i]});
    std::vector<double> out;
    for (const std::size_t i : choose_on_line(names, 3)) out.push_back(given[i].east);
    return out;
  };
  const std::vector<double> expected = chosen_of(summits);
  REQUIRE(expected.size() > 10);
  for (int round = 0; round < 50; ++round) {
    std::shuffle(summits.begin(), summits.end(), engine);
    CHECK(chosen_of(summits) == expected);
  }
}

TEST_CASE("what is far counts less, and what is subordinate less still") {
  const std::vector<NamedSummit> summits{{"near", 900, 0, 0, 100, 1e3},
                                         {"far", 900, 1, 0, 100, 100e3},
                                         {"sunk and near", 900, 2, 0, -100, 1e3},
                                         {"sunk and far", 900, 3, 0, -100, 100e3}};
  const RankedNames ranks = ranked(summits, 120e3);
  CHECK(ranks.order == std::vector<std::size_t>{0, 1, 2, 3});
  CHECK(ranks.weights[0].value == std::int64_t{1} << 40);
  CHECK(ranks.weights[2].value == 0);
  CHECK(ranks.weights[2] > ranks.weights[3]);
}

} // namespace orograph::choose_names_test
