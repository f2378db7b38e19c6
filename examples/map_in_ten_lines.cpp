// SPDX-License-Identifier: GPL-3.0-or-later
// map_in_ten_lines DEM OUTPUT: the map that `orograph render DEM OUTPUT` draws.
#include <orograph.hpp>

#include <cstdio>

int main(int argc, char** argv) {
  if (argc != 3) return std::fprintf(stderr, "usage: map_in_ten_lines DEM OUTPUT\n"), 2;
  try {
    const orograph::Session session(orograph::Terrain::read({argv[1]}));
    const orograph::Format format = orograph::format_of_path(argv[2]);
    orograph::MapSpec spec;
    spec.pen_order = orograph::pen_order_for(format);
    if (orograph::has_one_width(format)) spec.style.light->by_density = true;
    const orograph::Map map = session.draw(spec);
    orograph::write_drawing(map.drawing, argv[2], {.format = format});
  } catch (const orograph::Error& error) {
    return std::fprintf(stderr, "%s\n", error.what()), 1;
  }
}
