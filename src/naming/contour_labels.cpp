// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <variant>

#include "naming/line_labels.hpp"

namespace orograph {
namespace {

constexpr double kApart_mm = 120;    // on one line, from a label to the next
constexpr double kAround_mm = 1.5;   // free of other texts
constexpr double kBeside_mm = 0.5;   // straight, on either side of the text
constexpr double kLeastOfText = 2.5; // shorter lines have no label, in the text's lengths
constexpr double kMostBend = 0.2;    // of the letters' size
constexpr double kMiddle = 0.35;     // of figures, above their baseline, in ems
constexpr double kMostInk = 0.5;     // of the paper beneath: closer lines leave a hole
constexpr double kStep_mm = 1;       // between places that are tried

// Lengths along a stroke, and the points there.
class Along {
public:
  Along(std::span<const Vec2> points, std::span<const Vec3> scene)
      : points_(points), scene_(scene) {
    lengths_.push_back(0);
    for (std::size_t i = 1; i < points.size(); ++i)
      lengths_.push_back(lengths_.back() + plain_length(points[i] - points[i - 1]));
  }

  double length_mm() const { return lengths_.back(); }
  Vec2 at(double mm) const {
    const auto [i, share] = place(mm);
    return points_[i] + share * (points_[i + 1] - points_[i]);
  }
  Vec3 scene_at(double mm) const {
    const auto [i, share] = place(mm);
    return scene_[i] + share * (scene_[i + 1] - scene_[i]);
  }
  /// How far the line is from the straight way between two of its points, at most.
  double bend_mm(double from, double to) const {
    const Vec2 begin = at(from), way = at(to) - begin;
    const double size = plain_length(way);
    // A line that comes back on itself isn't straight, however near its ends are.
    if (!(size > 0.9 * (to - from))) return to - from;
    double most = 0;
    for (std::size_t i = place(from).first + 1; i < points_.size() && lengths_[i] < to; ++i)
      most = std::max(most, std::abs(cross(way, points_[i] - begin)) / size);
    return most;
  }

private:
  std::pair<std::size_t, double> place(double mm) const {
    const auto after = std::upper_bound(lengths_.begin() + 1, lengths_.end() - 1, mm);
    const auto i = static_cast<std::size_t>(after - lengths_.begin()) - 1;
    const double size = lengths_[i + 1] - lengths_[i];
    return {i, size > 0 ? std::clamp((mm - lengths_[i]) / size, 0.0, 1.0) : 0};
  }

  std::span<const Vec2> points_;
  std::span<const Vec3> scene_;
  std::vector<double> lengths_;
};

std::optional<std::string> height_text(const Layer& lines, const Stroke& stroke) {
  if (stroke.feature < 0) return std::nullopt;
  for (const Attribute& own : lines.features[static_cast<std::size_t>(stroke.feature)])
    if (own.name == "elevation") {
      if (const auto* height = std::get_if<double>(&own.value))
        return fmt::format("{:.10g}", *height);
      if (const auto* height = std::get_if<std::int64_t>(&own.value))
        return fmt::format("{}", *height);
    }
  return std::nullopt;
}

// A place, and how little it suits.
struct Bend {
  double cost, middle_mm;
};

} // namespace

std::vector<PageText> contour_labels(const Layer& lines, double size_mm, const Box2& room_mm,
                                     const InkMap& ink, const SetText& set,
                                     const std::function<std::optional<Vec2>(Vec3)>& uphill_mm,
                                     TakenRoom& taken) {
  std::vector<PageText> out;
  for (const Stroke& stroke : lines.strokes) {
    const auto height = height_text(lines, stroke);
    if (!height) continue;
    const Along along(lines.points(stroke),
                      std::span(lines.map).subspan(stroke.first_point, stroke.point_count));
    PageText text;
    text.text = *height;
    text.size_mm = size_mm;
    text.anchor = TextAnchor::middle;
    text = set(text);
    const double half_mm = 0.5 * text.extent.width_mm + kBeside_mm;
    if (along.length_mm() < kLeastOfText * 2 * half_mm) continue;
    const double count = std::max(1.0, std::floor(along.length_mm() / kApart_mm));
    for (double part = 0; part < count; ++part) {
      const double from = along.length_mm() * part / count,
                   to = along.length_mm() * (part + 1) / count;
      std::vector<Bend> bends;
      for (double at = from + half_mm; at <= to - half_mm; at += kStep_mm) {
        const double bend = along.bend_mm(at - half_mm, at + half_mm);
        if (bend > kMostBend * size_mm) continue;
        Box2 about; // letters' height to either side of the line
        for (const double end : {at - half_mm, at + half_mm}) {
          about.include(along.at(end) - Vec2{0.5 * size_mm, 0.5 * size_mm});
          about.include(along.at(end) + Vec2{0.5 * size_mm, 0.5 * size_mm});
        }
        const double share = ink.share(about);
        if (share <= kMostInk) bends.push_back({share + bend / size_mm, at});
      }
      std::ranges::stable_sort(bends, {}, &Bend::cost);
      for (const Bend& bend : bends) {
        const Vec2 begin = along.at(bend.middle_mm - half_mm),
                   end = along.at(bend.middle_mm + half_mm);
        const auto uphill = uphill_mm(along.scene_at(bend.middle_mm));
        if (!uphill) continue;
        Vec2 way = end - begin;
        if (dot(Vec2{way.y, -way.x}, *uphill) < 0) way = Vec2{} - way;
        const double size = plain_length(way);
        const Vec2 up = 1 / size * Vec2{way.y, -way.x};
        text.angle = atan2_angle(-way.y, way.x);
        text.at_mm = 0.5 * (begin + end) - kMiddle * size_mm * up;
        const PageText placed = set(text);
        if (!is_inside(placed.box_mm(), room_mm) || !taken.is_free(box_of(placed, kAround_mm)))
          continue;
        taken.take(box_of(placed));
        out.push_back(placed);
        break;
      }
    }
  }
  return out;
}

} // namespace orograph
