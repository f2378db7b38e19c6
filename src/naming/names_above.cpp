// SPDX-License-Identifier: GPL-3.0-or-later
#include "naming/names_above.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "naming/choose_names.hpp"
#include "naming/taken_room.hpp"

namespace orograph {
namespace {

constexpr double kBetween_mm = 0.5;      // names beside each other
constexpr double kBetweenWords_mm = 1.2; // names behind each other in a row
constexpr double kSky_mm = 3;            // between the highest line beneath the names and theirs
constexpr double kOffSummit_mm = 1;      // where leaders begin
constexpr double kOnLeader_mm = 0.6;     // between a leader's end and its name

double line_height_mm(const TextExtent& extent) {
  return extent.ascent_mm + extent.descent_mm;
}

// A slanted name whose middle, across, is above its leader's end at the origin.
PageText slanted(PageText text, Vec2 at_mm, Angle angle) {
  const auto [width_mm, ascent_mm, descent_mm] = text.extent;
  text.angle = angle;
  text.anchor = TextAnchor::start;
  text.at_mm = {at_mm.x + 0.5 * (ascent_mm - descent_mm) * sin(angle),
                at_mm.y - kOnLeader_mm - descent_mm * cos(angle)};
  return text;
}

// The highest line beneath names, each from one abscissa to another; of several names at once.
double line_of_names_mm(const StripRoom& strip, const std::vector<Box2>& boxes,
                        const std::vector<Vec2>& summits) {
  double highest = std::numeric_limits<double>::infinity();
  for (const Box2& box : boxes)
    highest = std::min(highest, strip.highest_mm(box.low.x, box.high.x));
  for (const Vec2 summit : summits) highest = std::min(highest, summit.y);
  return highest - kSky_mm;
}

} // namespace

RoomForNames room_for_names(const TextExtent& longest, double size_mm, Angle angle, int rows) {
  const double line_mm = line_height_mm(longest);
  if (angle == Angle()) return {kSky_mm + kOnLeader_mm + rows * (line_mm + kBetween_mm), 0};
  TextExtent extent = longest;
  PageText text;
  text.size_mm = size_mm;
  text.extent = extent;
  const Box2 box = slanted(text, {0, 0}, angle).box_mm();
  return {kSky_mm - box.low.y, box.high.x};
}

std::vector<PlacedName> names_slanted(std::span<const NameToPlace> names,
                                      std::span<const StripRoom> strips, Angle angle,
                                      std::optional<std::size_t> most) {
  if (names.empty()) return {};
  // Strips are side by side on one long line, too far apart to touch.
  constexpr double kStripsApart_mm = 1e6;
  std::vector<std::size_t> with_room;
  std::vector<NameOnLine> on_line;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const NameToPlace& name = names[i];
    const Box2& room = strips[name.strip].box_mm;
    const Box2 box = slanted(name.text, name.summit_mm, angle).box_mm();
    if (name.text.extent.width_mm <= 0 || box.low.x < room.low.x || box.high.x > room.high.x)
      continue;
    const double line_mm =
        std::min(strips[name.strip].highest_mm(box.low.x, box.high.x), name.summit_mm.y) - kSky_mm;
    if (line_mm - (name.summit_mm.y - box.low.y) < room.low.y) continue;
    with_room.push_back(i);
    on_line.push_back(
        {name.summit_mm.x + kStripsApart_mm * static_cast<double>(name.strip), name.weight});
  }
  double highest_line_mm = 0; // long names may be set smaller
  for (const NameToPlace& name : names)
    highest_line_mm = std::max(highest_line_mm, line_height_mm(name.text.extent));
  const double pitch_mm = highest_line_mm / sin(angle) + kBetween_mm;
  std::vector<std::size_t> chosen;
  for (const std::size_t i : choose_on_line(on_line, pitch_mm, most))
    chosen.push_back(with_room[i]);

  std::vector<PlacedName> out;
  for (std::size_t s = 0; s < strips.size(); ++s) {
    std::vector<Box2> boxes;
    std::vector<Vec2> summits;
    for (const std::size_t i : chosen)
      if (names[i].strip == s) {
        boxes.push_back(slanted(names[i].text, names[i].summit_mm, angle).box_mm());
        summits.push_back(names[i].summit_mm);
      }
    const double line_mm = line_of_names_mm(strips[s], boxes, summits);
    for (const std::size_t i : chosen) {
      const NameToPlace& name = names[i];
      if (name.strip != s) continue;
      const Vec2 end_mm{name.summit_mm.x, line_mm};
      out.push_back({i, slanted(name.text, end_mm, angle),
                     Leader{{end_mm.x, name.summit_mm.y - kOffSummit_mm}, end_mm}});
    }
  }
  std::erase_if(out, [&](const PlacedName& placed) {
    return !is_inside(placed.text.box_mm(), strips[names[placed.name].strip].box_mm);
  });
  return out;
}

namespace {

struct InRow {
  std::size_t name;
  double left_mm, right_mm; ///< of the text
  double leader_mm;         ///< abscissa
};

// One strip's rows, the lowest first.
class Rows {
public:
  explicit Rows(int count) : rows_(static_cast<std::size_t>(count)) {}

  bool put(const InRow& name) {
    for (std::size_t row = 0; row < rows_.size(); ++row)
      if (has_room(name, row)) {
        rows_[row].push_back(name);
        return true;
      }
    return false;
  }
  const std::vector<std::vector<InRow>>& rows() const { return rows_; }

private:
  // Leaders of higher rows go through the lower ones.
  bool has_room(const InRow& name, std::size_t row) const {
    for (std::size_t other_row = 0; other_row < rows_.size(); ++other_row)
      for (const InRow& other : rows_[other_row]) {
        if (std::abs(other.leader_mm - name.leader_mm) < kBetween_mm) return false;
        if (other_row == row && name.left_mm < other.right_mm + kBetweenWords_mm &&
            other.left_mm < name.right_mm + kBetweenWords_mm)
          return false;
        if (other_row < row && is_beside(name.leader_mm, other)) return false;
        if (other_row > row && is_beside(other.leader_mm, name)) return false;
      }
    return true;
  }
  static bool is_beside(double leader_mm, const InRow& name) {
    return leader_mm > name.left_mm - kBetween_mm && leader_mm < name.right_mm + kBetween_mm;
  }

  std::vector<std::vector<InRow>> rows_;
};

} // namespace

std::vector<PlacedName> names_in_rows(std::span<const NameToPlace> names,
                                      std::span<const StripRoom> strips, int rows,
                                      std::optional<std::size_t> most) {
  std::vector<std::size_t> order(names.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(
      order, [&](std::size_t a, std::size_t b) { return names[b].weight < names[a].weight; });
  std::vector<Rows> of_strips(strips.size(), Rows(rows));
  std::size_t count = 0;
  for (const std::size_t i : order) {
    if (most && count == *most) break;
    const NameToPlace& name = names[i];
    const Box2& room = strips[name.strip].box_mm;
    const double width_mm = name.text.extent.width_mm, x_mm = name.summit_mm.x;
    // At the strip's ends a name stands beside its leader's middle.
    const double left_mm =
        std::clamp(x_mm - 0.5 * width_mm, room.low.x, std::max(room.low.x, room.high.x - width_mm));
    if (width_mm <= 0 || width_mm > room.width() || x_mm < left_mm || x_mm > left_mm + width_mm)
      continue;
    if (of_strips[name.strip].put({i, left_mm, left_mm + width_mm, x_mm})) ++count;
  }
  std::vector<PlacedName> out;
  for (std::size_t s = 0; s < strips.size(); ++s) {
    std::vector<Box2> boxes;
    std::vector<Vec2> summits;
    for (const auto& row : of_strips[s].rows())
      for (const InRow& one : row) {
        boxes.push_back({{one.left_mm, 0}, {one.right_mm, 0}});
        summits.push_back(names[one.name].summit_mm);
      }
    double line_mm = line_of_names_mm(strips[s], boxes, summits);
    for (const auto& row : of_strips[s].rows()) {
      double row_mm = 0;
      for (const InRow& one : row) {
        row_mm = std::max(row_mm, line_height_mm(names[one.name].text.extent) + kBetween_mm);
        PlacedName placed{one.name, names[one.name].text};
        placed.text.angle = {};
        placed.text.anchor = TextAnchor::start;
        placed.text.at_mm = {one.left_mm, line_mm - kOnLeader_mm - placed.text.extent.descent_mm};
        placed.leader = Leader{{one.leader_mm, names[one.name].summit_mm.y - kOffSummit_mm},
                               {one.leader_mm, line_mm}};
        if (is_inside(placed.text.box_mm(), strips[s].box_mm)) out.push_back(placed);
      }
      line_mm -= row_mm;
    }
  }
  return out;
}

} // namespace orograph
