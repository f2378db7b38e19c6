// SPDX-License-Identifier: GPL-3.0-or-later
#include "hidden_lines/behind_solids.hpp"

#include "geometry/on_all_cores.hpp"

#include <algorithm>
#include <utility>

namespace orograph {
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

std::vector<LinePart> not_behind(const SolidsInView& solids, const LinePass& lines,
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
