// SPDX-License-Identifier: GPL-3.0-or-later
#include "hidden_lines/surface_lines.hpp"

#include "geometry/on_all_cores.hpp"
#include "profiles/level_ground.hpp"
#include "profiles/outline.hpp"
#include "profiles/silhouettes.hpp"
#include "profiles/surface_edges.hpp"
#include "view/sectors.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <optional>
#include <span>

namespace orograph {

namespace {

// Finds edges that are asked for in order in a list that is in order.
class EdgesInOrder {
public:
  explicit EdgesInOrder(const std::vector<SurfaceEdge>& edges) : edges_(edges) {}

  std::optional<std::size_t> find(SurfaceEdge edge) {
    while (at_ < edges_.size() && edges_[at_] < edge) ++at_;
    if (at_ == edges_.size() || edges_[at_] != edge) return std::nullopt;
    return at_;
  }

private:
  const std::vector<SurfaceEdge>& edges_;
  std::size_t at_ = 0;
};

} // namespace

bool outlines_terrain(const Style& style, const View& view) {
  const bool is_plan = view.is_perspective() ? shows_beside(view) : view.y_per_z == 0;
  return style.outline == Outline::one && style.asks_for("skyline") && !is_plan;
}

bool draws_silhouettes(const Style& style) {
  return style.asks_for("silhouettes") || style.asks_for("skyline");
}

namespace {

// Of open border the stretches that hang together, each as the places of its edges in the list.
std::vector<std::vector<std::size_t>> open_stretches(const std::vector<BorderEdge>& border,
                                                     const std::vector<bool>& open) {
  struct End {
    std::uint32_t vertex;
    std::size_t edge;
    auto operator<=>(const End&) const = default;
  };
  std::vector<End> ends;
  for (std::size_t i = 0; i < border.size(); ++i)
    if (open[i]) ends.insert(ends.end(), {{border[i].edge.from, i}, {border[i].edge.to, i}});
  std::size_t steps = 0;
  std::sort(ends.begin(), ends.end(), StoppableLess(steps));
  std::vector<bool> taken(border.size());
  std::vector<std::vector<std::size_t>> stretches;
  for (const End& first : ends) {
    if (taken[first.edge]) continue;
    std::vector<std::size_t> stretch{first.edge};
    taken[first.edge] = true;
    for (std::size_t at = 0; at < stretch.size(); ++at) {
      throw_if_stopped(at);
      const SurfaceEdge edge = border[stretch[at]].edge;
      for (const std::uint32_t vertex : {edge.from, edge.to})
        for (auto next = std::lower_bound(ends.begin(), ends.end(), End{vertex, 0});
             next != ends.end() && next->vertex == vertex; ++next)
          if (!taken[next->edge]) {
            taken[next->edge] = true;
            stretch.push_back(next->edge);
          }
    }
    stretches.push_back(std::move(stretch));
  }
  return stretches;
}

// Water that takes less of the border is a lake or a river, which the data cuts as it does the land
// beside it. So much is 20 mm along a page of A4; the outlines that looked torn were open for less
// than 4 mm, but for 1.2 % of the border, about a corner.
constexpr double kLeastOfOpen = 0.02;

// Of the border whether it is that of open water whose shores are drawn, where nothing in the
// landscape ends: it isn't drawn. But to an eye in the landscape water that ends within 2 degrees
// below its horizontal, and nearly level, ends at the sea's horizon, for all that a picture tells.
// Water without shores is all that there is, and has its border.
std::vector<bool> open_water(const TerrainData& terrain, const PlacedView& placed,
                             const Style& style) {
  if (style.flat == FlatGround::draw || style.outline != Outline::one ||
      placed.level.shores.empty())
    return std::vector<bool>(placed.border.size());
  std::vector<bool> open = borders_of(terrain.surface, placed.border, placed.level.triangles);
  const auto least = kLeastOfOpen * static_cast<double>(placed.border.size());
  for (const auto& stretch : open_stretches(placed.border, open))
    if (static_cast<double>(stretch.size()) < least)
      for (const std::size_t edge : stretch) open[edge] = false;
  const View& view = placed.view;
  if (!view.is_perspective() || view.frames_terrain) return open;
  constexpr double kLowestOfHorizon = 0.035, kRiseOfHorizon = 0.1;
  const EdgeEnds ends(terrain.surface, view);
  for (std::size_t i = 0; i < open.size(); ++i) {
    if (!open[i]) continue;
    throw_if_stopped(i);
    const auto [from, to] = ends(placed.border[i].edge);
    const double from_m = std::hypot(from.u, from.v), to_m = std::hypot(to.u, to.v);
    const double from_drop = (view.eye_z_m - from.z) / from_m,
                 to_drop = (view.eye_z_m - to.z) / to_m;
    const double turn = (from.u * to.v - from.v * to.u) / (from_m * to_m); // to the left
    const bool is_behind_water = (turn > 0) == placed.border[i].left;
    if (is_behind_water && std::max(from_drop, to_drop) <= kLowestOfHorizon &&
        std::abs(from_drop - to_drop) <= kRiseOfHorizon * std::abs(turn))
      open[i] = false;
  }
  return open;
}

// Silhouettes are in order.
std::vector<EdgeLine> lines_with(const std::vector<SurfaceEdge>& silhouettes,
                                 std::span<const SurfaceEdge> valleys, bool is_sheet,
                                 const TerrainData& terrain, const PlacedView& placed,
                                 const Style& style) {
  // With the seed's occluders only what is drawn of the profiles hides.
  const bool surface = style.occluder == Occluder::surface;
  const bool border = style.asks_for("border"), voids = style.asks_for("voids");
  const bool outlines =
      outlines_terrain(style, placed.view); // whatever else is drawn of the border
  std::vector<EdgeLine> lines;
  std::vector<SurfaceEdge> drawn; // in order: an edge of several kinds is drawn as the first
  // What was added behind `middle` in order goes where it belongs.
  const auto merge_drawn = [&](std::size_t middle) {
    std::size_t steps = 0;
    std::inplace_merge(drawn.begin(), drawn.begin() + static_cast<std::ptrdiff_t>(middle),
                       drawn.end(), StoppableLess(steps));
  };
  const auto add_drawn = [&](const std::vector<SurfaceEdge>& edges, LineKind kind) {
    std::vector<SurfaceEdge> news;
    std::size_t steps = 0;
    news.reserve(edges.size());
    std::set_difference(edges.begin(), edges.end(), drawn.begin(), drawn.end(),
                        std::back_inserter(news), StoppableLess(steps));
    lines.reserve(lines.size() + news.size());
    for (const SurfaceEdge& edge : news) {
      throw_if_stopped(lines.size());
      lines.push_back({edge, kind, false, true, false});
    }
    const std::size_t middle = drawn.size();
    drawn.insert(drawn.end(), news.begin(), news.end());
    merge_drawn(middle);
  };
  // A sheet's walls have two sides as well, and a place of their own in its order.
  const std::vector<SurfaceEdge> behind_walls =
      is_sheet ? std::vector<SurfaceEdge>() : edges_behind_walls(terrain.surface, placed.view);
  const std::vector<SurfaceEdge> all_brinks = brinks(terrain.surface, placed.border, placed.view);
  const bool draws_more = style.asks_for("shores") || style.asks_for("edges");
  std::vector<bool> hides(all_brinks.size()); // of brinks: is there as another line, too
  const auto add_hiding = [&](SurfaceEdge edge, LineKind kind, bool is_asked, bool is_drawn,
                              EdgesInOrder& walls, EdgesInOrder& brinks_on) {
    throw_if_stopped(lines.size());
    if (is_drawn && walls.find(edge)) is_drawn = false;
    const std::optional<std::size_t> brink = brinks_on.find(edge);
    if (brink) hides[*brink] = true;
    lines.push_back({edge, kind, surface, is_drawn, brink.has_value()});
    if (is_drawn && is_asked && draws_more) drawn.push_back(edge);
  };
  drawn = behind_walls; // not to be drawn at all
  lines.reserve(silhouettes.size() + valleys.size() + placed.border.size());
  // The underside of a block is within it.
  const auto is_in_block = [&](LineKind kind) {
    return kind == LineKind::underside && placed.block_base_m;
  };
  const auto add_all_hiding = [&](std::span<const SurfaceEdge> edges, LineKind kind) {
    EdgesInOrder walls(behind_walls), brinks_on(all_brinks);
    const std::size_t middle = drawn.size();
    for (const SurfaceEdge& edge : edges)
      add_hiding(edge, kind, true, draws_silhouettes(style) && !is_in_block(kind), walls,
                 brinks_on);
    merge_drawn(middle);
  };
  add_all_hiding(silhouettes, LineKind::silhouette);
  add_all_hiding(valleys, LineKind::underside);
  if (surface || border || voids || outlines) {
    const std::vector<bool> of_void = border || voids || outlines
                                          ? around_voids(terrain.surface, placed.border)
                                          : std::vector<bool>(placed.border.size());
    const std::vector<bool> open = open_water(terrain, placed, style);
    EdgesInOrder walls(behind_walls), brinks_on(all_brinks);
    const std::size_t middle = drawn.size();
    for (std::size_t i = 0; i < placed.border.size(); ++i) {
      const LineKind kind = of_void[i] ? LineKind::void_edge : LineKind::border;
      const bool is_asked = of_void[i] ? voids : border && !open[i];
      const bool may_be_outline = outlines && (of_void[i] || !open[i]);
      add_hiding(placed.border[i].edge, kind, is_asked, is_asked || may_be_outline, walls,
                 brinks_on);
    }
    merge_drawn(middle);
  }
  // The foot of a wall that the eye sees hides nothing, but what may hang there beneath it.
  if (surface && !is_sheet)
    for (std::size_t i = 0; i < all_brinks.size(); ++i)
      if (!hides[i]) {
        throw_if_stopped(lines.size());
        lines.push_back({all_brinks[i], LineKind::silhouette, true, false, true});
      }
  if (style.asks_for("shores")) add_drawn(placed.level.shores, LineKind::shore);
  if (style.asks_for("edges")) add_drawn(edges_of(terrain.surface), LineKind::edge);
  return lines;
}

} // namespace

std::vector<EdgeLine> lines_but_silhouettes(const TerrainData& terrain, const PlacedView& placed,
                                            const Style& style) {
  return lines_with({}, {}, false, terrain, placed, style);
}

std::vector<EdgeLine> lines_of_sheet(const TerrainData& terrain, const PlacedView& placed,
                                     const Style& style, const Sheet& sheet) {
  return lines_with(sheet.ridges, sheet.valleys, true, terrain, placed, style);
}

std::vector<EdgeLine> lines_of(const TerrainData& terrain, const PlacedView& placed,
                               const Style& style, const SeenGround* ground) {
  std::vector<SurfaceEdge> silhouettes;
  if (style.occluder == Occluder::surface || draws_silhouettes(style))
    silhouettes = silhouette_edges(terrain.surface, placed.view, ground);
  return lines_with(silhouettes, {}, false, terrain, placed, style);
}

} // namespace orograph
