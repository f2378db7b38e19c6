// SPDX-License-Identifier: GPL-3.0-or-later
// heights_in_memory: heights that a program has computed go in without a copy, lines come out, on
// the page and on the ground. Prints the ground points of the skyline, a stroke after another.
#include <orograph.hpp>

#include <cmath>
#include <cstdio>
#include <memory>
#include <vector>

int main() {
  constexpr int kSize = 400; // cells of 25 m
  auto heights = std::make_shared<std::vector<float>>();
  for (int row = 0; row < kSize; ++row)
    for (int column = 0; column < kSize; ++column) {
      const double x = column * 0.025 - 5, y = 5 - row * 0.025; // km
      heights->push_back(static_cast<float>(900 * std::exp(-0.3 * (x * x + y * y)) +
                                            120 * std::sin(2 * x) * std::cos(1.5 * y)));
    }

  orograph::GridInput input;
  input.columns = input.rows = kSize;
  input.heights = std::span<const float>(*heights);
  input.owner = heights; // is kept for as long as the terrain lives
  input.geotransform = {600000, 25, 0, 5200000, 0, -25};
  input.crs = "EPSG:32632";
  input.name = "two waves and a hill";
  const float* const first = heights->data();
  heights.reset();
  if (*first < -1e4) return 1; // they are still there

  orograph::MapSpec spec;
  spec.view.from_elevation = orograph::Angle::degrees(12);
  spec.style.layers = {"skyline"};
  spec.ground_points = true;
  try {
    const orograph::Session session(orograph::Terrain::of(input));
    const orograph::Map map = session.draw(spec);
    for (const orograph::Layer& layer : map.drawing.layers)
      for (const orograph::Stroke& stroke : layer.strokes) {
        for (std::uint32_t i = 0; i < stroke.point_count; ++i) {
          const orograph::Vec3 at = layer.map[stroke.first_point + i];
          std::printf("%.1f %.1f %.1f\n", at.x, at.y, at.z);
        }
        std::printf("\n");
      }
    std::fprintf(stderr, "%llu strokes, %.0f mm of ink\n",
                 static_cast<unsigned long long>(map.facts.counts.strokes), map.facts.pen_down_mm);
  } catch (const orograph::Error& error) {
    return std::fprintf(stderr, "%s\n", error.what()), 1;
  }
}
