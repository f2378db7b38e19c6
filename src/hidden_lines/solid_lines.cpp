// SPDX-License-Identifier: GPL-3.0-or-later
#include "hidden_lines/solid_lines.hpp"

#include "dem/triangles_over.hpp"
#include "geometry/on_all_cores.hpp"
#include "hidden_lines/sheet_shadows.hpp"
#include "placing/block.hpp"
#include "profiles/slab_lines.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace orograph {
namespace {

// A straight piece of ground that stands in front of a solid, or beside it.
struct GroundEdge {
  Vec3 left, right;              // profile frame
  double x_begin, x_end, y_high; // in the visibility plane
};

struct GroundShadows {
  std::vector<GroundEdge> edges;        // see `edge_shadow`
  std::vector<Shadow> buried;           // by triangles of the ground
  std::vector<TriangleShadow> of_sheet; // instead, where it has two sides
  double touching_m = 0;                // what is under ground by less lies on it
};

// What lies on the ground by no more than this lies on it, times the rounding of positions: a
// triangle's plane is told by three of them, across its own slope.
constexpr double kTouching = 16;

struct Found {
  std::uint32_t solid;
  GroundEdge edge;
};

// Edges of the ground, against the solids that they may stand in front of.
class EdgeShadows {
public:
  EdgeShadows(const SolidsInView& solids, const View& view) : solids_(solids), view_(view) {}

  void add(ProfilePoint from, ProfilePoint to, std::vector<Found>& found) const {
    if (view_.is_perspective()) {
      const double near_m = view_.near_m;
      if (from.v < near_m && to.v < near_m) return;
      if (std::min(from.v, to.v) < near_m)
        (from.v < to.v ? from : to) = point_between(from, to, (near_m - from.v) / (to.v - from.v));
    }
    Vec2 left = project(view_, from), right = project(view_, to);
    if (left.x > right.x) {
      std::swap(left, right);
      std::swap(from, to);
    }
    if (!(left.x < right.x)) return;
    const double high = std::max(left.y, right.y);
    const std::size_t first = found.size();
    solids_.for_each_behind(left.x, right.x, high, std::min(from.v, to.v), [&](std::size_t i) {
      // It may be in several buckets of X.
      for (std::size_t k = first; k < found.size(); ++k)
        if (found[k].solid == i) return;
      found.push_back(
          {static_cast<std::uint32_t>(i), {as_vec(from), as_vec(to), left.x, right.x, high}});
    });
  }

private:
  const SolidsInView& solids_;
  const View& view_;
};

void add_buried(const TerrainData& terrain, const PlacedView& placed, const SolidsInView& solids,
                std::vector<GroundShadows>& out) {
  std::vector<Box2> boxes;
  for (const SolidInView& solid : solids.solids()) {
    Box2 box;
    for (const Vec3& vertex : solid.standing->vertices_m) box.include({vertex.x, vertex.y});
    boxes.push_back(box);
  }
  const auto triangles = triangles_over(terrain.surface, placed.extent, boxes);
  on_all_cores(boxes.size(), [&](std::size_t i) {
    for (const GroundTriangle& triangle : triangles[i]) {
      std::array<Vec3, 3> corners;
      for (std::size_t k = 0; k < 3; ++k)
        corners[k] = as_vec(to_profile_frame(solids.view(), triangle[k]));
      out[i].buried.push_back(buried_under(corners, out[i].touching_m));
    }
  });
}

void add_near_cut(std::span<const Segment> near_cut, const EdgeShadows& shadows, const View& view,
                  std::vector<Found>& found) {
  for (const Segment& s : near_cut)
    shadows.add({s.x0 * view.near_m, view.near_m, s.y0 * view.near_m + view.eye_z_m},
                {s.x1 * view.near_m, view.near_m, s.y1 * view.near_m + view.eye_z_m}, found);
}

// For each solid the shadows of ground that may reach it: of lines, of the near cut, and of the
// triangles about it that bury it.
std::vector<GroundShadows> ground_shadows(const HidingGround& ground, const SolidsInView& solids) {
  const auto& [terrain, placed, sector, lines, visible, near_cut, sheet, sheet_part] = ground;
  const View& view = sector.view;
  std::vector<GroundShadows> out(solids.solids().size());
  for (std::size_t i = 0; i < out.size(); ++i)
    out[i].touching_m = kTouching * solids.solids()[i].rounding_m;
  if (sheet) {
    std::vector<double> touching_m;
    for (const GroundShadows& of : out) touching_m.push_back(of.touching_m);
    auto shadows = sheet_shadows(ground, solids, touching_m);
    for (std::size_t i = 0; i < out.size(); ++i) out[i].of_sheet = std::move(shadows[i]);
    // An eye on a closed block is in the plane of what it stands on, which hides nothing then.
    if (placed.block_base_m && view.is_perspective() &&
        view.eye_z_m > base_z_m(*placed.block_base_m, view, terrain.map)) {
      std::vector<Found> found;
      add_near_cut(near_cut, EdgeShadows(solids, view), view, found);
      for (const auto& [solid, edge] : found) out[solid].edges.push_back(edge);
    }
    return out;
  }
  add_buried(terrain, placed, solids, out);
  // Straight down, nothing stands in front of anything.
  if (!view.is_perspective() && !(view.y_per_z > 0)) return out;

  const EdgeShadows shadows(solids, view);
  const EdgeEnds ends(terrain.surface, view);
  std::vector<LinePart> hiding;
  for (const LinePart& part : visible)
    if (lines[part.line].hides) hiding.push_back(part);
  for (std::size_t i = 0; i < lines.size(); ++i)
    if (lines[i].hides && !lines[i].drawn) hiding.push_back({static_cast<std::uint32_t>(i), 0, 1});
  constexpr std::size_t kPartsOfTask = 1U << 12U;
  const std::size_t tasks = (hiding.size() + kPartsOfTask - 1) / kPartsOfTask;
  std::vector<std::vector<Found>> of_tasks(tasks + 1); // the last for the near cut
  on_all_cores(tasks, [&](std::size_t task) {
    const std::size_t end = std::min(hiding.size(), (task + 1) * kPartsOfTask);
    for (std::size_t i = task * kPartsOfTask; i < end; ++i) {
      const ProfileLine line = ends(lines[hiding[i].line].edge);
      shadows.add(point_between(line.from, line.to, hiding[i].t_begin),
                  point_between(line.from, line.to, hiding[i].t_end), of_tasks[task]);
    }
  });
  add_near_cut(near_cut, shadows, view, of_tasks.back());
  for (const auto& found : of_tasks)
    for (const auto& [solid, edge] : found) out[solid].edges.push_back(edge);
  return out;
}

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
    for (const TriangleShadow& of : ground_.of_sheet) {
      throw_if_stopped();
      for (Asked& asked : asked_)
        if (SolidsInView::overlap(asked.line.box, of.box) &&
            of.box.nearest_m <= asked.line.box.farthest_m)
          add(of.shadow, asked);
    }
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

SolidParts seen_edges(const SolidsInView& solids, const HidingGround* ground) {
  const std::size_t count = solids.solids().size();
  const std::vector<GroundShadows> shadows =
      ground ? ground_shadows(*ground, solids) : std::vector<GroundShadows>(count);
  std::vector<std::uint32_t> first_line(count + 1);
  for (std::size_t i = 0; i < count; ++i)
    first_line[i + 1] = first_line[i] + static_cast<std::uint32_t>(
                                            solids.solids()[i].standing->solid->edges.size());
  std::vector<SolidParts> of_solids(count);
  on_all_cores(count, [&](std::size_t i) {
    EdgesOfSolid(solids, i, shadows[i], first_line[i]).find(of_solids[i]);
  });
  SolidParts out;
  for (const SolidParts& parts : of_solids) {
    out.visible.insert(out.visible.end(), parts.visible.begin(), parts.visible.end());
    out.hidden.insert(out.hidden.end(), parts.hidden.begin(), parts.hidden.end());
  }
  return out;
}

void keep_in_range(SolidParts& parts, std::span<const StandingSolid> standing, const View& view,
                   XRange range) {
  struct NumberedEdge {
    const StandingSolid* solid;
    const SolidEdge* edge;
  };
  std::vector<NumberedEdge> edges;
  for (const StandingSolid& solid : standing)
    for (const SolidEdge& edge : solid.solid->edges) edges.push_back({&solid, &edge});
  for (std::vector<LinePart>* of_kind : {&parts.visible, &parts.hidden}) {
    for (LinePart& part : *of_kind) {
      const auto& [solid, edge] = edges[part.line];
      const ProfilePoint from = to_profile_frame(view, solid->vertices_m[edge->from]),
                         to = to_profile_frame(view, solid->vertices_m[edge->to]);
      // Of both sides of the range, 0 or more inside; linear along the edge.
      for (const auto& [a, b] :
           {std::pair{from.u - range.begin * from.v, to.u - range.begin * to.v},
            std::pair{range.end * from.v - from.u, range.end * to.v - to.u}}) {
        if (a >= 0 && b >= 0) continue;
        const double crossing = a < 0 && b < 0 ? 0 : a / (a - b);
        if (a < 0) part.t_begin = b < 0 ? part.t_end : std::max(part.t_begin, crossing);
        if (b < 0) part.t_end = std::min(part.t_end, crossing);
      }
    }
    std::erase_if(*of_kind, [](const LinePart& part) { return !(part.t_begin < part.t_end); });
  }
}

namespace {

// What of a line's part is left, from a share of the line to another.
class Remover {
public:
  explicit Remover(const SolidsInView& solids) : solids_(solids) {}

  // Calls `take` with each part that is left.
  template <class Take>
  void take_rest(const LineInView& line, Share asked, const Take& take) {
    hidden_.clear();
    solids_.add_hidden(line, {}, hidden_);
    if (hidden_.empty()) {
      take(asked);
      return;
    }
    const double length_m = length(line.to - line.from);
    const double sliver = length_m > 0 ? solids_.sliver_m() / length_m : 1;
    unite(hidden_, sliver);
    for_each_rest(hidden_, asked.begin, asked.end, sliver, take);
  }

private:
  const SolidsInView& solids_;
  std::vector<Share> hidden_;
};

} // namespace

void leave_out_behind(const SolidsInView& solids, const Profile& profile,
                      std::vector<VisibleRun>& runs) {
  const View& view = solids.view();
  const double depth_m = profile.depth_m;
  // `project`, at one depth.
  const Vec2 origin = project(view, {0, depth_m, 0});
  const Vec2 step = project(view, {1, depth_m, 1}) - origin;
  const auto at = [&](std::uint32_t i) { return Vec3{profile.u_m[i], depth_m, profile.z_m[i]}; };
  const auto picture = [&](std::uint32_t i) {
    return Vec2{origin.x + step.x * profile.u_m[i], origin.y + step.y * profile.z_m[i]};
  };
  std::vector<VisibleRun> left;
  Remover remover(solids);
  for (const VisibleRun& run : runs) {
    Vec2 from = picture(run.first);
    if (!solids.any_in(from.x, picture(run.last + 1).x)) {
      left.push_back(run);
      continue;
    }
    bool joins = false; // the next span to the last of `left`
    for (std::uint32_t i = run.first; i <= run.last; ++i) {
      const Vec2 to = picture(i + 1);
      const LineInView line{
          at(i),
          at(i + 1),
          {from.x, to.x, std::min(from.y, to.y), std::max(from.y, to.y), depth_m, depth_m}};
      from = to;
      const Share asked{i == run.first ? run.t_begin : 0, i == run.last ? run.t_end : 1};
      bool next_joins = false;
      remover.take_rest(line, asked, [&](Share rest) {
        if (joins && rest.begin <= 0) {
          left.back().last = i;
          left.back().t_end = rest.end;
        } else {
          left.push_back({i, i, rest.begin, rest.end});
        }
        joins = false;
        next_joins = rest.end >= 1;
      });
      joins = next_joins;
    }
  }
  runs = std::move(left);
}

std::vector<LinePart> not_behind(const SolidsInView& solids, const LinePictures& lines,
                                 const std::vector<LinePart>& parts) {
  std::vector<LinePart> left;
  left.reserve(parts.size());
  Remover remover(solids);
  for (const LinePart& part : parts) {
    throw_if_stopped(left.size());
    // Only what is asked for is sure to be in front of the eye.
    const Vec3 from = as_vec(lines.point(part.line, part.t_begin)),
               to = as_vec(lines.point(part.line, part.t_end));
    const double scale = part.t_end - part.t_begin;
    remover.take_rest(line_in_view(solids.view(), from, to), {0, 1}, [&](Share rest) {
      left.push_back({part.line, rest.begin <= 0 ? part.t_begin : part.t_begin + rest.begin * scale,
                      rest.end >= 1 ? part.t_end : part.t_begin + rest.end * scale});
    });
  }
  return left;
}

} // namespace orograph
