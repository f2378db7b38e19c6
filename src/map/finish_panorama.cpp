// SPDX-License-Identifier: GPL-3.0-or-later
#include "map/finish_panorama.hpp"

#include "draw/stroke_builder.hpp"
#include "geometry/on_all_cores.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <tuple>
#include <utility>
#include <vector>

namespace orograph {
namespace {

constexpr std::uint32_t kNoStroke = ~std::uint32_t{0};

// Both sides reckon a profile's place at the border in frames of their own.
constexpr double kSamePlace_mm = 1e-6;

bool is_same_line(const Stroke& a, const Stroke& b) {
  return a.profile == b.profile && a.feature == b.feature;
}
// Which stroke goes on from where one ends; and which one has another in front of it.
class Successors {
public:
  Successors(const Layer& layer, std::span<const Sector> sectors)
      : layer_(layer), next_(layer.strokes.size(), kNoStroke), has_before_(layer.strokes.size()) {
    link_widths();
    for (std::size_t i = 0; i + 1 < sectors.size(); ++i) link_at(sectors[i].frame_mm->high.x);
  }

  std::uint32_t next(std::uint32_t stroke) const { return next_[stroke]; }
  bool has_before(std::uint32_t stroke) const { return has_before_[stroke]; }

private:
  struct End {
    std::int32_t profile;
    double y;
    std::uint32_t stroke;
    auto key() const { return std::tuple(profile, y, stroke); }
  };

  void link(std::uint32_t from, std::uint32_t to) {
    next_[from] = to;
    has_before_[to] = true;
  }
  // Where the width of one line changes.
  void link_widths() {
    for (std::uint32_t i = 0; i + 1 < layer_.strokes.size(); ++i) {
      const Stroke &a = layer_.strokes[i], &b = layer_.strokes[i + 1];
      if (is_same_line(a, b) && layer_.points(a).back() == layer_.points(b).front()) link(i, i + 1);
    }
  }
  void link_at(double border_mm) {
    std::vector<End> left, right; // of the border
    for (std::uint32_t i = 0; i < layer_.strokes.size(); ++i) {
      const auto points = layer_.points(layer_.strokes[i]);
      const std::int32_t profile = layer_.strokes[i].profile;
      if (points.back().x == border_mm && next_[i] == kNoStroke)
        left.push_back({profile, points.back().y, i});
      if (points.front().x == border_mm && !has_before_[i])
        right.push_back({profile, points.front().y, i});
    }
    const auto less = [](const End& a, const End& b) { return a.key() < b.key(); };
    std::sort(left.begin(), left.end(), less);
    std::sort(right.begin(), right.end(), less);
    auto other = right.begin();
    for (const End& end : left) {
      while (other != right.end() &&
             std::pair(other->profile, other->y) < std::pair(end.profile, end.y - kSamePlace_mm))
        ++other;
      if (other == right.end()) return;
      if (other->profile != end.profile || other->y > end.y + kSamePlace_mm ||
          other->stroke == end.stroke)
        continue;
      link(end.stroke, other->stroke);
      ++other;
    }
  }

  const Layer& layer_;
  std::vector<std::uint32_t> next_;
  std::vector<bool> has_before_;
};

// Of a line that sectors and widths have parted.
struct LinePiece {
  Stroke stroke;
  double begin_mm; // along the line
};

// As a line's widths are in one sector (StrokeBuilder::widen).
void widen_short_parts(std::vector<LinePiece>& line, double length_mm) {
  std::size_t part = 0; // where the present width begins
  for (std::size_t i = 1; i < line.size(); ++i) {
    const double width_mm = line[i].stroke.width_mm;
    if (width_mm == line[part].stroke.width_mm) continue;
    const bool is_end = length_mm - line[i].begin_mm < kShortWidth_mm;
    if (is_end) {
      for (std::size_t k = i; k < line.size(); ++k)
        line[k].stroke.width_mm = line[part].stroke.width_mm;
      return;
    }
    if (line[i].begin_mm - line[part].begin_mm < kShortWidth_mm)
      for (std::size_t k = part; k < i; ++k) line[k].stroke.width_mm = width_mm;
    else
      part = i;
  }
}

void append_points(const Layer& from, const Stroke& stroke, std::size_t first, Layer& to) {
  const auto begin = static_cast<std::ptrdiff_t>(stroke.first_point + first),
             end = static_cast<std::ptrdiff_t>(stroke.first_point + stroke.point_count);
  to.page_mm.insert(to.page_mm.end(), from.page_mm.begin() + begin, from.page_mm.begin() + end);
  if (!from.map.empty())
    to.map.insert(to.map.end(), from.map.begin() + begin, from.map.begin() + end);
}

} // namespace

void join_at_borders(Layer& profiles, std::span<const Sector> sectors, double min_stroke_mm,
                     double& left_out_mm) {
  const Successors successors(profiles, sectors);
  Layer out = profiles;
  out.clear();
  std::vector<LinePiece> line;
  for (std::uint32_t first = 0; first < profiles.strokes.size(); ++first) {
    throw_if_stopped(first);
    if (successors.has_before(first)) continue;
    double length_mm = 0;
    line.clear();
    for (std::uint32_t i = first; i != kNoStroke; i = successors.next(i)) {
      line.push_back({profiles.strokes[i], length_mm});
      length_mm += line_length_mm(profiles.points(profiles.strokes[i]));
    }
    if (length_mm < min_stroke_mm) {
      left_out_mm += length_mm;
      continue;
    }
    widen_short_parts(line, length_mm);
    for (std::size_t i = 0; i < line.size(); ++i) {
      const Stroke& stroke = line[i].stroke;
      const bool goes_on = i > 0 && line[i - 1].stroke.width_mm == stroke.width_mm;
      if (!goes_on) {
        out.strokes.push_back(stroke);
        out.strokes.back().first_point = static_cast<std::uint32_t>(out.page_mm.size());
        out.strokes.back().point_count = 0;
      }
      append_points(profiles, stroke, goes_on ? 1 : 0, out);
      Stroke& last = out.strokes.back();
      last.point_count = static_cast<std::uint32_t>(out.page_mm.size()) - last.first_point;
    }
  }
  profiles = std::move(out);
}

Layer in_strips(const Layer& layer, std::span<const PanoramaStrip> strips) {
  Layer out = layer;
  out.clear();
  const auto strip_of = [&](double x_mm) {
    const auto at = std::partition_point(strips.begin(), strips.end() - 1,
                                         [&](const PanoramaStrip& s) { return s.end_mm < x_mm; });
    return static_cast<std::size_t>(at - strips.begin());
  };
  for (const Stroke& stroke : layer.strokes) {
    throw_if_stopped(out.strokes.size());
    const auto begin = [&] {
      out.strokes.push_back(stroke);
      out.strokes.back().first_point = static_cast<std::uint32_t>(out.page_mm.size());
      out.strokes.back().point_count = 0;
    };
    const auto add = [&](Vec2 at, std::size_t strip, std::size_t point) {
      out.page_mm.push_back(at + strips[strip].shift_mm);
      if (!layer.map.empty()) out.map.push_back(layer.map[stroke.first_point + point]);
      ++out.strokes.back().point_count;
    };
    const auto points = layer.points(stroke);
    std::size_t strip = strip_of(points[0].x);
    begin();
    add(points[0], strip, 0);
    for (std::size_t i = 1; i < points.size(); ++i) {
      const Vec2 a = points[i - 1], b = points[i];
      // Over as many ends of strips as lie between.
      for (;;) {
        const bool rises = b.x > strips[strip].end_mm && strip + 1 < strips.size(),
                   falls = strip > 0 && b.x < strips[strip - 1].end_mm;
        if (!rises && !falls) break;
        const double end_mm = strips[rises ? strip : strip - 1].end_mm;
        const double share = a.x == b.x ? 0 : std::clamp((end_mm - a.x) / (b.x - a.x), 0.0, 1.0);
        const Vec2 cut{end_mm, a.y + share * (b.y - a.y)};
        add(cut, strip, i);
        strip = rises ? strip + 1 : strip - 1;
        begin();
        add(cut, strip, i);
      }
      add(b, strip, i);
    }
  }
  return out;
}

} // namespace orograph
