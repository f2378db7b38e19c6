// SPDX-License-Identifier: GPL-3.0-or-later
#include "fit_drawing.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace orograph {
namespace {

constexpr double kAngleOff_deg = 5;

Strokes turned(const Strokes& strokes, int quarters) {
  Strokes result = strokes;
  for (auto& stroke : result)
    for (Vec2& p : stroke)
      for (int i = 0; i < quarters; ++i) p = {-p.y, p.x};
  return result;
}

void scale_to_picture(Strokes& strokes) {
  double left = kInfinity, right = -kInfinity;
  for (const auto& stroke : strokes)
    for (const Vec2 p : stroke) left = std::min(left, p.x), right = std::max(right, p.x);
  const double scale = kPicture_mm / (right - left);
  for (auto& stroke : strokes)
    for (Vec2& p : stroke) p = {(p.x - left) * scale, p.y * scale};
}

struct Outline {
  std::vector<double> lowest, highest; ///< mm, by column; infinite where there is no ink
};

Outline outline_of(const Strokes& strokes_mm, int columns) {
  Outline outline{std::vector<double>(static_cast<std::size_t>(columns), kInfinity),
                  std::vector<double>(static_cast<std::size_t>(columns), -kInfinity)};
  const double step_mm = kPicture_mm / (columns - 1);
  for (const auto& stroke : strokes_mm)
    for (std::size_t i = 1; i < stroke.size(); ++i) {
      const auto [a, b] = stroke[i - 1].x < stroke[i].x ? std::pair(stroke[i - 1], stroke[i])
                                                        : std::pair(stroke[i], stroke[i - 1]);
      for (double k = std::ceil(a.x / step_mm); k * step_mm <= b.x && b.x > a.x; ++k) {
        const double y = a.y + (b.y - a.y) * (k * step_mm - a.x) / (b.x - a.x);
        const auto at = static_cast<std::size_t>(std::clamp(k, 0.0, columns - 1.0));
        outline.lowest[at] = std::min(outline.lowest[at], y);
        outline.highest[at] = std::max(outline.highest[at], y);
      }
    }
  return outline;
}

/// A place of the terrain's outline and where the ink's outline is.
struct Pair {
  double z_m, v_m, y_mm;
};

// Which line makes the outline depends on the fit.
std::vector<Pair> pairs_of(const ProfileLines& lines, const Outline& outline, const Fit& fit,
                           bool underside) {
  std::vector<Pair> pairs;
  for (int column = 1; column + 1 < lines.grid.columns; ++column) {
    const auto at = static_cast<std::size_t>(column);
    if (outline.lowest[at] > outline.highest[at]) continue;
    const ProfilePoint front = lines.at(0, column);
    Pair top{0, 0, outline.highest[at]}, bottom{front.z, front.v, outline.lowest[at]};
    double greatest = -kInfinity, least = kInfinity;
    for (int line = 0; line < lines.count(); ++line) {
      const ProfilePoint p = lines.at(line, column);
      const double y = fit.per_height * p.z + fit.per_way * p.v;
      if (y > greatest) greatest = y, top.z_m = p.z, top.v_m = p.v;
      if (underside && y < least) least = y, bottom.z_m = p.z, bottom.v_m = p.v;
    }
    pairs.push_back(top);
    pairs.push_back(bottom);
  }
  return pairs;
}

// Solves for three unknowns by elimination; the matrix is symmetric and positive.
std::array<double, 3> solved(std::array<std::array<double, 4>, 3> m) {
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = i + 1; k < 3; ++k) {
      const double by = m[k][i] / m[i][i];
      for (std::size_t j = i; j < 4; ++j) m[k][j] -= by * m[i][j];
    }
  std::array<double, 3> x{};
  for (std::size_t i = 3; i-- > 0;) {
    double rest = m[i][3];
    for (std::size_t j = i + 1; j < 3; ++j) rest -= m[i][j] * x[j];
    x[i] = rest / m[i][i];
  }
  return x;
}

double away_mm(const Fit& fit, const Pair& pair) {
  return std::abs(fit.up_mm + fit.per_height * pair.z_m + fit.per_way * pair.v_m - pair.y_mm);
}

double median_mm(const Fit& fit, const std::vector<Pair>& pairs) {
  std::vector<double> away;
  for (const Pair& pair : pairs) away.push_back(away_mm(fit, pair));
  if (away.empty()) return kInfinity;
  std::nth_element(away.begin(), away.begin() + static_cast<std::ptrdiff_t>(away.size() / 2),
                   away.end());
  return away[away.size() / 2];
}

// Of the pairs that are no farther off than four times the median: a frame or a stray line isn't an
// outline. `slope`: per_way over per_height, where it is known.
Fit least_squares(const std::vector<Pair>& pairs, const Fit& before, const double* slope) {
  std::array<std::array<double, 4>, 3> sums{};
  const double limit = 4 * median_mm(before, pairs) + 1e-9;
  for (const Pair& pair : pairs) {
    if (away_mm(before, pair) > limit) continue;
    const double a = slope ? pair.z_m + *slope * pair.v_m : pair.z_m;
    const std::array<double, 4> row{a / 1000, slope ? 0 : pair.v_m / 1000, 1, pair.y_mm};
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 4; ++j) sums[i][j] += row[i] * row[j];
  }
  if (slope) sums[1][1] = 1;
  const auto [per_a, per_way, up_mm] = solved(sums);
  return {per_a / 1000, slope ? *slope * per_a / 1000 : per_way / 1000, up_mm, 0};
}

Fit fitted(const ProfileLines& lines, const Outline& outline, Angle elevation, bool underside,
           bool keep_angle) {
  const Grid& grid = lines.grid;
  const double scale = kPicture_mm / ((grid.columns - 1) * grid.plane().column_step_m.x);
  const double slope = tan(elevation);
  Fit fit{scale * cos(elevation), scale * sin(elevation), 0, 0};
  std::vector<Pair> pairs = pairs_of(lines, outline, fit, underside);
  std::vector<double> ups;
  for (const Pair& p : pairs) ups.push_back(p.y_mm - fit.per_height * p.z_m - fit.per_way * p.v_m);
  if (ups.empty()) return {0, 0, 0, kInfinity};
  std::nth_element(ups.begin(), ups.begin() + static_cast<std::ptrdiff_t>(ups.size() / 2),
                   ups.end());
  fit.up_mm = ups[ups.size() / 2];
  for (int round = 0; round < 8; ++round) {
    fit = least_squares(pairs, fit, keep_angle ? &slope : nullptr);
    pairs = pairs_of(lines, outline, fit, underside);
  }
  fit.median_mm = median_mm(fit, pairs);
  return fit;
}

} // namespace

Angle Fit::elevation() const {
  return atan2_angle(per_way, per_height);
}

PlacedDrawing place_drawing(const ProfileLines& lines, const Strokes& strokes, Angle elevation) {
  PlacedDrawing best;
  best.fit.median_mm = kInfinity;
  for (int quarters = 0; quarters < 4; ++quarters) {
    Strokes placed = turned(strokes, quarters);
    scale_to_picture(placed);
    const Outline outline = outline_of(placed, lines.grid.columns);
    for (const bool underside : {false, true}) {
      Fit fit = fitted(lines, outline, elevation, underside, true);
      const Fit free = fitted(lines, outline, elevation, underside, false);
      const double off_deg = free.elevation().in_degrees() - elevation.in_degrees();
      if (free.median_mm < 0.5 * fit.median_mm && std::abs(off_deg) < kAngleOff_deg) fit = free;
      if (fit.median_mm < best.fit.median_mm) best = {placed, fit};
    }
  }
  return best;
}

} // namespace orograph
