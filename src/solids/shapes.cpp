// SPDX-License-Identifier: GPL-3.0-or-later
#include "solids/shapes.hpp"

#include "geometry/error.hpp"
#include "solids/build_solid.hpp"
#include "solids/plane_polygon.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace orograph {
namespace {

using Index = std::uint32_t;

// Counterclockwise, from above.
std::vector<Vec2> checked_base(std::vector<Vec2> base_m) {
  if (base_m.size() < 3)
    throw Error("the base has fewer than three corners", "give three or more, [x, y] each");
  if (const std::string fault = fault_of_line(base_m, true); !fault.empty())
    throw Error("the base " + fault, "its edges should meet at corners only; its last corner is "
                                     "joined to the first without being told");
  if (signed_area(base_m) < 0) std::reverse(base_m.begin(), base_m.end());
  return base_m;
}

std::vector<Index> bottom_face(std::size_t corners) {
  std::vector<Index> face;
  for (std::size_t i = corners; i-- > 0;) face.push_back(static_cast<Index>(i));
  return face;
}

Vec3 apex_of(const std::vector<Vec2>& base_m, const Apex& apex_m) {
  if (const Vec3* point = std::get_if<Vec3>(&apex_m)) return *point;
  Vec2 middle;
  for (const Vec2 corner : base_m)
    middle = middle + (1.0 / static_cast<double>(base_m.size())) * corner;
  return {middle.x, middle.y, std::get<double>(apex_m)};
}

} // namespace

Solid box(Vec3 size_m) {
  const auto [x, y, z] = size_m;
  if (!(x > 0 && y > 0 && z > 0)) throw Error("the box is flat", "its lengths should be above 0");
  return prism({{-x / 2, -y / 2}, {x / 2, -y / 2}, {x / 2, y / 2}, {-x / 2, y / 2}}, z);
}

Solid prism(std::vector<Vec2> base_m, double height_m) {
  if (!(height_m > 0)) throw Error("the prism is flat", "its height should be above 0");
  const std::vector<Vec2> base = checked_base(std::move(base_m));
  const auto n = static_cast<Index>(base.size());
  Polyhedron polyhedron;
  for (const double z : {0.0, height_m})
    for (const Vec2 corner : base) polyhedron.vertices_m.push_back({corner.x, corner.y, z});
  polyhedron.faces.push_back(bottom_face(n));
  std::vector<Index> top;
  for (Index i = 0; i < n; ++i) {
    const Index next = (i + 1) % n;
    polyhedron.faces.push_back({i, next, n + next, n + i});
    top.push_back(n + i);
  }
  polyhedron.faces.push_back(top);
  return build_solid(polyhedron);
}

Solid pyramid(std::vector<Vec2> base_m, const Apex& apex_m) {
  const std::vector<Vec2> base = checked_base(std::move(base_m));
  const Vec3 apex = apex_of(base, apex_m);
  if (!(apex.z > 0))
    throw Error("the pyramid's apex isn't above its base", "give it a height above 0");
  const auto n = static_cast<Index>(base.size());
  Polyhedron polyhedron;
  for (const Vec2 corner : base) polyhedron.vertices_m.push_back({corner.x, corner.y, 0});
  polyhedron.vertices_m.push_back(apex);
  polyhedron.faces.push_back(bottom_face(n));
  for (Index i = 0; i < n; ++i) polyhedron.faces.push_back({i, (i + 1) % n, n});
  return build_solid(polyhedron);
}

Solid tetrahedron(const std::array<Vec3, 4>& vertices_m) {
  Polyhedron polyhedron{{vertices_m.begin(), vertices_m.end()}, {}, {}};
  const auto& [a, b, c, d] = vertices_m;
  if (dot(cross(b - a, c - a), d - a) < 0)
    std::swap(polyhedron.vertices_m[2], polyhedron.vertices_m[3]);
  polyhedron.faces = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  return build_solid(polyhedron);
}

namespace {

constexpr double kMostFaces = 1e6;
constexpr double kSharpBend_deg = 20;

void check_turning(const Turning& turning) {
  if (turning.sides < 3 || turning.sides > 10'000)
    throw Error(fmt::format("there are {} sides to a turn", turning.sides), "give 3 to 10000");
  for (std::size_t i = 0; i < turning.profile_m.size(); ++i)
    if (!(turning.profile_m[i].x >= 0))
      throw Error(fmt::format("point {} of the profile is beyond the axis", i),
                  "a point is [r, z], r 0 or more");
}

void check_line(const std::vector<Vec2>& line_m, bool closed) {
  if (const std::string fault = fault_of_line(line_m, closed); !fault.empty())
    throw Error("the profile " + fault, "its pieces should meet at ends only");
}

void check_faces(double faces) {
  if (faces > kMostFaces)
    throw Error(fmt::format("it would have {:.0f} faces", faces), "give fewer than a million");
}

// A script's cosine of 90 degrees is on the axis.
void pull_to_axis(std::vector<Vec2>& profile_m) {
  double greatest = 0;
  for (const Vec2 p : profile_m) greatest = std::max(greatest, p.x);
  for (Vec2& p : profile_m)
    if (p.x <= 1e-12 * greatest) p.x = 0;
}

bool bends_sharply(Vec2 before, Vec2 at, Vec2 after) {
  return std::abs(atan2_angle(cross(at - before, after - at), dot(at - before, after - at))
                      .in_degrees()) > kSharpBend_deg;
}

// The profile's points, all at step j, as vertices; those on the axis are there once.
class Grid {
public:
  Grid(const std::vector<Vec2>& profile_m, Index steps) : steps_(steps) {
    for (const Vec2 p : profile_m) {
      first_.push_back(count_);
      on_axis_.push_back(p.x == 0);
      count_ += p.x == 0 ? 1 : steps;
    }
  }
  Index operator()(std::size_t point, Index step) const {
    return first_[point] + (on_axis_[point] ? 0 : step % steps_);
  }
  Index count() const { return count_; }
  bool on_axis(std::size_t point) const { return on_axis_[point]; }
  std::size_t points() const { return first_.size(); }

private:
  Index steps_, count_ = 0;
  std::vector<Index> first_;
  std::vector<bool> on_axis_;
};

Vec3 turned(Vec2 p, Angle by, double rise_m) {
  return {p.x * cos(by), p.x * sin(by), p.y + rise_m};
}

Angle step_angle(const Turning& turning, Index step) {
  return turning.start + Angle::degrees(360.0 * step / turning.sides);
}

// The faces that a piece of the profile leaves: quadrangles, triangles at the axis.
void add_piece(Polyhedron& body, const Grid& at, std::size_t p, std::size_t q, Index sides) {
  if (at.on_axis(p) && at.on_axis(q)) return;
  for (Index j = 0; j < sides; ++j) {
    std::vector<Index> face{at(p, j)};
    if (!at.on_axis(p)) face.push_back(at(p, j + 1));
    face.push_back(at(q, j + 1));
    if (!at.on_axis(q)) face.push_back(at(q, j));
    body.faces.push_back(face);
  }
}

void add_cap(Polyhedron& body, const Grid& at, std::size_t point, Index sides, bool upper) {
  if (at.on_axis(point)) return;
  std::vector<Index> face;
  for (Index j = 0; j < sides; ++j) face.push_back(at(point, upper ? j : sides - 1 - j));
  body.faces.push_back(face);
}

// Edges beside the pieces of a revolved profile, and rings where it is nearly straight.
void smooth_revolution(Polyhedron& body, const Grid& at, const Turning& turning, bool ring) {
  const std::vector<Vec2>& profile = turning.profile_m;
  const std::size_t n = profile.size();
  const auto sides = static_cast<Index>(turning.sides);
  for (Index j = 0; j < sides; ++j)
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t next = (i + 1) % n, before = (i + n - 1) % n;
      if (ring || i + 1 < n) body.smooth_edges.push_back({at(i, j), at(next, j)});
      const bool capped = !ring && (i == 0 || i + 1 == n);
      if (!capped && !at.on_axis(i) && !bends_sharply(profile[before], profile[i], profile[next]))
        body.smooth_edges.push_back({at(i, j), at(i, j + 1)});
    }
}

// The profile counterclockwise about what it encloses, r to the right and z up.
std::vector<Vec2> checked_profile(const Turning& turning, bool ring) {
  std::vector<Vec2> profile = turning.profile_m;
  pull_to_axis(profile);
  if (ring) profile.pop_back();
  std::vector<Vec2> line = profile;
  if (!ring && line.back().x > 0) line.push_back({0, line.back().y});
  if (!ring && line.front().x > 0) line.insert(line.begin(), {0, line.front().y});
  const double area = signed_area(line);
  double around = 0;
  for (std::size_t i = 1; i < line.size(); ++i) around += length(line[i] - line[i - 1]);
  if (!(std::abs(area) > 1e-12 * around * around))
    throw Error("the profile encloses nothing", "let it go about a part of the plane (r, z)");
  check_line(profile, ring);
  if (!ring && !fault_of_line(line, false).empty())
    throw Error("the profile crosses or touches a cap",
                "its ends off the axis are joined to the axis on the level");
  if (area < 0) std::reverse(profile.begin(), profile.end());
  return profile;
}

} // namespace

Solid revolution(const Turning& turning) {
  check_turning(turning);
  const std::vector<Vec2>& given = turning.profile_m;
  const bool ring = given.size() > 3 && given.front() == given.back();
  if (given.size() < 2)
    throw Error("the profile is no line", "give two points or more, [r, z] each");
  check_faces(static_cast<double>(given.size()) * turning.sides);
  Turning checked = turning;
  checked.profile_m = checked_profile(turning, ring);
  const std::vector<Vec2>& profile = checked.profile_m;
  const auto sides = static_cast<Index>(turning.sides);
  const Grid at(profile, sides);
  Polyhedron body;
  for (std::size_t i = 0; i < profile.size(); ++i)
    for (Index j = 0; j < (at.on_axis(i) ? 1 : sides); ++j)
      body.vertices_m.push_back(turned(profile[i], step_angle(turning, j), 0));
  if (!ring) add_cap(body, at, 0, sides, false);
  for (std::size_t i = 0; i + (ring ? 0 : 1) < profile.size(); ++i)
    add_piece(body, at, i, (i + 1) % profile.size(), sides);
  if (!ring) add_cap(body, at, profile.size() - 1, sides, true);
  if (turning.smooth) smooth_revolution(body, at, checked, ring);
  return build_solid(body);
}

namespace {

std::vector<Vec2> checked_section(const Turning& turning) {
  std::vector<Vec2> section = turning.profile_m;
  if (section.size() > 3 && section.front() == section.back()) section.pop_back();
  if (section.size() < 3)
    throw Error("the profile is no polygon", "give three points or more, [r, z] each");
  for (std::size_t i = 0; i < section.size(); ++i)
    if (!(section[i].x > 0))
      throw Error(fmt::format("point {} of the profile is on the axis", i),
                  "keep the profile of a rotation off it, r above 0");
  check_line(section, true);
  if (signed_area(section) < 0) std::reverse(section.begin(), section.end());
  return section;
}

Index checked_steps(const Turning& turning, const Rise& rise) {
  const double steps = turning.sides * rise.turns, whole = std::round(steps);
  if (!(whole >= 1 && std::abs(steps - whole) <= 1e-6))
    throw Error(
        fmt::format("{:.6g} turns of {} sides are {:.6g} steps", rise.turns, turning.sides, steps),
        "give a whole number of steps, 1 or more");
  if (rise.per_turn_m == 0 && rise.turns > 1 - 1e-9)
    throw Error("a whole turn without a rise closes on itself",
                "shape = \"revolution\" makes a ring of a closed profile");
  check_faces(2 * whole * static_cast<double>(turning.profile_m.size()));
  return static_cast<Index>(whole);
}

} // namespace

Solid rotation_body(const Turning& turning, const Rise& rise) {
  check_turning(turning);
  const std::vector<Vec2> section = checked_section(turning);
  const Index steps = checked_steps(turning, rise), n = static_cast<Index>(section.size());
  Polyhedron body;
  for (Index j = 0; j <= steps; ++j)
    for (const Vec2 p : section)
      body.vertices_m.push_back(
          turned(p, step_angle(turning, j), rise.per_turn_m * j / turning.sides));
  std::vector<Index> first, last;
  for (Index i = 0; i < n; ++i) {
    first.push_back(i);
    last.push_back(steps * n + n - 1 - i);
  }
  body.faces.push_back(first);
  for (Index j = 0; j < steps; ++j)
    for (Index i = 0; i < n; ++i) {
      const Index next = (i + 1) % n, p = j * n + i, q = j * n + next;
      body.faces.push_back({p, p + n, q + n});
      body.faces.push_back({p, q + n, q});
      body.smooth_edges.push_back({p, q + n});
      if (!turning.smooth) continue;
      if (j > 0) body.smooth_edges.push_back({p, q});
      if (!bends_sharply(section[(i + n - 1) % n], section[i], section[next]))
        body.smooth_edges.push_back({p, p + n});
    }
  body.faces.push_back(last);
  return build_solid(body);
}

} // namespace orograph
