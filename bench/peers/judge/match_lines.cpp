// SPDX-License-Identifier: GPL-3.0-or-later
#include "match_lines.hpp"

#include "reference/ray_walk.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>
#include <vector>

namespace orograph {
namespace {

constexpr double kColumnsAside = 16;

/// A place on the picture, and how much farther apart two lines along its ink are upwards than
/// across.
struct Ink {
  Vec2 at;
  double stretch;
};

struct Segment {
  Vec2 a, b; ///< a.x <= b.x
  double stretch() const { return length(b - a) / (b.x - a.x); }
  double y_at(double x) const { return a.y + (b.y - a.y) * (x - a.x) / (b.x - a.x); }
};

class Matcher {
public:
  Matcher(const ProfileLines& lines, const PlacedDrawing& drawing, double tolerance_mm)
      : lines_(lines), strokes_(drawing.strokes_mm), fit_(drawing.fit), tolerance_mm_(tolerance_mm),
        step_mm_(kPicture_mm / (lines.grid.columns - 1)), view_(view_of(lines.grid, drawing.fit)),
        walk_(lines.grid, view_), per_plane_(drawing.fit.per_height / view_.y_per_z) {}

  void ask_ink(std::uint64_t count, std::mt19937_64& engine, InkCounts& counts) const;
  void ask_rows(std::uint64_t count, std::mt19937_64& engine, InkCounts& counts) const;

private:
  static View view_of(const Grid& grid, const Fit& fit) {
    View view;
    view.projection = Projection::orthographic;
    view.elevation = fit.elevation();
    view.y_per_z = cos(view.elevation);
    view.y_per_v = sin(view.elevation);
    view.depth_origin_m = grid.plane().position_m(0, grid.rows - 1);
    return view;
  }
  double y_mm(ProfilePoint p) const {
    return fit_.up_mm + fit_.per_height * p.z + fit_.per_way * p.v;
  }
  /// Above what is in front, on the picture.
  double above_mm(ProfilePoint p) const {
    return (project(view_, p).y - walk_.in_front(p).greatest_y) * per_plane_;
  }
  std::vector<Ink> ink_around(const std::vector<Vec2>& stroke, std::size_t segment, double x) const;
  bool keeps_to(int line, const std::vector<Ink>& ink) const {
    return std::all_of(ink.begin(), ink.end(), [&](const Ink& i) {
      return std::abs(y_mm(lines_.at(line, i.at.x / step_mm_)) - i.at.y) <=
             tolerance_mm_ * i.stretch;
    });
  }

  ProfileLines lines_;
  const Strokes& strokes_;
  Fit fit_;
  double tolerance_mm_, step_mm_;
  View view_;
  RayWalk walk_;
  double per_plane_; ///< mm on the picture a metre of the visibility plane
};

// The place itself first, then where the ink crosses columns, and its turns and ends.
std::vector<Ink> Matcher::ink_around(const std::vector<Vec2>& stroke, std::size_t segment,
                                     double x) const {
  const bool rising = stroke[segment].x > stroke[segment - 1].x;
  const auto goes_on = [&](std::size_t i) {
    return rising ? stroke[i].x > stroke[i - 1].x : stroke[i].x < stroke[i - 1].x;
  };
  std::size_t first = segment, last = segment;
  const double aside = kColumnsAside * step_mm_;
  while (first > 1 && goes_on(first - 1) && std::abs(stroke[first - 1].x - x) < aside) --first;
  while (last + 1 < stroke.size() && goes_on(last + 1) && std::abs(stroke[last].x - x) < aside)
    ++last;
  std::vector<Ink> ink;
  const auto add = [&](const Segment& s, double at) {
    if (std::abs(at - x) <= aside) ink.push_back({{at, s.y_at(at)}, s.stretch()});
  };
  const auto segment_at = [&](std::size_t i) {
    return rising ? Segment{stroke[i - 1], stroke[i]} : Segment{stroke[i], stroke[i - 1]};
  };
  add(segment_at(segment), x);
  for (std::size_t i = first; i <= last; ++i) {
    const Segment s = segment_at(i);
    for (double k = std::ceil((std::max(s.a.x, x - aside)) / step_mm_);
         k * step_mm_ <= std::min(s.b.x, x + aside); ++k)
      add(s, k * step_mm_);
    add(s, s.b.x);
    add(s, s.a.x);
  }
  return ink;
}

void Matcher::ask_ink(std::uint64_t count, std::mt19937_64& engine, InkCounts& counts) const {
  // Lines of constant column are upright on the picture: they aren't asked about.
  const auto weight = [&](const std::vector<Vec2>& stroke, std::size_t i) {
    const double across = std::abs(stroke[i].x - stroke[i - 1].x);
    return across > 0.05 * step_mm_ ? length(stroke[i] - stroke[i - 1]) : 0;
  };
  double total = 0;
  for (const auto& stroke : strokes_)
    for (std::size_t i = 1; i < stroke.size(); ++i) total += weight(stroke, i);
  const double apart = total / static_cast<double>(count);
  double next = apart * std::uniform_real_distribution(0.0, 1.0)(engine), so_far = 0;
  for (const auto& stroke : strokes_)
    for (std::size_t i = 1; i < stroke.size(); ++i) {
      const double here = weight(stroke, i);
      for (; here > 0 && next < so_far + here; next += apart) {
        const double t = (next - so_far) / here;
        const double x = stroke[i - 1].x + t * (stroke[i].x - stroke[i - 1].x);
        const std::vector<Ink> ink = ink_around(stroke, i, x);
        bool on_line = false, right = false;
        for (int line = 0; line < lines_.count() && !right; ++line)
          if (keeps_to(line, ink)) {
            on_line = true;
            right = above_mm(lines_.at(line, x / step_mm_)) >= -tolerance_mm_;
          }
        ++counts.asked;
        if (!on_line) ++counts.unmatched;
        if (on_line && !right) ++counts.hidden;
      }
      so_far += here;
    }
}

void Matcher::ask_rows(std::uint64_t count, std::mt19937_64& engine, InkCounts& counts) const {
  std::vector<std::vector<Segment>> by_column(static_cast<std::size_t>(lines_.grid.columns));
  for (const auto& stroke : strokes_)
    for (std::size_t i = 1; i < stroke.size(); ++i) {
      const Segment s = stroke[i - 1].x < stroke[i].x ? Segment{stroke[i - 1], stroke[i]}
                                                      : Segment{stroke[i], stroke[i - 1]};
      if (s.b.x <= s.a.x) continue;
      for (double k = std::floor(s.a.x / step_mm_); k * step_mm_ <= s.b.x; ++k)
        by_column[static_cast<std::size_t>(std::clamp(k, 0.0, lines_.grid.columns - 1.0))]
            .push_back(s);
    }
  std::uniform_int_distribution any_line(0, lines_.count() - 1);
  std::uniform_real_distribution any_column(0.0, lines_.grid.columns - 1.0);
  for (std::uint64_t i = 0; i < count; ++i) {
    const double column = any_column(engine);
    const ProfilePoint at = lines_.at(any_line(engine), column);
    if (above_mm(at) <= tolerance_mm_) continue;
    const double x = column * step_mm_, y = y_mm(at);
    const auto& near = by_column[static_cast<std::size_t>(column)];
    ++counts.visible;
    if (std::none_of(near.begin(), near.end(), [&](const Segment& s) {
          const double nearest = std::clamp(x, s.a.x, s.b.x);
          return std::abs(nearest - x) <= tolerance_mm_ &&
                 std::abs(s.y_at(nearest) - y) <= tolerance_mm_ * (1 + s.stretch());
        }))
      ++counts.missing;
  }
}

double share(std::uint64_t part, std::uint64_t whole) {
  return whole > 0 ? static_cast<double>(part) / static_cast<double>(whole) : 0;
}

} // namespace

double InkCounts::hidden_share() const {
  return share(hidden, asked - unmatched);
}

double InkCounts::missing_share() const {
  return share(missing, visible);
}

InkCounts match_lines(const ProfileLines& lines, const PlacedDrawing& drawing, double tolerance_mm,
                      std::uint64_t count) {
  InkCounts counts;
  std::mt19937_64 engine(1);
  const Matcher matcher(lines, drawing, tolerance_mm);
  matcher.ask_ink(count, engine, counts);
  matcher.ask_rows(count, engine, counts);
  return counts;
}

} // namespace orograph
