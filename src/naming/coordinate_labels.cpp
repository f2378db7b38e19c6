// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <variant>

#include "naming/line_labels.hpp"

namespace orograph {
namespace {

constexpr double kOffLine_mm = 1;        // from a line's end to its label
constexpr double kAroundNumber_mm = 0.6; // free of other texts
constexpr double kMiddleOfNumber = 0.35; // of figures, above their baseline, in ems

struct End {
  Vec2 at_mm, out_mm; ///< the way out, unit
};

std::optional<double> value_of(const Attribute& attribute) {
  if (const auto* real = std::get_if<double>(&attribute.value)) return *real;
  if (const auto* whole = std::get_if<std::int64_t>(&attribute.value))
    return static_cast<double>(*whole);
  return std::nullopt;
}

std::string label_of(const Attributes& feature) {
  if (feature.empty()) return {};
  const std::string& coordinate = feature.front().name;
  const auto value = value_of(feature.front());
  if (!value) return {};
  if (coordinate == "longitude" || coordinate == "latitude")
    return angle_label(*value, coordinate == "longitude");
  return fmt::format("{:.10g} {}", *value, coordinate == "easting" ? "E" : "N");
}

// Level, on the side of the end that the line points to.
PageText beyond(PageText text, const End& end) {
  const Vec2 at = end.at_mm + kOffLine_mm * end.out_mm;
  const bool is_aside = std::abs(end.out_mm.x) > std::abs(end.out_mm.y);
  text.anchor = !is_aside          ? TextAnchor::middle
                : end.out_mm.x > 0 ? TextAnchor::start
                                   : TextAnchor::end;
  text.at_mm = {at.x, is_aside           ? at.y + kMiddleOfNumber * text.size_mm
                      : end.out_mm.y > 0 ? at.y + text.extent.ascent_mm
                                         : at.y - text.extent.descent_mm};
  return text;
}

// The two that are farthest apart, or all.
void keep_two(std::vector<End>& ends) {
  if (ends.size() <= 2) return;
  std::pair<std::size_t, std::size_t> farthest{0, 1};
  double most = -1;
  for (std::size_t i = 0; i < ends.size(); ++i)
    for (std::size_t k = i + 1; k < ends.size(); ++k)
      if (const double apart = length(ends[k].at_mm - ends[i].at_mm); apart > most) {
        most = apart;
        farthest = {i, k};
      }
  ends = {ends[farthest.first], ends[farthest.second]};
}

} // namespace

std::string angle_label(double deg, bool is_longitude) {
  const char* const side = is_longitude ? (deg < 0 ? "W" : "E") : (deg < 0 ? "S" : "N");
  // Whole hundredths of a second, in which steps of graticules are whole.
  const auto all = static_cast<std::int64_t>(std::round(std::abs(deg) * 360000));
  const std::int64_t degrees = all / 360000, minutes = all / 6000 % 60, hundredths = all % 6000;
  std::string out = fmt::format("{}°", degrees);
  if (minutes != 0 || hundredths != 0) out += fmt::format("{:02}′", minutes);
  if (hundredths % 100 != 0)
    out += fmt::format("{:05.2f}″", static_cast<double>(hundredths) / 100);
  else if (hundredths != 0)
    out += fmt::format("{:02}″", hundredths / 100);
  return all == 0 ? out : out + side;
}

std::vector<PageText> coordinate_labels(const Layer& lines, double size_mm, const Box2& room_mm,
                                        const SetText& set,
                                        const std::function<bool(Vec3, Vec3)>& leaves,
                                        TakenRoom& taken) {
  std::map<std::string, std::vector<End>> by_label; // a line's strokes are features of their own
  for (const Stroke& stroke : lines.strokes) {
    if (stroke.feature < 0) continue;
    const std::string label = label_of(lines.features[static_cast<std::size_t>(stroke.feature)]);
    if (label.empty()) continue;
    const auto points = lines.points(stroke);
    const auto scene = std::span(lines.map).subspan(stroke.first_point, stroke.point_count);
    const auto add = [&](std::size_t end, std::size_t beside) {
      const Vec2 way = points[end] - points[beside];
      const double size = plain_length(way);
      if (size > 0 && leaves(scene[end], scene[beside]))
        by_label[label].push_back({points[end], 1 / size * way});
    };
    add(0, 1);
    add(points.size() - 1, points.size() - 2);
  }
  std::vector<PageText> out;
  for (auto& [label, ends] : by_label) {
    std::ranges::sort(ends, [](const End& a, const End& b) {
      return std::pair(a.at_mm.x, a.at_mm.y) < std::pair(b.at_mm.x, b.at_mm.y);
    });
    keep_two(ends);
    PageText text;
    text.text = label;
    text.size_mm = size_mm;
    text = set(text);
    for (const End& end : ends) {
      const PageText placed = set(beyond(text, end));
      if (!is_inside(placed.box_mm(), room_mm) || !taken.is_free(box_of(placed, kAroundNumber_mm)))
        continue;
      taken.take(box_of(placed));
      out.push_back(placed);
    }
  }
  return out;
}

} // namespace orograph
