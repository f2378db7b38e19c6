// SPDX-License-Identifier: GPL-3.0-or-later
// Which triangles of a grid on the ellipsoid the eye sees, a row of cells at a time.
#pragma once

#include "dem/grid.hpp"
#include "geometry/angle.hpp"
#include "profiles/facing.hpp"
#include "profiles/lattice_order.hpp"
#include "profiles/row_facing.hpp"
#include "view/view.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace orograph {

// A vertex is where its foot is, at a middle height, and t times its upright: P = B + t U. A
// triangle's sign is det(E - P0, P1 - P0, P2 - P0), in a parallel view det(ray, ...). With B and U
// instead of P it is a sum of what t0, t1 - t0 and t2 - t0 count, as on a map plane, and of what
// uprights that aren't parallel add to it, which is no more than a bound: a ten-thousandth of what
// counts, where the ground is within 1000 m of the middle height. Along a row feet and uprights go
// round the earth's axis, so that each factor is a sine of the longitude but for what doesn't
// change: a parabola through three columns, to 0.3 m of the eye's height for a degree. So a row is
// plain arithmetic on heights in float, and no vertex is reckoned but at three columns and where a
// sign is within all these bounds. Those are asked of `facing_of`: of the tile N44W072 seen whole,
// 0.1 % of the triangles.

template <class Height>
class EarthRowFacing {
public:
  EarthRowFacing(const Grid& grid, const Heights<Height>& heights, const View& view)
      : lower(static_cast<std::size_t>(grid.columns) - 1), upper(lower.size()), grid_(grid),
        earth_(grid.earth()), heights_(heights), view_(view),
        step_rad_(std::abs(Angle::degrees(earth_.degrees().lon_step_deg).in_radians())),
        axis_m_(earth_.frame().ellipsoid().semi_major_axis_m +
                std::hypot(length(view.depth_origin_m), view.eye_z_m)) {}

  std::vector<std::uint8_t> lower, upper; ///< bits, a cell each

  /// Of the cells from column `first` to `end`.
  void reckon(int row, int first, int end) {
    const RowHeights heights = range_of(row, first, end);
    const int most_cells = cells_at_once(row, (first + end) / 2, heights.middle);
    for (int begin = first; begin < end;) {
      // The last ones together, rather than a few of them alone.
      const int past = end - begin < 2 * most_cells ? end : begin + most_cells;
      const SignTerms terms = terms_of(row, begin, past, heights);
      sign_bits(&heights_[grid_.index(0, row)], &heights_[grid_.index(0, row + 1)], begin, past,
                terms, &lower[0], &upper[0]);
      begin = past;
    }
    doubt_limited(row, first, end);
    settle(row, first, end);
  }

  bool may_be_ridge(CellVertex from, std::size_t edge) {
    const auto beside = [&](CellVertex v) {
      return CellVertex{from.column + v.column, from.row + v.row};
    };
    const CellVertex to = beside(kEdgesOfCell[edge].to), left = beside(kEdgesOfCell[edge].left),
                     right = beside(kEdgesOfCell[edge].right);
    if (!earth_.lean_limits()) { // what stands upright isn't on its upright
      const Bend& bend = bend_at(edge, from, to, left, right);
      const double h = height(from), h_to = height(to) - h, h_left = height(left) - h,
                   h_right = height(right) - h;
      const double sum =
          bend.level + h_to * bend.per_to + h_left * bend.per_left + h_right * bend.per_right;
      const double most = std::max({std::abs(h_to), std::abs(h_left), std::abs(h_right)}),
                   lean_m = (std::abs(h) + most) * bend.lean + places_m(),
                   reach_m = bend.reach_m + lean_m, all_m = reach_m + most * bend.upright,
                   all_m2 = all_m * all_m;
      // Three factors of M = B + t0 (U - U0) instead of B; uprights instead of one or more of them.
      // What sinks bends by no more than it does within the edge's own reach: what it does in line
      // moves all alike.
      const double off = lean_m * (3 * reach_m * reach_m + 48 * most * bend.upright * reach_m) +
                         3 * sunk_per_m2() * all_m2 * all_m2;
      if (std::abs(sum) > off) return sum < 0;
    }
    const auto at = [&](CellVertex v) { return vertex(v.column, v.row); };
    return orograph::may_be_ridge(at(from), at(to), at(left), at(right));
  }

private:
  struct RowHeights {
    double middle = 0, reach = 0;
  };
  // A sign is constant + per_height * t + per_c * gc + per_r * gr, where t is the height of the
  // north-western vertex over the middle one and gc and gr are how heights change along the row and
  // southwards; and a bound on what that may be off, `least` and `reach` times the changes.
  struct SignTerms {
    Height middle;
    Parabola constant, per_height, per_c, per_r;
    double least, reach;
  };
  // Foot and upright.
  struct Stand {
    Vec3 foot, upright;
  };

  static double det(Vec3 a, Vec3 b, Vec3 c) { return dot(a, cross(b, c)); }
  static double size(Vec3 a) { return std::sqrt(dot(a, a)); }

  double height(CellVertex v) const { return heights_[grid_.index(v.column, v.row)]; }
  ProfilePoint vertex(int column, int row) const {
    const double height = heights_[grid_.index(column, row)];
    return to_profile_frame(view_, earth_.vertex_m(column, row, height));
  }
  Vec3 at_height(int column, int row, double height_m) const {
    const ProfilePoint p = to_profile_frame(view_, earth_.leaning_vertex_m(column, row, height_m));
    return {p.u, p.v, p.z};
  }
  // With the upright of a metre of height, of `over_m` metres.
  Stand stand(int column, int row, double height_m, double over_m) const {
    const Vec3 foot = at_height(column, row, height_m);
    return {foot, (1 / over_m) * (at_height(column, row, height_m + over_m) - foot)};
  }
  // More than what rounding moves a vertex by.
  double places_m() const { return 32 * std::numeric_limits<double>::epsilon() * axis_m_; }

  RowHeights range_of(int row, int first, int end) const {
    // Lanes for the vector units; what isn't there is neither lower nor higher.
    constexpr int kLanes = 8;
    std::array<Height, kLanes> lows, highs;
    lows.fill(std::numeric_limits<Height>::infinity());
    highs.fill(-std::numeric_limits<Height>::infinity());
    for (const int r : {row, row + 1}) {
      const Height* const h = &heights_[grid_.index(0, r)];
      const auto take = [&](std::size_t lane, Height height) {
        lows[lane] = height < lows[lane] ? height : lows[lane];
        highs[lane] = height > highs[lane] ? height : highs[lane];
      };
      int c = first;
      for (; c + kLanes <= end; c += kLanes)
        for (std::size_t k = 0; k < kLanes; ++k) take(k, h[static_cast<std::size_t>(c) + k]);
      for (; c <= end; ++c) take(0, h[c]);
    }
    const Height low = *std::ranges::min_element(lows), high = *std::ranges::max_element(highs);
    if (!(low <= high)) return {};
    // As a Height has it.
    const auto middle = static_cast<double>(static_cast<Height>(0.5 * low + 0.5 * high));
    return {middle, std::max(high - middle, middle - low)};
  }

  Vec3 to_eye(Vec3 from) const {
    return view_.is_perspective()
               ? Vec3{-from.x, -from.y, view_.eye_z_m - from.z}
               : Vec3{view_.x_per_v * view_.y_per_z, -view_.y_per_z, view_.y_per_v};
  }
  // How much what sinks sinks at most, over the square of its distance.
  double sunk_per_m2() const {
    const auto& [uu, uv, vv] = view_.drop;
    return std::max(std::abs(uu), std::abs(vv)) + 0.5 * std::abs(uv);
  }
  // The third derivatives along a row, at most, of a triangle's sign over the lengths of its edges.
  // What goes round the axis is as far from it as the eye. What sinks by q is of the second degree
  // in places `away_m` from the view's origin, and these change by `axis_m_` a radian: by the
  // product rule of q0 n and twice of (q1 - q0) (Q x D), where Q is the way to the eye and n and D
  // are an edge or two long.
  double arm_m(Vec3 place, Vec3 to_eye) const {
    const double away_m = std::hypot(place.x, place.y);
    const double sunk = sunk_per_m2() * (84 * axis_m_ + 90 * away_m);
    return (view_.is_perspective() ? axis_m_ : size(to_eye)) * (1 + sunk);
  }
  // Of a parabola through three points no farther than `angle` apart, one of them between, and a
  // function whose third derivatives are 1 at most: |(x - a)(x - b)(x - c)| / 6.
  static double off_parabola(double angle) { return angle * angle * angle / 40; }

  // As many as a parabola tells to a hundred-thousandth of how far the eye is.
  int cells_at_once(int row, int column, double height_m) const {
    constexpr int kLeast = 64, kMost = 4096;
    const Vec3 place = at_height(column, row, height_m), eye = to_eye(place);
    const double angle = std::cbrt(40 * 1e-5 * size(eye) / arm_m(place, eye));
    const double cells = angle / step_rad_;
    return cells > kLeast ? static_cast<int>(std::min<double>(cells, kMost)) : kLeast;
  }

  SignTerms terms_of(int row, int first, int end, const RowHeights& heights) const {
    const double over_m = std::max(heights.reach, 1.0);
    const int last = end - 1, half = (first + last) / 2;
    const std::array<int, 3> columns{first, half, last};
    std::array<double, 3> constant{}, per_height{}, per_c{}, per_r{};
    // What the two triangles of a cell differ by, and the greatest that there is.
    double constant_off = 0, per_height_off = 0, per_c_off = 0, per_r_off = 0;
    double eye_m = 0, arm_m = 0, edge_m = 0, upright = 0, lean = 0, slant = 0;
    for (std::size_t i = 0; i < columns.size(); ++i) {
      const auto at = [&](int right, int down) {
        return stand(columns[i] + right, row + down, heights.middle, over_m);
      };
      const Stand nw = at(0, 0), ne = at(1, 0), sw = at(0, 1), se = at(1, 1);
      const Vec3 eye = to_eye(nw.foot);
      const double per_t = view_.is_perspective() ? -1 : 0; // what of the eye's way an upright is
      struct Of {
        double constant, per_height, per_1, per_2;
      };
      const auto of = [&](const Stand& one, const Stand& other) {
        const Vec3 a = one.foot - nw.foot, b = other.foot - nw.foot;
        return Of{det(eye, a, b),
                  per_t * det(nw.upright, a, b) + det(eye, one.upright - nw.upright, b) +
                      det(eye, a, other.upright - nw.upright),
                  det(eye, one.upright, b), det(eye, a, other.upright)};
      };
      // South-west, then south-east: the first of what changes southwards, both; and so on.
      const Of below = of(sw, se), above = of(se, ne);
      const double below_c = below.per_2, below_r = below.per_1 + below.per_2,
                   above_c = above.per_1 + above.per_2, above_r = above.per_1;
      const auto mean = [](double a, double b, double& off) {
        off = std::max(off, 0.5 * std::abs(a - b));
        return 0.5 * (a + b);
      };
      constant[i] = mean(below.constant, above.constant, constant_off);
      per_height[i] = mean(below.per_height, above.per_height, per_height_off);
      per_c[i] = mean(below_c, above_c, per_c_off);
      per_r[i] = mean(below_r, above_r, per_r_off);
      eye_m = std::max(eye_m, size(eye));
      arm_m = std::max(arm_m, this->arm_m(nw.foot, eye));
      for (const Stand& other : {ne, sw, se}) {
        edge_m = std::max(edge_m, size(other.foot - nw.foot));
        upright = std::max(upright, size(other.upright));
        lean = std::max(lean, size(other.upright - nw.upright));
      }
      upright = std::max(upright, size(nw.upright));
      slant = std::max(slant, std::hypot(nw.upright.x, nw.upright.y) + lean);
    }
    // Between the columns the eye isn't farther than at them by what they are apart.
    if (view_.is_perspective())
      eye_m += size(at_height(last, row, heights.middle) - at_height(first, row, heights.middle));
    const double moves = view_.is_perspective() ? 1 : 0;
    const double t = heights.reach, lean_m = t * lean + places_m();
    // What sinks isn't in line between the foot and `over_m` above it, since that is aside.
    const double aside = slant + upright * step_rad_ * (last - first),
                 sunk_m = sunk_per_m2() * aside * aside * 2 * over_m * over_m;
    const double edge_reach_m = edge_m + lean_m;
    const double off = off_parabola(step_rad_ * (last - first)) * arm_m;
    // Between three columns one of which is about in the middle a parabola is no more than twice
    // what it is at them: 1.25 times, or 1.67 where there are four.
    constexpr double kBetween = 2;
    SignTerms out{static_cast<Height>(heights.middle),
                  through(columns, constant),
                  through(columns, per_height),
                  through(columns, per_c),
                  through(columns, per_r),
                  0,
                  0};
    const double cells = last - first;
    const double per_height_most = out.per_height.bound(cells),
                 per_change_most = out.per_c.bound(cells) + out.per_r.bound(cells);
    constexpr double kOfFloat = 32.0 * std::numeric_limits<float>::epsilon();
    out.least = kBetween * (constant_off + per_height_off * t) +
                off * (edge_m * edge_m + 2 * t * lean * edge_m) +
                lean_m * lean_m * (eye_m + 2 * moves * edge_reach_m) +
                4 * moves * t * upright * lean_m * edge_reach_m +
                4 * (sunk_m + places_m()) * (2 * eye_m * edge_reach_m + edge_m * edge_m) +
                kOfFloat * (out.constant.bound(cells) + eye_m * edge_m * edge_m +
                            t * (per_height_most + per_change_most));
    out.reach = kBetween * (per_c_off + per_r_off) + off * 2 * edge_m * upright +
                2 * upright * lean_m * (3 * eye_m + 4 * moves * edge_reach_m) +
                4 * (sunk_m + places_m()) * eye_m * upright + kOfFloat * per_change_most;
    return out;
  }

  // Through the values at three columns, counted from the first; two or all may be the same.
  static Parabola through(const std::array<int, 3>& columns, const std::array<double, 3>& values) {
    const double m = columns[1] - columns[0], e = columns[2] - columns[0];
    const double to_middle = m > 0 ? (values[1] - values[0]) / m : 0,
                 from_middle = e > m ? (values[2] - values[1]) / (e - m) : to_middle;
    const double bend = m > 0 ? (from_middle - to_middle) / e : 0;
    return {values[0], (m > 0 ? to_middle : from_middle) - bend * m, bend};
  }

  static void sign_bits(const Height* north, const Height* south, int first, int end,
                        const SignTerms& terms, std::uint8_t* __restrict lower,
                        std::uint8_t* __restrict upper) {
    const ParabolaIn<float> constant(terms.constant), per_height(terms.per_height),
        per_c(terms.per_c), per_r(terms.per_r);
    const auto least = static_cast<float>(terms.least), reach = static_cast<float>(terms.reach);
    const Height middle = terms.middle;
    for (int c = first; c < end; ++c) {
      const auto over = [&](Height h) { return static_cast<float>(h - middle); };
      const float nw = over(north[c]), ne = over(north[c + 1]), sw = over(south[c]),
                  se = over(south[c + 1]);
      const float south_c = se - sw, north_c = ne - nw, west_r = sw - nw, east_r = se - ne;
      const auto x = static_cast<float>(c - first);
      const float level = constant.at(x) + per_height.at(x) * nw, of_c = per_c.at(x),
                  of_r = per_r.at(x);
      lower[c] = bits_of_sign(level + of_c * south_c + of_r * west_r,
                              least + reach * (std::abs(south_c) + std::abs(west_r)),
                              north[c] + south[c] + south[c + 1]);
      upper[c] = bits_of_sign(level + of_c * north_c + of_r * east_r,
                              least + reach * (std::abs(north_c) + std::abs(east_r)),
                              north[c] + north[c + 1] + south[c + 1]);
    }
  }

  // Vertices that don't lean as far as their height would have them aren't on their uprights.
  void doubt_limited(int row, int first, int end) {
    const LeanLimits* const limits = earth_.lean_limits();
    if (!limits) return;
    for (const int r : {row, row + 1})
      for (const LeanLimit& limit : limits->of_row(r))
        for (int c = std::max(limit.column - 1, first); c <= std::min(limit.column, end - 1); ++c)
          for (std::vector<std::uint8_t>* of : {&lower, &upper}) {
            std::uint8_t& bits = (*of)[static_cast<std::size_t>(c)];
            if (bits != 0) bits = kMayFace | kMayTurn;
          }
  }

  void settle(int row, int first, int end) {
    for_each_in_doubt(lower, upper, first, end, [&](int column) {
      const auto at = [&](int right, int down) { return vertex(column + right, row + down); };
      std::uint8_t &below = lower[static_cast<std::size_t>(column)],
                   &above = upper[static_cast<std::size_t>(column)];
      if (below == (kMayFace | kMayTurn)) below = facing_of(view_, at(0, 0), at(0, 1), at(1, 1));
      if (above == (kMayFace | kMayTurn)) above = facing_of(view_, at(0, 0), at(1, 1), at(1, 0));
    });
  }

  // det(to - from, left - from, right - from) of an edge and the third vertices beside it, as a sum
  // like that of signs, from height 0: the same along a row of the lattice.
  struct Bend {
    double level, per_to, per_left, per_right;
    double reach_m, upright, lean; // of the feet from the first one, and of the uprights
  };
  const Bend& bend_at(std::size_t edge, CellVertex from, CellVertex to, CellVertex left,
                      CellVertex right) {
    if (bends_of_ != from.row) {
      bends_ = {};
      bends_of_ = from.row;
    }
    std::optional<Bend>& bend = bends_[edge];
    if (!bend) {
      const auto place = [&](CellVertex v, double height_m) {
        const Vec3 at = earth_.leaning_vertex_m(v.column, v.row, height_m);
        return Vec3{at.x, at.y, view_.exaggeration * at.z};
      };
      const auto at = [&](CellVertex v) {
        constexpr double kOver_m = 1000;
        const Vec3 foot = place(v, 0);
        return Stand{foot, (1 / kOver_m) * (place(v, kOver_m) - foot)};
      };
      const Stand a = at(from), b = at(to), c = at(left), d = at(right);
      const Vec3 to_b = b.foot - a.foot, to_c = c.foot - a.foot, to_d = d.foot - a.foot;
      const auto most = [](double one, double other, double third) {
        return std::max({one, other, third});
      };
      bend =
          Bend{det(to_b, to_c, to_d),
               det(b.upright, to_c, to_d),
               det(to_b, c.upright, to_d),
               det(to_b, to_c, d.upright),
               most(size(to_b), size(to_c), size(to_d)),
               std::max(size(a.upright), most(size(b.upright), size(c.upright), size(d.upright))),
               most(size(b.upright - a.upright), size(c.upright - a.upright),
                    size(d.upright - a.upright))};
    }
    return *bend;
  }

  const Grid& grid_;
  const EarthLattice& earth_;
  const Heights<Height>& heights_;
  const View& view_;
  double step_rad_;
  double
      axis_m_; ///< more than how far the eye is from the earth's axis, and a vertex near sea level
  std::array<std::optional<Bend>, kEdgesOfCell.size()> bends_;
  int bends_of_ = -1; ///< row
};

} // namespace orograph
