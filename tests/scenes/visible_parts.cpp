// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/scenes/visible_parts.hpp"

#include "tests/catch.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace orograph {
namespace {

// Ends that differ by less are the same place.
constexpr double kSame_mm = 1e-9;

void add(SeenOfLine& line, double begin, double end) {
  if (!line.seen.empty() && line.seen.back() >= begin)
    line.seen.back() = std::max(line.seen.back(), end);
  else
    line.seen.insert(line.seen.end(), {begin, end});
}

double length_mm(const Sector& sector, const ProfileLine& line, double begin, double end) {
  const auto page = [&](double t) {
    return sector.to_page.of(
        project_homogeneous(sector.view, point_between(line.from, line.to, t)));
  };
  const Vec3 a = page(begin), b = page(end);
  if (!(a.z > 0 && b.z > 0)) return 0;
  return std::hypot(a.x / a.z - b.x / b.z, a.y / a.z - b.y / b.z);
}

} // namespace

void VisibleParts::see(const SeenProfile& seen) {
  const Profile& profile = seen.profile;
  const std::size_t first = lines.size();
  for (const Segment& segment : seen.segments) {
    const std::uint32_t left = left_vertex(segment);
    const auto at = [&](std::uint32_t i) {
      return ProfilePoint{profile.u_m[i], profile.depth_m, profile.z_m[i]};
    };
    lines.push_back({number_of(seen.sector), {at(left), at(left + 1)}, false, {}});
  }
  for (const Piece& piece : seen.visible)
    add(lines[first + piece.segment], piece.t_begin, piece.t_end);
}

void VisibleParts::see(const SeenLines& seen) {
  const std::size_t first = lines.size();
  for (std::uint32_t i = 0; i < seen.lines.size(); ++i)
    lines.push_back({number_of(seen.sector), seen.lines.whole(i), true, {}});
  for (const LinePart& part : seen.visible) add(lines[first + part.line], part.t_begin, part.t_end);
}

VisibleDifference difference(const VisibleParts& a, const VisibleParts& b, const PlacedView& placed,
                             const std::vector<Judge>& judges) {
  VisibleDifference out;
  REQUIRE(a.lines.size() == b.lines.size());
  std::vector<double> ends;
  for (std::size_t i = 0; i < a.lines.size(); ++i) {
    const SeenOfLine &one = a.lines[i], &other = b.lines[i];
    if (one.seen == other.seen) continue;
    ends = one.seen;
    ends.insert(ends.end(), other.seen.begin(), other.seen.end());
    std::sort(ends.begin(), ends.end());
    const auto shows = [](const SeenOfLine& line, double t) {
      const auto behind = std::upper_bound(line.seen.begin(), line.seen.end(), t);
      return (behind - line.seen.begin()) % 2 == 1;
    };
    for (std::size_t k = 1; k < ends.size(); ++k) {
      const double t = 0.5 * (ends[k - 1] + ends[k]);
      if (shows(one, t) == shows(other, t)) continue;
      const Sector& sector = placed.sectors[one.sector];
      if (length_mm(sector, one.whole, ends[k - 1], ends[k]) <= kSame_mm) continue;
      ++out.stretches;
      const Judge& judge = judges[one.sector];
      if (judge.verdict(one.whole, t, one.is_edge, true) == Verdict::tied ||
          judge.verdict(one.whole, t, one.is_edge, false) == Verdict::tied) {
        ++out.tied;
        continue;
      }
      if (!out.first_wrong.empty()) continue;
      const auto& [from, to] = one.whole;
      const ProfilePoint at = point_between(from, to, t);
      out.first_wrong = fmt::format(
          "{} {} {} {} to {} {} {}, from {} to {} only the {} shows; above by {}",
          one.is_edge ? "edge" : "span", from.u, from.v, from.z, to.u, to.v, to.z, ends[k - 1],
          ends[k], shows(one, t) ? "first" : "second", judge.above(at, one.is_edge));
    }
  }
  return out;
}

} // namespace orograph
