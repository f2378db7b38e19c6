// SPDX-License-Identifier: GPL-3.0-or-later
// What a sweep costs beside its views: seconds of the processor for all of it, over those of its
// views drawn one by one as `render` does, with a report, since a row tells of the same, and one
// read of the terrain; and on the clock with two threads over one. In turn, several rounds, each
// printed; ratios are to be read within a round.
//
//   sweep_cost DEM [STEP_DEG [ROUNDS]]     a turn in steps of 5 degrees, 5 rounds unless told
//                                          otherwise; writes beneath the folder for temporary files
#include "cli/options/options.hpp"
#include "cli/render.hpp"
#include "cli/sweep/sweep.hpp"
#include "dem/read/read_terrain.hpp"

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <string>
#include <vector>

using namespace orograph;

namespace {

struct Spent {
  double clock_s, processor_s;
};

double processor_s() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

template <class Act>
Spent spent(const Act& act) {
  const auto clock = std::chrono::steady_clock::now();
  const double processor = processor_s();
  act();
  const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - clock;
  return {passed.count(), processor_s() - processor};
}

} // namespace

int main(int argc, char** argv) {
  if (argc < 2) return std::fputs("usage: sweep_cost DEM [STEP_DEG [ROUNDS]]\n", stderr), 2;
  const std::string dem = argv[1];
  const int step_deg = argc > 2 ? std::atoi(argv[2]) : 5;
  const int rounds = argc > 3 ? std::atoi(argv[3]) : 5;
  const auto folder = std::filesystem::temp_directory_path() / "orograph-sweep-cost";

  const auto sweep_with = [&](const char* jobs) {
    std::filesystem::remove_all(folder);
    const std::string turn = "0:360:" + std::to_string(step_deg);
    const auto settings =
        parse_sweep({dem, folder.string(), "--azimuth", turn, "--quiet", "--jobs", jobs});
    return spent([&] { sweep(*settings); });
  };
  // Each of these reads the terrain; that is measured as well, and taken off.
  const auto render_all = [&] {
    std::filesystem::remove_all(folder);
    std::filesystem::create_directories(folder);
    return spent([&] {
      for (int azimuth = 0; azimuth < 360; azimuth += step_deg) {
        const auto out = folder / (std::to_string(azimuth) + ".svg");
        render(*parse_render(
            {dem, out.string(), "--quiet", "--view-from", std::to_string(azimuth) + "/25"}));
      }
    });
  };
  const auto read_all = [&] {
    const auto settings = parse_render({dem, "unused.svg"});
    return spent([&] {
      for (int azimuth = 0; azimuth < 360; azimuth += step_deg)
        read_terrain(settings->inputs, settings->reading);
    });
  };

  sweep_with("1"); // warm
  for (int round = 0; round < rounds; ++round) {
    const Spent read = read_all(), rendered = render_all();
    const Spent one = sweep_with("1"), two = sweep_with("2");
    const double views = 360.0 / step_deg;
    const double own_s = rendered.processor_s - read.processor_s;
    std::printf("views' own %.3f s, a read %.3f s, sweep %.3f s of processor: %.3f; two threads: "
                "%.3f s on the clock after %.3f s: %.2f times faster\n",
                own_s, read.processor_s / views, one.processor_s,
                one.processor_s / (own_s + read.processor_s / views), two.clock_s, one.clock_s,
                one.clock_s / two.clock_s);
  }
  std::filesystem::remove_all(folder);
  return 0;
}
