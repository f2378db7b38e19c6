// SPDX-License-Identifier: GPL-3.0-or-later
// Prints how every family of hard scenes comes out (docs/stability.md).
// usage: stability [SCENES-A-FAMILY [FIRST-SEED [FAMILY]]]   (1000, 1, all)
#include "geometry/on_all_cores.hpp"
#include "tests/stability/hard_families.hpp"
#include "tests/stability/judged_view.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <mutex>
#include <string>
#include <string_view>

using namespace orograph;

namespace {

constexpr std::uint64_t kPointsAScene = 10;

Judged judge_family(const HardFamily& family, std::uint64_t scenes, std::uint64_t first_seed) {
  Judged sum;
  std::mutex lock;
  constexpr std::uint64_t kATask = 256;
  on_all_cores((scenes + kATask - 1) / kATask, [&](std::size_t task) {
    Judged some;
    for (std::uint64_t i = task * kATask; i < std::min(scenes, (task + 1) * kATask); ++i) {
      const std::uint64_t seed = first_seed + i;
      Random random(seed);
      HardScene scene = family.make(random);
      Judged one = judge_view(std::move(scene.terrain), scene.spec, kPointsAScene, seed,
                              random.chance(0.25));
      if (one.wrong > 0) one.first_wrong = fmt::format("seed {}: {}", seed, one.first_wrong);
      some.add(one);
    }
    const std::lock_guard guard(lock);
    sum.add(some);
  });
  return sum;
}

void print_row(std::string_view name, const Judged& sum) {
  fmt::print("| {} | {} | {} | {} | {:.2f} | {:.2f} | {} | {} | {:.0e} |\n", name,
             sum.scenes - sum.refused, sum.points, sum.ties,
             100.0 * static_cast<double>(sum.ties) /
                 static_cast<double>(std::max<std::uint64_t>(1, sum.points)),
             100.0 * static_cast<double>(sum.in_rounding) /
                 static_cast<double>(std::max<std::uint64_t>(1, sum.points)),
             sum.wrong, sum.ends, sum.farthest_mm);
  std::fflush(stdout);
}

} // namespace

int main(int argc, char** argv) {
  try {
    const std::uint64_t scenes = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 1000;
    const std::uint64_t first_seed = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 1;
    fmt::print("| family | scenes | points | ties | ties, % | in rounding, % | wrong | ends | "
               "farthest, mm |\n|---|--:|--:|--:|--:|--:|--:|--:|--:|\n");
    Judged all;
    for (const HardFamily& family : hard_families()) {
      if (argc > 3 && family.name.find(argv[3]) == std::string::npos) continue;
      const Judged sum = judge_family(family, scenes, first_seed);
      print_row(family.name, sum);
      if (sum.wrong > 0) fmt::print(stderr, "{}: {}\n", family.name, sum.first_wrong);
      all.add(sum);
    }
    print_row("all", all);
    return all.wrong == 0 ? 0 : 1;
  } catch (const std::exception& error) {
    fmt::print(stderr, "stability: {}\n", error.what());
    return 1;
  }
}
