// SPDX-License-Identifier: GPL-3.0-or-later
#include "hidden_lines/sheet_strip.hpp"

#include "geometry/large_pages.hpp"
#include "geometry/on_all_cores.hpp"
#include "geometry/sort_by_number.hpp"

#include <algorithm>
#include <cmath>

namespace orograph {
namespace {

// No line's source has it, nor a profile's, and the near cut's have it.
constexpr std::uint64_t kFootBit = std::uint64_t{1} << 62U;

} // namespace

SheetInWork::SheetInWork(const SectorInWork& of)
    : work(of), sheet(*of.sheet), all(sheet.triangles), part(of.sheet_part ? *of.sheet_part : all),
      vertices(of.terrain.surface, of.sector.view),
      order(of.terrain.surface, sheet.triangles, part, of.placed.border, of.sector.view,
            of.from_m) {
  if (of.placed.block_base_m) feet.emplace(of.terrain, of.placed, of.sector.view);
}

bool SheetInWork::has_place(std::uint32_t triangle) const {
  if (triangle == kNoTriangle) return false;
  if (sheet.walls.empty() || !sheet.walls.has(triangle)) return true;
  const View& view = work.sector.view;
  const double rounding_m = 2 * position_rounding_m(work.placed.reach_m, view);
  const auto corners = sheet.triangles.corners(triangle);
  for (std::size_t k = 0; k < 3; ++k) {
    const ProfilePoint &a = vertices[corners[k]], &b = vertices[corners[(k + 1) % 3]];
    const double times = view.is_perspective()
                             ? std::abs(a.u) + std::abs(a.v) + std::abs(b.u) + std::abs(b.v)
                             : 1 + std::abs(view.x_per_v);
    if (std::abs(way_to_left(view, a, b)) > rounding_m * times) return true;
  }
  return false;
}

SheetStrip::SheetStrip(const SheetInWork& sheet, std::size_t number, const Strip& strip)
    : sheet_(sheet), number_(number), range_(strip.range),
      pictures_(sheet.work.terrain.surface, sheet.work.placed.reach_m, sheet.work.on_ground.points,
                sheet.work.sector, sheet.work.lines, strip.range, sheet.work.from_m),
      covered_(strip.core, pictures_.looked_at(), 2 * strip.blocks) {}

// Of edges as `pictures_` has it: from vertices that are known.
ProfileLine SheetStrip::whole(std::uint32_t number) const {
  if (!pictures_.is_edge(number) || pictures_.sector().keeps_strip) return pictures_.whole(number);
  const SurfaceEdge edge = pictures_.line(number).edge;
  return {sheet_.vertices[edge.from], sheet_.vertices[edge.to]};
}

void SheetStrip::add_line(std::uint32_t number) {
  const EdgeLine& line = pictures_.line(number);
  if (!line.drawn && !line.hides) return;
  if (pictures_.is_edge(number))
    add_edge(number, line.edge);
  else if (is_on_wall(line.kind))
    add_wall_line(number);
  else
    add_ground_line(number);
}

// Which lie on the upper side. A contour on level ground's rim has the triangle below it, but lies
// on the one above as well.
void SheetStrip::add_ground_line(std::uint32_t number) {
  const std::uint32_t triangle = sheet_.work.triangle_of(number);
  if (sheet_.part.place_of(triangle) == kNoTriangle) return;
  if (sheet_.sheet.is_up[triangle] == 0) {
    if (const auto edge = edge_under(pictures_.whole(number), triangle)) add_edge(number, *edge);
    return;
  }
  events_->emplace_back(turn_of(sheet_.order.place(triangle), SheetStep::inside), SheetEnd::turns,
                        true, true, number, kLine);
}

// Below an edge of the border: of a wall that is turned to the eye before that edge and its foot
// hide anything; of one that is turned away, whose foot may be seen from below, between the two. A
// void's rim is that edge itself.
void SheetStrip::add_wall_line(std::uint32_t number) {
  const auto& [edge, is_left] = sheet_.work.placed.border[sheet_.work.triangle_of(number)];
  const auto [left, right] = sheet_.sheet.triangles.sides_of(edge);
  const std::uint32_t triangle = is_left ? left : right;
  if (sheet_.part.place_of(triangle) == kNoTriangle) return;
  const ProfileLine ends{sheet_.vertices[edge.from], sheet_.vertices[edge.to]};
  int side = eye_side(sheet_.work.sector.view, ends.from, ends.to);
  if (may_be_upright(ends) && pictures_.picture(ends).is_upright()) side = 0;
  SheetStep step = SheetStep::on_rim;
  if (side == 0 || (side > 0) == is_left) {
    const View& view = sheet_.work.sector.view;
    const double from_z = pictures_.whole(number).from.z;
    const bool is_rim = from_z >= (is_left ? ends.from : ends.to).z;
    const bool is_below = view.is_perspective() ? view.eye_z_m < from_z : view.y_per_v < 0;
    if (is_rim ? sheet_.sheet.is_up[triangle] == 0 : side == 0 && !is_below) return;
    step = side == 0 ? SheetStep::inside : is_rim ? SheetStep::behind : SheetStep::foot;
  }
  // Straight away from the eye it is beside its own triangle that it is seen.
  const bool takes_left = side != 0 || is_left == (ends.from.v < ends.to.v);
  events_->emplace_back(turn_of(sheet_.order.place(triangle), step), SheetEnd::turns, true,
                        takes_left, number, kLine);
}

// The side of a triangle that a line runs along from vertex to vertex.
std::optional<SurfaceEdge> SheetStrip::edge_under(const ProfileLine& line,
                                                  std::uint32_t triangle) const {
  const double rounding_m = 4 * pictures_.rounding_m();
  const bool is_wall = !sheet_.sheet.walls.empty() && sheet_.sheet.walls.has(triangle);
  const auto corner_at = [&](ProfilePoint p) -> std::optional<std::uint32_t> {
    for (const std::uint32_t corner : sheet_.sheet.triangles.corners(triangle))
      if (const ProfilePoint& at = sheet_.vertices[corner];
          std::abs(p.u - at.u) <= rounding_m && std::abs(p.v - at.v) <= rounding_m &&
          (!is_wall || std::abs(p.z - at.z) <= rounding_m))
        return corner;
    return std::nullopt;
  };
  const auto from = corner_at(line.from), to = corner_at(line.to);
  if (!from || !to || *from == *to) return std::nullopt;
  return SurfaceEdge{std::min(*from, *to), std::max(*from, *to)};
}

// Most lines are far from it, which is told without dividing: by as many times the rounding of X as
// its bound, as `LinePictures::picture` has it, may be too small.
bool SheetStrip::may_be_upright(const ProfileLine& line) const {
  const auto& [a, b] = line;
  const View& view = sheet_.work.sector.view;
  constexpr double kTimes = 2;
  if (!view.is_perspective())
    return std::abs(a.u - b.u + view.x_per_v * (a.v - b.v)) <=
           kTimes * pictures_.rounding_m() * (1 + std::abs(view.x_per_v));
  const double nearest = std::min(a.v, b.v), farthest = std::max(a.v, b.v),
               aside = std::max(std::abs(a.u), std::abs(b.u));
  return nearest <= pictures_.from_m() ||
         std::abs(a.u * b.v - b.u * a.v) * nearest <=
             kTimes * pictures_.rounding_m() * farthest * (nearest + aside);
}

// Of a wall at an upright edge of it, whether it is on the left of that.
bool SheetStrip::reaches_left(std::uint32_t triangle, SurfaceEdge edge) const {
  const auto corners = sheet_.sheet.triangles.corners(triangle);
  const std::uint32_t apex = *std::ranges::find_if(
      corners, [&](std::uint32_t corner) { return corner != edge.from && corner != edge.to; });
  return eye_side(sheet_.work.sector.view, sheet_.vertices[edge.from], sheet_.vertices[apex]) > 0;
}

// Up a step of a closed block's border, whose wall in the ground isn't seen: it bounds the block's
// own wall below the edge of the border that goes on from its upper end.
void SheetStrip::add_upright_of_border(std::uint32_t number, SurfaceEdge edge, std::uint32_t wall) {
  const bool rises = sheet_.vertices[edge.from].z < sheet_.vertices[edge.to].z;
  std::uint32_t upper = rises ? edge.to : edge.from, before = rises ? edge.from : edge.to,
                triangle = wall;
  for (;;) { // around the upper end, from the wall to the border
    const auto corners = sheet_.sheet.triangles.corners(triangle);
    std::size_t beside = 0;
    while (corners[beside] != before) ++beside;
    std::size_t next = 0;
    while (corners[next] == before || corners[next] == upper) ++next;
    const std::uint32_t vertex = corners[next],
                        other = sheet_.sheet.triangles.across(triangle, beside);
    if (other != kNoTriangle) {
      before = vertex;
      triangle = other;
      continue;
    }
    const ProfilePoint &from = sheet_.vertices[upper], &to = sheet_.vertices[vertex];
    if (from.u == to.u && from.v == to.v) {
      if (to.z < from.z) return;
      before = upper; // up the next step
      upper = vertex;
      continue;
    }
    if (sheet_.part.place_of(triangle) == kNoTriangle) return;
    const int side = eye_side(sheet_.work.sector.view, from, to);
    const auto [left, right] =
        sheet_.sheet.triangles.sides_of({std::min(upper, vertex), std::max(upper, vertex)});
    const bool is_left = (upper < vertex ? left : right) == triangle;
    if (side == 0 || (side > 0) == is_left) return; // turned away
    events_->emplace_back(turn_of(sheet_.order.place(triangle), SheetStep::on_rim), SheetEnd::turns,
                          true, side > 0, number, kLine);
    return;
  }
}

void SheetStrip::add_edge(std::uint32_t number, SurfaceEdge edge) {
  const EdgeLine& line = pictures_.line(number);
  const auto [left, right] = sheet_.sheet.triangles.sides_of(edge);
  const auto is_looked_at = [&](std::uint32_t t) {
    return t != kNoTriangle && sheet_.part.place_of(t) != kNoTriangle;
  };
  if (!is_looked_at(left) && !is_looked_at(right)) return;
  const bool of_upper_side =
      line.kind == LineKind::shore || is_on_ground(line.kind) || sheet_.feet.has_value();
  const auto is_up = [&](std::uint32_t t) {
    return t != kNoTriangle && sheet_.sheet.is_up[t] != 0;
  };
  const ProfileLine ends{sheet_.vertices[edge.from], sheet_.vertices[edge.to]};
  const int side = eye_side(sheet_.work.sector.view, ends.from, ends.to);
  const auto place = [&](std::uint32_t t) { return sheet_.order.place(t); };
  std::optional<LinePicture> picture; // where the line may be straight away from the eye
  if (side == 0 || pictures_.sector().keeps_strip || may_be_upright(ends))
    picture = pictures_.picture(number, pictures_.is_edge(number) && !pictures_.sector().keeps_strip
                                            ? ends
                                            : whole(number));
  if (picture && (picture->is_upright() || side == 0)) {
    if (!line.drawn) return;
    // It is asked before either of its triangles covers anything, beside the first of them.
    const bool has_left = sheet_.has_place(left), has_right = sheet_.has_place(right);
    const bool is_up_a_wall = ends.from.u == ends.to.u && ends.from.v == ends.to.v;
    const bool is_seen = (is_up(left) && has_left) || (is_up(right) && has_right);
    if (is_up_a_wall && sheet_.feet && !is_seen && (left == kNoTriangle || right == kNoTriangle)) {
      add_upright_of_border(number, edge, left == kNoTriangle ? right : left);
      return;
    }
    // Of the two that of which the upper side is seen, where it lies on that alone.
    const bool left_is_asked = has_left && (!of_upper_side || is_up(left)),
               right_is_asked = has_right && (!of_upper_side || is_up(right));
    if (!left_is_asked && !right_is_asked) return;
    const bool takes_left = !right_is_asked || (left_is_asked && place(left) < place(right));
    const std::uint32_t taken = takes_left ? left : right;
    const bool is_on_left = is_up_a_wall ? reaches_left(taken, edge)
                                         : takes_left == (picture->t_left < picture->t_right);
    events_->emplace_back(turn_of(place(taken), SheetStep::inside), SheetEnd::turns, true,
                          is_on_left, number, kLine);
    return;
  }
  const std::uint32_t front = side > 0 ? left : right, behind = side > 0 ? right : left;
  // The side that one sees of an edge is that of the triangle in front of it.
  const bool is_rim = front == kNoTriangle;
  const bool is_asked =
      line.drawn && (!of_upper_side || (is_rim && sheet_.feet) || is_up(is_rim ? behind : front));
  const SheetEnd end = is_rim                  ? SheetEnd::opens
                       : behind == kNoTriangle ? SheetEnd::closes
                                               : SheetEnd::turns;
  const SheetTurn turn = is_rim ? turn_of(place(behind), SheetStep::rim, line.hides)
                                : turn_of(place(front), SheetStep::behind, line.hides);
  // A block begins with its foot and the wall above it, and where it ends it goes down to its foot
  // again. Between, its base is never seen beyond both.
  const bool has_foot = line.hides && sheet_.feet && end != SheetEnd::turns;
  if (has_foot)
    events_->emplace_back(is_rim ? turn : turn_of(place(front), SheetStep::foot, true),
                          is_rim ? SheetEnd::opens : SheetEnd::closes, false, true, number, kFoot);
  events_->emplace_back(turn, has_foot ? SheetEnd::turns : end, is_asked, true, number, kLine);
}

void SheetStrip::add_spans(std::uint32_t number, const SheetProfile& profile) {
  const ProjectedProfile& projected = profile.profile->projected;
  const std::vector<double>& x = projected.x;
  for (const VertexRun& run : projected.runs) {
    const auto first = x.begin() + run.first, last = x.begin() + run.last;
    for (auto left = first; left != last; ++left) {
      if (!(left[0] < left[1]) || left[1] <= range_.begin) continue;
      if (left[0] >= range_.end) break;
      const auto span = static_cast<std::uint32_t>(left - x.begin());
      const SheetSpan& of = profile.spans[span];
      if (of.is_there && (of.is_up || !sheet_.feet)) // a block's underside is within it
        events_->emplace_back(of.turn, SheetEnd::turns, true, true, number, span);
    }
  }
  for (const Segment& upright : profile.profile->uprights) {
    const std::uint32_t span = left_vertex(upright);
    const SheetSpan& of = profile.spans[span];
    if (upright.x0 >= range_.begin && upright.x0 < range_.end && of.is_there &&
        (of.is_up || !sheet_.feet))
      events_->emplace_back(of.turn, SheetEnd::turns, true, true, number, span);
  }
}

void SheetStrip::run(std::span<const LineAtDepth> which, std::span<const Segment> near_cut,
                     std::span<const SheetProfile> profiles) {
  covered_.expect(which.size());
  const XRange looked_at = pictures_.looked_at();
  for (const Segment& s : near_cut) {
    const double begin = std::max(s.x0, looked_at.begin), end = std::min(s.x1, looked_at.end);
    if (!(begin < end)) continue;
    if (sheet_.feet) { // the near plane cuts the block from its base up
      const double y = sheet_.feet->y_at_near_plane();
      covered_.take({s.x0, y, s.x1, y, s.id ^ kFootBit}, begin, end, SheetEnd::opens, false);
    }
    covered_.take(s, begin, end, sheet_.feet ? SheetEnd::turns : SheetEnd::opens, false);
  }
  // The system takes longer to hand out memory than events to be written there.
  thread_local std::vector<Event> events, sorted;
  events.clear();
  events_ = &events;
  std::size_t most = which.size();
  for (const SheetProfile& of : profiles) most += of.spans.size();
  for (std::vector<Event>* of : {&events, &sorted})
    if (of->capacity() < most) {
      of->reserve(most);
      use_large_pages(of->data(), most * sizeof(Event));
    }
  for (const LineAtDepth& line : which) add_line(line.line);
  for (std::uint32_t i = 0; i < profiles.size(); ++i) add_spans(i, profiles[i]);
  throw_if_stopped();
  sort_by_number(
      events, [](const Event& event) { return event.turn; }, sorted);
  std::size_t step = 0;
  for (const Event& event : events) {
    throw_if_stopped(step++);
    if (event.span == kLine)
      take_line(event);
    else if (event.span == kFoot)
      take_foot(event);
    else
      take_span(event, profiles[event.number]);
  }
  events_ = nullptr;
}

void SheetStrip::take_line(const Event& event) {
  const LinePicture picture = pictures_.picture(event.number, whole(event.number));
  SurfaceLine line = pictures_.surface_line(event.number, picture);
  if (!pictures_.cut_to_range(line)) return;
  if (event.is_asked) {
    seen_.clear();
    bool changes_nothing = true;
    if (line.upright())
      covered_.add_upright_seen(
          line.source, line.source.x0 + (event.takes_left ? -line.beside : line.beside), seen_);
    else
      changes_nothing =
          covered_.add_seen(line.source, line.begin, line.end, sheet_.work.tolerance, seen_);
    for (const Shares& part : seen_)
      pictures_.add_part(event.number, picture, part.begin, part.end, parts_);
    if (changes_nothing) return;
  }
  // Nothing is seen at a block's underside.
  const bool is_inked =
      line.drawn || (sheet_.feet && pictures_.line(event.number).kind == LineKind::underside);
  if (raises(line) && !pictures_.is_moved(pictures_.line(event.number).edge))
    covered_.take(line.source, line.begin, line.end, event.end, is_inked);
}

void SheetStrip::take_foot(const Event& event) {
  const EdgeLine& edge = pictures_.line(event.number);
  const LinePicture picture = pictures_.picture(event.number, sheet_.feet->below(edge.edge));
  SurfaceLine line = pictures_.surface_line(event.number, picture);
  line.source.id = kFootBit | event.number;
  if (pictures_.cut_to_range(line) && raises(line) && !pictures_.is_moved(edge.edge))
    covered_.take(line.source, line.begin, line.end, event.end, true);
}

void SheetStrip::take_span(const Event& event, const SheetProfile& profile) {
  const ProjectedProfile& of = profile.profile->projected;
  const std::uint32_t i = event.span;
  seen_.clear();
  if (profile.profile->profile.after[i] == Span::wall) {
    const double beside = pictures_.rounding(std::abs(of.x[i]), profile.profile->planned.depth_m);
    covered_.add_upright_seen({of.x[i], of.y[i], of.x[i], of.y[i + 1], i, 0},
                              of.x[i] + (profile.spans[i].takes_left ? -beside : beside), seen_);
  } else {
    const Segment span{of.x[i], of.y[i], of.x[i + 1], of.y[i + 1], i};
    covered_.add_seen(span, std::max(span.x0, range_.begin), std::min(span.x1, range_.end),
                      sheet_.work.tolerance, seen_);
  }
  if (seen_.empty()) return;
  ProfileInWork& in_work = *profile.profile;
  std::vector<VisibleRun>& runs =
      (profile.spans[i].is_up ? in_work.by_strip : in_work.underside_by_strip)[number_];
  for (const Shares& part : seen_) runs.push_back({i, i, part.begin, part.end});
}

} // namespace orograph
