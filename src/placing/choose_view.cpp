// SPDX-License-Identifier: GPL-3.0-or-later
#include "placing/choose_view.hpp"

#include "geometry/on_all_cores.hpp"
#include "profiles/cut_surface.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace orograph {
namespace {

constexpr double kNoSlope = -std::numeric_limits<double>::infinity(); // no ground on the way
constexpr double kNoGround = std::numeric_limits<double>::quiet_NaN();
constexpr int kAzimuths = 16;

void sample_row(const Profile& profile, CoarseGround& ground, int row, double first_u_m) {
  double* const out =
      &ground.z_m[static_cast<std::size_t>(row) * static_cast<std::size_t>(ground.columns)];
  std::size_t i = 0;
  for (int column = 0; column < ground.columns; ++column) {
    const double u = first_u_m + column * ground.step_m;
    while (i + 1 < profile.size() && profile.u_m[i + 1] <= u) ++i;
    if (i + 1 >= profile.size() || profile.u_m[i] > u || profile.after[i] == Span::gap) continue;
    const double t = (u - profile.u_m[i]) / (profile.u_m[i + 1] - profile.u_m[i]);
    out[column] = (1 - t) * profile.z_m[i] + t * profile.z_m[i + 1];
  }
}

// The ray from a place towards the viewer, in steps of the raster.
class RayUp {
public:
  RayUp(const CoarseGround& ground, Vec2 towards, double highest_m)
      : ground_(ground), towards_(towards), highest_m_(highest_m) {}

  double steepest_from(int column, int row) {
    column_ = column;
    row_ = row;
    z_m_ = ground_.at(column, row);
    steepest_ = kNoSlope;
    cross(towards_.x, [&](double t) { return height_on_column(t); });
    cross(towards_.y, [&](double t) { return height_on_row(t); });
    cross(towards_.x + towards_.y, [&](double t) { return height_on_diagonal(t); });
    return steepest_;
  }

private:
  // The lines of a family are one step apart along `speed`.
  template <class HeightAt>
  void cross(double speed, const HeightAt& height_at) {
    if (std::abs(speed) < 1e-9) return; // along them: the others are crossed
    for (int k = 1;; ++k) {
      const double t = k / std::abs(speed), away_m = t * ground_.step_m;
      const Vec2 at = point(t);
      if (at.x < 0 || at.y < 0 || at.x > ground_.columns - 1 || at.y > ground_.rows - 1) return;
      if ((highest_m_ - z_m_) / away_m <= steepest_) return;
      const double slope = (height_at(t) - z_m_) / away_m;
      if (slope > steepest_) steepest_ = slope; // not where there is no ground
    }
  }

  Vec2 point(double t) const { return {column_ + t * towards_.x, row_ + t * towards_.y}; }

  // On the edge between two vertices, of which the second is beyond the raster only where the first
  // is all that counts.
  double between(int c0, int r0, int c1, int r1, double share) const {
    if (share == 0) return ground_.at(c0, r0);
    if (c1 >= ground_.columns || r1 >= ground_.rows || r1 < 0) return kNoGround;
    return (1 - share) * ground_.at(c0, r0) + share * ground_.at(c1, r1);
  }
  double height_on_column(double t) const {
    const Vec2 at = point(t);
    const int column = static_cast<int>(std::lround(at.x)), row = static_cast<int>(at.y);
    return between(column, row, column, row + 1, at.y - row);
  }
  double height_on_row(double t) const {
    const Vec2 at = point(t);
    const int column = static_cast<int>(at.x), row = static_cast<int>(std::lround(at.y));
    return between(column, row, column + 1, row, at.x - column);
  }
  double height_on_diagonal(double t) const {
    const Vec2 at = point(t);
    const int column = static_cast<int>(at.x);
    const int row = static_cast<int>(std::lround(at.x + at.y)) - column;
    if (row >= ground_.rows) return kNoGround;
    return between(column, row, column + 1, row - 1, at.x - column);
  }

  const CoarseGround& ground_;
  Vec2 towards_;
  double highest_m_;
  int column_ = 0, row_ = 0;
  double z_m_ = 0, steepest_ = 0;
};

// Uphill, as long as the sine of the slope; by the differences to the neighbours that there are.
Vec2 steepness(const CoarseGround& ground, int column, int row) {
  const auto slope = [&](int c0, int r0, int c1, int r1) {
    c0 = std::max(c0, 0), r0 = std::max(r0, 0);
    c1 = std::min(c1, ground.columns - 1), r1 = std::min(r1, ground.rows - 1);
    const int steps = (c1 - c0) + (r1 - r0);
    const double rise = steps == 0 ? 0 : (ground.at(c1, r1) - ground.at(c0, r0)) / steps;
    return std::isnan(rise) ? 0 : rise / ground.step_m;
  };
  const Vec2 tangent{slope(column - 1, row, column + 1, row),
                     slope(column, row - 1, column, row + 1)};
  return (1 / std::hypot(1, length(tangent))) * tangent;
}

// Of each place; and what they make together.
struct Relief {
  std::vector<Vec2> steepness;
  double mean = 0; ///< of its length, over places with ground
  std::size_t places = 0;
};

Relief relief_of(const CoarseGround& ground) {
  Relief out;
  double sum = 0;
  for (int row = 0; row < ground.rows; ++row)
    for (int column = 0; column < ground.columns; ++column) {
      out.steepness.push_back(steepness(ground, column, row));
      if (std::isnan(ground.at(column, row))) continue;
      sum += length(out.steepness.back());
      ++out.places;
    }
  if (out.places > 0) out.mean = sum / static_cast<double>(out.places);
  return out;
}

// What a place counts if it is seen, times the number of places.
double worth(Vec2 steepness, double mean, Vec2 towards_viewer) {
  if (!(mean > 0)) return 1;
  return 0.5 + 0.25 * (length(steepness) - dot(steepness, towards_viewer)) / mean;
}

ChosenView best_from(const CoarseGround& ground, const Relief& relief, Angle azimuth) {
  const std::vector<double> slopes = slopes_to_see(ground, azimuth);
  ChosenView best;
  best.score = -1;
  const Vec2 towards = direction_of_azimuth(azimuth);
  const double each = 1 / static_cast<double>(std::max<std::size_t>(relief.places, 1));
  for (const double elevation_deg : kTriedElevations_deg) {
    const Angle elevation = Angle::degrees(elevation_deg);
    double worth_seen = 0;
    std::size_t places_seen = 0;
    for (std::size_t i = 0; i < slopes.size(); ++i) {
      if (std::isnan(slopes[i]) || slopes[i] > tan(elevation)) continue;
      worth_seen += worth(relief.steepness[i], relief.mean, towards);
      ++places_seen;
    }
    if (const double score = cos(elevation) * each * worth_seen; score > best.score)
      best = {azimuth, elevation, score, each * static_cast<double>(places_seen)};
  }
  return best;
}

} // namespace

CoarseGround coarse_ground(const CutSurface& of, const Box3& box, double cell_m,
                           double exaggeration) {
  const double width_m = box.high.x - box.low.x, depth_m = box.high.y - box.low.y;
  CoarseGround out;
  out.step_m = std::max(std::max(width_m, depth_m) / kCoarseCells, cell_m);
  // In the middle of cells, so that none is on the terrain's edge.
  const auto cells = [&](double length_m) {
    return std::max(1, static_cast<int>(std::lround(length_m / out.step_m)));
  };
  out.columns = cells(width_m);
  out.rows = cells(depth_m);
  out.z_m.assign(static_cast<std::size_t>(out.columns) * static_cast<std::size_t>(out.rows),
                 kNoGround);
  View north;
  const Vec3 centre = box.centre();
  north.depth_origin_m = {centre.x, centre.y};
  north.exaggeration = exaggeration;
  const SurfaceCutter cutter(of.surface, north, of.level, of.for_cutters);
  const double first_u_m = -0.5 * (out.columns - 1) * out.step_m,
               first_v_m = -0.5 * (out.rows - 1) * out.step_m;
  on_all_cores(static_cast<std::size_t>(out.rows), [&](std::size_t row) {
    Profile profile;
    cutter.cut(first_v_m + static_cast<double>(row) * out.step_m, profile);
    sample_row(profile, out, static_cast<int>(row), first_u_m);
  });
  return out;
}

std::vector<double> slopes_to_see(const CoarseGround& ground, Angle azimuth) {
  double highest_m = kNoSlope;
  for (const double z_m : ground.z_m)
    if (z_m > highest_m) highest_m = z_m;
  RayUp ray(ground, direction_of_azimuth(azimuth), highest_m);
  std::vector<double> out;
  out.reserve(ground.z_m.size());
  for (int row = 0; row < ground.rows; ++row) {
    throw_if_stopped();
    for (int column = 0; column < ground.columns; ++column)
      out.push_back(std::isnan(ground.at(column, row)) ? kNoGround
                                                       : ray.steepest_from(column, row));
  }
  return out;
}

ChosenView choose_view(const CoarseGround& ground) {
  const Relief relief = relief_of(ground);
  std::array<ChosenView, kAzimuths> best;
  on_all_cores(best.size(), [&](std::size_t i) {
    const double from_south = 180 + 360.0 / kAzimuths * static_cast<double>(i);
    best[i] =
        best_from(ground, relief, Angle::degrees(from_south < 360 ? from_south : from_south - 360));
  });
  return *std::ranges::max_element(best, {}, &ChosenView::score); // the first of equals
}

} // namespace orograph
