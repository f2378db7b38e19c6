// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/triangulate/exact_places.hpp"

#include <CGAL/Exact_rational.h>

namespace orograph {
namespace {

using Exact = CGAL::Exact_rational;

struct ExactVec {
  Exact x, y;
};

ExactVec difference(Vec2 to, Vec2 from) {
  return {Exact(to.x) - Exact(from.x), Exact(to.y) - Exact(from.y)};
}

Exact area(const ExactVec& a, const ExactVec& b) {
  return a.x * b.y - a.y * b.x;
}

// Of a / b.
double rounded_ratio(const Exact& a, const Exact& b) {
  return CGAL::to_double(Exact(a / b));
}

} // namespace

Vec2 crossing(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
  const ExactVec u = difference(b, a), v = difference(d, c);
  const Exact share = area(difference(c, a), v) / area(u, v);
  return {CGAL::to_double(Exact(Exact(a.x) + share * u.x)),
          CGAL::to_double(Exact(Exact(a.y) + share * u.y))};
}

double share_along(Vec2 a, Vec2 b, Vec2 p) {
  const ExactVec u = difference(b, a), v = difference(p, a);
  return u.x != 0 ? rounded_ratio(v.x, u.x) : rounded_ratio(v.y, u.y);
}

std::array<double, 2> shares_in(Vec2 a, Vec2 b, Vec2 c, Vec2 p) {
  const ExactVec u = difference(b, a), v = difference(c, a), w = difference(p, a);
  return {rounded_ratio(area(w, v), area(u, v)), rounded_ratio(area(u, w), area(u, v))};
}

} // namespace orograph
