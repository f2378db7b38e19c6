// SPDX-License-Identifier: GPL-3.0-or-later
// Every portion is told by t along its line's source, so that a steep line keeps its ends exact.
#include "horizon/surface_line.hpp"

#include "horizon/compare.hpp"
#include "horizon/horizon.hpp"
#include "horizon/take_above.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace orograph {
namespace {

// Of a line, as shares of the way along it.
struct Portion {
  double begin, end;
  bool empty() const { return !(begin < end); }
};

// Where a linear function is positive, as shares of the way from where it is f0 to where it is f1.
Portion positive(double f0, double f1) {
  if (f0 > 0 && f1 > 0) return {0, 1};
  if (f0 <= 0 && f1 <= 0) return {0, 0};
  const double zero = f0 / (f0 - f1);
  return f0 > 0 ? Portion{0, zero} : Portion{zero, 1};
}

Portion intersection(Portion a, Portion b) {
  return {std::max(a.begin, b.begin), std::min(a.end, b.end)};
}

double nearness_at(const SurfaceLine& line, double x) {
  const Segment nearness{line.source.x0, line.nearness0, line.source.x1, line.nearness1, 0};
  return height_at(nearness, x);
}

// Where between two abscissae the line's depth is the mean of that at both.
double middle_in_depth(const SurfaceLine& line, double low, double high) {
  const double n_low = nearness_at(line, low), n_high = nearness_at(line, high);
  if (!line.perspective || n_low == n_high) return 0.5 * (low + high);
  const double share = n_low / (n_low + n_high); // from the harmonic mean of the two
  return std::clamp(low + share * (high - low), low, high);
}

// Of nearness at an X: a line that runs aslant is as far off as its X.
double nearness_rounding_at(const SurfaceLine& line, double x) {
  const double slope =
      std::abs(line.nearness1 - line.nearness0) / (line.source.x1 - line.source.x0);
  if (!line.perspective) return line.rounding_m * (1 + slope);
  const double nearness = nearness_at(line, x);
  return line.rounding_m * nearness * (nearness + (1 + std::abs(x)) * slope);
}

template <class AnyHorizon>
double greatest_height(const AnyHorizon& horizon, double x, double beside) {
  double height = -std::numeric_limits<double>::infinity();
  for (auto piece = pieces_from(horizon, x - beside); piece && piece->x_begin <= x + beside;
       ++piece)
    if (!is_sky(*piece))
      height =
          std::max(height, height_at(piece->source, std::clamp(x, piece->x_begin, piece->x_end)));
  return height;
}

// What an upright line has to be above.
template <class AnyHorizon>
double height_before(const SurfaceLine& line, const AnyHorizon& horizon) {
  const double x = line.source.x0;
  return line.vertical() ? std::min(horizon_height(horizon, x - line.beside),
                                    horizon_height(horizon, x + line.beside))
                         : greatest_height(horizon, x, line.beside);
}

template <class AnyHorizon>
bool is_below(const SurfaceLine& line, const AnyHorizon& horizon) {
  for (auto piece = pieces_from(horizon, line.begin); piece && piece->x_begin < line.end; ++piece) {
    if (is_sky(*piece)) return false;
    for (const double x : {std::max(line.begin, piece->x_begin), std::min(line.end, piece->x_end)})
      if (height_at(line.source, x) > height_at(piece->source, x)) return false;
  }
  return true;
}

// By bounds, where those are kept.
bool is_clear_of(const Horizon&, const SurfaceLine&, const TieTolerance&) {
  return false;
}
bool is_clear_of(const BlockedHorizon& horizon, const SurfaceLine& line,
                 const TieTolerance& tolerance) {
  const double low = std::min(height_at(line.source, line.begin), height_at(line.source, line.end));
  return horizon.is_all_below(low, line.begin, line.end, tolerance);
}

template <class AnyHorizon, class Take>
void above_horizon(const SurfaceLine& line, const AnyHorizon& horizon,
                   const TieTolerance& tolerance, const Take& take) {
  for (auto piece = pieces_from(horizon, line.begin); piece && piece->x_begin < line.end; ++piece) {
    const double begin = std::max(line.begin, piece->x_begin),
                 end = std::min(line.end, piece->x_end);
    if (begin < end)
      take_above(compare(line.source, *piece, tolerance), line.source, *piece, begin, end,
                 [&](double t_begin, double t_end) {
                   take(Portion{t_begin, t_end});
                 });
  }
}

// A line straight away from the eye shows where it rises above all in front of it. Where it doesn't
// rise and isn't lifted from the ground, its own nearer end hides it.
Portion upright_above(const SurfaceLine& line, double height) {
  const double y0 = line.source.y0, y1 = line.source.y1;
  if (!(y1 > y0) && !line.is_lifted) return {0, 0};
  if (height == -std::numeric_limits<double>::infinity()) return {line.begin, line.end};
  return intersection({line.begin, line.end}, positive(y0 - height, y1 - height));
}

double first_x(const SurfaceLine& line) {
  return line.upright() ? line.source.x0 - line.beside : line.begin;
}
double last_x(const SurfaceLine& line) {
  return line.upright() ? line.source.x0 + line.beside : line.end;
}

} // namespace

double height_in_front(const SurfaceLine& upright, const BlockedHorizon& horizon) {
  return height_before(upright, horizon);
}

double lower_height_beside(const SurfaceLine& upright, const BlockedHorizon& horizon) {
  const double x = upright.source.x0;
  return std::min(horizon_height(horizon, x - upright.beside),
                  horizon_height(horizon, x + upright.beside));
}

template <class AnyHorizon>
void add_above_horizon(const SurfaceLine& line, std::uint32_t number, const AnyHorizon& horizon,
                       const TieTolerance& tolerance, std::vector<VisibleLinePart>& parts) {
  above_horizon(line, horizon, tolerance,
                [&](Portion seen) { append(parts, number, seen.begin, seen.end); });
}
template void add_above_horizon(const SurfaceLine&, std::uint32_t, const BlockedHorizon&,
                                const TieTolerance&, std::vector<VisibleLinePart>&);

void add_above_height(const SurfaceLine& line, std::uint32_t number, double height,
                      std::vector<VisibleLinePart>& parts) {
  const Portion seen = upright_above(line, height);
  append(parts, number, seen.begin, seen.end);
}

// Adds where `behind` is hidden by `front`: where that is nearer and higher, or tied with it.
void SlabHorizon::hide_behind(std::span<const SurfaceLine> lines, std::uint32_t front,
                              std::uint32_t behind, const TieTolerance& tolerance) {
  const SurfaceLine &f = lines[front], &b = lines[behind];
  if (!f.hides || !b.drawn || f.upright()) return;
  if (b.upright()) {
    const double x = std::clamp(b.source.x0, f.begin, f.end);
    const double nearness = nearness_at(f, x), height = height_at(f.source, x);
    if (b.vertical() && std::abs(nearness - b.nearness0) <= 2 * nearness_rounding_at(f, x)) return;
    const Portion portion = intersection(positive(nearness - b.nearness0, nearness - b.nearness1),
                                         positive(height - b.source.y0, height - b.source.y1));
    if (!portion.empty()) hidden_.push_back({behind, portion.begin, portion.end});
    return;
  }
  const double low = std::max(f.begin, b.begin), high = std::min(f.end, b.end);
  if (!(low < high)) return;
  const double nearer_low = nearness_at(f, low) - nearness_at(b, low),
               nearer_high = nearness_at(f, high) - nearness_at(b, high);
  // Where a line comes close to the plane beside the eye, rounding is more than all else at that
  // end, so the middle of the line in depth is asked as well.
  const auto are_at_one_place = [&](double from, double to) {
    for (const double x : {from, to, middle_in_depth(f, from, to)})
      if (!(std::abs(nearness_at(f, x) - nearness_at(b, x)) <=
            nearness_rounding_at(f, x) + nearness_rounding_at(b, x)))
        return false;
    return true;
  };
  bool one_place = are_at_one_place(low, high);
  if (one_place && !f.covers) return;
  // A line that runs nearly straight away from the eye, whose depth at an X is known to decimetres,
  // may end at `f`, and the slab hold less than that of it.
  one_place = one_place && are_at_one_place(std::max(f.source.x0, b.source.x0),
                                            std::min(f.source.x1, b.source.x1));
  Portion portion = one_place ? Portion{0, 1} : positive(nearer_low, nearer_high);
  const bool one_line = !one_place && f.drawn && tolerance.mm > 0 &&
                        compare(b.source, f.source, tolerance).kind == Standing::Kind::tied;
  if (!one_line)
    portion = intersection(portion, positive(height_difference(f.source, b.source, low),
                                             height_difference(f.source, b.source, high)));
  if (portion.empty()) return;
  const double t_low = parameter_at(b.source, low), t_high = parameter_at(b.source, high);
  const auto t_at = [&](double share) {
    return share >= 1 ? t_high : t_low + share * (t_high - t_low);
  };
  hidden_.push_back({behind, t_at(portion.begin), t_at(portion.end)});
}

template <class AnyHorizon>
std::span<const VisibleLinePart> SlabHorizon::visible_parts(std::vector<SurfaceLine>& lines,
                                                            const AnyHorizon& horizon,
                                                            const TieTolerance& tolerance) {
  parts_.clear();
  const bool draws =
      std::any_of(lines.begin(), lines.end(), [](const SurfaceLine& line) { return line.drawn; });
  if (draws) // or else nothing is asked, and raising a horizon finds it out itself
    std::erase_if(lines, [&](SurfaceLine& line) {
      if (line.upright()) return !line.drawn;
      line.is_clear = is_clear_of(horizon, line, tolerance);
      return !line.is_clear && is_below(line, horizon);
    });
  const auto count = static_cast<std::uint32_t>(lines.size());
  by_x_.clear();
  for (std::uint32_t i = 0; i < count; ++i)
    by_x_.push_back({first_x(lines[i]), lines[i].source.id, i});
  std::sort(by_x_.begin(), by_x_.end(),
            [](const Begin& a, const Begin& b) { return a.x != b.x ? a.x < b.x : a.id < b.id; });
  if (!draws) return parts_;

  // Sweep over X: each pair that shares some of it, and of which one may hide the other, once.
  active_.clear();
  active_hiding_.clear();
  hidden_.clear();
  for (const auto& [x, id, i] : by_x_) {
    const auto is_past = [begin = x](const Active& k) { return k.last_x < begin; };
    std::erase_if(active_hiding_, is_past);
    for (const Active& k : active_hiding_) hide_behind(lines, k.line, i, tolerance);
    if (lines[i].hides) {
      std::erase_if(active_, is_past);
      for (const std::vector<Active>* all : {&active_hiding_, &active_})
        for (const Active& k : *all) hide_behind(lines, i, k.line, tolerance);
    }
    (lines[i].hides ? active_hiding_ : active_).push_back({last_x(lines[i]), i});
  }
  std::sort(hidden_.begin(), hidden_.end(), [](const Hidden& a, const Hidden& b) {
    return a.line != b.line ? a.line < b.line : a.begin < b.begin;
  });

  auto hidden = hidden_.begin();
  for (std::uint32_t i = 0; i < count; ++i) {
    const SurfaceLine& line = lines[i];
    const auto first = hidden;
    while (hidden != hidden_.end() && hidden->line == i) ++hidden;
    if (!line.drawn) continue;
    // What is above the horizon, less the hidden portions.
    const auto take = [&](Portion seen) {
      double begin = seen.begin;
      for (auto h = first; h != hidden; ++h) {
        append(parts_, i, begin, std::min(h->begin, seen.end));
        begin = std::max(begin, h->end);
      }
      append(parts_, i, begin, seen.end);
    };
    if (line.upright())
      take(upright_above(line, height_before(line, horizon)));
    else if (line.is_clear)
      take({parameter_at(line.source, line.begin), parameter_at(line.source, line.end)});
    else
      above_horizon(line, horizon, tolerance, take);
  }
  return parts_;
}

template std::span<const VisibleLinePart>
SlabHorizon::visible_parts(std::vector<SurfaceLine>&, const Horizon&, const TieTolerance&);
template std::span<const VisibleLinePart>
SlabHorizon::visible_parts(std::vector<SurfaceLine>&, const BlockedHorizon&, const TieTolerance&);

} // namespace orograph
