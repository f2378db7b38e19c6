// SPDX-License-Identifier: GPL-3.0-or-later
// Parts of lines as long strokes.
#pragma once

#include "draw/chain.hpp"
#include "draw/stroke_builder.hpp"
#include "geometry/on_all_cores.hpp"
#include "view/view.hpp"

#include <limits>
#include <vector>

#include "hidden_lines/line_parts.hpp"

namespace orograph {

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
    for (const auto& [piece, turned] : chains[i]) {
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
