// SPDX-License-Identifier: GPL-3.0-or-later
#include "hidden_lines/place_silhouettes.hpp"

#include "geometry/for_each_marked.hpp"

#include <algorithm>
#include <ranges>

namespace orograph {
SurfaceEdge PlaceSilhouettes::edge_at(int strip, int cell, std::uint8_t mark) const {
  const bool rows = lattice_.order.rows_are_strips();
  const auto columns = static_cast<std::uint32_t>(lattice_.grid.columns);
  const auto from = static_cast<std::uint32_t>(rows ? lattice_.grid.index(cell, strip)
                                                    : lattice_.grid.index(strip, cell));
  const std::uint32_t along = rows ? 1 : columns, upright = rows ? columns : 1;
  return {from, from + (mark == SilhouetteMarks::kAlong     ? along
                        : mark == SilhouetteMarks::kUpright ? upright
                                                            : along + upright)};
}

void PlaceSilhouettes::add(PlacePart part, SurfaceEdge edge, const BlockedHorizon& horizon) {
  const ProfileLine whole = pictures_.whole(edge);
  if (std::max(whole.from.v, whole.to.v) <= pictures_.from_m()) return;
  const LinePicture picture = pictures_.picture(whole);
  const Segment& s = picture.source;
  const XRange looked_at = pictures_.looked_at();
  if (s.x1 < looked_at.begin || s.x0 > looked_at.end) return;
  if (picture.is_upright() ? pictures_.is_hidden(picture, horizon)
                           : is_below_blocks(horizon, std::max(s.x0, looked_at.begin),
                                             std::min(s.x1, looked_at.end), std::max(s.y0, s.y1)))
    return;
  found_[static_cast<std::size_t>(part)].push_back({lattice_.order.turn(edge), edge, picture});
}

void PlaceSilhouettes::find_marked(std::span<const std::uint8_t> marks, const ShownOfPlace& shown,
                                   std::uint8_t which) {
  cells_.clear();
  for_each_marked(marks, shown.first_cell, shown.end_cell, which,
                  [&](int cell) { cells_.push_back(cell); });
}

void PlaceSilhouettes::find(const LatticeOrder::Place& place, const ShownOfPlace& shown,
                            const BlockedHorizon& horizon) {
  for (auto& found : found_) found.clear();
  if (shown.empty()) return;
  const LatticeOrder& order = lattice_.order;
  if (order.earth()) {
    find_on_earth(place, shown, horizon);
    return;
  }
  const int strips = (order.rows_are_strips() ? lattice_.grid.rows : lattice_.grid.columns) - 1;
  const int own = order.first_outwards(); // the eye's own cell, or the first behind it
  const auto from_own = [&](auto&& take_rising, auto&& take_falling) {
    for (const int cell : cells_)
      if (cell >= own) take_rising(cell);
    for (const int cell : std::views::reverse(cells_))
      if (cell <= own) take_falling(cell);
  };
  // Neither the first nor the last line of a grid has any.
  if (place.line > 0 && place.line < strips) {
    find_marked(marks_.of_strip(place.line), shown, SilhouetteMarks::kAlong);
    const auto add_along = [&](int cell) {
      const SurfaceEdge edge = edge_at(place.line, cell, SilhouetteMarks::kAlong);
      if (!pictures_.is_moved(edge)) add(PlacePart::line, edge, horizon);
    };
    from_own(add_along, [&](int cell) {
      if (cell < own) add_along(cell);
    });
  }
  if (place.strip == LatticeOrder::Place::kNone) return;
  const std::span<const std::uint8_t> marks = marks_.of_strip(place.strip);
  find_marked(marks, shown, SilhouetteMarks::kUpright | SilhouetteMarks::kDiagonal);
  const auto add_if = [&](PlacePart part, int cell, std::uint8_t mark) {
    if (marks[static_cast<std::size_t>(cell)] & mark)
      add(part, edge_at(place.strip, cell, mark), horizon);
  };
  // An upright is at its cell's lower end. That of the eye's own cell is taken backwards, unless
  // the eye is beside the grid.
  from_own(
      [&](int cell) {
        if (cell > own || order.is_outwards(cell))
          add_if(PlacePart::outwards, cell, SilhouetteMarks::kUpright);
        add_if(PlacePart::outwards, cell, SilhouetteMarks::kDiagonal);
      },
      [&](int cell) {
        if (cell < own) add_if(PlacePart::backwards, cell, SilhouetteMarks::kDiagonal);
        if (cell < own || !order.is_outwards(cell))
          add_if(PlacePart::backwards, cell, SilhouetteMarks::kUpright);
      });
}

// All outwards.
void PlaceSilhouettes::find_on_earth(const LatticeOrder::Place& place, const ShownOfPlace& shown,
                                     const BlockedHorizon& horizon) {
  const int strips = lattice_.order.earth()->strips();
  if (place.line > 0 && place.line < strips) {
    find_marked(marks_.of_strip(place.line), shown, SilhouetteMarks::kAlong);
    for (const int cell : cells_)
      add(PlacePart::line, edge_at(place.line, cell, SilhouetteMarks::kAlong), horizon);
  }
  if (place.strip == LatticeOrder::Place::kNone) return;
  const std::span<const std::uint8_t> marks = marks_.of_strip(place.strip);
  find_marked(marks, shown, SilhouetteMarks::kUpright | SilhouetteMarks::kDiagonal);
  for (const int cell : cells_)
    for (const std::uint8_t mark : {SilhouetteMarks::kUpright, SilhouetteMarks::kDiagonal})
      if (marks[static_cast<std::size_t>(cell)] & mark)
        add(PlacePart::outwards, edge_at(place.strip, cell, mark), horizon);
  auto& found = found_[static_cast<std::size_t>(PlacePart::outwards)];
  if (!std::ranges::is_sorted(found, {}, &Found::turn)) std::ranges::sort(found, {}, &Found::turn);
}

std::vector<SurfaceEdge> PlaceSilhouettes::moved(int line) const {
  std::vector<SurfaceEdge> out;
  const std::span<const std::uint8_t> marks = marks_.of_strip(line);
  for (int cell = 0; cell < static_cast<int>(marks.size()); ++cell) {
    if (!(marks[static_cast<std::size_t>(cell)] & SilhouetteMarks::kAlong)) continue;
    const SurfaceEdge edge = edge_at(line, cell, SilhouetteMarks::kAlong);
    if (pictures_.is_moved(edge)) out.push_back(edge);
  }
  return out;
}

} // namespace orograph
