// SPDX-License-Identifier: GPL-3.0-or-later
// All of the plane that rests on CGAL: it keeps a triangulation and which edges each line has come
// to; where lines cross and what is rounding is decided here.
#include "dem/triangulate/plane_triangulation.hpp"

#include "dem/tin.hpp"
#include "dem/triangulate/orientation.hpp"
#include "dem/triangulate/place_order.hpp"
#include "geometry/error.hpp"
#include "geometry/on_all_cores.hpp"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Constrained_triangulation_plus_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <utility>

namespace orograph {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
// A vertex gets its number after CGAL has made it.
constexpr std::uint32_t kUnnumbered = 0xffffffff;
struct Number {
  std::uint32_t value = kUnnumbered;
};
struct FaceNotes {
  std::uint32_t number = 0; ///< in the mesh written last
  std::uint64_t search = 0; ///< the last one that came here
};
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<Number, Kernel>;
using FaceBase = CGAL::Constrained_triangulation_face_base_2<
    Kernel, CGAL::Triangulation_face_base_with_info_2<FaceNotes, Kernel>>;
using Structure = CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>;
using Delaunay =
    CGAL::Constrained_Delaunay_triangulation_2<Kernel, Structure, CGAL::Exact_predicates_tag>;
using WithLines = CGAL::Constrained_triangulation_plus_2<Delaunay>;
using Point = Kernel::Point_2;

// How deep the split of one line may call for another's, because rounding moved it across a third:
// to split as it should be, and at all.
constexpr int kManyNested = 20, kMostNested = 1000;
// How often one line may be split at vertices that are there, beside each of them once.
constexpr std::size_t kMostInVain = 1'000'000;

Point point_at(Vec2 place) {
  return {place.x, place.y};
}

Vec2 place_of(const Point& p) {
  return {p.x(), p.y()};
}

std::array<std::uint32_t, 3> numbers_of(WithLines::Face_handle f) {
  return {f->vertex(0)->info().value, f->vertex(1)->info().value, f->vertex(2)->info().value};
}

std::vector<std::uint32_t> numbers_on(const WithLines& plane, WithLines::Constraint_id line) {
  std::vector<std::uint32_t> numbers;
  for (const auto v : plane.vertices_in_constraint(line)) numbers.push_back(v->info().value);
  return numbers;
}

bool nearer(const Point& to, const Point& a, const Point& b) {
  return CGAL::compare_distance(to, a, b) == CGAL::SMALLER;
}

// Four units in the last place of the greatest coordinate: what lines between these are worth.
double rounding(std::initializer_list<const Point*> ends) {
  double greatest = 0;
  for (const Point* p : ends) greatest = std::max({greatest, std::abs(p->x()), std::abs(p->y())});
  return 0x1p-50 * greatest;
}

// Whether the line from a to b passes through a vertex between them but for rounding. Without that,
// lines that all cross at one place would make a cluster of vertices there, and lines that nearly
// coincide would push each other about for ever. Between them is what is nearer to each than the
// other is, so that a line never turns back.
bool passes(const Point& a, const Point& b, const Point& vertex, double rounding_m) {
  const Vec2 along{b.x() - a.x(), b.y() - a.y()}, to{vertex.x() - a.x(), vertex.y() - a.y()};
  return std::abs(cross(along, to)) <= rounding_m * length(along) && nearer(a, vertex, b) &&
         nearer(b, vertex, a);
}

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

// Where the lines through a and b and through c and d cross. REQUIRES that they aren't parallel.
Vec2 crossing(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
  const ExactVec u = difference(b, a), v = difference(d, c);
  const Exact share = area(difference(c, a), v) / area(u, v);
  return {CGAL::to_double(Exact(Exact(a.x) + share * u.x)),
          CGAL::to_double(Exact(Exact(a.y) + share * u.y))};
}

// p as a share of the way from a to b. REQUIRES a and b different, p on the line through them.
double share_along(Vec2 a, Vec2 b, Vec2 p) {
  const ExactVec u = difference(b, a), v = difference(p, a);
  return u.x != 0 ? CGAL::to_double(Exact(v.x / u.x)) : CGAL::to_double(Exact(v.y / u.y));
}

// Shares s with p = a + s[0] (b - a) + s[1] (c - a). REQUIRES that a, b, c aren't on one line.
std::array<double, 2> shares_in(Vec2 a, Vec2 b, Vec2 c, Vec2 p) {
  const ExactVec u = difference(b, a), v = difference(c, a), w = difference(p, a);
  return {CGAL::to_double(Exact(area(w, v) / area(u, v))),
          CGAL::to_double(Exact(area(u, w) / area(u, v)))};
}

} // namespace

struct PlaneTriangulation::Inside : WithLines {
  std::vector<Vec2> places;
  std::vector<Vertex_handle> vertices;
  std::vector<Constraint_id> lines;
  Vertex_handle near; ///< the last one that was asked for: the next is near
  std::uint64_t searches = 0;
  int nested = 0;                 ///< splits that called for the one at hand
  std::size_t splits_in_vain = 0; ///< of the line at hand

  std::uint32_t number(Vertex_handle v) {
    if (v->info().value == kUnnumbered) {
      v->info().value = static_cast<std::uint32_t>(vertices.size());
      vertices.push_back(v);
      places.push_back(place_of(v->point()));
    }
    return v->info().value;
  }

  // Called where a -> b, about to be put in, crosses the constrained edge of f opposite to its
  // vertex i; gives the vertex that both are to pass through. The base class's own version reckons
  // the place in double precision and loses a split where it falls on a third line.
  Vertex_handle intersect(Face_handle f, int i, Vertex_handle a, Vertex_handle b) override {
    const Vertex_handle c = f->vertex(cw(i)), d = f->vertex(ccw(i));
    const Point &pa = a->point(), &pb = b->point(), &pc = c->point(), &pd = d->point();
    const double slack = rounding({&pa, &pb, &pc, &pd});
    const bool at_c = passes(pa, pb, pc, slack), at_d = passes(pa, pb, pd, slack);
    if (at_c || at_d) return in_vain(at_c && !(at_d && nearer(pa, pd, pc)) ? c : d);

    const Point p =
        passes(pc, pd, pa, slack) ? pa
        : passes(pc, pd, pb, slack)
            ? pb
            : point_at(crossing(place_of(pa), place_of(pb), place_of(pc), place_of(pd)));
    // A place outside of the two triangles at the edge puts others on the wrong side, which splits
    // them in turn. That ends soon, and where it doesn't an end of the edge stands in.
    if (p == pc || p == pd || (nested > kManyNested && !within(f, i, p)))
      return in_vain(nearer(p, pc, pd) ? c : d);
    if (++nested > kMostNested) give_up();
    remove_constrained_edge(f, i);
    const Vertex_handle v = insert(p, f);
    if (v->info().value != kUnnumbered) in_vain(v);
    number(v);
    hierarchy.split_constraint(c, d, v);
    insert_subconstraint(c, v);
    insert_subconstraint(v, d);
    --nested;
    return v;
  }

  // A line from each to the next. REQUIRES two or more.
  Constraint_id line_through(const std::vector<std::uint32_t>& numbers) {
    Constraint_id line;
    for (std::size_t k = 1; k < numbers.size(); ++k) {
      const Vertex_handle from = vertices[numbers[k - 1]], to = vertices[numbers[k]];
      if (k == 1)
        line = hierarchy.insert_constraint(from, to);
      else
        hierarchy.append_constraint(line, from, to);
      insert_subconstraint(from, to);
    }
    return line;
  }

  // A split at a vertex that is there already; too many of them for one line go round in circles.
  Vertex_handle in_vain(Vertex_handle v) {
    if (++splits_in_vain > kMostInVain + vertices.size()) give_up();
    return v;
  }

  [[noreturn]] static void give_up() {
    throw Error("lines cross too close to each other for double precision",
                "leave out lines that nearly repeat others");
  }

  // Whether p is in one of the two triangles at the edge of f opposite to its vertex i.
  bool within(Face_handle f, int i, const Point& p) const {
    const auto in = [&](Face_handle g, int j) {
      const Point &apex = g->vertex(j)->point(), &right = g->vertex(ccw(j))->point(),
                  &left = g->vertex(cw(j))->point();
      return orientation(apex, right, p) != CGAL::RIGHT_TURN &&
             orientation(left, apex, p) != CGAL::RIGHT_TURN &&
             orientation(right, left, p) != CGAL::RIGHT_TURN;
    };
    return in(f, i) || in(f->neighbor(i), mirror_index(f, i));
  }

  // Exact: two convex sets are apart where a line along an edge of either parts them.
  bool meets(Face_handle f, const Point& from, const Point& to) const {
    int left = 0, right = 0;
    for (int i = 0; i < 3; ++i) {
      const Point &begin = f->vertex(i)->point(), &end = f->vertex(ccw(i))->point();
      if (orientation(begin, end, from) == CGAL::RIGHT_TURN &&
          orientation(begin, end, to) == CGAL::RIGHT_TURN)
        return false;
      const CGAL::Orientation side = orientation(from, to, begin);
      left += side == CGAL::LEFT_TURN;
      right += side == CGAL::RIGHT_TURN;
    }
    return left < 3 && right < 3;
  }

  // The finite one of a face and the one beyond its hull edge.
  Face_handle finite(Face_handle f) const {
    return is_infinite(f) ? f->neighbor(f->index(infinite_vertex())) : f;
  }
};

PlaneTriangulation::PlaneTriangulation(std::span<const Vec2> places)
    : inside_(std::make_unique<Inside>()) {
  inside_->places.assign(places.begin(), places.end());
  inside_->vertices.resize(places.size());
  const std::vector<std::uint32_t> order = insertion_order(places);
  WithLines::Face_handle near;
  for (const std::uint32_t k : order) {
    throw_if_stopped(inside_->number_of_vertices());
    inside_->near = inside_->insert(point_at(places[k]), near);
    inside_->near->info().value = k;
    inside_->vertices[k] = inside_->near;
    near = inside_->near->face();
  }
}

PlaneTriangulation::~PlaneTriangulation() = default;

bool PlaneTriangulation::has_area() const {
  return inside_->dimension() == 2;
}

const std::vector<Vec2>& PlaneTriangulation::places() const {
  return inside_->places;
}

std::uint32_t PlaneTriangulation::insert(Vec2 place) {
  inside_->near = inside_->insert(point_at(place), inside_->near->face());
  return inside_->number(inside_->near);
}

std::uint32_t PlaneTriangulation::add_line(std::uint32_t from, std::uint32_t to) {
  throw_if_stopped();
  inside_->splits_in_vain = 0;
  inside_->near = inside_->vertices[from];
  inside_->lines.push_back(inside_->line_through(vertices_along(from, to)));
  return static_cast<std::uint32_t>(inside_->lines.size() - 1);
}

// From one to the other through what the line between them passes, before any crossing bends it.
std::vector<std::uint32_t> PlaneTriangulation::vertices_along(std::uint32_t from,
                                                              std::uint32_t to) const {
  const Vec2 begin = places()[from], along = places()[to] - begin;
  const Point a = point_at(begin), b = point_at(places()[to]);
  const double slack = rounding({&a, &b});
  std::vector<std::pair<double, std::uint32_t>> passed;
  for (const auto& triangle : triangles_along(begin, places()[to]))
    for (const std::uint32_t v : triangle)
      if (passes(a, b, point_at(places()[v]), slack))
        passed.emplace_back(dot(places()[v] - begin, along), v);
  std::sort(passed.begin(), passed.end());
  passed.erase(std::unique(passed.begin(), passed.end()), passed.end());
  std::vector<std::uint32_t> through{from};
  for (const auto& [distance, v] : passed) through.push_back(v);
  through.push_back(to);
  return through;
}

std::vector<std::uint32_t> PlaneTriangulation::line(std::uint32_t number) const {
  return numbers_on(*inside_, inside_->lines[number]);
}

std::vector<Share> PlaneTriangulation::around(Vec2 place) const {
  WithLines::Locate_type type{};
  int i = 0;
  const Point p = point_at(place);
  const auto f = inside_->locate(p, type, i, inside_->near->face());
  const auto at = [&](int k) { return place_of(f->vertex(k)->point()); };
  const auto number = [&](int k) { return f->vertex(k)->info().value; };
  switch (type) {
  case WithLines::VERTEX:
    return {{number(i), 1}};
  case WithLines::EDGE: {
    const int a = WithLines::ccw(i), b = WithLines::cw(i);
    const double share = share_along(at(a), at(b), place);
    return {{number(a), 1 - share}, {number(b), share}};
  }
  case WithLines::FACE: {
    const auto [b, c] = shares_in(at(0), at(1), at(2), place);
    return {{number(0), 1 - b - c}, {number(1), b}, {number(2), c}};
  }
  default:
    return {};
  }
}

std::vector<std::array<std::uint32_t, 3>> PlaneTriangulation::triangles_along(Vec2 from,
                                                                              Vec2 to) const {
  const Point begin = point_at(from), end = point_at(to);
  std::vector<std::array<std::uint32_t, 3>> found;
  // Those that a segment within the hull meets hang together.
  std::vector<WithLines::Face_handle> open{
      inside_->finite(inside_->locate(begin, inside_->near->face()))};
  inside_->near = open.front()->vertex(0);
  const std::uint64_t search = ++inside_->searches;
  open.front()->info().search = search;
  while (!open.empty()) {
    const auto f = open.back();
    open.pop_back();
    if (!inside_->meets(f, begin, end)) continue;
    found.push_back(numbers_of(f));
    for (int i = 0; i < 3; ++i) {
      const auto next = f->neighbor(i);
      if (inside_->is_infinite(next) || next->info().search == search) continue;
      next->info().search = search;
      open.push_back(next);
    }
  }
  return found;
}

std::vector<std::array<std::uint32_t, 2>> PlaneTriangulation::hull_edges() const {
  std::vector<std::array<std::uint32_t, 2>> edges;
  auto f = inside_->incident_faces(inside_->infinite_vertex());
  const auto first = f;
  do {
    const int i = f->index(inside_->infinite_vertex());
    edges.push_back(
        {f->vertex(WithLines::ccw(i))->info().value, f->vertex(WithLines::cw(i))->info().value});
  } while (++f != first);
  return edges;
}

PlaneMesh PlaneTriangulation::mesh() const {
  PlaneMesh mesh;
  mesh.triangles.reserve(inside_->number_of_faces());
  mesh.neighbours.reserve(inside_->number_of_faces());
  for (const auto f : inside_->finite_face_handles()) {
    throw_if_stopped(mesh.triangles.size());
    f->info().number = static_cast<std::uint32_t>(mesh.triangles.size());
    mesh.triangles.push_back(numbers_of(f));
  }
  for (const auto f : inside_->finite_face_handles()) {
    throw_if_stopped(mesh.neighbours.size());
    auto& across = mesh.neighbours.emplace_back();
    for (int i = 0; i < 3; ++i)
      across[i] =
          inside_->is_infinite(f->neighbor(i)) ? kNoTriangle : f->neighbor(i)->info().number;
  }
  return mesh;
}

// `intersect` is CGAL's own here: CGAL 5.5's way with crossings of inexact coordinates goes round
// in circles where lines are nearly parallel, so there mustn't be any.
TriangulatedLines triangulate_lines(std::span<const Vec2> points, std::span<const Edge> lines) {
  WithLines plane;
  std::vector<WithLines::Vertex_handle> vertices;
  WithLines::Face_handle near;
  for (const Vec2 p : points) {
    vertices.push_back(plane.insert(point_at(p), near));
    vertices.back()->info().value = static_cast<std::uint32_t>(vertices.size() - 1);
    near = vertices.back()->face();
  }
  std::vector<WithLines::Constraint_id> ids;
  for (const auto& [from, to] : lines)
    ids.push_back(plane.insert_constraint(vertices[from], vertices[to]));
  TriangulatedLines result;
  for (const auto face : plane.finite_face_handles()) result.faces.push_back(numbers_of(face));
  for (const auto& id : ids) result.through.push_back(numbers_on(plane, id));
  return result;
}

int exact_orientation(Vec2 a, Vec2 b, Vec2 c) {
  return static_cast<int>(CGAL::orientation(point_at(a), point_at(b), point_at(c)));
}

} // namespace orograph
