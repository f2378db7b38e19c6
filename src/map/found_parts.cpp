// SPDX-License-Identifier: GPL-3.0-or-later
#include "map/found_parts.hpp"

#include "geometry/on_all_cores.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace orograph {
namespace {

void append(const std::vector<LinePart>& parts, std::vector<LinePart>& all) {
  all.insert(all.end(), parts.begin(), parts.end());
}

} // namespace

std::vector<LinePart> of_kind(const std::vector<EdgeLine>& lines,
                              const std::vector<LinePart>& parts, LineKind kind) {
  const auto for_each = [&](const auto& take) {
    std::size_t step = 0;
    for (const LinePart& part : parts) {
      throw_if_stopped(step++);
      if (lines[part.line].kind == kind) take(part);
    }
  };
  std::size_t count = 0;
  for_each([&](const LinePart&) { ++count; });
  std::vector<LinePart> out;
  out.reserve(count);
  for_each([&](const LinePart& part) { out.push_back(part); });
  return out;
}

FoundParts::FoundParts(const TerrainData& terrain, const PlacedView& placed,
                       std::span<const ProfilePoint> points, std::vector<EdgeLine> listed,
                       std::vector<SectorLines> sectors)
    : terrain_(terrain), placed_(placed), points_(points), lines_(std::move(listed)),
      listed_(lines_.size()), sectors_(std::move(sectors)) {
  number_as_one();
  for (const SectorLines& sector : sectors_) folded_mm_ += sector.folded_mm;
}

// Lines that a sector has found have numbers of its own behind those of the list; a line that
// two have found is one.
void FoundParts::number_as_one() {
  if (sectors_.size() == 1) { // they have these numbers
    lines_.insert(lines_.end(), sectors_[0].found.begin(), sectors_[0].found.end());
    return;
  }
  const std::size_t listed = lines_.size();
  const auto by_edge = [](const EdgeLine& a, const EdgeLine& b) { return a.edge < b.edge; };
  std::vector<EdgeLine> all;
  for (const SectorLines& sector : sectors_) {
    std::vector<EdgeLine> merged;
    std::set_union(all.begin(), all.end(), sector.found.begin(), sector.found.end(),
                   std::back_inserter(merged), by_edge);
    all = std::move(merged);
  }
  lines_.insert(lines_.end(), all.begin(), all.end());
  for (SectorLines& sector : sectors_) {
    throw_if_stopped();
    std::vector<std::uint32_t> numbers;
    auto at = all.begin();
    for (const EdgeLine& line : sector.found) {
      at = std::lower_bound(at, all.end(), line, by_edge);
      numbers.push_back(static_cast<std::uint32_t>(listed) +
                        static_cast<std::uint32_t>(at - all.begin()));
    }
    for (std::vector<LinePart>* parts : {&sector.visible, &sector.skyline})
      for (LinePart& part : *parts)
        if (part.line >= listed) part.line = numbers[part.line - listed];
  }
}

std::vector<LinePart> FoundParts::of(std::vector<LinePart> SectorLines::*kind) const {
  std::vector<LinePart> all;
  for (const SectorLines& sector : sectors_) append(sector.*kind, all);
  throw_if_stopped();
  if (placed_.panorama) // sectors overlap by a hair
    join(all);
  else if (sectors_.size() > 1 && has_ground(terrain_.surface))
    join_sectors(terrain_.surface, points_, placed_.view, lines_,
                 std::max(0.0, placed_.sectors.front().view.drawn_from_m), all);
  return all;
}

std::vector<LinePart> FoundParts::visible_of(LineKind kind,
                                             const std::vector<LinePart>& visible) const {
  std::vector<LinePart> parts = of_kind(lines_, visible, kind);
  if (!is_on_ground(kind)) return parts;
  const std::vector<std::uint8_t> whole = whole_of(kind);
  return whole.empty() ? parts : with_whole(parts, listed_ - whole.size(), whole);
}

std::vector<std::uint8_t> FoundParts::whole_of(LineKind kind) const {
  if (sectors_.size() != 1) return {};
  std::vector<std::uint8_t> whole = sectors_.front().whole_on_ground;
  const std::size_t first = listed_ - whole.size();
  for (std::size_t i = 0; i < whole.size(); ++i)
    if (lines_[first + i].kind != kind) whole[i] = 0;
  return whole;
}

std::vector<LinePart> FoundParts::hidden() const {
  std::vector<LinePart> hidden = of(&SectorLines::hidden);
  if (sectors_.size() < 2 || hidden.empty()) return hidden;
  std::vector<LinePart> shown = of(&SectorLines::visible);
  append(of(&SectorLines::skyline), shown);
  join(shown);
  return without(hidden, shown);
}

std::vector<LinePart> FoundParts::of(std::vector<LinePart> SolidParts::*kind) const {
  std::vector<LinePart> all;
  for (const SectorLines& sector : sectors_) append(sector.solids.*kind, all);
  join(all);
  return all;
}

} // namespace orograph
