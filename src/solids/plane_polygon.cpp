// SPDX-License-Identifier: GPL-3.0-or-later
#include "solids/plane_polygon.hpp"

#include "geometry/box.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <numeric>

namespace orograph {
namespace {

// On which side of the line from a to b the point c is: 1 to the left, -1 to the right, 0 on it.
int side_of(Vec2 a, Vec2 b, Vec2 c) {
  const Vec2 along = b - a, to = c - a;
  const double turn = cross(along, to);
  if (std::abs(turn) <= 1e-12 * length(along) * length(to)) return 0;
  return turn > 0 ? 1 : -1;
}

bool apart(double a, double b, double c, double d) {
  return std::max(a, b) < std::min(c, d) || std::max(c, d) < std::min(a, b);
}

bool meet(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
  if (apart(a.x, b.x, c.x, d.x) || apart(a.y, b.y, c.y, d.y)) return false;
  return side_of(a, b, c) * side_of(a, b, d) <= 0 && side_of(c, d, a) * side_of(c, d, b) <= 0;
}

// All corners turn to one side, and all in all once round.
bool is_convex(std::span<const Vec2> corners) {
  const std::size_t n = corners.size();
  double turned = 0;
  int side = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2 a = corners[i], b = corners[(i + 1) % n], c = corners[(i + 2) % n];
    const int here = side_of(a, b, c);
    if (here == 0 || here == -side) return false;
    side = here;
    turned += std::atan2(cross(b - a, c - b), dot(b - a, c - b));
  }
  return std::abs(std::abs(turned) - 2 * std::numbers::pi) < 1;
}

// The polygon that is left while ears are cut off, as a ring of corners.
class Ears {
public:
  explicit Ears(std::span<const Vec2> corners)
      : corners_(corners), before_(corners.size()), after_(corners.size()), is_ear_(corners.size()),
        left_(corners.size()) {
    const auto n = static_cast<std::uint32_t>(corners.size());
    for (std::uint32_t i = 0; i < n; ++i) {
      before_[i] = (i + n - 1) % n;
      after_[i] = (i + 1) % n;
    }
    look_at_all();
  }

  std::vector<std::array<std::uint32_t, 3>> cut() {
    std::vector<std::array<std::uint32_t, 3>> triangles;
    while (left_ > 3) {
      if (!find_ear()) {
        look_at_all(); // an ear far away may have come to be
        if (!find_ear()) return {};
      }
      triangles.push_back({before_[at_], at_, after_[at_]});
      cut_off();
    }
    if (side_of(corners_[before_[at_]], corners_[at_], corners_[after_[at_]]) <= 0) return {};
    triangles.push_back({before_[at_], at_, after_[at_]});
    return triangles;
  }

private:
  bool is_ear(std::uint32_t corner) const {
    const Vec2 a = corners_[before_[corner]], b = corners_[corner], c = corners_[after_[corner]];
    if (side_of(a, b, c) <= 0) return false;
    for (std::uint32_t i = after_[after_[corner]]; i != before_[corner]; i = after_[i]) {
      const Vec2 p = corners_[i];
      if (side_of(a, b, p) >= 0 && side_of(b, c, p) >= 0 && side_of(c, a, p) >= 0) return false;
    }
    return true;
  }

  void look_at_all() {
    std::uint32_t i = at_;
    do {
      is_ear_[i] = is_ear(i);
      i = after_[i];
    } while (i != at_);
  }

  bool find_ear() {
    for (std::size_t tried = 0; tried < left_; ++tried, at_ = after_[at_])
      if (is_ear_[at_]) return true;
    return false;
  }

  // Goes on two corners farther, which spreads the triangles.
  void cut_off() {
    const std::uint32_t before = before_[at_], after = after_[at_];
    after_[before] = after;
    before_[after] = before;
    --left_;
    is_ear_[before] = is_ear(before);
    is_ear_[after] = is_ear(after);
    at_ = after_[after];
  }

  std::span<const Vec2> corners_;
  std::vector<std::uint32_t> before_, after_;
  std::vector<bool> is_ear_;
  std::size_t left_;
  std::uint32_t at_ = 0;
};

std::string fault_at_corners(std::span<const Vec2> corners, bool closed) {
  const std::size_t n = corners.size();
  for (std::size_t i = 0; i < (closed ? n : n - 1); ++i)
    if (corners[i] == corners[(i + 1) % n])
      return fmt::format("has the corners {} and {} in one place", i, (i + 1) % n);
  for (std::size_t i = 0; i < (closed ? n : n - 2); ++i) {
    const Vec2 a = corners[i], b = corners[(i + 1) % n], c = corners[(i + 2) % n];
    if (side_of(a, b, c) == 0 && dot(b - a, c - b) < 0)
      return fmt::format("turns back along itself at corner {}", (i + 1) % n);
  }
  return "";
}

} // namespace

double signed_area(std::span<const Vec2> corners) {
  double twice = 0;
  for (std::size_t i = 2; i < corners.size(); ++i)
    twice += cross(corners[i - 1] - corners[0], corners[i] - corners[0]);
  return twice / 2;
}

std::string fault_of_line(std::span<const Vec2> corners, bool closed) {
  if (std::string fault = fault_at_corners(corners, closed); !fault.empty()) return fault;
  const std::size_t n = corners.size(), edges = closed ? n : n - 1;
  if (closed && is_convex(corners)) return "";
  if (n > kMostCorners) return fmt::format("has over {} corners", kMostCorners);
  for (std::size_t i = 0; i < edges; ++i)
    for (std::size_t j = i + 2; j < edges; ++j) {
      if (closed && i == 0 && j == n - 1) continue; // neighbours
      if (meet(corners[i], corners[i + 1], corners[j], corners[(j + 1) % n]))
        return fmt::format("crosses or touches itself, beyond corners {} and {}", i, j);
    }
  return "";
}

std::vector<std::array<std::uint32_t, 3>> triangles_of(std::span<const Vec2> corners) {
  std::vector<std::array<std::uint32_t, 3>> fan;
  for (std::uint32_t i = 2; i < corners.size(); ++i) {
    if (side_of(corners[0], corners[i - 1], corners[i]) <= 0) return Ears(corners).cut();
    fan.push_back({0, i - 1, i});
  }
  return fan;
}

} // namespace orograph
