// SPDX-License-Identifier: GPL-3.0-or-later
// A stroke is sampled at even steps. Each sample may move within a disc about its place, and of all
// lines through the discs one is taken that hardly bends: it minimises the sum of squared
// displacements and, times a stiffness, of squared second differences (Whittaker's smoothing). That
// damps a wave of the line by 1 / (1 + (w / wavelength)^4), so a staircase of cells goes and a bay
// stays as deep as it was. Where a sample would leave its disc its displacement is given more
// weight, until none does. Walking both lines from sample to sample shows that they are no farther
// apart than the discs' radius and half a step: half a step is what the stroke itself may be
// beside the straight line between two samples.
#include "draw/smooth_strokes.hpp"

#include "draw/simplify.hpp"
#include "geometry/on_all_cores.hpp"
#include "geometry/sort_by_number.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <span>
#include <vector>

namespace orograph {
namespace {

constexpr double kStepsABound = 5;
constexpr double kRadius = 1 - 0.5 / kStepsABound; ///< of the discs, in bounds
constexpr double kHalfDamped = 12;                 ///< the wave damped by half, in bounds

// A stroke's samples. Of a closed one the first isn't there again as the last.
struct Track {
  std::size_t first = 0, count = 0;
  double step_mm = 0, length_mm = 0;
  bool closed = false;

  std::size_t segments() const { return closed ? count : count - 1; }
  std::size_t next(std::size_t sample) const {
    return sample + 1 < first + count ? sample + 1 : first;
  }
};

// Appends the samples of a stroke, at most a step apart along it.
Track sample(std::span<const Vec2> points, double step_mm, std::vector<Vec2>& places) {
  constexpr double kLeastSteps = 16;
  Track track;
  track.first = places.size();
  track.closed = points.size() > 2 && points.front() == points.back();
  track.length_mm = line_length_mm(points);
  const double steps = std::max(kLeastSteps, std::ceil(track.length_mm / step_mm));
  track.step_mm = track.length_mm / steps;
  places.push_back(points.front());
  double before_mm = 0; // along the stroke, of the segment's first point
  double number = 1;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const double along_mm = plain_length(points[i] - points[i - 1]);
    if (!(along_mm > 0)) continue;
    for (; number < steps && number * track.step_mm <= before_mm + along_mm; ++number) {
      throw_if_stopped(places.size());
      const double share = (number * track.step_mm - before_mm) / along_mm;
      places.push_back(points[i - 1] + std::clamp(share, 0.0, 1.0) * (points[i] - points[i - 1]));
    }
    before_mm += along_mm;
  }
  for (; number < steps; ++number) places.push_back(points.back()); // rounding, or no length
  if (!track.closed) places.push_back(points.back());
  track.count = places.size() - track.first;
  return track;
}

// Minimises the sum of weight * |x - place|² and stiffness * |second difference of x|²: a
// symmetric system with two diagonals beside its own, solved by its factors L D L^T.
class Fairing {
public:
  void solve(std::span<const Vec2> places, std::span<const double> weights, double stiffness,
             std::vector<Vec2>& x) {
    const std::size_t n = places.size();
    diagonal_.assign(n, 0);
    beside_.assign(n, 0); // of rows i and i + 1
    next_.assign(n, 0);   // of rows i and i + 2
    x.assign(n, {});
    for (std::size_t i = 0; i < n; ++i) {
      diagonal_[i] += weights[i];
      x[i] = weights[i] * places[i];
      if (i + 2 >= n) continue;
      diagonal_[i] += stiffness;
      diagonal_[i + 1] += 4 * stiffness;
      diagonal_[i + 2] += stiffness;
      beside_[i] -= 2 * stiffness;
      beside_[i + 1] -= 2 * stiffness;
      next_[i] += stiffness;
    }
    for (std::size_t i = 0; i < n; ++i) {
      throw_if_stopped(i);
      const double beside = beside_[i] / diagonal_[i], next = next_[i] / diagonal_[i];
      if (i + 1 < n) {
        diagonal_[i + 1] -= beside * beside_[i];
        beside_[i + 1] -= beside * next_[i];
        x[i + 1] = x[i + 1] - beside * x[i];
      }
      if (i + 2 < n) {
        diagonal_[i + 2] -= next * next_[i];
        x[i + 2] = x[i + 2] - next * x[i];
      }
      beside_[i] = beside;
      next_[i] = next;
    }
    for (std::size_t i = n; i-- > 0;) {
      x[i] = (1 / diagonal_[i]) * x[i];
      if (i + 1 < n) x[i] = x[i] - beside_[i] * x[i + 1];
      if (i + 2 < n) x[i] = x[i] - next_[i] * x[i + 2];
    }
  }

private:
  std::vector<double> diagonal_, beside_, next_;
};

Vec2 within(Vec2 p, Vec2 place, double radius_mm) {
  const Vec2 moved = p - place;
  const double size = plain_length(moved);
  return size > radius_mm ? place + (radius_mm / size) * moved : p;
}

// Where the samples of a track go.
void fair(const Track& track, std::span<const Vec2> places, double bound_mm, Fairing& fairing,
          std::vector<Vec2>& out) {
  constexpr double kPinned = 1e12;
  constexpr int kMostSolutions = 24;
  if (!(track.length_mm > 0)) {
    out.insert(out.end(), places.begin(), places.end());
    return;
  }
  const double radius_mm = kRadius * bound_mm;
  // Of a ring no wave that it is itself is damped: an island stays as large.
  const double wave_mm =
      std::min(kHalfDamped * bound_mm, (track.closed ? 0.5 : 1) * track.length_mm);
  const double waves_steps = wave_mm / track.step_mm;
  const double stiffness = std::pow(waves_steps / (2 * std::numbers::pi), 4);
  // A ring goes on beyond its begin and end, as far as anything there bends it here.
  const std::size_t beyond =
      track.closed ? static_cast<std::size_t>(std::ceil(4 * waves_steps)) : 0;
  std::vector<Vec2> line;
  for (std::size_t i = 0; i < track.count + 2 * beyond; ++i)
    line.push_back(places[(i + track.count * (1 + beyond / track.count) - beyond) % track.count]);
  std::vector<double> weights(line.size(), 1);
  if (!track.closed) weights.front() = weights.back() = kPinned;
  std::vector<Vec2> x;
  for (int solution = 0; solution < kMostSolutions; ++solution) {
    fairing.solve(line, weights, stiffness, x);
    bool all_within = true;
    for (std::size_t i = 0; i < line.size(); ++i) {
      const double share = plain_length(x[i] - line[i]) / radius_mm;
      if (share <= 1) continue;
      all_within = false;
      weights[i] = std::min(kPinned, weights[i] * share * share * share);
    }
    if (all_within) break;
  }
  for (std::size_t i = 0; i < track.count; ++i)
    out.push_back(within(x[i + beyond], line[i + beyond], radius_mm));
  if (track.closed) return;
  out[track.first] = places.front();
  out.back() = places.back();
}

bool cross_each_other(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
  const auto sides = [](Vec2 p, Vec2 q, Vec2 r, Vec2 s) {
    return cross(q - p, r - p) * cross(q - p, s - p);
  };
  return sides(a, b, c, d) < 0 && sides(c, d, a, b) < 0;
}

// All strokes' samples, how they would move and how much of that they do.
class MovedSamples {
public:
  MovedSamples(std::vector<Track> tracks, std::vector<Vec2> places, std::vector<Vec2> moved)
      : tracks_(std::move(tracks)), places_(std::move(places)), moved_(std::move(moved)),
        shares_(places_.size(), 1) {
    for (std::uint32_t t = 0; t < tracks_.size(); ++t)
      track_of_.insert(track_of_.end(), tracks_[t].count, t);
  }

  Vec2 at(std::size_t i) const {
    return shares_[i] == 1 ? moved_[i] : places_[i] + shares_[i] * (moved_[i] - places_[i]);
  }
  const std::vector<Track>& tracks() const { return tracks_; }

  /// Moves back what crosses something, first by half, until nothing does but what isn't moved.
  void part_crossings(double cell_mm, double taper_mm) {
    for (;;) {
      const std::vector<std::uint32_t> crossing = crossing_segments(cell_mm);
      bool changes = false;
      for (const std::uint32_t segment : crossing) changes |= move_back(segment, taper_mm);
      if (!changes) return;
    }
  }

private:
  struct InCell {
    std::uint64_t cell;
    std::uint32_t segment; ///< by its first sample
  };

  std::vector<std::uint32_t> crossing_segments(double cell_mm) const {
    std::vector<InCell> cells;
    Vec2 low{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
    for (std::size_t i = 0; i < places_.size(); ++i)
      low = {std::min(low.x, at(i).x), std::min(low.y, at(i).y)};
    const auto along = [&](double mm, double low_mm) {
      return static_cast<std::uint64_t>((mm - low_mm) / cell_mm);
    };
    for (const Track& track : tracks_)
      for (std::size_t i = track.first; i < track.first + track.segments(); ++i) {
        throw_if_stopped(cells.size());
        const Vec2 a = at(i), b = at(track.next(i));
        for (std::uint64_t y = along(std::min(a.y, b.y), low.y);
             y <= along(std::max(a.y, b.y), low.y); ++y)
          for (std::uint64_t x = along(std::min(a.x, b.x), low.x);
               x <= along(std::max(a.x, b.x), low.x); ++x)
            cells.push_back({y << 31U | x, static_cast<std::uint32_t>(i)});
      }
    sort_by_number(cells, [](const InCell& in) { return in.cell; });
    std::vector<std::uint32_t> crossing;
    for (std::size_t first = 0, end = 0; first < cells.size(); first = end) {
      throw_if_stopped(first);
      while (end < cells.size() && cells[end].cell == cells[first].cell) ++end;
      for (std::size_t i = first; i < end; ++i)
        for (std::size_t k = first; k < i; ++k)
          if (cross(cells[i].segment, cells[k].segment))
            for (const std::uint32_t segment : {cells[i].segment, cells[k].segment})
              crossing.push_back(segment);
    }
    std::sort(crossing.begin(), crossing.end());
    crossing.erase(std::unique(crossing.begin(), crossing.end()), crossing.end());
    return crossing;
  }

  bool cross(std::uint32_t a, std::uint32_t b) const {
    return cross_each_other(at(a), at(tracks_[track_of_[a]].next(a)), at(b),
                            at(tracks_[track_of_[b]].next(b)));
  }

  // Less and less with the distance along the stroke. Tells whether anything was moved.
  bool move_back(std::uint32_t segment, double taper_mm) {
    const Track& track = tracks_[track_of_[segment]];
    const std::size_t next = track.next(segment);
    const double least = std::min(shares_[segment], shares_[next]);
    if (std::max(shares_[segment], shares_[next]) == 0) return false;
    const double share = least == 1 ? 0.5 : 0;
    const auto reach = static_cast<std::size_t>(taper_mm / track.step_mm) + 1;
    const auto move = [&](std::size_t sample, std::size_t away) {
      const double tapered =
          share + (1 - share) * static_cast<double>(away) / static_cast<double>(reach);
      shares_[sample] = std::min(shares_[sample], tapered);
    };
    const std::size_t here = segment - track.first;
    for (std::size_t away = 0; away < std::min(reach, track.count); ++away) {
      if (track.closed || here >= away)
        move(track.first + (here + track.count - away) % track.count, away);
      if (track.closed || here + 1 + away < track.count)
        move(track.first + (here + 1 + away) % track.count, away);
    }
    return true;
  }

  std::vector<Track> tracks_;
  std::vector<Vec2> places_, moved_;
  std::vector<double> shares_;
  std::vector<std::uint32_t> track_of_; ///< by sample
};

} // namespace

Layer smoothed(const Layer& layer, const SmoothSettings& settings) {
  const bool smooths = settings.bound_mm >= kLeastSmoothing_mm;
  Layer out = layer;
  out.clear();
  std::vector<Track> tracks;
  std::vector<Vec2> places, moved;
  Fairing fairing;
  for (const Stroke& stroke : layer.strokes) {
    if (!smooths) break;
    const Track track = sample(layer.points(stroke), settings.bound_mm / kStepsABound, places);
    fair(track, std::span(places).subspan(track.first), settings.bound_mm, fairing, moved);
    tracks.push_back(track);
  }
  const auto& [low, high] = settings.frame_mm;
  for (Vec2& p : moved) p = {std::clamp(p.x, low.x, high.x), std::clamp(p.y, low.y, high.y)};
  MovedSamples samples(std::move(tracks), std::move(places), std::move(moved));
  samples.part_crossings(settings.bound_mm, 2 * settings.bound_mm);
  std::vector<Vec2> points;
  std::vector<std::uint32_t> kept;
  for (std::size_t s = 0; s < layer.strokes.size(); ++s) {
    const auto before = layer.points(layer.strokes[s]);
    points.assign(before.begin(), before.end());
    if (smooths) {
      const Track& track = samples.tracks()[s];
      points.clear();
      for (std::size_t i = 0; i < track.count; ++i) points.push_back(samples.at(track.first + i));
      if (track.closed) points.push_back(points.front());
    }
    simplify(points, settings.simplify_mm, kept);
    Stroke stroke = layer.strokes[s];
    stroke.first_point = static_cast<std::uint32_t>(out.page_mm.size());
    stroke.point_count = static_cast<std::uint32_t>(kept.size());
    for (const std::uint32_t i : kept) out.page_mm.push_back(points[i]);
    out.strokes.push_back(stroke);
  }
  return out;
}

} // namespace orograph
