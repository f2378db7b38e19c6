// SPDX-License-Identifier: GPL-3.0-or-later
#include "horizon/upright.hpp"

#include "horizon/blocked_horizon.hpp"
#include "horizon/horizon_pieces.hpp"

#include <algorithm>
#include <limits>

namespace orograph {
namespace {

template <class AnyHorizon>
double height_of(const AnyHorizon& horizon, double x) {
  const auto piece = pieces_from(horizon, x);
  return is_sky(*piece) ? -std::numeric_limits<double>::infinity() : height_at(piece->source, x);
}

} // namespace

template <class AnyHorizon>
std::vector<Piece> visible_uprights(std::span<const Segment> uprights, const AnyHorizon& horizon,
                                    double beside) {
  std::vector<Piece> visible;
  for (std::uint32_t i = 0; i < uprights.size(); ++i) {
    const Segment& s = uprights[i];
    const double horizon_y =
        std::min(height_of(horizon, s.x0 - beside), height_of(horizon, s.x0 + beside));
    if (s.y0 == s.y1 || std::max(s.y0, s.y1) <= horizon_y) continue;
    const double share = std::min(s.y0, s.y1) >= horizon_y ? 0 : (horizon_y - s.y0) / (s.y1 - s.y0);
    if (s.y0 < s.y1)
      visible.push_back({i, s.x0, s.x0, share, 1});
    else
      visible.push_back({i, s.x0, s.x0, 0, share > 0 ? share : 1});
  }
  return visible;
}

template std::vector<Piece> visible_uprights(std::span<const Segment>, const Horizon&, double);
template std::vector<Piece> visible_uprights(std::span<const Segment>, const BlockedHorizon&,
                                             double);

void insert_uprights(std::span<const Segment> uprights, std::span<const Piece> visible_uprights,
                     std::vector<Segment>& segments, std::vector<Piece>& visible) {
  const std::vector<Segment> others = std::move(segments);
  segments.clear();
  std::vector<std::uint32_t> number_of_other(others.size()), number_of_upright(uprights.size());
  for (std::size_t i = 0, k = 0; i < others.size() || k < uprights.size();) {
    const bool other = k == uprights.size() || (i < others.size() && others[i].id < uprights[k].id);
    (other ? number_of_other[i] : number_of_upright[k]) =
        static_cast<std::uint32_t>(segments.size());
    segments.push_back(other ? others[i++] : uprights[k++]);
  }
  for (Piece& piece : visible) piece.segment = number_of_other[piece.segment];
  const auto middle = static_cast<std::ptrdiff_t>(visible.size());
  for (Piece piece : visible_uprights) {
    piece.segment = number_of_upright[piece.segment];
    visible.push_back(piece);
  }
  std::inplace_merge(visible.begin(), visible.begin() + middle, visible.end(),
                     [](const Piece& a, const Piece& b) { return a.segment < b.segment; });
}

} // namespace orograph
