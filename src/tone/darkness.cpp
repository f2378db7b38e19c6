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
    for (int i = 0; i <= kSteps; ++i)
      values_[static_cast<std::size_t>(i)] = std::pow(static_cast<double>(i) / kSteps, kGamma);
  }
  double operator()(double x) const {
    const double at = std::clamp(x, 0.0, 1.0) * kSteps;
    const int i = std::min(static_cast<int>(at), kSteps - 1);
    const double* const step = values_.data() + i;
    return step[0] + (at - i) * (step[1] - step[0]);
  }

private:
  static constexpr int kSteps = 1024;
  std::array<double, kSteps + 1> values_;
};

// Of a panorama's columns: turns vectors by an angle clockwise, as the column's own direction is,
// so that they count from that.
class Turn {
public:
  explicit Turn(double angle) : cos_(std::cos(angle)), sin_(std::sin(angle)) {}
  Vec2 of(Vec2 v) const { return {v.x * cos_ - v.y * sin_, v.x * sin_ + v.y * cos_}; }

private:
  double cos_, sin_;
};

// Of a strip's columns.
using StripNumbers = std::array<double, kColumnsOfStrip>;

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

constexpr StripNumbers kNoGround = [] {
  StripNumbers all{};
  all.fill(kNone);
  return all;
}();

// The ground's normals, each as long as the page that shows it. Nothing here branches: so two
// columns are reckoned at once.
class Normals {
public:
  Normals(const PlanOnPage& plan, const PageColumns& columns, const View& view)
      : plan_(plan), columns_(columns), view_(view) {
    for (std::size_t i = 0; i < columns.count; ++i) u_per_v_.push_back(columns.u_per_v(view, i));
    for (const FanColumn& column : columns.fan) turns_.emplace_back(column.aside);
  }

  void operator()(std::size_t j, std::size_t first, std::size_t count, StripValues<3>& out) const {
    const SampledProfile& here = plan_.profiles[j];
    const double* const z_m = here.z_m.data() + first;
    const StripNumbers per_u = along_line(here, first, count);
    const double *front_z_m = kNoGround.data(), *behind_z_m = kNoGround.data();
    const double own_m = here.depth_m;
    double front_m = own_m, behind_m = own_m;
    if (j > 0) {
      front_m = plan_.profiles[j - 1].depth_m;
      front_z_m = plan_.profiles[j - 1].z_m.data() + first;
    }
    if (j + 1 < plan_.profiles.size()) {
      behind_m = plan_.profiles[j + 1].depth_m;
      behind_z_m = plan_.profiles[j + 1].z_m.data() + first;
    }
    const double* const u_per_v = u_per_v_.data() + first;
    const float* const gap_mm = plan_.seen[j].gap_mm.data() + first;
    StripNumbers right, ahead, weights;
    for (std::size_t k = 0; k < count; ++k) {
      const double own_z_m = z_m[k], in_front_m = front_z_m[k], in_back_m = behind_z_m[k];
      const bool has_front = !std::isnan(in_front_m), has_behind = !std::isnan(in_back_m);
      const double rise_m = (has_behind ? in_back_m : own_z_m) - (has_front ? in_front_m : own_z_m);
      const double way_m = (has_behind ? behind_m : own_m) - (has_front ? front_m : own_m);
      // Along the column first, which is not straight away from the viewer.
      const double along_column = rise_m / (way_m != 0 ? way_m : 1);
      const double per_v = (way_m != 0 ? 1.0 : 0.0) * (along_column - u_per_v[k] * per_u[k]);
      right[k] = -per_u[k];
      ahead[k] = -per_v;
      weights[k] = (1e-3 + gap_mm[k]) / std::sqrt(per_u[k] * per_u[k] + per_v * per_v + 1);
    }
    if (!turns_.empty())
      for (std::size_t k = 0; k < count; ++k) {
        const Vec2 turned = turns_[first + k].of({right[k], ahead[k]});
        right[k] = turned.x;
        ahead[k] = turned.y;
      }
    for (std::size_t k = 0; k < count; ++k) {
      out[0][k] = static_cast<float>(right[k] * weights[k]);
      out[1][k] = static_cast<float>(ahead[k] * weights[k]);
      out[2][k] = static_cast<float>(weights[k]);
    }
  }

private:
  // By how much the height changes a metre of u.
  StripNumbers along_line(const SampledProfile& here, std::size_t first, std::size_t count) const {
    std::array<double, kColumnsOfStrip + 2> z_m; // with one to either side
    z_m.front() = first > 0 ? here.z_m[first - 1] : kNone;
    std::copy_n(here.z_m.data() + first, count, z_m.data() + 1);
    z_m[count + 1] = first + count < here.z_m.size() ? here.z_m[first + count] : kNone;
    StripNumbers per_u, step_m;
    for (std::size_t k = 0; k < count; ++k)
      step_m[k] = columns_.step_u_m(view_, here.depth_m, first + k);
    for (std::size_t k = 0; k < count; ++k) {
      const double left_z_m = z_m[k], own_z_m = z_m[k + 1], right_z_m = z_m[k + 2];
      const bool has_left = !std::isnan(left_z_m), has_right = !std::isnan(right_z_m);
      const double rise_m = (has_right ? right_z_m : own_z_m) - (has_left ? left_z_m : own_z_m);
      per_u[k] = rise_m / (has_left && has_right ? 2 * step_m[k] : step_m[k]);
    }
    return per_u;
  }

  const PlanOnPage& plan_;
  const PageColumns& columns_;
  const View& view_;
  std::vector<double> u_per_v_;
  std::vector<Turn> turns_;
};

} // namespace

std::vector<float> darkness_of(const PlanOnPage& plan, const PageColumns& columns, const View& view,
                               const ToneRequest& request) {
  if (!request.light) return {};
  const GroundLight& light = *request.light;
  const Normals own{plan, columns, view};
  const auto normals =
      sums_on_page<3>(plan.seen, columns, std::max(light.smooth_mm, 0.5 * columns.mm), own);
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
    for (std::size_t i = 0; i < columns.fan.size(); ++i) {
      const Vec2 turned = Turn(columns.fan[i].azimuth).of({light.towards.x, light.towards.y});
      towards[i] = {turned.x, turned.y, light.towards.z};
    }
  on_all_cores(plan.profiles.size(), [&](std::size_t j) {
    const double far = range_m > 0 ? (plan.profiles[j].depth_m - nearest_m) / range_m : 0;
    const float *const x = normals[j].data(), *const y = x + columns.count,
                       *const z = y + columns.count;
    thread_local std::vector<double> memory; // asked for once
    memory.resize(columns.count);
    double* const lit = memory.data(); // NaN where nothing is seen
    for (std::size_t i = 0; i < columns.count; ++i) {
      const Vec3 n{x[i], y[i], z[i]};
      lit[i] = dot(n, towards[i]) / std::sqrt(dot(n, n));
    }
    float* const out = darkness.data() + j * columns.count;
    for (std::size_t i = 0; i < columns.count; ++i) {
      if (std::isnan(lit[i])) {
        out[i] = std::numeric_limits<float>::quiet_NaN();
        continue;
      }
      out[i] = static_cast<float>(
          (1 - request.haze * far) *
          std::clamp(level + light.contrast * (of_lit(std::max(0.0, lit[i])) - level), 0.0, 1.0));
    }
  });
  return darkness;
}

} // namespace orograph
