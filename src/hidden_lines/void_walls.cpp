// SPDX-License-Identifier: GPL-3.0-or-later
#include "hidden_lines/void_walls.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace orograph {
namespace {

// Points that rims connect have one number: that of a void, or of several that touch.
class Connected {
public:
  Connected(std::size_t points, std::span<const VoidRim> rims) : parents_(points) {
    std::iota(parents_.begin(), parents_.end(), 0U);
    for (const VoidRim& rim : rims) {
      const std::uint32_t a = of(rim.from), b = of(rim.to);
      parents_[std::max(a, b)] = std::min(a, b);
    }
  }
  std::uint32_t of(std::uint32_t point) {
    while (parents_[point] != point) {
      parents_[point] = parents_[parents_[point]];
      point = parents_[point];
    }
    return point;
  }

private:
  std::vector<std::uint32_t> parents_;
};

// A void's near rim over X: the lowest of it in bins of equal width.
struct NearRim {
  XRange x{kInfinity, -kInfinity};
  std::uint32_t rims = 0;
  bool is_ahead = true; ///< all of it is
  std::vector<double> lowest = {};

  template <class Take>
  void for_each_bin(XRange of, const Take& take) {
    // To rounding it may be in the next.
    constexpr double kBeside = 1e-6;
    const double last = static_cast<double>(lowest.size() - 1),
                 bins_per_x = static_cast<double>(lowest.size()) / (x.end - x.begin);
    const auto bin = [&](double at) {
      return static_cast<std::size_t>(std::clamp(std::floor(at), 0.0, last));
    };
    const std::size_t first = bin((of.begin - x.begin) * bins_per_x - kBeside),
                      end = bin((of.end - x.begin) * bins_per_x + kBeside);
    for (std::size_t i = first; i <= end; ++i) take(lowest[i]);
  }
};

} // namespace

std::vector<double> hidden_below(const View& view, std::span<const ProfilePoint> points,
                                 std::span<const VoidRim> rims, double slack_y) {
  Connected connected(points.size(), rims);
  std::vector<NearRim> voids(points.size()); // by number
  const auto x_of = [&](const VoidRim& rim) {
    const auto [low, high] =
        std::minmax({project(view, points[rim.from]).x, project(view, points[rim.to]).x});
    return XRange{low, high};
  };
  for (const VoidRim& rim : rims) {
    NearRim& of = voids[connected.of(rim.from)];
    ++of.rims;
    if (view.is_perspective() && std::min(points[rim.from].v, points[rim.to].v) <= view.near_m) {
      of.is_ahead = false;
      continue;
    }
    const XRange x = x_of(rim);
    of.x = {std::min(of.x.begin, x.begin), std::max(of.x.end, x.end)};
  }
  for (NearRim& of : voids)
    if (of.rims > 0 && of.is_ahead && of.x.begin < of.x.end)
      of.lowest.assign(std::max(1U, of.rims / 2), kInfinity);
  for (const VoidRim& rim : rims) {
    NearRim& of = voids[connected.of(rim.from)];
    if (rim.is_towards_eye || of.lowest.empty()) continue;
    const double y = std::min(project(view, points[rim.from]).y, project(view, points[rim.to]).y);
    of.for_each_bin(x_of(rim), [&](double& lowest) { lowest = std::min(lowest, y); });
  }
  std::vector<double> out(rims.size(), -kInfinity);
  for (std::size_t i = 0; i < rims.size(); ++i) {
    NearRim& of = voids[connected.of(rims[i].from)];
    if (!rims[i].is_towards_eye || of.lowest.empty()) continue;
    double lowest = kInfinity;
    bool is_known = true;
    of.for_each_bin(x_of(rims[i]), [&](double& y) {
      is_known = is_known && y < kInfinity;
      lowest = std::min(lowest, y);
    });
    if (is_known) out[i] = lowest - slack_y;
  }
  return out;
}

} // namespace orograph
