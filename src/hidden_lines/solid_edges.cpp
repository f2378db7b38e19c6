// SPDX-License-Identifier: GPL-3.0-or-later
#include "hidden_lines/solid_edges.hpp"

#include "geometry/on_all_cores.hpp"

#include <algorithm>
#include <optional>

namespace orograph {
namespace {

// The part of a line that has a picture.
std::optional<Share> in_front(const View& view, Vec3 from, Vec3 to) {
  if (!view.is_perspective()) return Share{0, 1};
  const double a = from.y - view.near_m, b = to.y - view.near_m;
  if (a < 0 && b < 0) return std::nullopt;
  return Share{a < 0 ? a / (a - b) : 0, b < 0 ? a / (a - b) : 1};
}

// All edges of one solid.
class EdgesOfSolid {
public:
  EdgesOfSolid(const SolidsInView& solids, std::size_t number, const GroundShadows& ground,
               std::uint32_t first_line)
      : solids_(solids), number_(number), solid_(solids.solids()[number]), ground_(ground),
        first_line_(first_line) {}

  void find(SolidParts& out) {
    const auto& edges = solid_.standing->solid->edges;
    for (std::uint32_t i = 0; i < edges.size(); ++i)
      if (solid_.edges[i] != EdgeFacing::not_drawn) take(i, edges[i], out);
    add_hidden_by_solids();
    add_hidden_by_ground();
    for (Asked& asked : asked_) tell(asked, out);
  }

private:
  // An edge, as far as it has a picture.
  struct Asked {
    std::uint32_t edge;
    Share front;
    LineInView line;
    std::vector<Share> hidden = {};
  };

  void take(std::uint32_t i, const SolidEdge& edge, SolidParts& out) {
    const Vec3 from = solid_.vertices[edge.from], to = solid_.vertices[edge.to];
    const std::optional<Share> front = in_front(solids_.view(), from, to);
    if (!front || from == to) return;
    if (solid_.edges[i] == EdgeFacing::dark) {
      out.hidden.push_back({first_line_ + i, front->begin, front->end});
      return;
    }
    const auto at = [&](double t) { return t >= 1 ? to : from + t * (to - from); };
    asked_.push_back({i, *front, line_in_view(solids_.view(), at(front->begin), at(front->end))});
  }

  void add_hidden_by_solids() {
    for (Asked& asked : asked_) {
      const SolidEdge& edge = solid_.standing->solid->edges[asked.edge];
      solids_.add_hidden(asked.line, {number_, edge.left, edge.right}, asked.hidden);
    }
  }

  void add_hidden_by_ground() {
    const auto add = [](const Shadow& shadow, Asked& asked) {
      if (const auto share = hidden_share(shadow, asked.line.from, asked.line.to))
        asked.hidden.push_back(*share);
    };
    for (const Shadow& shadow : ground_.buried)
      for (Asked& asked : asked_) add(shadow, asked);
    const SightRays rays = sight_rays(solids_.view());
    for (const GroundEdge& edge : ground_.edges) {
      throw_if_stopped();
      std::optional<Shadow> shadow; // made where it may reach an edge
      for (Asked& asked : asked_) {
        const SeenBox& box = asked.line.box;
        if (edge.x_end < box.x_begin || edge.x_begin > box.x_end || edge.y_high < box.y_low)
          continue;
        if (!shadow)
          shadow = edge_shadow(solids_.view(), rays, edge.left, edge.right, ground_.touching_m);
        add(*shadow, asked);
      }
    }
  }

  void tell(Asked& asked, SolidParts& out) const {
    const std::uint32_t line = first_line_ + asked.edge;
    const Share front = asked.front;
    const auto along = [&](double share) {
      return share <= 0   ? front.begin
             : share >= 1 ? front.end
                          : front.begin + share * (front.end - front.begin);
    };
    const double length_m = length(asked.line.to - asked.line.from);
    const double sliver = length_m > 0 ? solids_.sliver_m() / length_m : 1;
    unite(asked.hidden, sliver);
    for (const Share& h : asked.hidden) out.hidden.push_back({line, along(h.begin), along(h.end)});
    for_each_rest(asked.hidden, 0, 1, sliver, [&](Share rest) {
      out.visible.push_back({line, along(rest.begin), along(rest.end)});
    });
  }

  const SolidsInView& solids_;
  std::size_t number_;
  const SolidInView& solid_;
  const GroundShadows& ground_;
  std::uint32_t first_line_;
  std::vector<Asked> asked_;
};

} // namespace

SolidParts seen_edges(const SolidsInView& solids, const std::vector<GroundShadows>& ground) {
  const std::size_t count = solids.solids().size();
  std::vector<std::uint32_t> first_line(count + 1);
  for (std::size_t i = 0; i < count; ++i)
    first_line[i + 1] = first_line[i] + static_cast<std::uint32_t>(
                                            solids.solids()[i].standing->solid->edges.size());
  std::vector<SolidParts> of_solids(count);
  on_all_cores(count, [&](std::size_t i) {
    EdgesOfSolid(solids, i, ground[i], first_line[i]).find(of_solids[i]);
  });
  SolidParts out;
  for (const SolidParts& parts : of_solids) {
    out.visible.insert(out.visible.end(), parts.visible.begin(), parts.visible.end());
    out.hidden.insert(out.hidden.end(), parts.hidden.begin(), parts.hidden.end());
  }
  return out;
}

} // namespace orograph
