// SPDX-License-Identifier: GPL-3.0-or-later
#include "map/draw_solids.hpp"

#include "hidden_lines/line_parts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <set>
#include <utility>

namespace orograph {
namespace {

// Ends of a part on the page, the lower first, in the page's steps.
using PageEnds = std::array<double, 4>;

// The edges of all solids, numbered through.
class EdgePlaces {
public:
  EdgePlaces(std::span<const StandingSolid> standing, const View& view) : view_(view) {
    std::uint64_t first_vertex = 0;
    for (const StandingSolid& solid : standing) {
      for (const SolidEdge& edge : solid.solid->edges)
        edges_.push_back({&solid, &edge, first_vertex});
      first_vertex += solid.vertices_m.size();
    }
  }

  ChainLink link(const LinePart& part) const {
    const auto& [solid, edge, first_vertex] = edges_[part.line];
    return {part.t_begin <= 0 ? first_vertex + edge->from : kLooseEnd,
            part.t_end >= 1 ? first_vertex + edge->to : kLooseEnd};
  }
  ProfilePoint point(const LinePart& part, double t) const {
    const Edge& at = edges_[part.line];
    const std::vector<Vec3>& vertices = at.solid->vertices_m;
    return point_between(to_profile_frame(view_, vertices[at.edge->from]),
                         to_profile_frame(view_, vertices[at.edge->to]), t);
  }
  // None where an end has no picture.
  std::optional<PageEnds> ends(const LinePart& part, const PlacedView& placed) const {
    std::array<std::array<double, 2>, 2> ends;
    for (std::size_t i = 0; i < 2; ++i) {
      const Vec3 page = placed.on_page(point(part, i == 0 ? part.t_begin : part.t_end));
      if (!(page.z > 0)) return std::nullopt;
      ends[i] = {std::round(page.x / page.z / kPageStep_mm),
                 std::round(page.y / page.z / kPageStep_mm)};
    }
    const auto& [low, high] = std::minmax(ends[0], ends[1]);
    return PageEnds{low[0], low[1], high[0], high[1]};
  }

private:
  struct Edge {
    const StandingSolid* solid;
    const SolidEdge* edge;
    std::uint64_t first_vertex; // of its solid, all vertices numbered through
  };

  const View& view_;
  std::vector<Edge> edges_;
};

} // namespace

void drop_repeated(const PlacedView& placed, const std::vector<LinePart>& drawn,
                   std::vector<LinePart>& parts) {
  const EdgePlaces places(placed.solids, placed.view);
  std::set<PageEnds> known;
  const auto is_known = [&](const LinePart& part) {
    const std::optional<PageEnds> ends = places.ends(part, placed);
    return ends && !known.insert(*ends).second;
  };
  for (const LinePart& part : drawn) is_known(part);
  std::erase_if(parts, is_known);
}

void draw_edges(std::span<const StandingSolid> standing, const View& view,
                const std::vector<LinePart>& parts, StrokeBuilder& builder) {
  const EdgePlaces places(standing, view);
  draw_chained(
      parts, view, [&](const LinePart& part) { return places.link(part); },
      [&](const LinePart& part, double t) { return places.point(part, t); }, builder);
}

} // namespace orograph
