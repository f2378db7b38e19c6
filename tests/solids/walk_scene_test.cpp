// SPDX-License-Identifier: GPL-3.0-or-later
// Traversal against every path, found by brute force.
#include "solids/walk_scene.hpp"
#include "tests/solids/made_scene_graph.hpp"
#include "tests/support/random.hpp"
#include "tests/view/matrices.hpp"

#include <Eigen/LU>

using namespace orograph;

namespace {

// A path from a place to a solid, with the product of the maps along it.
struct Path {
  std::size_t place, solid;
  Eigen::Matrix4d product;
};

// Every path from a part on, as the product along it: by recursion, matrices on the left.
void follow(const SceneGraph& graph, std::uint32_t part, std::vector<Eigen::Matrix4d> arcs,
            std::size_t place, std::vector<Path>& found) {
  if (graph.parts[part].solid) {
    Eigen::Matrix4d product = Eigen::Matrix4d::Identity();
    for (auto arc = arcs.rbegin(); arc != arcs.rend(); ++arc) product = *arc * product;
    found.push_back({place, *graph.parts[part].solid, product});
  }
  for (const PartUse& use : graph.parts[part].uses) {
    arcs.push_back(use.map);
    follow(graph, use.part, arcs, place, found);
    arcs.pop_back();
  }
}

SceneGraph chain(std::size_t parts, int uses_each) {
  SceneGraph graph;
  for (std::size_t i = 0; i < parts; ++i) {
    ScenePart part{"p" + std::to_string(i), {}, {}};
    if (i == 0) part.solid = 0;
    for (int k = 0; i > 0 && k < uses_each; ++k)
      part.uses.push_back({static_cast<std::uint32_t>(i - 1), Eigen::Matrix4d::Identity(), 10 + i});
    graph.parts.push_back(part);
  }
  graph.places = {{static_cast<std::uint32_t>(parts - 1), Eigen::Matrix4d::Identity(), 5}};
  return graph;
}

} // namespace

TEST_CASE("the walk makes an instance of every path, with the product along it") {
  std::size_t most = 0;
  for (std::uint64_t seed = 1; seed <= last_seed(1000); ++seed) {
    Random random(seed);
    INFO("seed " << seed);
    const SceneGraph graph = made_scene_graph(random);
    std::vector<Path> expected;
    for (std::size_t i = 0; i < graph.places.size(); ++i)
      follow(graph, graph.places[i].part, {graph.places[i].map}, i, expected);
    const auto found = walk_scene(graph, "a.toml");
    most = std::max(most, found.size());
    REQUIRE(found.size() == expected.size());
    for (std::size_t i = 0; i < found.size(); ++i) {
      REQUIRE(found[i].place == expected[i].place);
      REQUIRE(found[i].solid == expected[i].solid);
      REQUIRE((matrix_of(found[i].to_place) - expected[i].product).cwiseAbs().maxCoeff() < 1e-9);
    }
  }
  CHECK(most > enough(800));
}

TEST_CASE("paths are counted before they are walked") {
  CHECK(walk_scene(chain(18, 2), "a.toml").size() == std::size_t{1} << 17);
  check_refused([] { walk_scene(chain(19, 2), "a.toml"); },
                "a.toml, line 5: with this place the scene has more than 200,000 instances");
  check_refused([] { walk_scene(chain(61, 2), "a.toml"); }, "more than 200,000 instances");
  check_refused([] { walk_scene(chain(5000, 3), "a.toml"); }, "more than 200,000 instances");
  // Deep, but with few paths; and with few instances, but too many parts on the way to them.
  CHECK(walk_scene(chain(100'000, 1), "a.toml").size() == 1);
  SceneGraph graph = chain(100'000, 1);
  graph.places.resize(1000, graph.places[0]);
  check_refused([&] { walk_scene(graph, "a.toml"); }, "parts are met more than 2,000,000 times");
}

TEST_CASE("a circle of parts is named, wherever it is") {
  SceneGraph graph = chain(4, 1);
  graph.parts[1].uses.push_back({3, Eigen::Matrix4d::Identity(), 99});
  check_refused([&] { walk_scene(graph, "a.toml"); },
                "a.toml, line 12: parts use each other in a circle, p1 -> p3 -> p2 -> p1");
  graph = chain(3, 1);
  graph.parts.push_back({"alone", {}, {{3, Eigen::Matrix4d::Identity(), 7}}});
  check_refused([&] { walk_scene(graph, "a.toml"); },
                "a.toml, line 7: parts use each other in a circle, alone -> alone");
  graph = chain(5000, 1);
  graph.parts[0].uses.push_back({4999, Eigen::Matrix4d::Identity(), 8});
  check_refused([&] { walk_scene(graph, "a.toml"); }, "p4991 -> ... -> p");
}

TEST_CASE("maps that vanish or overflow only together are told by the place") {
  Eigen::Matrix4d flat = Eigen::Matrix4d::Identity(), large = flat;
  flat.col(1) = Eigen::Vector4d(1, 1e-8, 0, 0);
  large(0, 0) = 1e9;
  SceneGraph graph = chain(3, 1);
  graph.parts[2].uses[0].map = graph.parts[1].uses[0].map = large;
  check_refused([&] { walk_scene(graph, "a.toml"); },
                "a.toml, line 5: part 'p0' of this place: its map has numbers beyond 1e12");
  Eigen::Matrix4d squeeze = Eigen::Matrix4d::Identity(), turn = squeeze;
  squeeze(1, 1) = 1e-8;
  turn.topLeftCorner<2, 2>() << 0.8, -0.6, 0.6, 0.8;
  graph.parts[2].uses[0].map = turn * squeeze;
  graph.parts[1].uses[0].map = squeeze * turn;
  check_refused([&] { walk_scene(graph, "a.toml"); }, "a model's matrix is singular");
}
