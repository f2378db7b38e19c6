// SPDX-License-Identifier: GPL-3.0-or-later
#include "hidden_lines/parts_by_edge.hpp"

#include "geometry/on_all_cores.hpp"
#include "geometry/sort_by_number.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <span>

namespace orograph {
namespace {

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

struct FoundLine {
  EdgeLine line;
  std::uint32_t strip, number; ///< the strip's
};

// Of a strip: its numbers of lines found, less `listed`, to those of all strips.
using Numbers = std::vector<std::uint32_t>;

// Lines of which something is visible.
std::vector<FoundLine> visible_lines(const std::vector<std::unique_ptr<LatticeStrip>>& strips,
                                     std::size_t listed) {
  std::vector<FoundLine> out;
  std::vector<bool> taken;
  for (std::uint32_t i = 0; i < strips.size(); ++i) {
    const LatticeStrip& strip = *strips[i];
    const std::vector<EdgeLine>& found = strip.pictures().found();
    taken.assign(found.size(), false);
    const auto add = [&](const std::vector<LinePart>& parts) {
      for (const LinePart& part : parts) {
        throw_if_stopped(out.size());
        if (part.line < listed || taken[part.line - listed]) continue;
        taken[part.line - listed] = true;
        out.push_back({found[part.line - listed], i, part.line});
      }
    };
    add(strip.lines().visible_parts());
    if (const Ridges* ridges = strip.lines().ridges()) add(ridges->ridges());
  }
  sort_by_number_then(
      out, [](const FoundLine& found) { return found.line.edge.from; },
      [](const FoundLine& a, const FoundLine& b) {
        return a.line.edge != b.line.edge ? a.line.edge < b.line.edge : a.strip < b.strip;
      });
  return out;
}

} // namespace

SectorParts parts_by_edge(const std::vector<std::unique_ptr<LatticeStrip>>& strips,
                          std::size_t listed) {
  SectorParts out;
  std::vector<Numbers> numbers;
  for (const auto& strip : strips) numbers.emplace_back(strip->pictures().found().size(), kNone);
  for (const auto& [line, strip, number] : visible_lines(strips, listed)) {
    if (out.found.empty() || out.found.back().edge != line.edge) out.found.push_back(line);
    numbers[strip][number - listed] = static_cast<std::uint32_t>(listed + out.found.size() - 1);
  }
  struct OfStrip {
    std::vector<LinePart> visible, skyline, ridges;
  };
  std::vector<OfStrip> of_strips(strips.size());
  on_all_cores(strips.size(), [&](std::size_t i) {
    const LatticeStrip& strip = *strips[i];
    const auto renumbered = [&](std::span<const LinePart> parts) {
      std::vector<LinePart> of_all;
      of_all.reserve(parts.size());
      for (LinePart part : parts) {
        throw_if_stopped(of_all.size());
        if (part.line >= listed) part.line = numbers[i][part.line - listed];
        if (part.line != kNone) of_all.push_back(part);
      }
      return of_all;
    };
    of_strips[i].visible = renumbered(strip.lines().visible_parts());
    of_strips[i].skyline = renumbered(strip.pictures().skyline(strip.horizon().joined()));
    if (const Ridges* ridges = strip.lines().ridges())
      of_strips[i].ridges = renumbered(ridges->ridges());
  });
  for (const auto& strip : strips)
    if (const Ridges* ridges = strip->lines().ridges()) out.folded_mm += ridges->folded_mm();
  struct List {
    std::vector<LinePart> OfStrip::*of_strip;
    std::vector<LinePart>& of_all;
  };
  const std::array<List, 3> lists{List{&OfStrip::visible, out.visible},
                                  List{&OfStrip::skyline, out.skyline},
                                  List{&OfStrip::ridges, out.ridges}};
  on_all_cores(lists.size(), [&](std::size_t list) {
    const auto& [of_strip, of_all] = lists[list];
    std::size_t size = 0;
    for (const OfStrip& of : of_strips) size += (of.*of_strip).size();
    of_all.reserve(size);
    for (const OfStrip& of : of_strips) {
      throw_if_stopped();
      const std::vector<LinePart>& some = of.*of_strip;
      of_all.insert(of_all.end(), some.begin(), some.end());
    }
    join(of_all);
  });
  out.skyline = shared(out.skyline, out.visible);
  return out;
}

} // namespace orograph
