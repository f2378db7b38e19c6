// SPDX-License-Identifier: GPL-3.0-or-later
#include "solids/walk_scene.hpp"

#include "geometry/error.hpp"
#include "view/pipeline.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace orograph {
namespace {

using Index = std::uint32_t;

// How far the walk is: a part, and the next of its uses.
struct Step {
  Index part;
  std::size_t next = 0;
};

std::string place_in(const std::string& path, std::size_t line) {
  return fmt::format("{}, line {}", path, line);
}

// The parts from the one that the last leads back to.
[[noreturn]] void refuse_circle(const SceneGraph& graph, const std::vector<Step>& steps,
                                const PartUse& back, const std::string& path) {
  auto step =
      std::find_if(steps.begin(), steps.end(), [&](const Step& s) { return s.part == back.part; });
  std::string circle;
  constexpr std::ptrdiff_t named = 10;
  const auto length = steps.end() - step;
  for (std::ptrdiff_t i = 0; i < length; ++i, ++step)
    if (i < named)
      circle += graph.parts[step->part].name + " -> ";
    else if (i == named)
      circle += "... -> ";
  throw Error(fmt::format("{}: parts use each other in a circle, {}{}", place_in(path, back.line),
                          circle, graph.parts[back.part].name),
              "a part should not hold itself");
}

// Each part behind all that it uses.
std::vector<Index> used_first(const SceneGraph& graph, const std::string& path) {
  enum class Mark : std::uint8_t { untouched, open, done };
  std::vector<Mark> marks(graph.parts.size(), Mark::untouched);
  std::vector<Index> order;
  for (Index root = 0; root < graph.parts.size(); ++root) {
    std::vector<Step> steps;
    const auto enter = [&](Index part) {
      if (marks[part] != Mark::untouched) return;
      marks[part] = Mark::open;
      steps.push_back({part});
    };
    enter(root);
    while (!steps.empty()) {
      Step& step = steps.back();
      const auto& uses = graph.parts[step.part].uses;
      if (step.next < uses.size()) {
        const PartUse& use = uses[step.next++];
        if (marks[use.part] == Mark::open) refuse_circle(graph, steps, use, path);
        enter(use.part);
      } else {
        marks[step.part] = Mark::done;
        order.push_back(step.part);
        steps.pop_back();
      }
    }
  }
  return order;
}

// Of paths from one part on; doubles, since there may be 2^1000 of them.
struct PathCounts {
  double to_shapes = 0, to_parts = 0;
};

void check_counts(const SceneGraph& graph, const std::vector<Index>& order,
                  const std::string& path) {
  constexpr double most = kMostInstances;
  std::vector<PathCounts> counts(graph.parts.size());
  for (const Index part : order) {
    PathCounts& count = counts[part];
    count = {graph.parts[part].solid ? 1.0 : 0.0, 1};
    for (const PartUse& use : graph.parts[part].uses) {
      count.to_shapes += counts[use.part].to_shapes;
      count.to_parts += counts[use.part].to_parts;
    }
  }
  PathCounts all;
  for (const PartUse& place : graph.places) {
    all.to_shapes += counts[place.part].to_shapes;
    all.to_parts += counts[place.part].to_parts;
    if (all.to_shapes > most)
      throw Error(fmt::format("{}: with this place the scene has more than 200,000 instances",
                              place_in(path, place.line)),
                  "use parts less often");
    if (all.to_parts > 10 * most)
      throw Error(fmt::format("{}: with this place parts are met more than 2,000,000 times",
                              place_in(path, place.line)),
                  "let parts use others less deeply");
  }
}

void check_matrix(const Eigen::Matrix4d& matrix, const PartUse& place, const std::string& part,
                  const std::string& path) {
  try {
    require_model(matrix);
    if (!(matrix.cwiseAbs().maxCoeff() <= 1e12))
      throw Error("its map has numbers beyond 1e12", "scale or move it less");
  } catch (const Error& error) {
    throw Error(fmt::format("{}: part '{}' of this place", place_in(path, place.line), part),
                error.what());
  }
}

AffineMap affine_map(const Eigen::Matrix4d& matrix) {
  const auto column = [&](int i) { return Vec3{matrix(0, i), matrix(1, i), matrix(2, i)}; };
  return {column(0), column(1), column(2), column(3)};
}

} // namespace

std::vector<SolidInstance> walk_scene(const SceneGraph& graph, const std::string& path) {
  check_counts(graph, used_first(graph, path), path);
  std::vector<SolidInstance> instances;
  std::vector<Step> steps;
  std::vector<Eigen::Matrix4d> matrices;
  for (std::size_t i = 0; i < graph.places.size(); ++i) {
    const PartUse& place = graph.places[i];
    const auto enter = [&](Index part, const Eigen::Matrix4d& matrix) {
      if (const auto solid = graph.parts[part].solid) {
        check_matrix(matrix, place, graph.parts[part].name, path);
        instances.push_back({i, *solid, affine_map(matrix)});
      }
      steps.push_back({part});
      matrices.push_back(matrix);
    };
    enter(place.part, place.map);
    while (!steps.empty()) {
      const auto& uses = graph.parts[steps.back().part].uses;
      if (steps.back().next < uses.size()) {
        const PartUse& use = uses[steps.back().next++];
        enter(use.part, matrices.back() * use.map);
      } else {
        steps.pop_back();
        matrices.pop_back();
      }
    }
  }
  return instances;
}

} // namespace orograph
