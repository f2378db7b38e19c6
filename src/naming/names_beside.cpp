// SPDX-License-Identifier: GPL-3.0-or-later
#include "naming/names_beside.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

namespace orograph {
namespace {

constexpr double kOffPoint_mm = 1.1;
constexpr double kAroundTexts_mm = 0.6; // half of it around each name

// Of the room, by names whose number isn't given: by looking, a map with more of them isn't read
// as ground any more.
constexpr double kMostCovered = 1.0 / 16;

// What a worse place costs, in shares of ink: by looking, a name goes elsewhere for a quarter of
// the lines beneath it.
constexpr double kWorsePlace = 0.05;

// A corner or the middle of a side of the text's box, and the way from the summit to it.
struct Beside {
  TextAnchor anchor;
  double right, up; ///< -1, 0, 1
};
constexpr std::array<Beside, 8> kPlacesBeside{{{TextAnchor::middle, 0, 1},
                                               {TextAnchor::start, 1, 1},
                                               {TextAnchor::end, -1, 1},
                                               {TextAnchor::start, 1, 0},
                                               {TextAnchor::end, -1, 0},
                                               {TextAnchor::start, 1, -1},
                                               {TextAnchor::end, -1, -1},
                                               {TextAnchor::middle, 0, -1}}};

PageText put(PageText text, Vec2 summit_mm, const Beside& place) {
  const auto [width_mm, ascent_mm, descent_mm] = text.extent;
  const double off_mm = place.right != 0 && place.up != 0 ? 0.7 * kOffPoint_mm : kOffPoint_mm;
  const double baseline_mm = place.up > 0   ? -off_mm - descent_mm
                             : place.up < 0 ? off_mm + ascent_mm
                                            : 0.5 * (ascent_mm - descent_mm);
  text.angle = {};
  text.anchor = place.anchor;
  text.at_mm = {summit_mm.x + place.right * off_mm, summit_mm.y + baseline_mm};
  return text;
}

} // namespace

std::vector<PlacedName> names_beside(std::span<const NameToPlace> names, const Box2& room_mm,
                                     const InkMap& ink, std::optional<std::size_t> most,
                                     TakenRoom& taken) {
  std::vector<std::size_t> order(names.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(
      order, [&](std::size_t a, std::size_t b) { return names[b].weight < names[a].weight; });
  std::vector<PlacedName> out;
  double covered_mm2 = 0;
  for (const std::size_t i : order) {
    if (most ? out.size() == *most
             : covered_mm2 > kMostCovered * room_mm.width() * room_mm.height())
      break;
    const NameToPlace& name = names[i];
    if (name.text.extent.width_mm <= 0) continue;
    const TurnedBox summit = box_of(name.summit_mm, name.summit_mm, kSummitMark_mm);
    if (!is_inside(bounds_of(summit), room_mm)) continue;
    if (!taken.is_free(summit)) continue; // it would seem to be another's
    std::optional<PageText> best;
    double least = 0;
    for (std::size_t k = 0; k < kPlacesBeside.size(); ++k) {
      const PageText text = put(name.text, name.summit_mm, kPlacesBeside[k]);
      const Box2 box = text.box_mm();
      if (!is_inside(box, room_mm)) continue;
      const double cost = ink.share(box) + kWorsePlace * static_cast<double>(k);
      if (best && cost >= least) continue;
      if (!taken.is_free(box_of(text, 0.5 * kAroundTexts_mm))) continue;
      best = text;
      least = cost;
    }
    if (!best) continue;
    const Box2 box = best->box_mm();
    covered_mm2 += box.width() * box.height();
    taken.take(box_of(*best, 0.5 * kAroundTexts_mm));
    taken.take(summit);
    out.push_back({i, *std::move(best)});
  }
  return out;
}

} // namespace orograph
