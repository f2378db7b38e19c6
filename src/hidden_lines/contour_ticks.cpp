// SPDX-License-Identifier: GPL-3.0-or-later
#include "hidden_lines/contour_ticks.hpp"

#include "geometry/clip_by_planes.hpp"
#include "geometry/on_all_cores.hpp"
#include "placing/vertex_values.hpp"
#include "profiles/hollows.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace orograph {
namespace {

// Of the way down to the next contour, and from the contour to the middle of a round hollow.
constexpr double kToNext = 0.6, kToMiddle = 0.4;
constexpr double kLeastTicks = 4;

// What of a piece of a contour is in the frame.
struct PieceInFrame {
  std::size_t piece;
  double begin, end;     ///< shares of it
  double w_begin, w_end; ///< in homogeneous page coordinates
  double length_mm;
};

class Ticks {
public:
  Ticks(const TerrainData& terrain, const PlacedView& placed, const ContourLevels& levels,
        GroundLines& out)
      : placed_(placed), levels_(levels), heights_(heights_of(terrain)),
        triangles_(terrain.surface, heights_), ends_(terrain.surface, placed.view),
        vertices_(static_cast<std::uint32_t>(vertex_count(terrain.surface))), out_(out) {}

  const PlanTriangles& triangles() const { return triangles_; }
  const VertexValues& heights() const { return heights_; }

  void add(const Hollow& hollow) {
    std::vector<PieceInFrame> pieces;
    double length_mm = 0;
    for (std::size_t i = 0; i < hollow.line.size(); ++i)
      if (const auto piece = in_frame(hollow, i)) {
        pieces.push_back(*piece);
        length_mm += piece->length_mm;
      }
    if (!(length_mm > 0)) return;
    const bool is_whole = std::ranges::all_of(
        pieces, [](const PieceInFrame& piece) { return piece.begin <= 0 && piece.end >= 1; });
    const double count = std::max(is_whole && pieces.size() == hollow.line.size() ? kLeastTicks : 1,
                                  std::round(length_mm / kTicksApart_mm));
    const double apart_mm = length_mm / count;
    double next_mm = 0.5 * apart_mm, done_mm = 0;
    const std::size_t before = out_.lines.size();
    for (const PieceInFrame& piece : pieces) {
      for (; next_mm < done_mm + piece.length_mm; next_mm += apart_mm) {
        // Shares on the page are no shares of the way where its ends are differently far.
        const double share = (next_mm - done_mm) / piece.length_mm,
                     along = share * piece.w_begin /
                             (piece.w_end + share * (piece.w_begin - piece.w_end));
        add_tick(hollow, piece.piece, piece.begin + along * (piece.end - piece.begin));
      }
      done_mm += piece.length_mm;
    }
    if (out_.lines.size() > before)
      out_.features.push_back(
          {levels_.is_index[hollow.level] ? LineKind::index_contour : LineKind::contour,
           {{"elevation", levels_.heights[hollow.level]}},
           true});
  }

private:
  ProfilePoint point_at(const EdgePoint& at) const {
    const auto [from, to] = ends_(at.edge);
    return point_between(from, to, at.t);
  }
  Vec2 place_m(const EdgePoint& at) const {
    const Vec2 from = triangles_.place_m(at.edge.from), to = triangles_.place_m(at.edge.to);
    return from + at.t * (to - from);
  }
  static const EdgePoint& end_of(const Hollow& hollow, std::size_t piece) {
    return hollow.line[(piece + 1) % hollow.line.size()].at;
  }
  std::optional<PieceInFrame> in_frame(const Hollow& hollow, std::size_t piece) const {
    const ProfilePoint a = point_at(hollow.line[piece].at), b = point_at(end_of(hollow, piece));
    if (placed_.panorama && seam_crossing(a, b)) return std::nullopt;
    const auto page = [&](ProfilePoint p) { return placed_.on_page(p); };
    const auto values = [&](ProfilePoint p) {
      return plane_values(placed_.frame_mm, placed_.depth, page(p), p);
    };
    const auto shares = clip_by_planes(values(a), values(b));
    if (!shares || !(shares->begin < shares->end)) return std::nullopt;
    const Vec3 begin = page(point_between(a, b, shares->begin)),
               end = page(point_between(a, b, shares->end));
    if (!(begin.z > 0 && end.z > 0)) return std::nullopt;
    const double length_mm =
        std::hypot(begin.x / begin.z - end.x / end.z, begin.y / begin.z - end.y / end.z);
    return PieceInFrame{piece, shares->begin, shares->end, begin.z, end.z, length_mm};
  }

  void add_tick(const Hollow& hollow, std::size_t piece, double t) {
    const EdgePoint &from = hollow.line[piece].at, &to = end_of(hollow, piece);
    const double mm_a_metre =
        mm_a_metre_at(placed_, point_between(point_at(from), point_at(to), t));
    if (!(mm_a_metre > 0)) return;
    const double most_m =
        std::min(kTick_mm / mm_a_metre, kToMiddle * std::sqrt(hollow.area_m2 / std::numbers::pi));
    const std::vector<double>& heights_m = levels_.heights_m;
    const double lowest_m = hollow.level == 0 ? -std::numeric_limits<double>::infinity()
                                              : std::lerp(heights_m[hollow.level],
                                                          heights_m[hollow.level - 1], kToNext);
    const Vec2 begin_m = place_m(from), end_m = place_m(to);
    const auto pieces = downhill(triangles_, hollow.line[piece].triangle,
                                 begin_m + t * (end_m - begin_m), most_m, lowest_m);
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      if (i == 0) add_point(pieces[i].triangle, pieces[i].from);
      add_point(pieces[i].triangle, pieces[i].to);
      const auto last = vertices_ + static_cast<std::uint32_t>(out_.points.size()) - 1;
      out_.lines.push_back(
          {{last - 1, last}, pieces[i].triangle, static_cast<std::uint32_t>(out_.features.size())});
    }
  }
  void add_point(std::uint32_t triangle, const std::array<double, 3>& shares) {
    const auto corners = triangles_.corners(triangle);
    ProfilePoint point{0, 0, 0};
    for (std::size_t k = 0; k < 3; ++k) {
      const ProfilePoint corner = ends_({corners[k], corners[k]}).from;
      point = {point.u + shares[k] * corner.u, point.v + shares[k] * corner.v,
               point.z + shares[k] * corner.z};
    }
    out_.points.push_back(point);
  }

  const PlacedView& placed_;
  const ContourLevels& levels_;
  VertexValues heights_;
  PlanTriangles triangles_;
  EdgeEnds ends_;
  std::uint32_t vertices_;
  GroundLines& out_;
};

} // namespace

void add_contour_ticks(const TerrainData& terrain, const PlacedView& placed,
                       const ContourLevels& levels, GroundLines& out) {
  Ticks ticks(terrain, placed, levels, out);
  // Of all ground: a line that is seen in part may go round ground that isn't looked at.
  const Isolines lines = isolines(terrain.surface, ticks.heights(), levels.heights_m);
  for (const Hollow& hollow : hollows(ticks.triangles(), levels.heights_m, lines.lines)) {
    throw_if_stopped();
    ticks.add(hollow);
  }
}

} // namespace orograph
