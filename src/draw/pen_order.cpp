// SPDX-License-Identifier: GPL-3.0-or-later
#include "draw/pen_order.hpp"

#include "draw/chain.hpp"
#include "draw/pen_route.hpp"
#include "draw/shorten_route.hpp"
#include "geometry/on_all_cores.hpp"
#include "geometry/sort_by_number.hpp"

#include <algorithm>
#include <cmath>
#include <compare>
#include <cstdint>
#include <limits>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

namespace orograph {
namespace {

// All that is told of a stroke besides its points. Its depth goes with its profile.
auto kind_of(const Stroke& stroke) {
  return std::tuple(stroke.width_mm, stroke.profile, stroke.level, stroke.feature,
                    std::isnan(stroke.darkness) ? -1.0F : stroke.darkness);
}

enum class Meeting { of_one_kind, any };

// Where strokes' ends meet, by numbers that rise with the place.
std::vector<ChainLink> meetings(const Layer& layer, Meeting which) {
  struct Met {
    Vec2 at_mm;
    std::uint32_t end; ///< 2 * stroke: of its first point; 2 * stroke + 1: of its last
  };
  std::vector<Met> ends;
  ends.reserve(2 * layer.strokes.size());
  for (std::uint32_t i = 0; i < layer.strokes.size(); ++i) {
    const std::span<const Vec2> points = layer.points(layer.strokes[i]);
    ends.push_back({points.front(), 2 * i});
    ends.push_back({points.back(), 2 * i + 1});
  }
  const auto compared = [&](const Met& a, const Met& b) -> std::partial_ordering {
    if (const auto by_x = a.at_mm.x <=> b.at_mm.x; by_x != 0) return by_x;
    if (const auto by_y = a.at_mm.y <=> b.at_mm.y; by_y != 0) return by_y;
    if (which == Meeting::any) return std::partial_ordering::equivalent;
    return kind_of(layer.strokes[a.end / 2]) <=> kind_of(layer.strokes[b.end / 2]);
  };
  double least_mm = 0;
  for (const Met& end : ends) least_mm = std::min(least_mm, end.at_mm.x);
  const auto step_of = [&](const Met& end) {
    return static_cast<std::uint64_t>((end.at_mm.x - least_mm) / kPageStep_mm);
  };
  sort_by_number_then(ends, step_of, [&](const Met& a, const Met& b) {
    const std::partial_ordering order = compared(a, b);
    return order != 0 ? order < 0 : a.end < b.end;
  });
  std::vector<ChainLink> links(layer.strokes.size());
  std::uint64_t meeting = 0;
  for (std::size_t i = 0; i < ends.size(); ++i) {
    if (i > 0 && compared(ends[i], ends[i - 1]) != 0) ++meeting;
    ChainLink& link = links[ends[i].end / 2];
    (ends[i].end % 2 == 0 ? link.begin : link.end) = meeting;
  }
  return links;
}

// Appends points to the last stroke of `out`, or begins one like `like`. The first of them is there
// already where the stroke goes on.
void draw_on(Layer& out, std::span<const Vec2> points, bool turned, bool goes_on,
             const Stroke& like) {
  if (!goes_on) {
    out.strokes.push_back(like);
    out.strokes.back().first_point = static_cast<std::uint32_t>(out.page_mm.size());
    out.strokes.back().point_count = 0;
  }
  const std::size_t size = points.size();
  for (std::size_t i = goes_on ? 1 : 0; i < size; ++i)
    out.page_mm.push_back(points[turned ? size - 1 - i : i]);
  out.strokes.back().point_count += static_cast<std::uint32_t>(size - (goes_on ? 1 : 0));
}

Layer without_strokes(const Layer& layer) {
  Layer out;
  out.name = layer.name;
  out.pen_width_mm = layer.pen_width_mm;
  out.grey = layer.grey;
  out.colour = layer.colour;
  out.is_hidden = layer.is_hidden;
  out.pen = layer.pen;
  out.features = layer.features;
  out.fields = layer.fields;
  out.texts = layer.texts;
  return out;
}

Layer merged(const Layer& layer, const Chains& chains) {
  Layer out = without_strokes(layer);
  out.page_mm.reserve(layer.page_mm.size());
  for (std::size_t i = 0; i < chains.size(); ++i) {
    throw_if_stopped(i);
    bool goes_on = false;
    for (const auto& [piece, turned] : chains[i]) {
      const Stroke& stroke = layer.strokes[piece];
      draw_on(out, layer.points(stroke), turned, goes_on, stroke);
      goes_on = true;
    }
  }
  return out;
}

// Whether each stroke is a chain of its own, as it is and in its place.
bool are_strokes(const Chains& chains) {
  for (std::uint32_t i = 0; i < chains.pieces.size(); ++i)
    if (chains.pieces[i].piece != i || chains.pieces[i].turned) return false;
  return chains.size() == chains.pieces.size();
}

// A layer's strokes as lines that are drawn without lifting the pen.
class LinesOfLayer {
public:
  explicit LinesOfLayer(Layer& layer)
      : layer_(layer), chains_(chain(meetings(layer, Meeting::any))) {
    std::vector<Vec2> places;
    for (std::size_t i = 0; i < chains_.size(); ++i) {
      throw_if_stopped(i);
      const std::span<const ChainedPiece> chain = chains_[i];
      const Vec2 begin = first_of(chain.front()), end = last_of(chain.back());
      if (begin != end) {
        lines_.add_open(begin, end);
        continue;
      }
      // A stroke begins anywhere; of several the first is one of them.
      places.clear();
      const std::span<const Vec2> points = points_of(chain.front());
      if (chain.size() == 1)
        places.assign(points.begin(), points.end() - 1);
      else
        for (const ChainedPiece& piece : chain) places.push_back(first_of(piece));
      lines_.add_ring(places);
    }
  }

  const PenLines& lines() const { return lines_; }

  /// Appends a line's strokes, begun at a place. Their points stay where they are in the layer, but
  /// for those of strokes that are turned round or that begin elsewhere.
  void draw(std::uint32_t place, std::vector<Stroke>& out) {
    const std::uint32_t line = lines_.line_of(place);
    const std::span<const ChainedPiece> chain = chains_[line];
    const std::uint32_t begin = place - lines_.first_place(line);
    if (!lines_.is_ring(line)) {
      for (std::size_t i = 0; i < chain.size(); ++i) {
        const auto& [piece, turned] = chain[begin == 0 ? i : chain.size() - 1 - i];
        draw_piece({piece, turned != (begin == 1)}, out);
      }
    } else if (chain.size() > 1) {
      for (std::size_t i = 0; i < chain.size(); ++i)
        draw_piece(chain[(begin + i) % chain.size()], out);
    } else {
      const std::span<Vec2> points = changeable_points_of(chain.front());
      std::ranges::rotate(points.first(points.size() - 1), points.begin() + begin);
      points.back() = points.front();
      draw_piece({chain.front().piece, false}, out);
    }
  }

private:
  std::span<const Vec2> points_of(const ChainedPiece& piece) const {
    return layer_.points(layer_.strokes[piece.piece]);
  }
  Vec2 first_of(const ChainedPiece& piece) const {
    return piece.turned ? points_of(piece).back() : points_of(piece).front();
  }
  Vec2 last_of(const ChainedPiece& piece) const {
    return piece.turned ? points_of(piece).front() : points_of(piece).back();
  }
  std::span<Vec2> changeable_points_of(const ChainedPiece& piece) {
    const Stroke& stroke = layer_.strokes[piece.piece];
    return std::span(layer_.page_mm).subspan(stroke.first_point, stroke.point_count);
  }
  void draw_piece(const ChainedPiece& piece, std::vector<Stroke>& out) {
    if (piece.turned) std::ranges::reverse(changeable_points_of(piece));
    out.push_back(layer_.strokes[piece.piece]);
  }

  Layer& layer_;
  Chains chains_;
  PenLines lines_;
};

// Of the layers from `first` on that have a pen, the one with a stroke's end nearest to `pen`.
std::size_t nearest_layer(const Drawing& drawing, std::size_t first, Vec2 pen) {
  std::size_t nearest = first;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = first; i < drawing.layers.size(); ++i) {
    const Layer& layer = drawing.layers[i];
    if (!layer.pen || layer.is_pen_way) continue;
    std::size_t step = 0;
    for (const Stroke& stroke : layer.strokes) {
      throw_if_stopped(step++);
      const std::span<const Vec2> points = layer.points(stroke);
      for (const Vec2 end : {points.front(), points.back()})
        if (const double distance = dot(end - pen, end - pen); distance < least) {
          least = distance;
          nearest = i;
        }
    }
  }
  return nearest;
}

} // namespace

Layer merged(const Layer& layer) {
  return merged(layer, chain(meetings(layer, Meeting::of_one_kind)));
}

void order_for_pen(Drawing& drawing, PenOrder order) {
  if (order == PenOrder::drawing) return;
  Vec2 pen{0, 0};
  for (std::size_t i = 0; i < drawing.layers.size(); ++i) {
    if (drawing.layers[i].pen)
      std::swap(drawing.layers[i], drawing.layers[nearest_layer(drawing, i, pen)]);
    Layer& layer = drawing.layers[i];
    if (layer.strokes.empty() || layer.is_pen_way) continue;
    // Where nothing meets, as of profiles, there is nothing to merge: a copy took a fifth of the
    // time.
    if (const Chains chains = chain(meetings(layer, Meeting::of_one_kind)); !are_strokes(chains))
      layer = merged(layer, chains);
    LinesOfLayer lines(layer);
    PenRoute route = nearest_first(lines.lines(), pen);
    if (order == PenOrder::best) route = shortened(lines.lines(), pen, route);
    std::vector<Stroke> strokes;
    strokes.reserve(layer.strokes.size());
    for (const std::uint32_t place : route) {
      throw_if_stopped(strokes.size());
      lines.draw(place, strokes);
    }
    layer.strokes = std::move(strokes);
    layer.depths_m = {};
    pen = layer.points(layer.strokes.back()).back();
  }
}

} // namespace orograph
