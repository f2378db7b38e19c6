// SPDX-License-Identifier: GPL-3.0-or-later
#include "map/draw_contours.hpp"

#include "dem/surface.hpp"
#include "draw/chain.hpp"
#include "geometry/on_all_cores.hpp"
#include "geometry/sort_by_number.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

namespace orograph {
namespace {

using Runs = std::span<const SeenContours::Run>;

// Runs of a level are all over the memory: waiting for them was a third of the time.
constexpr std::size_t kAhead = 16;
[[gnu::always_inline]] inline void fetch(const ContourPoint& point) {
  __builtin_prefetch(&point);
}

// The points of a level's runs, joined where those meet, way after way.
struct Ways {
  struct Way {
    std::size_t begin, end;
    bool is_ring;
  };
  std::vector<const ContourPoint*> points;
  std::vector<Way> ways;
};

// An end of a run at a node, and the node beside it on the run.
struct EndAtNode {
  std::uint64_t node, beside;
  std::uint64_t* link;
};

// The ends that meet have a number of their own. Where more than two do they are paired by the
// nodes beside them, so that runs may be parted elsewhere.
std::vector<ChainLink> links_of(const SeenContours& contours, Runs runs) {
  std::vector<ChainLink> links(runs.size(), {kLooseEnd, kLooseEnd});
  std::vector<EndAtNode> ends;
  ends.reserve(2 * runs.size());
  for (std::size_t i = 0; i < runs.size(); ++i) {
    throw_if_stopped(i);
    if (i + kAhead < runs.size()) {
      const auto ahead = contours.points(runs[i + kAhead]);
      fetch(ahead.front());
      fetch(ahead.back());
    }
    const auto points = contours.points(runs[i]);
    const auto add = [&](std::size_t at, std::size_t beside, std::uint64_t& link) {
      if (!points[at].node.is_loose())
        ends.push_back({points[at].node.number(), points[beside].node.number(), &link});
    };
    add(0, 1, links[i].begin);
    add(points.size() - 1, points.size() - 2, links[i].end);
  }
  sort_by_number(ends, [](const EndAtNode& end) { return end.node; });
  std::uint64_t pairs = 0;
  for (auto first = ends.begin(); first != ends.end(); ++pairs) {
    const auto end = std::find_if(
        first, ends.end(), [&](const EndAtNode& other) { return other.node != first->node; });
    if (end - first > 2)
      std::sort(first, end,
                [](const EndAtNode& a, const EndAtNode& b) { return a.beside < b.beside; });
    for (auto last = std::min(first + 2, end); first != last; ++first) *first->link = pairs;
  }
  return links;
}

// Orders the ends of ways: by the nodes of the piece there; where that isn't visible up to either
// node, by where it ends.
auto order_of(const ContourPoint& end, const ContourPoint& beside) {
  const auto [low, high] = std::minmax({end.node.number(), beside.node.number()});
  return std::tuple(low, high, end.at.u, end.at.v);
}

// A ring begins at its lowest node, towards the highest of those beside it, which are four where it
// meets itself there; another way at its lower end: so nothing depends on where it was found first.
void put_in_order(Ways& ways, Ways::Way& way) {
  const std::span all = std::span(ways.points).subspan(way.begin, way.end - way.begin);
  const auto number = [](const ContourPoint* point) { return point->node.number(); };
  way.is_ring = number(all.front()) == number(all.back()) && !all.front()->node.is_loose();
  if (!way.is_ring) {
    if (order_of(*all.back(), *all[all.size() - 2]) < order_of(*all[0], *all[1]))
      std::ranges::reverse(all);
    return;
  }
  const std::span ring = all.first(all.size() - 1);
  const std::uint64_t lowest = number(*std::ranges::min_element(ring, {}, number));
  std::size_t start = 0;
  std::uint64_t highest = 0;
  bool is_turned = false;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    if (number(ring[i]) != lowest) continue;
    const std::uint64_t next = number(all[i + 1]),
                        last = number(i == 0 ? ring.back() : ring[i - 1]);
    if (std::max(next, last) <= highest) continue;
    highest = std::max(next, last);
    is_turned = last > next;
    start = i;
  }
  std::ranges::rotate(ring, ring.begin() + static_cast<std::ptrdiff_t>(start));
  all.back() = all.front();
  if (is_turned) std::ranges::reverse(all);
}

Ways ways_of(const SeenContours& contours, Runs runs) {
  const Chains chains = chain(links_of(contours, runs));
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
    return std::tuple(way.is_ring, order_of(*out.points[way.begin], *out.points[way.begin + 1]));
  });
  return out;
}

// Chains pieces from point to point of which nothing is hidden, nearly all there are, by what each
// point has beside it: without sorting them.
class WholePieces {
public:
  /// `first_point`: what has a lower number is a vertex. REQUIRES that the points outlive this.
  WholePieces(std::span<const ProfilePoint> points, std::size_t first_point)
      : points_(points), first_point_(first_point), beside_(points.size(), {kNone, kNone}) {}

  bool takes(SurfaceEdge ends) const { return ends.from >= first_point_; }
  void add(SurfaceEdge ends, std::uint32_t level) {
    link(ends.from, ends.to);
    link(ends.to, ends.from);
    pieces_.push_back({number(ends.from), level});
  }
  /// From end to end, and then rings, of which the first point is the last as well.
  void add_runs(ContourRuns& out) {
    taken_.assign(points_.size(), false);
    out.points.reserve(out.points.size() + pieces_.size() + pieces_.size() / 8);
    for (const bool from_end : {true, false})
      for (const auto& [from, level] : pieces_) {
        throw_if_stopped(out.points.size());
        for (const std::uint32_t end : {from, beside_[from][0], beside_[from][1]})
          if (end != kNone && !taken_[end] && (!from_end || beside_[end][1] == kNone))
            walk(end, level, out);
      }
  }

private:
  static constexpr std::uint32_t kNone = ContourChains::kNone;
  struct Piece {
    std::uint32_t from, level;
  };
  std::uint32_t number(std::uint32_t point) const {
    return point - static_cast<std::uint32_t>(first_point_);
  }
  void link(std::uint32_t from, std::uint32_t to) {
    auto& beside = beside_[number(from)];
    beside[beside[0] == kNone ? 0 : 1] = number(to);
  }
  void walk(std::uint32_t first, std::uint32_t level, ContourRuns& out) {
    const auto add = [&](std::uint32_t point) {
      out.points.push_back({ContourNode(level, first_point_ + point), points_[point]});
    };
    std::uint32_t last = kNone, here = first;
    do {
      taken_[here] = true;
      add(here);
      const auto& beside = beside_[here];
      last = std::exchange(here, beside[beside[0] == last ? 1 : 0]);
    } while (here != kNone && here != first);
    if (here == first) add(first);
    out.end_run();
  }

  std::span<const ProfilePoint> points_;
  std::size_t first_point_;
  std::vector<std::array<std::uint32_t, 2>> beside_;
  std::vector<Piece> pieces_;
  std::vector<bool> taken_;
};

} // namespace

SeenContours take_contours(const Surface& surface, const View& view,
                           const std::vector<EdgeLine>& lines, const GroundLines& on_ground,
                           std::size_t first_line, std::span<const std::uint8_t> whole,
                           std::vector<LinePart>& parts) {
  const EdgeEnds ends(surface, view, {on_ground.points});
  WholePieces whole_pieces(on_ground.points, vertex_count(surface));
  ContourRuns runs;
  // Tells whether it is none of a tick.
  const auto takes = [&](const LinePart& part) {
    const std::uint32_t feature = on_ground.lines[part.line - first_line].feature;
    if (on_ground.features[feature].is_tick) return false;
    const auto level = feature - static_cast<std::uint32_t>(on_ground.first_contour);
    const SurfaceEdge edge = lines[part.line].edge;
    if (part.t_begin <= 0 && part.t_end >= 1 && whole_pieces.takes(edge)) {
      whole_pieces.add(edge, level);
      return true;
    }
    const ProfileLine line = ends(edge);
    const auto add = [&](double t, bool is_node, std::uint32_t node) {
      runs.points.push_back({is_node ? ContourNode(level, node) : ContourNode::loose(level),
                             point_between(line.from, line.to, t)});
    };
    add(part.t_begin, part.t_begin <= 0, edge.from);
    add(part.t_end, part.t_end >= 1, edge.to);
    runs.end_run();
    return true;
  };
  std::size_t step = 0;
  std::erase_if(parts, [&](const LinePart& part) {
    throw_if_stopped(step++);
    return takes(part);
  });
  std::vector<std::uint8_t> ticks;
  for (std::size_t i = 0; i < whole.size(); ++i) {
    throw_if_stopped(i);
    if (whole[i] == 0 || takes({static_cast<std::uint32_t>(first_line + i), 0, 1})) continue;
    ticks.resize(whole.size());
    ticks[i] = 1;
  }
  if (!ticks.empty()) parts = with_whole(parts, first_line, ticks);
  whole_pieces.add_runs(runs);
  return seen_contours({std::move(runs)}, {});
}

double draw_contours(const View& view, const SeenContours& contours, const GroundLines& on_ground,
                     LineKind kind, const StrokeSettings& settings, Layer& layer) {
  std::vector<Runs> levels;
  for (Runs left = contours.by_level; !left.empty();) {
    const std::uint32_t level = left.front().level;
    const auto end = std::ranges::find_if(
        left, [&](const SeenContours::Run& run) { return run.level != level; });
    const auto count = static_cast<std::size_t>(end - left.begin());
    if (on_ground.features[on_ground.first_contour + level].kind == kind)
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
        if (at + kAhead < ways.points.size()) fetch(*ways.points[at + kAhead]);
        const ProfilePoint& here = ways.points[at]->at;
        builder.add({project_homogeneous(view, here), here});
      }
      builder.end();
    }
    drawn[i].left_out_mm = builder.left_out_mm();
    if (own.strokes.empty()) return;
    for (Stroke& stroke : own.strokes) stroke.feature = 0;
    own.features.push_back(
        on_ground.features[on_ground.first_contour + levels[i].front().level].attributes);
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
