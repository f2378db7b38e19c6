// SPDX-License-Identifier: GPL-3.0-or-later
#include "horizon/clip_line.hpp"

#include "horizon/compare.hpp"

#include <algorithm>

namespace orograph {
namespace {

void append(std::vector<LinePart>& out, std::size_t first, double begin, double end) {
  if (!(begin < end)) return;
  if (out.size() > first && out.back().end == begin)
    out.back().end = end;
  else
    out.push_back({begin, end});
}

// The first piece that reaches to or beyond x.
Horizon::const_iterator piece_at(const Horizon& horizon, double x) {
  return std::partition_point(horizon.begin(), horizon.end(),
                              [&](const HorizonPiece& piece) { return piece.x_end < x; });
}

void clip_upright(Vec2 a, Vec2 b, const Horizon& horizon, std::vector<LinePart>& out) {
  double height = -std::numeric_limits<double>::infinity();
  for (auto piece = piece_at(horizon, a.x); piece != horizon.end() && piece->x_begin <= a.x;
       ++piece)
    if (!is_sky(*piece)) height = std::max(height, height_at(piece->source, a.x));
  const double from = a.y - height, to = b.y - height;
  if (from <= 0 && to <= 0) return;
  // from / (from - to) would be inf / nan under the open sky.
  const bool crosses = (from > 0) != (to > 0);
  const double crossing = crosses ? from / (from - to) : 0;
  out.push_back({from > 0 || !crosses ? 0 : crossing, to > 0 || !crosses ? 1 : crossing});
}

} // namespace

void clip_line(Vec2 a, Vec2 b, const Horizon& horizon, std::vector<LinePart>& out) {
  if (a.x == b.x) {
    clip_upright(a, b, horizon, out);
    return;
  }
  using enum Standing::Kind;
  const bool turned = a.x > b.x;
  const Segment line = turned ? Segment{b.x, b.y, a.x, a.y, 0} : Segment{a.x, a.y, b.x, b.y, 0};
  const std::size_t first = out.size();
  for (auto piece = piece_at(horizon, line.x0); piece != horizon.end() && piece->x_begin < line.x1;
       ++piece) {
    const double t_begin = parameter_at(line, piece->x_begin);
    const double t_end = parameter_at(line, piece->x_end);
    if (!(t_begin < t_end)) continue;
    if (is_sky(*piece)) {
      append(out, first, t_begin, t_end);
      continue;
    }
    const Standing standing = compare(line, piece->source, {});
    const double t = std::clamp(standing.t, t_begin, t_end);
    if (standing.kind == above) append(out, first, t_begin, t_end);
    if (standing.kind == above_then_below) append(out, first, t_begin, t);
    if (standing.kind == below_then_above) append(out, first, t, t_end);
  }
  if (!turned) return;
  std::reverse(out.begin() + static_cast<std::ptrdiff_t>(first), out.end());
  for (std::size_t i = first; i < out.size(); ++i) out[i] = {1 - out[i].end, 1 - out[i].begin};
  std::erase_if(out, [](const LinePart& part) { return !(part.begin < part.end); });
}

} // namespace orograph
