// SPDX-License-Identifier: GPL-3.0-or-later
#include "figures/house.hpp"

namespace orograph {
namespace {

enum Side : std::size_t { south, north, east, west, east_roof, west_roof, floor };

constexpr double kWidth_m = 8, kLength_m = 12, kEaves_m = 5, kRidge_m = 8;

// A rectangle on the southern gable: x to the right; or on the eastern wall: y to the right.
void add_opening(House& house, Side side, Vec2 low, Vec2 high) {
  const auto on_wall = [&](double right, double up) {
    return side == south ? Vec3{right, 0, up} : Vec3{kWidth_m, right, up};
  };
  const std::array corners{on_wall(low.x, low.y), on_wall(high.x, low.y), on_wall(high.x, high.y),
                           on_wall(low.x, high.y)};
  for (std::size_t i = 0; i < 4; ++i)
    house.lines.push_back({corners[i], corners[(i + 1) % 4], {side, side}});
}

} // namespace

House house() {
  // A gable's corners, from the floor's south-western (or north-western) one, counterclockwise for
  // who stands in the south.
  const auto gable = [](double y) {
    return std::array<Vec3, 5>{{{0, y, 0},
                                {kWidth_m, y, 0},
                                {kWidth_m, y, kEaves_m},
                                {kWidth_m / 2, y, kRidge_m},
                                {0, y, kEaves_m}}};
  };
  const auto front = gable(0), rear = gable(kLength_m);
  // What lies between two neighbouring corners of the gables.
  constexpr std::array<Side, 5> along{floor, east, east_roof, west_roof, west};

  House house;
  house.faces.resize(7);
  house.faces[south] = {front[0], front[1], front[2]};
  house.faces[north] = {rear[0], rear[2], rear[1]};
  for (std::size_t i = 0; i < 5; ++i) {
    const std::size_t next = (i + 1) % 5;
    house.faces[along[i]] = {front[i], rear[i], front[next]};
    house.lines.push_back({front[i], front[next], {south, along[i]}});
    house.lines.push_back({rear[i], rear[next], {north, along[i]}});
    house.lines.push_back({front[i], rear[i], {along[i], along[(i + 4) % 5]}});
  }
  add_opening(house, south, {1, 0}, {2.6, 2.6}); // a door
  add_opening(house, south, {4.4, 1.2}, {6.8, 2.8});
  for (const double y : {1.5, 5.0, 8.5}) add_opening(house, east, {y, 1.5}, {y + 2, 3.5});
  return house;
}

} // namespace orograph
