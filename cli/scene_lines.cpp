// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/scene_lines.hpp"

#include "profiles/ground_behind.hpp"
#include "profiles/silhouettes.hpp"

#include <algorithm>

namespace orograph {

bool asks_for(const RenderSettings& settings, std::string_view layer) {
  return std::find(settings.layers.begin(), settings.layers.end(), layer) != settings.layers.end();
}

std::vector<SweptLine> lines_of(const Terrain& terrain, const Scene& scene,
                                const RenderSettings& settings) {
  // With the seed's occluders only what is drawn of the profiles hides.
  const bool surface = settings.occluder == Occluder::surface;
  const bool silhouettes = asks_for(settings, "silhouettes") || asks_for(settings, "skyline");
  const bool border = asks_for(settings, "border");
  std::vector<SweptLine> lines;
  std::vector<SurfaceEdge> edges;
  if (surface || silhouettes) edges = silhouette_edges(terrain.grid, scene.view);
  for (const SurfaceEdge& edge : edges)
    lines.push_back({edge, LineKind::silhouette, surface, silhouettes});
  if (surface || border)
    for (const BorderEdge& edge : scene.border)
      lines.push_back({edge.edge, LineKind::border, surface, border});
  if (asks_for(settings, "shores")) {
    // A shore that is a silhouette as well is drawn as such, once.
    const auto before = [](const SurfaceEdge& a, const SurfaceEdge& b) {
      return a.from != b.from ? a.from < b.from : a.to < b.to;
    };
    if (!silhouettes) edges.clear();
    std::sort(edges.begin(), edges.end(), before);
    for (const SurfaceEdge& edge : scene.level.shores)
      if (!std::binary_search(edges.begin(), edges.end(), edge, before))
        lines.push_back({edge, LineKind::shore, false, true});
  }
  return lines;
}

std::vector<LinePart> folds(const LineSweep& sweep, const std::vector<LinePart>& parts,
                            const Grid& grid, const View& view, double share,
                            double parallel_depth_m) {
  std::vector<LinePart> out;
  if (share <= 0) return out;
  const GroundBehind ground(grid, view);
  for (const LinePart& part : parts) {
    if (sweep.line(part.line).kind != LineKind::silhouette) continue;
    const ProfilePoint middle = sweep.point(part.line, 0.5 * (part.t_begin + part.t_end));
    const double depth = view.is_perspective() ? middle.v : parallel_depth_m;
    if (ground.rises_within(middle, share * depth)) out.push_back(part);
  }
  return out;
}

} // namespace orograph
