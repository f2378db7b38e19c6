// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/solids/solid_edges.hpp"

#include "draw/chain.hpp"
#include "geometry/on_all_cores.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <set>
#include <utility>

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

namespace {

// Ends of a part on the page, the lower first, in the page's steps; none without a picture.
using PageEnds = std::array<double, 4>;

class EdgePlaces {
public:
  EdgePlaces(std::span<const StandingSolid> standing, const View& view)
      : standing_(standing), view_(view), lines_(lines_of(standing)) {}

  const SolidLine& line(const LinePart& part) const { return lines_[part.line]; }
  const SolidEdge& edge(const LinePart& part) const {
    return standing_[line(part).solid].solid->edges[line(part).edge];
  }
  ProfilePoint point(const LinePart& part, double t) const {
    const auto& vertices = standing_[line(part).solid].vertices_m;
    return point_between(to_profile_frame(view_, vertices[edge(part).from]),
                         to_profile_frame(view_, vertices[edge(part).to]), t);
  }
  PageEnds ends(const LinePart& part, const Homography& to_page) const {
    const auto at = [&](double t) {
      const Vec3 page = to_page.of(project_homogeneous(view_, point(part, t)));
      return std::array{std::round(page.x / page.z / kPageStep_mm),
                        std::round(page.y / page.z / kPageStep_mm)};
    };
    auto [a, b] = std::pair(at(part.t_begin), at(part.t_end));
    if (b < a) std::swap(a, b);
    return {a[0], a[1], b[0], b[1]};
  }

private:
  std::span<const StandingSolid> standing_;
  const View& view_;
  std::vector<SolidLine> lines_;
};

} // namespace

std::vector<SolidLine> lines_of(std::span<const StandingSolid> standing) {
  std::vector<SolidLine> lines;
  for (std::uint32_t solid = 0; solid < standing.size(); ++solid)
    for (std::uint32_t edge = 0; edge < standing[solid].solid->edges.size(); ++edge)
      lines.push_back({solid, edge});
  return lines;
}

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

void drop_repeated(std::span<const StandingSolid> standing, const View& view,
                   const Homography& to_page, const std::vector<LinePart>& drawn,
                   std::vector<LinePart>& parts) {
  const EdgePlaces places(standing, view);
  std::set<PageEnds> known;
  for (const LinePart& part : drawn) known.insert(places.ends(part, to_page));
  std::erase_if(parts, [&](const LinePart& part) {
    return !known.insert(places.ends(part, to_page)).second;
  });
}

void draw_edges(std::span<const StandingSolid> standing, const View& view,
                const std::vector<LinePart>& parts, StrokeBuilder& builder) {
  std::vector<std::uint64_t> first_vertex(standing.size() + 1);
  for (std::size_t i = 0; i < standing.size(); ++i)
    first_vertex[i + 1] = first_vertex[i] + standing[i].vertices_m.size();
  const EdgePlaces places(standing, view);
  std::vector<ChainLink> links;
  for (const LinePart& part : parts) {
    const SolidEdge& edge = places.edge(part);
    const std::uint64_t first = first_vertex[places.line(part).solid];
    links.push_back({part.t_begin <= 0 ? first + edge.from : kLooseEnd,
                     part.t_end >= 1 ? first + edge.to : kLooseEnd});
  }
  const Chains chains = chain(links);
  for (std::size_t i = 0; i < chains.size(); ++i) {
    builder.begin(-1, std::numeric_limits<double>::quiet_NaN());
    bool is_first = true;
    for (const auto& [piece, turned] : chains[i]) {
      const LinePart& part = parts[piece];
      const auto add = [&](double t) {
        const ProfilePoint at = places.point(part, t);
        builder.add({project_homogeneous(view, at), at});
      };
      if (is_first) add(turned ? part.t_end : part.t_begin);
      add(turned ? part.t_begin : part.t_end);
      is_first = false;
    }
    builder.end();
  }
}

} // namespace orograph
