// SPDX-License-Identifier: GPL-3.0-or-later
#include "naming/rank_names.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

namespace orograph {
namespace {

double rank_of(const NamedSummit& summit, double haze_m) {
  if (!summit.distance_m) return summit.stature;
  constexpr double kAtTheEye_m = 1;
  const double d_m = std::max(*summit.distance_m, kAtTheEye_m);
  const double falloff = std::max(std::exp(-d_m / haze_m) / std::sqrt(d_m), 1e-300);
  return summit.stature >= 0 ? summit.stature * falloff : summit.stature / falloff;
}

} // namespace

RankedNames ranked(std::span<const NamedSummit> summits, double haze_m) {
  std::vector<double> ranks;
  for (const NamedSummit& summit : summits) ranks.push_back(rank_of(summit, haze_m));
  RankedNames out;
  out.order.resize(summits.size());
  std::iota(out.order.begin(), out.order.end(), std::size_t{0});
  std::ranges::sort(out.order, [&](std::size_t a, std::size_t b) {
    const NamedSummit &one = summits[a], &other = summits[b];
    return std::tie(ranks[b], other.height_m, one.east, one.north, one.text) <
           std::tie(ranks[a], one.height_m, other.east, other.north, other.text);
  });
  out.weights.resize(summits.size());
  const double greatest = summits.empty() ? 0 : ranks[out.order.front()];
  for (std::size_t place = 0; place < out.order.size(); ++place) {
    const std::size_t i = out.order[place];
    const double share = greatest > 0 ? std::max(ranks[i], 0.0) / greatest : 0;
    out.weights[i] = {static_cast<std::int64_t>(std::round(share * 0x1p40)),
                      static_cast<std::int64_t>(out.order.size() - place)};
  }
  return out;
}

} // namespace orograph
