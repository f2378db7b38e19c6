// SPDX-License-Identifier: GPL-3.0-or-later
// What a place on the ellipsoid costs: whole rows of a lattice in degrees, over LocalCartesian a
// vertex, with the greatest distance between the two. A tile of a degree, 1.2 to 2.2 degrees from
// the origin; one thread, the least of several rounds.
//
//   frame_cost [VERTICES [ROUNDS]]     3601 a side and 5 unless told otherwise
#include "dem/frame/earth_lattice.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <vector>

using namespace orograph;

namespace {

template <class Act>
double seconds(const Act& act) {
  const auto start = std::chrono::steady_clock::now();
  act();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// One row of heights and what becomes of it.
template <class Height>
struct RowOf {
  std::vector<Height> heights_m;
  std::vector<double> x_m, y_m, z_m;
};
template <class Height>
RowOf<Height> hilly_row(int columns) {
  const auto count = static_cast<std::size_t>(columns);
  RowOf<Height> row{std::vector<Height>(count), std::vector<double>(count),
                    std::vector<double>(count), std::vector<double>(count)};
  for (std::size_t c = 0; c < count; ++c)
    row.heights_m[c] = static_cast<Height>(2000 + 1900 * std::sin(0.01 * static_cast<double>(c)));
  return row;
}

template <class Height>
double row_ns(const EarthLattice& places, int rounds) {
  const DegreeLattice& lattice = places.degrees();
  RowOf<Height> row = hilly_row<Height>(lattice.columns);
  double least_s = std::numeric_limits<double>::infinity(), sum = 0;
  for (int round = 0; round < rounds; ++round)
    least_s = std::min(least_s, seconds([&] {
                         for (int r = 0; r < lattice.rows; ++r) {
                           places.row_vertices_m(r, 0, row.heights_m, row.x_m, row.y_m, row.z_m);
                           sum += row.x_m.front() + row.y_m.back() + row.z_m.back();
                         }
                       }));
  if (std::isnan(sum)) std::puts("not a number");
  return 1e9 * least_s / lattice.columns / lattice.rows;
}

double vertex_ns(const LocalFrame& frame, const DegreeLattice& lattice, int rounds) {
  const RowOf<float> row = hilly_row<float>(lattice.columns);
  double least_s = std::numeric_limits<double>::infinity();
  Vec3 sum;
  for (int round = 0; round < rounds; ++round)
    least_s =
        std::min(least_s, seconds([&] {
                   for (int r = 0; r < lattice.rows; ++r)
                     for (int c = 0; c < lattice.columns; ++c)
                       sum = sum + frame.to_frame(lattice.lon_deg(c), lattice.lat_deg(r),
                                                  1.5 * row.heights_m[static_cast<std::size_t>(c)]);
                 }));
  if (std::isnan(sum.x)) std::puts("not a number");
  return 1e9 * least_s / lattice.columns / lattice.rows;
}

double greatest_distance_m(const EarthLattice& places, const LocalFrame& frame) {
  const DegreeLattice& lattice = places.degrees();
  const RowOf<double> row = hilly_row<double>(lattice.columns);
  double greatest_m = 0;
  for (int r = 0; r < lattice.rows; r += 7)
    for (int c = 0; c < lattice.columns; c += 3) {
      const double h_m = row.heights_m[static_cast<std::size_t>(c)];
      const Vec3 exact = frame.to_frame(lattice.lon_deg(c), lattice.lat_deg(r), h_m);
      greatest_m = std::max(greatest_m, length(places.vertex_m(c, r, h_m) - exact));
    }
  return greatest_m;
}

} // namespace

int main(int argc, char** argv) {
  const int vertices = argc > 1 ? std::atoi(argv[1]) : 3601;
  const int rounds = argc > 2 ? std::atoi(argv[2]) : 5;
  for (const double north_deg : {1.0, 45.0, 85.0}) {
    const double step_deg = 1. / (vertices - 1);
    const DegreeLattice lattice{-72, step_deg, vertices, north_deg, -step_deg, vertices};
    const LocalFrame frame(-70.7, north_deg - 2.2);
    const double tables_s = seconds([&] { EarthLattice(lattice, frame); });
    const EarthLattice places(lattice, frame);
    std::printf("%d x %d to latitude %g: tables %.2f ms; a vertex in ns: rows of float %.2f, of "
                "double %.2f; LocalCartesian %.1f; greatest distance %.1e m\n",
                vertices, vertices, north_deg, 1e3 * tables_s, row_ns<float>(places, rounds),
                row_ns<double>(places, rounds), vertex_ns(frame, lattice, std::min(rounds, 2)),
                greatest_distance_m(places, frame));
  }
}
