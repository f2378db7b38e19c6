// SPDX-License-Identifier: GPL-3.0-or-later
#include "tone/line_widths.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace orograph {
namespace {

constexpr double kBridge_mm = 1.5, kLeastRun_mm = 2, kLeastWidthRun_mm = 1.5;
// Steps of width; 1.25 would let the tone swing by 17 %.
constexpr double kWidthRatio = 1.1;

// kWidthRatio to the power of a step, from a table where the pen's widths don't differ by hundreds.
double width_of_step(double step) {
  constexpr double kFirst = -1, kSteps = 64;
  static const std::array<double, static_cast<std::size_t>(kSteps)> powers = [] {
    std::array<double, static_cast<std::size_t>(kSteps)> all{};
    for (std::size_t i = 0; i < all.size(); ++i)
      all[i] = std::pow(kWidthRatio, kFirst + static_cast<double>(i));
    return all;
  }();
  const double at = step - kFirst;
  return at >= 0 && at < kSteps ? powers[static_cast<std::size_t>(at)]
                                : std::pow(kWidthRatio, step);
}

// Of an octave of distances, the share in which the lines that go get thinner, about its middle.
constexpr double kFade = 0.7;

// A line's width at one place, or 0 where it isn't drawn. `planned_octave` as in LinePlace.
class WidthOfLine {
public:
  WidthOfLine(const LinePlace& line, const ToneRequest& request)
      : line_(line), request_(request), spacing_octave_(std::log2(request.spacing_mm)) {}

  double at(double planned_octave, double darkness) const {
    const bool by_width = request_.is_shown_by(LightShownBy::width);
    if (!request_.is_even)
      return by_width ? within_pen(darkness * std::exp2(planned_octave)) : request_.pen_width_mm;
    const double lambda =
        (request_.is_shown_by(LightShownBy::density) ? std::log2(request_.pen_width_mm / darkness)
                                                     : spacing_octave_) -
        planned_octave;
    // Lines of level k go in this octave; finer ones have gone, and all others stay.
    const double least_k = lambda - 0.5 - 0.5 * kFade;
    if (line_.level < least_k || line_.level < -line_.halvings) return 0;
    const double k = std::max(std::ceil(least_k), static_cast<double>(-line_.halvings));
    const double into_octave = lambda - k; // 0.5 is where lines go that don't fade
    if (!by_width) return line_.level > k || into_octave <= 0.5 ? request_.pen_width_mm : 0;
    const double full_mm =
        darkness * std::exp2(planned_octave + k); // of each line, if all are drawn
    const double share = std::clamp((0.5 + 0.5 * kFade - into_octave) / kFade, 0.0, 1.0);
    // It is drawn until it gets too thin, and at any rate where it wouldn't fade.
    const bool goes_on = share >= 0.5 || share >= request_.least_width_mm / full_mm;
    const double going_mm = goes_on ? std::max(share * full_mm, request_.least_width_mm) : 0;
    if (line_.level == k) return going_mm > 0 ? within_pen(going_mm) : 0;
    return within_pen(2 * full_mm - going_mm);
  }

private:
  double within_pen(double width_mm) const {
    return std::clamp(width_mm, request_.least_width_mm, request_.greatest_width_mm);
  }

  const LinePlace& line_;
  const ToneRequest& request_;
  double spacing_octave_;
};

std::size_t columns_in(double mm, const PageColumns& columns) {
  return static_cast<std::size_t>(std::ceil(mm / columns.mm));
}

// Calls `take(begin, end)` for each run of columns of which `is` or its contrary is true.
template <class Is, class Take>
void for_each_run(std::size_t count, const Is& is, bool value, const Take& take) {
  for (std::size_t begin = 0; begin < count;) {
    const bool own = is(begin);
    std::size_t end = begin + 1;
    while (end < count && is(end) == own) ++end;
    if (own == value) take(begin, end);
    begin = end;
  }
}

void bridge_and_drop(std::vector<double>& widths, const PageColumns& columns) {
  const std::size_t count = widths.size(), bridge = columns_in(kBridge_mm, columns),
                    least = columns_in(kLeastRun_mm, columns);
  const auto is_drawn = [&](std::size_t i) { return widths[i] > 0; };
  for_each_run(count, is_drawn, false, [&](std::size_t begin, std::size_t end) {
    if (begin == 0 || end == count || end - begin >= bridge) return;
    const double width = std::min(widths[begin - 1], widths[end]);
    std::fill(widths.begin() + static_cast<std::ptrdiff_t>(begin),
              widths.begin() + static_cast<std::ptrdiff_t>(end), width);
  });
  for_each_run(count, is_drawn, true, [&](std::size_t begin, std::size_t end) {
    if (begin == 0 || end == count || end - begin >= least) return;
    std::fill(widths.begin() + static_cast<std::ptrdiff_t>(begin),
              widths.begin() + static_cast<std::ptrdiff_t>(end), 0);
  });
}

} // namespace

std::vector<ToneRun> runs_of_line(const LinePlace& line, const PageColumns& columns,
                                  const ToneRequest& request) {
  const std::size_t count = columns.count;
  const WidthOfLine width_of(line, request);
  thread_local std::vector<double> memory; // asked for once
  std::vector<double>& widths = memory;
  widths.resize(count);
  // What isn't known is as at the nearest place where it is.
  std::size_t known = count, first = count;
  bool any = false;
  for (std::size_t i = 0; i < count; ++i) {
    if (std::isnan(line.planned_octave[i])) continue;
    const double width =
        width_of.at(line.planned_octave[i], line.darkness.empty() ? 0 : line.darkness[i]);
    any |= width > 0;
    widths[i] = width;
    if (known == count)
      first = i;
    else
      for (std::size_t k = known + 1; k < i; ++k)
        widths[k] = k - known <= i - k ? widths[known] : width;
    known = i;
  }
  std::vector<ToneRun> runs;
  if (first == count) { // what of it shows is narrower than a column
    if (!request.is_even)
      runs.push_back({columns.edge(0), columns.edge(count), request.pen_width_mm});
    return runs;
  }
  if (!any) return runs;
  std::fill_n(widths.begin(), first, widths[first]);
  std::fill(widths.begin() + static_cast<std::ptrdiff_t>(known), widths.end(), widths[known]);
  bridge_and_drop(widths, columns);
  // What is seen may begin a column before the first of which that is known, or end one behind.
  if (request.is_even) {
    std::fill_n(widths.begin(), first - std::min<std::size_t>(first, 1), 0);
    if (known + 2 < count)
      std::fill(widths.begin() + static_cast<std::ptrdiff_t>(known) + 2, widths.end(), 0);
    const auto is_hidden = [&](std::size_t i) { return std::isnan(line.planned_octave[i]); };
    for (std::size_t i = first + 1; i < known; ++i)
      if (is_hidden(i) && is_hidden(i - 1) && is_hidden(i + 1)) widths[i] = 0;
  }
  const auto is_drawn = [&](std::size_t i) { return widths[i] > 0; };
  const std::size_t least = columns_in(kLeastWidthRun_mm, columns);
  const auto step_of = [&](std::size_t i) {
    return std::log(widths[i] / request.least_width_mm) / std::log(kWidthRatio);
  };
  const auto width_at = [&](double step) { return request.least_width_mm * width_of_step(step); };
  for_each_run(count, is_drawn, true, [&](std::size_t begin, std::size_t end) {
    if (!request.is_shown_by(LightShownBy::width)) {
      runs.push_back({columns.edge(begin), columns.edge(end), request.pen_width_mm});
      return;
    }
    std::size_t from = begin;
    double step = std::round(step_of(begin)), from_mm = 0, to_mm = 0;
    const auto enter = [&](double next) { // widths beyond both are of other steps
      step = next;
      from_mm = width_at(step - 1);
      to_mm = width_at(step + 1);
    };
    enter(step);
    const auto close = [&](std::size_t to) {
      runs.push_back({columns.edge(from), columns.edge(to), width_at(step)});
      from = to;
    };
    for (std::size_t i = begin + 1; i < end; ++i) {
      if (i - from < least || end - i < least) continue;
      if (widths[i] > from_mm && widths[i] < to_mm) continue;
      close(i);
      enter(std::round(step_of(i)));
    }
    close(end);
  });
  return runs;
}

} // namespace orograph
