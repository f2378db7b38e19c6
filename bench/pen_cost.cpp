// SPDX-License-Identifier: GPL-3.0-or-later
// What a pen's order saves, and what it costs: of 10^3 to 10^5 strokes the way through the air over
// the ink, and seconds. On `fractal_alps` as it comes, with ever closer profiles, and on strokes
// scattered over a sheet, which are the hardest. The last columns are memory, as far as it grew.
//
//   pen_cost [MOST]     strokes, 100000 unless told otherwise
#include "data_samples/terrains.hpp"
#include "draw/pen_order.hpp"
#include "draw/round_drawing.hpp"
#include "map/draw_map.hpp"
#include "placing/placed_view.hpp"
#include "tests/support/random.hpp"

#include <fmt/format.h>
#include <sys/resource.h>

#include <chrono>
#include <cmath>
#include <cstdlib>
#include <string>

using namespace orograph;

namespace {

double peak_mb() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024;
}

std::size_t strokes_of(const Drawing& drawing) {
  std::size_t count = 0;
  for (const Layer& layer : drawing.layers) count += layer.strokes.size();
  return count;
}

// Of 2 mm each, on a sheet that grows with them.
Drawing scattered(std::size_t count) {
  Random random(1);
  const double side_mm = 3 * std::sqrt(static_cast<double>(count));
  Drawing drawing;
  Layer& layer = drawing.layers.emplace_back();
  for (std::size_t i = 0; i < count; ++i) {
    const Vec2 at{random.between(0, side_mm), random.between(0, side_mm)};
    const double turn = random.between(0, 6.283);
    layer.strokes.push_back(
        {.first_point = static_cast<std::uint32_t>(layer.page_mm.size()), .point_count = 2});
    layer.page_mm.push_back(at);
    layer.page_mm.push_back(at + 2.0 * Vec2{std::cos(turn), std::sin(turn)});
  }
  round_to_page_step(layer);
  return drawing;
}

Drawing mountains(double page_mm) {
  MapSpec spec;
  spec.page.width_mm = page_mm;
  spec.page.height_mm.reset();
  spec.style.light.reset();
  static const TerrainData terrain = [] {
    TerrainData made;
    made.surface = make_terrain(MadeTerrain::fractal_alps, 1000);
    return made;
  }();
  return draw_map(terrain, placed_view(terrain, spec), spec, [](double) {}).drawing;
}

void measure(const std::string& name, const Drawing& drawing) {
  fmt::print("{:<10}{:>8}", name, strokes_of(drawing));
  const auto print_ratio = [](const Drawing& of) {
    const PenTravel travel = pen_travels(of).all;
    fmt::print("{:>9.3f}", travel.up_mm / travel.down_mm);
  };
  print_ratio(drawing);
  for (const PenOrder order : {PenOrder::sorted, PenOrder::best}) {
    Drawing ordered = drawing;
    const double before_mb = peak_mb();
    const auto begin = std::chrono::steady_clock::now();
    order_for_pen(ordered, order);
    const double seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    print_ratio(ordered);
    fmt::print("{:>9.3f} s{:>7.0f} MB", seconds, peak_mb() - before_mb);
  }
  fmt::print("\n");
}

} // namespace

int main(int argc, char** argv) {
  const double most = argc > 1 ? std::atof(argv[1]) : 1e5;
  fmt::print("{:<10}{:>8}{:>9}{:>9}{:>11}{:>10}{:>9}{:>11}{:>10}\n", "", "strokes", "drawing",
             "sorted", "", "", "best", "", "");
  for (double count = 1e3; count < 1.01 * most; count *= std::sqrt(10.0))
    measure("scattered", scattered(static_cast<std::size_t>(std::round(count))));
  for (double page_mm = 150; page_mm <= 3000; page_mm *= 2) {
    const Drawing drawing = mountains(page_mm);
    if (static_cast<double>(strokes_of(drawing)) <= 1.5 * most) measure("mountains", drawing);
  }
}
