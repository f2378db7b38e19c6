// SPDX-License-Identifier: GPL-3.0-or-later
#include "map/ground_meter.hpp"

#include "geometry/vec.hpp"
#include "map/line_on_page.hpp"
#include "profiles/profile.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace orograph {
namespace {

struct Picture {
  Vec2 mm;
  bool in_frame = false; ///< and in front of the picture plane
};

Picture picture_of(ProfilePoint p, const Sector& sector, const Box2& frame_mm) {
  const Vec3 h = sector.to_page.of(project_homogeneous(sector.view, p));
  const Vec2 mm{h.x / h.z, h.y / h.z};
  return {mm, h.z > 0 && mm.x >= frame_mm.low.x && mm.x <= frame_mm.high.x &&
                  mm.y >= frame_mm.low.y && mm.y <= frame_mm.high.y};
}

// What of a line is in front of the picture plane; beyond it nothing has a picture.
std::optional<ProfileLine> in_front(const ProfileLine& line, const View& view,
                                    const Homography& to_page) {
  const auto w_of = [&](ProfilePoint p) { return to_page.of(project_homogeneous(view, p)).z; };
  const double w_from = w_of(line.from), w_to = w_of(line.to);
  if (w_from <= 0 && w_to <= 0) return std::nullopt;
  if (w_from > 0 && w_to > 0) return line;
  constexpr double kNear = 1e-9; // of the greater; its picture is far outside of any frame
  const double w = kNear * std::max(w_from, w_to);
  const ProfilePoint cut = point_between(line.from, line.to, (w - w_from) / (w_to - w_from));
  return w_from > 0 ? ProfileLine{line.from, cut} : ProfileLine{cut, line.to};
}

} // namespace

double GroundMeter::width_m(const Sector& sector, double depth_m) const {
  const std::vector<PlannedProfile>& profiles = sector.profiles;
  const auto at =
      std::lower_bound(profiles.begin(), profiles.end(), depth_m,
                       [](const PlannedProfile& p, double depth) { return p.depth_m < depth; });
  const bool first = at == profiles.begin(), last = at + 1 == profiles.end();
  const double nearest_m = sector.view.is_perspective()
                               ? std::max(sector.nearest_m, sector.view.near_m)
                               : sector.nearest_m;
  if (first && last) return std::max(sector.farthest_m - nearest_m, 0.0);
  // The ground at the eye's feet isn't the first profile's: it may be far from it, and unseen.
  const double behind_m = (last ? depth_m - (at - 1)->depth_m : (at + 1)->depth_m - depth_m) / 2;
  const double before_m = first ? behind_m : (depth_m - (at - 1)->depth_m) / 2;
  const double from = std::max(depth_m - before_m, nearest_m),
               to = std::min(depth_m + behind_m, sector.farthest_m);
  return std::max(to - from, 0.0);
}

void GroundMeter::see(const SeenProfile& seen) {
  const auto& [sector, clipped, profile, segments, visible] = seen;
  double ground_m = 0;
  for (std::size_t i = 0; i + 1 < profile.size(); ++i)
    if (profile.after[i] != Span::gap) ground_m += profile.u_m[i + 1] - profile.u_m[i];
  const View& view = sector.view;
  const auto at = [&](std::uint32_t left, double t) {
    return ProfilePoint{profile.u_m[left] + t * (profile.u_m[left + 1] - profile.u_m[left]),
                        profile.depth_m,
                        profile.z_m[left] + t * (profile.z_m[left + 1] - profile.z_m[left])};
  };
  double visible_m = 0;
  ProfilePoint end{};
  Picture ends;
  for (const Piece& piece : visible) {
    const std::uint32_t left = left_vertex(segments[piece.segment]);
    const ProfilePoint begin = at(left, piece.t_begin);
    const bool joined = begin.u == end.u && begin.z == end.z && &piece != visible.data();
    const Picture begins = joined ? ends : picture_of(begin, sector, scene_.frame_mm);
    end = at(left, piece.t_end);
    ends = picture_of(end, sector, scene_.frame_mm);
    if (begins.in_frame && ends.in_frame) {
      visible_m += std::abs(end.u - begin.u);
      visible_mm_ += plain_length(ends.mm - begins.mm);
      continue;
    }
    const auto part = in_front({begin, end}, view, sector.to_page);
    if (!part) continue;
    if (const auto line = LineOnPage::of(*part, view, sector.to_page, scene_.frame_mm)) {
      const double length_mm = line->length_mm();
      visible_m +=
          std::abs(part->to.u - part->from.u) * (line->share_at(length_mm) - line->share_at(0));
      visible_mm_ += length_mm;
    }
  }
  const double width = width_m(sector, profile.depth_m);
  ground_m2_ += width * ground_m;
  visible_m2_ += width * visible_m;
}

std::optional<double> GroundMeter::visible_share() const {
  if (!(ground_m2_ > 0)) return std::nullopt;
  return visible_m2_ / ground_m2_;
}

} // namespace orograph
