// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/levels/level_windows.hpp"

#include <algorithm>
#include <cmath>

namespace orograph {
double LevelWindow::weight(int at) const {
  return 1 - std::abs(at - middle) / reach;
}

int LevelWindow::nearest() const {
  return static_cast<int>(std::lround(middle));
}

LevelWindow LevelWindow::from(int start) const {
  return {middle - start,   reach, first - start, last - start, first_near - start,
          last_near - start};
}

int vertices_for(int vertices, int step) {
  return std::max(2, static_cast<int>(std::lround((vertices - 1.0) / step)) + 1);
}

std::vector<LevelWindow> windows_about(const std::vector<double>& places, double step,
                                       int vertices) {
  std::vector<LevelWindow> windows;
  const auto within = [&](double at) {
    return static_cast<int>(std::clamp(at, 0.0, vertices - 1.0));
  };
  for (const double middle : places) {
    const double reach = std::min({step, middle + 1, vertices - middle});
    windows.push_back({middle, reach, within(std::floor(middle - reach) + 1),
                       within(std::ceil(middle + reach) - 1), within(std::ceil(middle - reach / 2)),
                       within(std::floor(middle + reach / 2))});
  }
  return windows;
}

std::vector<LevelWindow> stretched_windows(int vertices, int made) {
  const double step = (vertices - 1.0) / (made - 1);
  std::vector<double> places;
  for (int i = 0; i < made; ++i) places.push_back(i == made - 1 ? vertices - 1 : i * step);
  return windows_about(places, step, vertices);
}

int nested_vertices(int vertices, int step) {
  return (vertices - 2 + step) / step + 1;
}

} // namespace orograph
