// SPDX-License-Identifier: GPL-3.0-or-later
// The horizon is a map: what stands from an abscissa on, up to the next one. A segment is put in by
// splitting the map at its ends and at its crossings; then each part is above, below, or tied.
#include "reference/exact_clip.hpp"

#define CGAL_DO_NOT_USE_BOOST_MP // its rationals are GMP's without; 1.7 s less to compile
#include <CGAL/Exact_rational.h>
#include <CGAL/Lazy_exact_nt.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <optional>
#include <unordered_map>
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
      : source(s), x0(s.x0), y0(s.y0), x1(s.x1), slope((Exact(s.y1) - y0) / (x1 - x0)) {}
  Exact y_at(const Exact& x) const { return y0 + (x - x0) * slope; }

  Segment source;
  Exact x0, y0, x1, slope;
};

// What stands from an abscissa on.
struct Top {
  const Line* line; ///< none: the sky
  bool inked;
  mutable std::optional<double> nearest = {}; ///< to the abscissa; kept, since it costs much
  bool is_like(const Top& other) const { return line == other.line && inked == other.inked; }
};
using Envelope = std::map<Exact, Top>;

// The place of abscissa x in the map, made if need be. REQUIRES x >= the first abscissa.
Envelope::iterator split(Envelope& envelope, const Exact& x) {
  const auto next = envelope.lower_bound(x);
  if (next != envelope.end() && next->first == x) return next;
  const Top& top = std::prev(next)->second;
  return envelope.emplace_hint(next, x, Top{top.line, top.inked});
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

// Puts a part of a line in; the parts to draw, in order.
std::vector<std::pair<Exact, Exact>> put_in(Envelope& envelope, const Line& line, const Exact& x0,
                                            const Exact& x1, Role role) {
  std::vector<std::pair<Exact, Exact>> drawn;
  const auto begin = split(envelope, x0), end = split(envelope, x1);
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
      top = {&line, role == Role::drawn_occluder, top.nearest};
  }
  // Abscissae where nothing changes any more.
  const auto after = std::next(end);
  for (auto at = begin; at != after;)
    at = at != envelope.begin() && std::prev(at)->second.is_like(at->second) ? envelope.erase(at)
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

struct ExactHorizon::Content {
  // From an abscissa on that is left of all.
  Envelope envelope{{Exact(-1), {nullptr, false}}};
  std::unordered_map<std::uint64_t, Line> lines; // by id; the envelope points into it

  const Line& line(const Segment& s) { return lines.try_emplace(s.id, s).first->second; }
  void reach(double x) {
    const auto first = envelope.begin();
    if (first->first < x) return;
    envelope.emplace(Exact(x) - 1, Top{nullptr, false});
    envelope.erase(first);
  }
};

ExactHorizon::ExactHorizon() : content_(std::make_unique<Content>()) {}
ExactHorizon::~ExactHorizon() = default;

ExactClip ExactHorizon::clip(const ExactList& list) {
  ExactClip clip;
  for (std::uint32_t number = 0; number < list.segments.size(); ++number) {
    const Segment& s = list.segments[number];
    const Line& line = content_->line(s);
    content_->reach(s.x0);
    const Exact length = line.x1 - line.x0;
    for (const auto& [begin, end] : put_in(content_->envelope, line, line.x0, line.x1, list.role))
      clip.visible.push_back({number, nearest_double(begin), nearest_double(end),
                              nearest_double((begin - line.x0) / length),
                              nearest_double((end - line.x0) / length)});
  }
  clip.least_horizon = size();
  return clip;
}

void ExactHorizon::raise(std::span<const HorizonPiece> occluders) {
  for (const HorizonPiece& piece : occluders) {
    content_->reach(piece.x_begin);
    put_in(content_->envelope, content_->line(piece.source), piece.x_begin, piece.x_end,
           Role::occluder);
  }
}

std::size_t ExactHorizon::size() const {
  return least_size(content_->envelope);
}

Horizon ExactHorizon::pieces() const {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Horizon out = initial_horizon();
  const Segment sky = out.front().source;
  const Line* last = nullptr;
  const Envelope& envelope = content_->envelope;
  for (auto at = std::next(envelope.begin()); at != envelope.end(); ++at) {
    const Top& top = at->second;
    if (top.line == last) continue;
    if (!top.nearest) top.nearest = nearest_double(at->first);
    out.back().x_end = *top.nearest;
    out.push_back({*top.nearest, infinity, top.line ? top.line->source : sky, false});
    last = top.line;
  }
  return out;
}

std::vector<ExactClip> exact_clip(std::span<const ExactList> lists) {
  ExactHorizon horizon;
  std::vector<ExactClip> out;
  for (const ExactList& list : lists) out.push_back(horizon.clip(list));
  return out;
}

} // namespace orograph
