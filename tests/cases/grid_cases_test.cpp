// SPDX-License-Identifier: GPL-3.0-or-later
// Hard cases of the whole program as text files, *.grid.txt: each is drawn, and every layer of it
// asked of the ray walk. A file holds, a line each:
//   # the caption, which says what must come out
//   cell M [M]               columns and rows apart; 1 without it
//   origin X Y               of the north-west vertex; 0 0 without it
//   row H H H …              heights of a row, from the north; - where there is none
//   rows COUNT H H H …       that many such rows
//   view-from AZ EL          orthographic
//   perspective AZ EL        the same in perspective
//   eye X Y Z X Y Z          the eye and what it looks at, with a field of 60 degrees
//   every M                  metres of depth from profile to profile, the first after half of it
//   layer NAME STROKES MM    what must be drawn in a layer, and how long it is in all, to 0.01 mm;
//                            "any" for either where the check alone decides
#include "geometry/error.hpp"
#include "map/draw_map.hpp"
#include "tests/catch.hpp"
#include "tests/support/grid_of.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>

namespace orograph::grid_cases_test {
namespace {

struct WantedLayer {
  std::string name, strokes, length_mm;
};

struct Case {
  std::string caption;
  TerrainData terrain;
  MapSpec spec;
  std::vector<WantedLayer> layers;
};

// strtod, unlike a stream, reads denormals.
double number_of(const std::string& word) {
  if (word == "-") return std::numeric_limits<double>::quiet_NaN();
  char* end = nullptr;
  const double number = std::strtod(word.c_str(), &end);
  INFO(word);
  REQUIRE(*end == '\0');
  return number;
}

std::vector<double> numbers_in(std::istringstream& words) {
  std::vector<double> out;
  for (std::string word; words >> word;) out.push_back(number_of(word));
  return out;
}

void add_rows(Grid& grid, int count, const std::vector<double>& row) {
  const auto& before = std::get<Heights<double>>(grid.heights_m);
  std::vector<double> heights(before.begin(), before.end());
  for (int i = 0; i < count; ++i) heights.insert(heights.end(), row.begin(), row.end());
  grid.heights_m = std::move(heights);
  if (grid.rows == 0) grid.columns = static_cast<int>(row.size());
  REQUIRE(row.size() == static_cast<std::size_t>(grid.columns));
  grid.rows += count;
}

void read_line(Case& scene, const std::string& word, std::istringstream& words) {
  Grid& grid = grid_of(scene.terrain);
  MapSpec& spec = scene.spec;
  if (word == "layer") {
    WantedLayer wanted;
    words >> wanted.name >> wanted.strokes >> wanted.length_mm;
    scene.layers.push_back(wanted);
    return;
  }
  std::vector<double> n = numbers_in(words);
  if (word == "cell") {
    grid.plane().column_step_m = {n.at(0), 0};
    grid.plane().row_step_m = {0, -n.back()};
  } else if (word == "origin") {
    grid.plane().first_vertex_m = {n.at(0), n.at(1)};
  } else if (word == "row") {
    add_rows(grid, 1, n);
  } else if (word == "rows") {
    const int count = static_cast<int>(n.at(0));
    n.erase(n.begin());
    add_rows(grid, count, n);
  } else if (word == "view-from" || word == "perspective") {
    spec.view.projection =
        word == "perspective" ? Projection::perspective : Projection::orthographic;
    spec.view.from_azimuth = Angle::degrees(n.at(0));
    spec.view.from_elevation = Angle::degrees(n.at(1));
  } else if (word == "eye") {
    spec.view.projection = Projection::perspective;
    spec.view.eye_map = Vec3{n.at(0), n.at(1), n.at(2)};
    spec.view.look_at_map = Vec3{n.at(3), n.at(4), n.at(5)};
    spec.view.field_of_view = Angle::degrees(60);
  } else {
    REQUIRE(word == "every");
    spec.style.plan = GroundSpacing{n.at(0)};
  }
}

Case read_case(const std::filesystem::path& path) {
  Case scene;
  grid_of(scene.terrain) = {0, 0, PlaneLattice{{}, {1, 0}, {0, -1}}, std::vector<double>()};
  scene.spec.view.exaggeration = 1;
  scene.spec.style.flat = FlatGround::draw;
  scene.spec.style.simplify_mm = 0;
  scene.spec.style.silhouette_jump = 0;
  scene.spec.check = 4000;
  std::ifstream file(path);
  for (std::string line; std::getline(file, line);) {
    INFO(path.filename() << ": " << line);
    std::istringstream words(line);
    std::string word;
    if (!(words >> word)) continue;
    if (word == "#")
      scene.caption += line.substr(2) + " ";
    else
      read_line(scene, word, words);
  }
  REQUIRE(!scene.caption.empty());
  REQUIRE(!scene.layers.empty());
  return scene;
}

double length_mm(const Layer& layer) {
  double sum = 0;
  for (const Stroke& stroke : layer.strokes) {
    const auto points = layer.points(stroke);
    for (std::size_t i = 0; i + 1 < points.size(); ++i) sum += length(points[i + 1] - points[i]);
  }
  return sum;
}

void check_layer(const Drawing& drawing, const WantedLayer& wanted) {
  CAPTURE(wanted.name);
  const auto layer = std::find_if(drawing.layers.begin(), drawing.layers.end(),
                                  [&](const Layer& l) { return l.name == wanted.name; });
  REQUIRE(layer != drawing.layers.end());
  if (wanted.strokes != "any")
    CHECK(layer->strokes.size() == static_cast<std::size_t>(number_of(wanted.strokes)));
  // Page points are rounded to 1e-4 mm.
  if (wanted.length_mm != "any")
    CHECK(std::abs(length_mm(*layer) - number_of(wanted.length_mm)) <= 0.01);
}

void check_case(const Case& wanted) {
  const PlacedView scene = placed_view(wanted.terrain, wanted.spec);
  const Map drawn = draw_map(wanted.terrain, scene, wanted.spec, [](double) {});
  const auto fault = find_fault(drawn.drawing);
  INFO(fault.value_or(""));
  CHECK(!fault);
  REQUIRE(drawn.facts.check);
  CHECK(drawn.facts.check->hidden == 0);
  CHECK(drawn.facts.check->missing == 0);
  for (const WantedLayer& layer : wanted.layers) check_layer(drawn.drawing, layer);
}

} // namespace

TEST_CASE("hard cases of the whole program come out as they say") {
  int count = 0;
  for (const auto& entry :
       std::filesystem::directory_iterator(OROGRAPH_SOURCE_DIR "/tests/cases")) {
    if (!entry.path().string().ends_with(".grid.txt")) continue;
    const Case scene = read_case(entry.path());
    INFO(entry.path().filename() << ": " << scene.caption);
    try {
      check_case(scene);
    } catch (const Error& error) {
      FAIL_CHECK(error.what());
    }
    ++count;
  }
  CHECK(count >= 20);
}

} // namespace orograph::grid_cases_test
