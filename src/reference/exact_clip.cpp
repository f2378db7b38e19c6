// SPDX-License-Identifier: GPL-3.0-or-later
// The horizon is a map: what stands from an abscissa on, up to the next one. A segment is put in by
// splitting the map at its ends and at its crossings; then each part is above, below, or tied.
#include "reference/exact_clip.hpp"

#include <CGAL/Exact_rational.h>
#include <CGAL/Lazy_exact_nt.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <list>
#include <map>
#include <utility>

namespace orograph {
namespace {

// The number type of CGAL's Exact_predicates_exact_constructions_kernel: intervals decide what they
// can, rationals the rest.
using Exact = CGAL::Lazy_exact_nt<CGAL::Exact_rational>;

double nearest_double(const Exact& x) {
  const CGAL::Exact_rational& exact = x.exact();
  const auto distance = [&](double to) { return CGAL::abs(exact - CGAL::Exact_rational(to)); };
  double nearest = CGAL::to_double(exact); // some of CGAL's rationals truncate
  for (const double other : {std::nextafter(nearest, -HUGE_VAL), std::nextafter(nearest, HUGE_VAL)})
    if (distance(other) < distance(nearest)) nearest = other;
  return nearest;
}

struct Line {
  explicit Line(const Segment& s)
      : x0(s.x0), y0(s.y0), x1(s.x1), slope((Exact(s.y1) - y0) / (x1 - x0)) {}
  Exact y_at(const Exact& x) const { return y0 + (x - x0) * slope; }

  Exact x0, y0, x1, slope;
};

// What stands from an abscissa on.
struct Top {
  const Line* line; ///< none: the sky
  bool inked;
  bool operator==(const Top&) const = default;
};
using Envelope = std::map<Exact, Top>;

// The place of abscissa x in the map, made if need be. REQUIRES x >= the first abscissa.
Envelope::iterator split(Envelope& envelope, const Exact& x) {
  const auto next = envelope.lower_bound(x);
  if (next != envelope.end() && next->first == x) return next;
  return envelope.emplace_hint(next, x, std::prev(next)->second);
}

// Splits the part of the map from `at` on where `line` crosses what stands there.
void split_at_crossing(Envelope& envelope, Envelope::iterator at, const Line& line) {
  if (!at->second.line) return;
  const Line& other = *at->second.line;
  if (line.slope == other.slope) return;
  const Exact x = ((other.y0 - other.x0 * other.slope) - (line.y0 - line.x0 * line.slope)) /
                  (line.slope - other.slope);
  if (at->first < x && x < std::next(at)->first) split(envelope, x);
}

// `line` against what stands between two neighbouring abscissae, where the two don't cross, so that
// the middle tells: 1 above it, 0 on it, -1 below it.
int side(const Line& line, const Top& top, const Exact& begin, const Exact& end) {
  if (!top.line) return 1;
  const Exact middle = (begin + end) / 2;
  return CGAL::sign(line.y_at(middle) - top.line->y_at(middle));
}

void append(std::vector<std::pair<Exact, Exact>>& drawn, const Exact& begin, const Exact& end) {
  if (!drawn.empty() && drawn.back().second == begin)
    drawn.back().second = end;
  else
    drawn.emplace_back(begin, end);
}

// Puts a line in; the parts to draw, in order.
std::vector<std::pair<Exact, Exact>> put_in(Envelope& envelope, const Line& line, Role role) {
  std::vector<std::pair<Exact, Exact>> drawn;
  const auto begin = split(envelope, line.x0), end = split(envelope, line.x1);
  for (auto at = begin; at != end; ++at) {
    split_at_crossing(envelope, at, line);
    const Exact& next = std::next(at)->first;
    Top& top = at->second;
    const int above = side(line, top, at->first, next);
    if (above < 0) continue;
    const bool draw = role != Role::occluder && (above > 0 || !top.inked);
    if (draw) append(drawn, at->first, next);
    if (above == 0)
      top.inked = top.inked || draw;
    else if (role != Role::compared)
      top = {&line, role == Role::drawn_occluder};
  }
  // Abscissae where nothing changes any more.
  const auto after = std::next(end);
  for (auto at = begin; at != after;)
    at = at != envelope.begin() && std::prev(at)->second == at->second ? envelope.erase(at)
                                                                       : std::next(at);
  return drawn;
}

std::size_t least_size(const Envelope& envelope) {
  std::size_t size = 1;
  for (auto at = std::next(envelope.begin()); at != envelope.end(); ++at)
    size += at->second.line != std::prev(at)->second.line ? 1 : 0;
  return size;
}

} // namespace

std::vector<ExactClip> exact_clip(std::span<const ExactList> lists) {
  double leftmost = 0;
  for (const ExactList& list : lists)
    for (const Segment& s : list.segments) leftmost = std::min(leftmost, s.x0);
  Envelope envelope{{Exact(leftmost) - 1, {nullptr, false}}};
  std::list<Line> lines; // which the envelope points into

  std::vector<ExactClip> out;
  for (const auto& [segments, role] : lists) {
    ExactClip& clip = out.emplace_back();
    for (std::uint32_t number = 0; number < segments.size(); ++number) {
      const Line& line = lines.emplace_back(segments[number]);
      const Exact length = line.x1 - line.x0;
      for (const auto& [begin, end] : put_in(envelope, line, role))
        clip.visible.push_back({number, nearest_double(begin), nearest_double(end),
                                nearest_double((begin - line.x0) / length),
                                nearest_double((end - line.x0) / length)});
    }
    clip.least_horizon = least_size(envelope);
  }
  return out;
}

} // namespace orograph
