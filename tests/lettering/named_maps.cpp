// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/lettering/named_maps.hpp"

#include "tests/dem/temp_folder.hpp"
#include "tests/library/made_ground.hpp"

#include <fmt/format.h>

#include <fstream>

namespace orograph {

Overlays names_of(const std::vector<NamedPoint>& points, const Terrain& terrain) {
  const TempFolder folder;
  std::ofstream file(folder.file("names.csv"), std::ios::binary);
  file << "name,x,y\n";
  for (const auto& [map, name] : points) {
    std::string quoted;
    for (const char c : name) quoted += c == '"' ? "\"\"" : std::string(1, c);
    file << fmt::format("\"{}\",{},{}\n", quoted, map.x, map.y);
  }
  file.close();
  return Overlays::read({{.path = folder.file("names.csv")}}, terrain);
}

std::vector<NamedPoint> random_names(Random& random, int side, int count) {
  const double half_m = 14 * side;
  const GivenPlace in_middle = middle(side);
  std::vector<NamedPoint> out;
  for (int i = 0; i < count; ++i) {
    std::string name = random.pick({std::string("Peak"), std::string("Mönch & Eiger"),
                                    std::string("The <long> name of a mountain without end"),
                                    std::string("הר"), std::string("W")});
    name += " " + std::to_string(i);
    out.push_back({{in_middle.x + random.between(-half_m, half_m),
                    in_middle.y + random.between(-half_m, half_m)},
                   name});
  }
  return out;
}

MapSpec random_named_spec(Random& random, int side) {
  MapSpec spec;
  spec.style.layers = {"skyline", "border", "silhouettes"};
  spec.view.projection =
      random.pick({Projection::perspective, Projection::orthographic, Projection::oblique,
                   Projection::cylindrical, Projection::equirectangular});
  const bool is_round = is_panorama(spec.view.projection);
  if (is_round || (spec.view.projection == Projection::perspective && random.chance(0.5))) {
    spec.view.eye_map = middle(side);
    spec.view.eye_height_m = random.between(20, 600);
  }
  spec.view.from_azimuth = Angle::degrees(random.whole(0, 359));
  spec.view.from_elevation = Angle::degrees(random.pick({5, 20, 45, 90}));
  if (is_round) {
    spec.page.strips = random.whole(1, 4);
    spec.labels.angle = Angle::degrees(random.pick({0, 30, 60, 90}));
    spec.labels.rows = random.whole(1, 4);
  }
  spec.page.width_mm = random.whole(100, 500);
  spec.page.height_mm.reset();
  spec.labels.size_mm = random.between(1.5, 4);
  if (random.chance(0.3)) spec.labels.elevation = LabelElevation::metres;
  if (random.chance(0.5)) {
    spec.furniture.pieces = {Furniture::title, Furniture::neatline, Furniture::caption};
    spec.title = "A map";
    if (is_round)
      spec.furniture.pieces.insert(spec.furniture.pieces.end(),
                                   {Furniture::azimuths, Furniture::altitudes});
  }
  if (!is_round && random.chance(0.5)) {
    spec.style.layers.insert(spec.style.layers.end(), {"contours", "graticule"});
    spec.labels.contours = spec.labels.coordinates = true;
  }
  return spec;
}

} // namespace orograph
