// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/growth.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace orograph {
namespace {

std::optional<double> slope(const std::vector<std::array<double, 2>>& points) {
  const auto n = static_cast<double>(points.size());
  double x = 0, y = 0, xx = 0, xy = 0;
  for (const auto& [px, py] : points) {
    x += px;
    y += py;
    xx += px * px;
    xy += px * py;
  }
  const double spread = n * xx - x * x;
  if (points.size() < 2 || !(spread > 0)) return std::nullopt;
  return (n * xy - x * y) / spread;
}

struct Measure {
  const char* name;
  std::optional<double> (*of)(const FragmentationRow&);
};

template <class Count>
double as_double(Count count) {
  return static_cast<double>(count);
}

constexpr std::array kMeasures{
    Measure{"occluders",
            [](const FragmentationRow& r) { return std::optional(as_double(r.occluders)); }},
    Measure{"visible_pieces",
            [](const FragmentationRow& r) { return std::optional(as_double(r.visible)); }},
    Measure{"pieces_without",
            [](const FragmentationRow& r) {
              return r.fragmented ? std::optional(as_double(r.fragmented->at_most)) : std::nullopt;
            }},
    Measure{
        "pieces_with",
        [](const FragmentationRow& r) { return std::optional(as_double(r.collapsed.at_most)); }},
    Measure{"pieces_least",
            [](const FragmentationRow& r) {
              return r.least ? std::optional(as_double(r.least->run.at_most)) : std::nullopt;
            }},
    Measure{"work_without",
            [](const FragmentationRow& r) {
              return r.fragmented ? std::optional(as_double(r.fragmented->work)) : std::nullopt;
            }},
    Measure{"work_with",
            [](const FragmentationRow& r) { return std::optional(as_double(r.collapsed.work)); }},
    Measure{"seconds_without",
            [](const FragmentationRow& r) {
              return r.fragmented ? std::optional(r.fragmented->seconds) : std::nullopt;
            }},
    Measure{"seconds_with",
            [](const FragmentationRow& r) { return std::optional(r.collapsed.seconds); }}};

bool alike(const FragmentationRow& a, const FragmentationRow& b) {
  return a.scene == b.scene && a.occluder == b.occluder && a.azimuth_deg == b.azimuth_deg &&
         a.elevation_deg == b.elevation_deg;
}

} // namespace

bool Growth::is_known() const {
  return std::any_of(exponents.begin(), exponents.end(),
                     [](const auto& named) { return named.second.has_value(); });
}

std::vector<Growth> growth_of(const std::vector<FragmentationRow>& rows) {
  std::vector<Growth> out;
  for (std::size_t i = 0; i < rows.size();) {
    std::size_t end = i;
    while (end < rows.size() && alike(rows[i], rows[end])) ++end;
    Growth& growth = out.emplace_back();
    growth.like = rows[i];
    for (const Measure& measure : kMeasures) {
      std::vector<std::array<double, 2>> points;
      for (const FragmentationRow& row : std::span(rows).subspan(i, end - i))
        if (const auto value = measure.of(row); value && *value > 0)
          points.push_back({std::log(row.profiles), std::log(*value)});
      growth.exponents.emplace_back(measure.name, slope(points));
    }
    i = end;
  }
  return out;
}

} // namespace orograph
