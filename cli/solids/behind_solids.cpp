// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/solids/behind_solids.hpp"

#include <utility>

namespace orograph {
namespace {

// What of a line's part is left, from a share of the line to another.
class Remover {
public:
  explicit Remover(const SolidsInView& solids) : solids_(solids) {}

  // Calls `take` with each part that is left.
  template <class Take>
  void take_rest(Vec3 from, Vec3 to, Share asked, const Take& take) {
    const LineInView line = line_in_view(solids_.view(), from, to);
    hidden_.clear();
    solids_.add_hidden(line, {}, hidden_);
    if (hidden_.empty()) {
      take(asked);
      return;
    }
    const double length_m = length(to - from);
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
  const auto at = [&](std::uint32_t i) {
    return Vec3{profile.u_m[i], profile.depth_m, profile.z_m[i]};
  };
  const auto x_at = [&](std::uint32_t i) {
    return project(view, {profile.u_m[i], profile.depth_m, profile.z_m[i]}).x;
  };
  std::vector<VisibleRun> left;
  Remover remover(solids);
  for (const VisibleRun& run : runs) {
    if (!solids.any_in(x_at(run.first), x_at(run.last + 1))) {
      left.push_back(run);
      continue;
    }
    bool joins = false; // the next span to the last of `left`
    for (std::uint32_t i = run.first; i <= run.last; ++i) {
      const Share asked{i == run.first ? run.t_begin : 0, i == run.last ? run.t_end : 1};
      bool next_joins = false;
      remover.take_rest(at(i), at(i + 1), asked, [&](Share rest) {
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

std::vector<LinePart> not_behind(const SolidsInView& solids, const LineSweep& lines,
                                 const std::vector<LinePart>& parts) {
  std::vector<LinePart> left;
  left.reserve(parts.size());
  Remover remover(solids);
  for (const LinePart& part : parts) {
    // Only what is asked for is sure to be in front of the eye.
    const Vec3 from = as_vec(lines.point(part.line, part.t_begin)),
               to = as_vec(lines.point(part.line, part.t_end));
    const double scale = part.t_end - part.t_begin;
    remover.take_rest(from, to, {0, 1}, [&](Share rest) {
      left.push_back({part.line, rest.begin <= 0 ? part.t_begin : part.t_begin + rest.begin * scale,
                      rest.end >= 1 ? part.t_end : part.t_begin + rest.end * scale});
    });
  }
  return left;
}

} // namespace orograph
