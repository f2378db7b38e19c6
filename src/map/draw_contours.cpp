// SPDX-License-Identifier: GPL-3.0-or-later
#include "map/draw_contours.hpp"

#include "draw/chain.hpp"
#include "geometry/on_all_cores.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <span>
#include <tuple>
#include <vector>

namespace orograph {
namespace {

using Runs = std::span<const SeenContours::Run>;

// The points of a level's runs, joined where those meet, way after way.
struct Ways {
  struct Way {
    std::size_t begin, end;
    bool is_ring;
  };
  std::vector<const ContourPoint*> points;
  std::vector<Way> ways;
};

std::uint64_t link_at(const ContourPoint& end) {
  return end.node.is_loose() ? kLooseEnd : end.node.number();
}

// A ring begins at its lowest node, towards the higher of those beside it; another way at its
// lower end: so nothing depends on where it was found first.
void put_in_order(Ways& ways, Ways::Way& way) {
  const auto begin = ways.points.begin() + static_cast<std::ptrdiff_t>(way.begin),
             end = ways.points.begin() + static_cast<std::ptrdiff_t>(way.end);
  const auto number = [](const ContourPoint* point) { return point->node.number(); };
  way.is_ring = number(*begin) == number(*(end - 1)) && !(*begin)->node.is_loose();
  if (!way.is_ring) {
    const auto at_begin = std::tuple(std::min(number(*begin), number(*(begin + 1))),
                                     std::max(number(*begin), number(*(begin + 1)))),
               at_end = std::tuple(std::min(number(*(end - 1)), number(*(end - 2))),
                                   std::max(number(*(end - 1)), number(*(end - 2))));
    if (at_end < at_begin) std::reverse(begin, end);
    return;
  }
  std::rotate(begin,
              std::min_element(begin, end - 1, [&](auto a, auto b) { return number(a) < number(b); }),
              end - 1);
  *(end - 1) = *begin;
  if (number(*(begin + 1)) < number(*(end - 2))) std::reverse(begin, end);
}

Ways ways_of(const SeenContours& contours, Runs runs) {
  std::vector<ChainLink> links;
  links.reserve(runs.size());
  for (const SeenContours::Run& run : runs) {
    const auto points = contours.points(run);
    links.push_back({link_at(points.front()), link_at(points.back())});
  }
  const Chains chains = chain(links);
  Ways out;
  for (std::size_t i = 0; i < chains.size(); ++i) {
    Ways::Way way{out.points.size(), 0, false};
    bool is_first = true;
    for (const auto& [run, turned] : chains[i]) {
      throw_if_stopped(out.points.size());
      const auto points = contours.points(runs[run]);
      for (std::size_t at = is_first ? 0 : 1; at < points.size(); ++at)
        out.points.push_back(&points[turned ? points.size() - 1 - at : at]);
      is_first = false;
    }
    way.end = out.points.size();
    put_in_order(out, way);
    out.ways.push_back(way);
  }
  std::ranges::sort(out.ways, {}, [&](const Ways::Way& way) {
    const std::uint64_t first = out.points[way.begin]->node.number(), second = out.points[way.begin + 1]->node.number();
    return std::tuple(way.is_ring, std::min(first, second), std::max(first, second));
  });
  return out;
}

} // namespace

double draw_contours(const View& view, const SeenContours& contours, const GroundLines& on_ground,
                     LineKind kind, const StrokeSettings& settings, Layer& layer) {
  std::vector<Runs> levels;
  for (Runs left = contours.by_level; !left.empty();) {
    const std::uint32_t level = contours.level(left.front());
    const auto end = std::ranges::find_if(
        left, [&](const SeenContours::Run& run) { return contours.level(run) != level; });
    const auto count = static_cast<std::size_t>(end - left.begin());
    if (on_ground.features[on_ground.first_to_find + level].kind == kind)
      levels.push_back(left.first(count));
    left = left.subspan(count);
  }
  struct Drawn {
    Layer layer;
    double left_out_mm = 0;
  };
  std::vector<Drawn> drawn(levels.size());
  on_all_cores(levels.size(), [&](std::size_t i) {
    Layer& own = drawn[i].layer;
    StrokeBuilder builder(settings, own);
    const Ways ways = ways_of(contours, levels[i]);
    for (const auto& [begin, end, is_ring] : ways.ways) {
      throw_if_stopped();
      builder.begin(-1, std::numeric_limits<double>::quiet_NaN());
      for (std::size_t at = begin; at < end; ++at) {
        const ProfilePoint& here = ways.points[at]->at;
        builder.add({project_homogeneous(view, here), here});
      }
      builder.end();
    }
    drawn[i].left_out_mm = builder.left_out_mm();
    if (own.strokes.empty()) return;
    for (Stroke& stroke : own.strokes) stroke.feature = 0;
    own.features.push_back(
        on_ground.features[on_ground.first_to_find + contours.level(levels[i].front())].attributes);
  });
  double left_out_mm = 0;
  for (Drawn& of_level : drawn) {
    append(layer, of_level.layer);
    of_level.layer = {};
    left_out_mm += of_level.left_out_mm;
  }
  return left_out_mm;
}

} // namespace orograph
