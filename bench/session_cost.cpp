// SPDX-License-Identifier: GPL-3.0-or-later
// How long drawings of one terrain take in memory, reading and writing left out: milliseconds on
// the clock of the next views of a session (by defaults; without light and even tone; skyline and
// silhouettes alone, as a preview has them), each the least of several rounds over views all round,
// with the stages that the drawing tells of. Freed memory is kept, as the command keeps it
// (decision 66) and as a program that draws many maps had better do.
//
//   session_cost DEM [ROUNDS [JOBS [KIND]]]     5 rounds, on all cores (JOBS 0), all kinds
//
// KIND is default, plain or lines: what a view finds in memory depends on those drawn before it, so
// that builds are best compared by one kind a process.
#include "orograph.hpp"

#include <malloc.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>
#include <vector>

using namespace orograph;

namespace {

struct Drawn {
  double clock_ms;
  StageSeconds stages;
};

Drawn draw(const Session& session, const MapSpec& spec, const Control& control) {
  const auto begin = std::chrono::steady_clock::now();
  const Map map = session.draw(spec, control);
  const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - begin;
  return {1e3 * passed.count(), map.facts.seconds};
}

void measure(const char* what, const Session& session, MapSpec spec, int rounds,
             const Control& control) {
  Drawn least = draw(session, spec, control); // the first view of its kind is not the measure
  const double first_ms = least.clock_ms;
  least.clock_ms = 1e9;
  for (int round = 0; round < rounds; ++round) {
    const Drawn drawn = draw(session, spec, control);
    if (drawn.clock_ms < least.clock_ms) least = drawn;
  }
  const StageSeconds& s = least.stages;
  std::printf("%-28s %6.1f ms (the first %.1f): facing %.1f, cut %.1f, project %.1f, "
              "clip %.1f, layout %.1f\n",
              what, least.clock_ms, first_ms, 1e3 * s.facing, 1e3 * s.cut, 1e3 * s.project,
              1e3 * s.clip, 1e3 * s.layout);
}

} // namespace

int main(int argc, char** argv) {
  const std::string_view kind = argc > 4 ? argv[4] : "";
  if (argc < 2 || (argc > 4 && kind != "default" && kind != "plain" && kind != "lines"))
    return std::fputs("usage: session_cost DEM [ROUNDS [JOBS [default|plain|lines]]]\n", stderr), 2;
  mallopt(M_MMAP_MAX, 0);
  mallopt(M_TRIM_THRESHOLD, -1);
  const int rounds = argc > 2 ? std::atoi(argv[2]) : 5;
  Control control;
  control.jobs = argc > 3 ? std::atoi(argv[3]) : 0;
  const Session session(Terrain::read({argv[1]}));
  MapSpec by_default, plain, preview;
  plain.style.light.reset();
  plain.style.spread = Spread::planes;
  preview = plain;
  preview.style.layers = {"skyline", "silhouettes"};
  const auto measure_if = [&](std::string_view asked, const char* what, const MapSpec& spec) {
    if (kind.empty() || kind == asked) measure(what, session, spec, rounds, control);
  };
  measure_if("default", "by default", by_default);
  measure_if("plain", "without light and even tone", plain);
  measure_if("lines", "skyline and silhouettes", preview);
  return 0;
}
