// SPDX-License-Identifier: GPL-3.0-or-later
// Flat scenes that double precision finds hard, each drawn at random from one kind of trouble.
#pragma once

#include "geometry/vec.hpp"
#include "tests/horizon/flat_scenes.hpp"

#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace orograph {

struct HardKind {
  std::string name;
  int lists;
  /// Vertices of one list, left to right, of strictly rising x.
  std::function<std::vector<Vec2>(Random&, int list)> vertices;
};

// `count` vertices a step apart, with heights by number.
template <class Height>
std::vector<Vec2> evenly(int count, double first_x, double step, const Height& height) {
  std::vector<Vec2> out;
  for (int i = 0; i < count; ++i) out.push_back({first_x + i * step, height(i)});
  return out;
}

inline std::vector<HardKind> hard_kinds() {
  constexpr double ulp = std::numeric_limits<double>::epsilon();
  constexpr double least = std::numeric_limits<double>::denorm_min();
  const auto zigzag = [](double height) {
    return [height](int i) { return i % 2 ? height : 0.0; };
  };
  return {
      {"a few ulp from one zigzag", 20,
       [](Random& random, int) {
         const double first = random.share();
         return evenly(12, first, random.pick({1.0, 0.7}),
                       [&](int i) { return 1 + 0.1 * (i % 2) + ulp * random.whole(-3, 3); });
       }},
      {"a few ulp from one line", 20,
       [](Random& random, int) {
         const double first = random.share(), step = random.between(0.5, 1);
         return evenly(12, first, step, [&](int i) {
           return 1 + 0.3 * (first + i * step) + ulp * random.whole(-3, 3);
         });
       }},
      {"nearly parallel", 20,
       [](Random& random, int) {
         const double tilt = std::pow(10, -random.between(4, 16)), middle = random.between(-1, 1);
         const double first = random.share(), step = random.between(0.5, 1);
         return evenly(9, first, step, [&](int i) {
           const double x = first + i * step;
           return 1 + 0.3 * x + tilt * (x - 4 + middle);
         });
       }},
      {"needles", 20,
       [](Random& random, int) {
         std::vector<Vec2> out;
         for (int i = 0; i < 8; ++i) {
           const double x = i + random.share(), half = std::pow(10, -random.between(2, 14));
           const double base = 0.1 * random.share();
           out.insert(out.end(), {{x, base}, {x + half, 1 + random.share()}, {x + 3 * half, base}});
         }
         std::vector<Vec2> rising;
         for (const Vec2 v : out)
           if (rising.empty() || v.x > rising.back().x) rising.push_back(v);
         return rising;
       }},
      {"zigzags under gentle lines", 30,
       [=](Random& random, int list) {
         if (list == 0) return evenly(41, 0, 0.5, zigzag(1000));
         const double slope = random.between(-1, 1);
         return evenly(2, 0, 20, [&](int i) { return 10 * list + slope * i; });
       }},
      {"fans from one end", 30,
       [](Random& random, int list) {
         const double rise = random.whole(1, 7) / 3.0;
         if (list % 2) return evenly(3, 0.1, 1, [&](int i) { return 0.7 + i * rise; });
         return evenly(3, 0.1, 1, [&](int i) { return 0.7 + (2 - i) * rise; });
       }},
      {"the same list again, and its parts", 12,
       [](Random& random, int list) {
         Random heights(static_cast<std::uint64_t>(list / 4));
         auto all = evenly(10, 0, 1.0 / 3, [&](int) { return heights.share(); });
         if (list % 4 == 3) all.erase(all.begin() + random.whole(0, 8));
         return all;
       }},
      {"seven digits and millimetres", 20,
       [](Random& random, int list) {
         double x = 4123456 + random.whole(0, 1000) / 1000.0;
         std::vector<Vec2> out;
         for (int i = 0; i < 15; ++i, x += random.whole(1, 3000) / 1000.0)
           out.push_back({x, 5234567 + 0.1 * list + random.whole(0, 2000) / 1000.0});
         return out;
       }},
      {"denormals and signed zeros", 20,
       [=](Random& random, int) {
         return evenly(10, 0, 1, [&](int) {
           return random.chance(0.3) ? -0.0 : least * random.whole(-4, 8);
         });
       }},
      {"heights of 1e30 and 1e-30", 20, [](Random& random, int) {
         return evenly(10, 0, 1, [&](int) {
           return random.pick({1e30, 1e-30, 1.0, 0.0}) * random.whole(-2, 5);
         });
       }}};
}

inline FlatScene hard_scene(const HardKind& kind, std::uint64_t seed) {
  Random random(seed);
  FlatScene scene;
  for (int list = 0; list < kind.lists; ++list) {
    const std::vector<Vec2> vertices = kind.vertices(random, list);
    auto& segments = scene.emplace_back();
    for (std::size_t i = 0; i + 1 < vertices.size(); ++i)
      segments.push_back({vertices[i].x, vertices[i].y, vertices[i + 1].x, vertices[i + 1].y,
                          (static_cast<std::uint64_t>(list) << 32U) | i});
  }
  return scene;
}

} // namespace orograph
