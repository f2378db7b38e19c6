// SPDX-License-Identifier: GPL-3.0-or-later
// Parts of lines on the surface, as sets of places along them, and as strokes.
#pragma once

#include "draw/chain.hpp"
#include "draw/stroke_builder.hpp"
#include "geometry/on_all_cores.hpp"
#include "view/view.hpp"

#include <cstdint>
#include <functional>
#include <limits>
#include <span>
#include <vector>

namespace orograph {
/// A visible part of a line; along its edge, 0 at `edge.from` and 1 at `edge.to`.
struct LinePart {
  std::uint32_t line;
  double t_begin, t_end;
};

/// Shares of one edge that were reckoned on both sides of a slab's plane are equal to rounding.
constexpr double kSameShare = 1e-12;

/// Brings parts in order by line and along it. Those that overlap, meet, or are no farther apart
/// than `gap` says of the line (shares; rounding, if it isn't given), become one. Slits that
/// rounding leaves where two occluders meet are dropped.
void join(std::vector<LinePart>& parts, const std::function<double(std::uint32_t)>& gap = {});

/// The same of the parts from number `first` on, all of one line. Cost: little, of the few that a
/// line has.
void join_of_line(std::vector<LinePart>& parts, std::size_t first);

/// What is left of `parts` without `taken`; both by line.
std::vector<LinePart> without(const std::vector<LinePart>& parts,
                              const std::vector<LinePart>& taken);

/// `parts` and all of each line that is marked, of which there is no part among them; by line.
/// Marks are those of lines from number `first` on.
std::vector<LinePart> with_whole(const std::vector<LinePart>& parts, std::size_t first,
                                 std::span<const std::uint8_t> marks);

/// What of `parts` is in `others` as well; both by line.
std::vector<LinePart> shared(const std::vector<LinePart>& parts,
                             const std::vector<LinePart>& others);

/// Draws parts joined where they meet at a vertex: `link(part)` tells the vertices that it ends at
/// (ChainLink), `point(part, t)` the place at a share of its line (ProfilePoint).
template <class Link, class Point>
void draw_chained(const std::vector<LinePart>& parts, const View& view, const Link& link,
                  const Point& point, StrokeBuilder& builder) {
  std::vector<ChainLink> links;
  links.reserve(parts.size());
  for (const LinePart& part : parts) {
    throw_if_stopped(links.size());
    links.push_back(link(part));
  }
  const Chains chains = chain(links);
  for (std::size_t i = 0; i < chains.size(); ++i) {
    throw_if_stopped();
    builder.begin(-1, std::numeric_limits<double>::quiet_NaN());
    bool is_first = true;
    std::size_t step = 0; // a chain may be all of a terrain's edges
    for (const auto& [piece, turned] : chains[i]) {
      throw_if_stopped(step++);
      const LinePart& part = parts[piece];
      const auto add = [&](double t) {
        const ProfilePoint at = point(part, t);
        builder.add({project_homogeneous(view, at), at});
      };
      if (is_first) add(turned ? part.t_end : part.t_begin);
      add(turned ? part.t_begin : part.t_end);
      is_first = false;
    }
    builder.end();
  }
}

} // namespace orograph
