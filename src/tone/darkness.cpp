// SPDX-License-Identifier: GPL-3.0-or-later
#include "tone/darkness.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "tone/mean_on_page.hpp"

namespace orograph {
namespace {

// A little more than 1: slopes that turn away from the light grow dark late.
constexpr double kGamma = 1.2;

// x^kGamma between 0 and 1, from a table: within 2e-7, where a step of a line's width is a tenth of
// it.
class GammaCurve {
public:
  GammaCurve() {
    for (std::size_t i = 0; i <= kSteps; ++i)
      values_[i] = std::pow(static_cast<double>(i) / kSteps, kGamma);
  }
  double operator()(double x) const {
    const double at = std::clamp(x, 0.0, 1.0) * kSteps;
    const auto i = std::min(static_cast<std::size_t>(at), kSteps - 1);
    return values_[i] + (at - static_cast<double>(i)) * (values_[i + 1] - values_[i]);
  }

private:
  static constexpr std::size_t kSteps = 1024;
  std::array<double, kSteps + 1> values_;
};

// By how much the height changes a metre of u and of v.
struct Slope {
  double per_u = 0, per_v = 0;
};

double change(double before, double here, double after, double step) {
  if (!std::isnan(before) && !std::isnan(after)) return (after - before) / (2 * step);
  if (!std::isnan(after)) return (after - here) / step;
  if (!std::isnan(before)) return (here - before) / step;
  return 0;
}

Slope slope_at(const PlanOnPage& plan, const PageColumns& columns, const View& view, std::size_t j,
               std::size_t i) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  const SampledProfile& at = plan.profiles[j];
  const auto& z = at.z_m;
  const double u_step = columns.step_u_m(view, at.depth_m, i);
  Slope slope;
  slope.per_u = change(i > 0 ? z[i - 1] : kNone, z[i], i + 1 < z.size() ? z[i + 1] : kNone, u_step);
  // Along the column first, which is not straight away from the viewer.
  const auto height = [&](std::size_t k) { return plan.profiles[k].z_m[i]; };
  const bool has_front = j > 0 && !std::isnan(height(j - 1)),
             has_behind = j + 1 < plan.profiles.size() && !std::isnan(height(j + 1));
  const std::size_t front = has_front ? j - 1 : j, behind = has_behind ? j + 1 : j;
  if (front == behind) return slope;
  const double along_column = (height(behind) - height(front)) /
                              (plan.profiles[behind].depth_m - plan.profiles[front].depth_m);
  slope.per_v = along_column - columns.u_per_v(view, i) * slope.per_u;
  return slope;
}

// Of a panorama's column: turned by an angle clockwise, as the column's own direction is, so that
// it counts from that.
Vec3 turned(Vec3 v, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {v.x * c - v.y * s, v.x * s + v.y * c, v.z};
}

} // namespace

std::vector<float> darkness_of(const PlanOnPage& plan, const PageColumns& columns, const View& view,
                               const ToneRequest& request) {
  if (!request.light) return {};
  const GroundLight& light = *request.light;
  const auto normals =
      sums_on_page<3>(plan.seen, columns, std::max(light.smooth_mm, 0.5 * columns.mm),
                      [&](std::size_t j, std::size_t i) -> Sums<3> {
                        const Slope slope = slope_at(plan, columns, view, j, i);
                        Vec3 up{-slope.per_u, -slope.per_v, 1};
                        if (!columns.fan.empty()) up = turned(up, columns.fan[i].aside);
                        // By how much of the page it shows.
                        const double weight =
                            (1e-3 + plan.seen[j].gap_mm[i]) /
                            std::sqrt(slope.per_u * slope.per_u + slope.per_v * slope.per_v + 1);
                        return {static_cast<float>(up.x * weight),
                                static_cast<float>(up.y * weight), static_cast<float>(weight)};
                      });
  std::vector<float> darkness(normals.size() * columns.count);
  const GammaCurve curve;
  const auto of_lit = [&](double lit) {
    return light.least + (light.greatest - light.least) * curve(1 - lit);
  };
  const double level = of_lit(std::max(0.0, light.towards.z));
  const double nearest_m = plan.profiles.empty() ? 0 : plan.profiles.front().depth_m,
               range_m = plan.profiles.empty() ? 1 : plan.profiles.back().depth_m - nearest_m;
  std::vector<Vec3> towards(columns.count, light.towards);
  if (light.stands)
    for (std::size_t i = 0; i < columns.fan.size(); ++i)
      towards[i] = turned(light.towards, columns.fan[i].azimuth);
  on_all_cores(plan.profiles.size(), [&](std::size_t j) {
    const double far = range_m > 0 ? (plan.profiles[j].depth_m - nearest_m) / range_m : 0;
    for (std::size_t i = 0; i < columns.count; ++i) {
      const auto [x, y, z] = normals[j][i];
      const Vec3 n{x, y, z};
      const double size = std::sqrt(dot(n, n));
      if (!(size > 0)) { // nothing is seen there
        darkness[j * columns.count + i] = std::numeric_limits<float>::quiet_NaN();
        continue;
      }
      const double lit = std::max(0.0, dot(n, towards[i]) / size);
      darkness[j * columns.count + i] =
          static_cast<float>((1 - request.haze * far) *
                             std::clamp(level + light.contrast * (of_lit(lit) - level), 0.0, 1.0));
    }
  });
  return darkness;
}

} // namespace orograph
