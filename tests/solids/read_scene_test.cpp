// SPDX-License-Identifier: GPL-3.0-or-later
// Scene files: what they hold, and the sources' models by way of them.
#include "geometry/box.hpp"
#include "solids/walk_scene.hpp"
#include "tests/solids/made_scene_files.hpp"
#include "tests/solids/made_scene_graph.hpp"
#include "tests/solids/solid_facts.hpp"
#include "tests/support/random.hpp"
#include "tests/view/matrices.hpp"

#include <fmt/format.h>

#include <iterator>

using namespace orograph;

namespace {

const std::string kPlace = "[[place]]\npart = \"it\"\nat = [0, 0]\n";

const Solid& only_solid(const SceneFile& file) {
  REQUIRE(file.solids.size() == 1);
  return file.solids[0];
}

// A point of the only instance, as the place's `map` leaves it.
Vec3 mapped(const std::string& steps, Vec3 p) {
  const SceneFile file =
      scene_of("[part.it]\nshape = \"box\"\nsize = [2, 2, 2]\n" + kPlace + "map = " + steps + "\n");
  REQUIRE(file.instances.size() == 1);
  return moved(matrix_of(file.instances[0].to_place), p);
}

std::string rows(const Eigen::Matrix4d& m) {
  std::string text;
  for (int row = 0; row < 3; ++row)
    text += fmt::format("{}[{:.17e}, {:.17e}, {:.17e}, {:.17e}]", row == 0 ? "" : ", ", m(row, 0),
                        m(row, 1), m(row, 2), m(row, 3));
  return text;
}

} // namespace

TEST_CASE("a scene file: parts, their uses and places") {
  const SceneFile file = scene_of(R"(# a comment
[part.wall]
shape = "box"
size = [8, 6, 3]
[part.roof]
shape = "prism"
base = [[-4, 0], [4, 0], [0, 3]]
height = 6
[part.hut]
uses = [
  { part = "wall" },
  { part = "roof", map = [ { turn_x = 90 }, { move = [0, 3, 0] }, { scale = [1, 1, 2] },
                           { move = [0, 0, 3] } ] },
]
[part.mast] # with a shape and another part on it
shape = "revolution"
profile = [[0.2, 0], [0.1, 20]]
sides = 12
smooth = true
uses = [ { part = "wall", map = [ { scale = 0.1 } ] } ]
[part.unused]
shape = "tetrahedron"
vertices = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]
[[place]]
part = "hut"
at = [455000, 5080000.5]
map = [ { turn_z = 90 } ]
[[place]]
part = "mast"
lonlat = [7.5, 46.1, 1200]
[[place]]
part = "hut"
at = [1, 2, 3]
)");
  CHECK(file.solids.size() == 4);
  REQUIRE(file.places.size() == 3);
  const ScenePlace& first = file.places[0];
  CHECK(first.part == "hut");
  CHECK(first.x == 455000);
  CHECK(first.y == 5080000.5);
  CHECK_FALSE(first.lonlat);
  CHECK_FALSE(first.height);
  CHECK(first.line == 24);
  CHECK(file.places[1].lonlat);
  CHECK(file.places[1].y == 46.1);
  CHECK(file.places[1].height == 1200.0);
  CHECK(file.places[2].height == 3.0);

  std::vector<std::pair<std::size_t, std::size_t>> met;
  for (const SolidInstance& one : file.instances) met.emplace_back(one.place, one.solid);
  CHECK(met == std::vector<std::pair<std::size_t, std::size_t>>{
                   {0, 0}, {0, 1}, {1, 2}, {1, 0}, {2, 0}, {2, 1}});
  // The ridge, before and after the place's own turn.
  CHECK(distance(moved(matrix_of(file.instances[5].to_place), {0, 3, 6}), {0, -3, 9}) < 1e-14);
  CHECK(distance(moved(matrix_of(file.instances[1].to_place), {0, 3, 6}), {3, 0, 9}) < 1e-14);
  CHECK(distance(moved(matrix_of(file.instances[3].to_place), {4, 3, 3}), {0.4, 0.3, 0.3}) < 1e-15);
}

TEST_CASE("the scene in docs/scenes.md is one") {
  std::ifstream page(std::string(OROGRAPH_SOURCE_DIR) + "/docs/scenes.md");
  const std::string text{std::istreambuf_iterator<char>(page), {}};
  const auto begin = text.find("```toml\n[part.wall]") + 8;
  const SceneFile file = scene_of(text.substr(begin, text.find("```", begin) - begin));
  CHECK(file.places.size() == 2);
  CHECK(file.instances.size() == 4);
  Box3 roof; // over the wall, on all sides
  for (const Vec3 p : file.solids[1].vertices_m)
    roof.include(moved(matrix_of(file.instances[3].to_place), p));
  CHECK(distance(roof.low, {-4.5, -3.5, 3}) < 1e-14);
  CHECK(distance(roof.high, {4.5, 3.5, 6}) < 1e-14);
}

TEST_CASE("steps of a map act in their order") {
  CHECK(mapped("[]", {1, 2, 3}) == Vec3{1, 2, 3});
  CHECK(mapped("[{ move = [1, 2, 3] }, { scale = 2 }]", {1, 1, 1}) == Vec3{4, 6, 8});
  CHECK(mapped("[{ scale = [1, -2, 3] }, { move = [1, 2, 3] }]", {1, 1, 1}) == Vec3{2, 0, 6});
  CHECK(mapped("[{ turn_x = 90 }]", {1, 2, 3}) == Vec3{1, -3, 2});
  CHECK(mapped("[{ turn_y = 90 }]", {1, 2, 3}) == Vec3{3, 2, -1});
  CHECK(mapped("[{ turn_z = 90 }]", {1, 2, 3}) == Vec3{-2, 1, 3});
  CHECK(mapped("[{ turn = { axis = [0, 0, -5], angle = 90 } }]", {1, 2, 3}) == Vec3{2, -1, 3});
  CHECK(mapped("[{ matrix = [[1, 2, 3, 4], [0, 1, 0, 5], [0, 0, 1, 6]] }]", {1, 1, 1}) ==
        Vec3{10, 6, 7});
  CHECK(mapped("[{ matrix = [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 6], [0, 0, 0, 1]] }]",
               {1, 1, 1}) == Vec3{1, 1, 7});
}

TEST_CASE("example 9.1 in a scene file: the cube's eight ACTUAL vertices, over 25") {
  const std::string cube = R"([part.it]
shape = "polyhedron"
vertices = [[1, 1, 1], [1, 1, -1], [1, -1, -1], [1, -1, 1],
            [-1, 1, 1], [-1, 1, -1], [-1, -1, -1], [-1, -1, 1]]
faces = [[0, 3, 2, 1], [4, 5, 6, 7], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7]]
)";
  const int actual[8][3] = {{26, -5, 7}, {-14, -5, -23}, {-38, -35, 9}, {2, -35, 39},
                            {8, 35, 31}, {-32, 35, 1},   {-56, 5, 33},  {-16, 5, 63}};
  const double alpha = std::atan2(-4, 3) / M_PI * 180; // cosine 3/5, sine -4/5
  const std::string turns = fmt::format(
      "map = [{{ turn_z = {:.17g} }}, {{ move = [-1, 0, 0] }}, {{ turn_y = {:.17g} }}]\n", alpha,
      -alpha);
  const std::string matrix = "map = [{ matrix = [[9, 12, 20, -15], [-20, 15, 0, 0], "
                             "[-12, -16, 15, 20]] }, { scale = 0.04 }]\n";
  for (const std::string& map : {turns, matrix}) {
    const SceneFile file = scene_of(std::string(cube).append(kPlace).append(map));
    const Solid& solid = only_solid(file);
    CHECK(drawn_edges(solid) == 12);
    require_closed(solid);
    for (int i = 0; i < 8; ++i) {
      const Vec3 found = 25 * moved(matrix_of(file.instances[0].to_place), solid.vertices_m[i]);
      CHECK(distance(found, {double(actual[i][0]), double(actual[i][1]), double(actual[i][2])}) <
            1e-13);
    }
  }
}

TEST_CASE("the tent of Chen and Sabbagh, section 5.1, with a floor: 6 vertices, 9 edges") {
  // Its faces run clockwise there; here they have to run the other way round.
  const auto tent = [](const std::string& faces) {
    return "[part.it]\nshape = 'polyhedron'\nvertices = [[10, 20, 40], [10, 20, 0], [20, 0, 0], "
           "[20, 0, 40], [0, 0, 40], [0, 0, 0]]\nfaces = " +
           faces + "\n" + kPlace + "map = [{ turn_x = 90 }]\n";
  };
  const SceneFile file =
      scene_of(tent("[[3, 2, 1, 0], [5, 4, 0, 1], [2, 5, 1], [4, 3, 0], [2, 3, 4, 5]]"));
  const Solid& solid = only_solid(file);
  require_closed(solid);
  CHECK(solid.vertices_m.size() == 6);
  CHECK(drawn_edges(solid) == 9);
  CHECK(volume_of(solid) == Approx(8000));
  for (const Vec3 p : solid.vertices_m) {
    const double up = moved(matrix_of(file.instances[0].to_place), p).z;
    CHECK((up == 0 || up == 20));
  }
  check_refused(
      [&] { scene_of(tent("[[0, 1, 2, 3], [1, 0, 4, 5], [1, 5, 2], [0, 3, 4], [5, 4, 3, 2]]")); },
      "line 4: the closed part with face 0 is inside out");
}

TEST_CASE("every shape is read with its keys") {
  const auto edges = [](const std::string& keys) {
    return drawn_edges(only_solid(scene_of("[part.it]\n" + keys + "\n" + kPlace)));
  };
  CHECK(edges("shape = 'box'\nsize = [1, 2, 3]") == 12);
  CHECK(edges("shape = 'prism'\nbase = [[0, 0], [0, 9], [9, 9], [1, 1]]\nheight = 1") == 12);
  CHECK(edges("shape = 'pyramid'\nbase = [[0, 0], [0, 9], [9, 9]]\napex = 1") == 6);
  CHECK(edges("shape = 'pyramid'\nbase = [[0, 0], [0, 9], [9, 9]]\napex = [0, 0, 1.5]") == 6);
  CHECK(edges("shape = 'tetrahedron'\nvertices = [[1,1,1],[1,-1,-1],[-1,1,-1],[-1,-1,1]]") == 6);
  CHECK(edges("shape = 'revolution'\nprofile = [[1, 0], [1, 1]]\nsides = 6\nstart = 15") == 18);
  CHECK(edges("shape = 'revolution'\nprofile = [[1, 0], [1, 1]]\nsides = 6\nsmooth = true") == 12);
  CHECK(edges("shape = 'rotation'\nprofile = [[1, 0], [2, 0], [1, 1]]\nsides = 6\nrise = 3\n"
              "turns = 1.5\nsmooth = false") == 57);
  CHECK(edges("shape = 'rotation'\nprofile = [[1, 0], [2, 0], [1, 1]]\nsides = 6\nrise = 3") == 39);
  CHECK(edges("shape = 'wires'\nvertices = [[0,0,0],[0,0,9],[3,0,0]]\nlines = [[0,1],[2,1]]") == 2);
}

TEST_CASE("polyhedra in files beside the scene, with faces of any size") {
  const TempFolder folder;
  std::filesystem::create_directory(folder.path() / "models");
  write_file(folder, "models/cube.off",
             "OFF # plain\n8 6 0\n\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n1 0 1\n1 1 1\n0 1 1\n"
             "4 3 2 1 0\n4 4 5 6 7\n4 0 1 5 4 255 0 0\n4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n");
  write_file(folder, "models/colours.OFF",
             "COFF 4 4 6\n0 0 0 9 9 9 1\n1 0 0 9 9 9 1\n0 1 0 9 9 9 1\n0 0 1 9 9 9 1\n"
             "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n");
  // Faces before vertices, from the end, with textures, tabs and lines of other kinds.
  write_file(
      folder, "models/prism.obj",
      "# made by hand\r\nmtllib a.mtl\r\no thing\r\nv 0 0 0 1.0\r\nv\t4 0 0\r\nv 0 4 0\r\n"
      "f 1/1/1 3/2/1 2/3/1\r\nf 4//7\t5//7\t6//7\r\nl 1 2\r\nv 0 0 2\r\nv 4 0 2\r\nv 0 4 2\r\n"
      "vn 0 0 1\r\nusemtl x\r\ns off\r\nf -6 -5 -2 -3\r\nf 2 3 6 5\r\nf 3 1 4 6\r\n");
  const auto read = [&](const std::string& file) {
    return read_scene(write_file(
        folder, "scene.toml", "[part.it]\nshape = 'polyhedron'\nfile = '" + file + "'\n" + kPlace));
  };
  CHECK(volume_of(only_solid(read("models/cube.off"))) == Approx(1));
  CHECK(drawn_edges(only_solid(read("models/cube.off"))) == 12);
  CHECK(drawn_edges(only_solid(read("models/colours.OFF"))) == 6);
  CHECK(volume_of(only_solid(read("models/prism.obj"))) == Approx(16));
  CHECK(drawn_edges(only_solid(read("models/prism.obj"))) == 9);
  CHECK(drawn_edges(only_solid(read(folder.file("models/cube.off")))) == 12);
}

TEST_CASE("graphs that are written to a file have the instances of the graph") {
  for (std::uint64_t seed = 1; seed <= last_seed(50); ++seed) {
    Random random(seed);
    INFO("seed " << seed);
    const SceneGraph graph = made_scene_graph(random);
    std::string text;
    std::size_t shapes = 0;
    for (const ScenePart& part : graph.parts) {
      text += "[part." + part.name + "]\n";
      if (part.solid) text += "shape = 'box'\nsize = [1, 1, 1]\n";
      shapes += part.solid ? 1 : 0;
      std::string uses;
      for (const PartUse& use : part.uses)
        uses += fmt::format("{{ part = 'p{}', map = [{{ matrix = [{}] }}] }},\n", use.part,
                            rows(use.map));
      if (!uses.empty()) text += "uses = [" + uses + "]\n";
    }
    for (const PartUse& place : graph.places)
      text += fmt::format("[[place]]\npart = 'p{}'\nat = [0, 0]\nmap = [{{ matrix = [{}] }}]\n",
                          place.part, rows(place.map));
    const SceneFile file = scene_of(text);
    REQUIRE(file.solids.size() == shapes);
    const auto expected = walk_scene(graph, "");
    REQUIRE(file.instances.size() == expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i) {
      REQUIRE(file.instances[i].place == expected[i].place);
      REQUIRE(file.instances[i].to_place == expected[i].to_place);
    }
  }
}
