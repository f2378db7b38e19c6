// SPDX-License-Identifier: GPL-3.0-or-later
#include "profiles/sheet_part.hpp"

#include "geometry/on_all_cores.hpp"
#include "profiles/sheet_vertices.hpp"

#include <array>
#include <cmath>
#include <iterator>
#include <limits>

namespace orograph {
namespace {

// Rises clockwise all round as the azimuth does, from -2 at the back to 2, in a division.
double diamond_angle(double u, double v) {
  const double size = std::abs(u) + std::abs(v);
  const double share = size > 0 ? u / size : 0;
  return v >= 0 ? share : (u >= 0 ? 2 : -2) - share;
}
constexpr double kAllRound = 4;

// Sectors overlap by 1e-7, and lines are given to those within a millionth.
constexpr double kWedgeRounding = 1e-5;

// Wedges about the eye, and which of them a convex figure reaches into.
class Wedges {
public:
  explicit Wedges(std::span<const AzimuthWedge> wedges) {
    for (const AzimuthWedge& wedge : wedges) {
      const double begin = wedge.begin - kWedgeRounding, end = wedge.end + kWedgeRounding,
                   middle = 0.5 * (begin + end);
      rays_.push_back({{std::sin(begin), std::cos(begin)},
                       {std::sin(end), std::cos(end)},
                       {std::sin(middle), std::cos(middle)}});
      const double from = diamond_angle(std::sin(begin), std::cos(begin));
      double to = diamond_angle(std::sin(end), std::cos(end));
      if (to < from) to += kAllRound;
      const auto number = static_cast<std::uint32_t>(rays_.size()) - 1;
      for (const double turned : {-kAllRound, 0.0, kAllRound})
        if (to + turned >= -2 && from + turned <= 2)
          shown_.push_back({from + turned, to + turned, number});
    }
    std::ranges::sort(shown_, {}, &Shown::begin);
    for (std::size_t bin = 0; bin < kBins; ++bin) {
      const double begin = -2 + kAllRound * static_cast<double>(bin) / kBins;
      first_.push_back(static_cast<std::uint32_t>(
          std::ranges::find_if(shown_, [&](const Shown& of) { return of.end >= begin; }) -
          shown_.begin()));
    }
  }

  // Calls take(number) with each wedge that a figure of these corners, whose angles they are,
  // reaches into; now and then twice.
  template <std::size_t kCorners, class Take>
  void for_each_reached(const std::array<ProfilePoint, kCorners>& corners,
                        const std::array<double, kCorners>& angles, const Take& take) const {
    const auto [low, high] = std::ranges::minmax(angles);
    constexpr double kNearEye = 1; // or across the back
    if (high - low > kNearEye) {
      for (std::uint32_t i = 0; i < rays_.size(); ++i)
        if (reaches(rays_[i], corners)) take(i);
      return;
    }
    constexpr double kRounding = 1e-12;
    const auto bin = static_cast<std::size_t>(
        std::clamp((low - kRounding + 2) / kAllRound * kBins, 0.0, kBins - 1.0));
    for (std::size_t i = first_[bin]; i < shown_.size() && shown_[i].begin <= high + kRounding; ++i)
      if (shown_[i].end >= low - kRounding) take(shown_[i].number);
  }

private:
  struct Shown {
    double begin, end;
    std::uint32_t number;
  };
  struct Rays {
    Vec2 left, right, middle;
  };

  template <std::size_t kCorners>
  static bool reaches(const Rays& rays, const std::array<ProfilePoint, kCorners>& corners) {
    const auto any = [&](const auto& test) { return std::ranges::any_of(corners, test); };
    return any([&](ProfilePoint p) { return p.u * rays.left.y - p.v * rays.left.x >= 0; }) &&
           any([&](ProfilePoint p) { return p.u * rays.right.y - p.v * rays.right.x <= 0; }) &&
           any([&](ProfilePoint p) { return p.u * rays.middle.x + p.v * rays.middle.y >= 0; });
  }

  static constexpr std::size_t kBins = 1024;
  std::vector<Rays> rays_;
  std::vector<Shown> shown_;         ///< rising
  std::vector<std::uint32_t> first_; ///< by bin, of `shown_`: the first that doesn't end before it
};

} // namespace

class PartsOfSheet {
public:
  PartsOfSheet(const Surface& surface, const SheetTriangles& triangles, const View& view,
               std::span<const AzimuthWedge> ranges)
      : triangles_(triangles), vertices_(surface, view), view_(view), wedges_(ranges) {
    parts_.resize(ranges.size(), SheetPart{});
    for (SheetPart& part : parts_) part.is_part_ = true;
  }

  void add_cells(const Grid& grid) {
    const auto rows = static_cast<std::size_t>(grid.rows) - 1,
               columns = static_cast<std::size_t>(grid.columns);
    for (SheetPart& part : parts_) {
      part.cells_ = static_cast<std::uint32_t>(columns) - 1;
      part.rows_.resize(rows);
    }
    constexpr std::size_t kRows = 32;
    on_all_cores((rows + kRows - 1) / kRows, [&](std::size_t task) {
      std::vector<ProfilePoint> above, below;
      std::vector<double> angles_above, angles_below;
      FilledRows filled(grid, view_, vertices_);
      const auto read = [&](std::size_t number, std::vector<ProfilePoint>& points,
                            std::vector<double>& angles) {
        const auto row = static_cast<std::uint32_t>(number),
                   behind = static_cast<std::uint32_t>(columns);
        if (grid.is_on_earth())
          filled.read(row, 0, behind, points);
        else
          vertices_.read(row, 0, behind, points);
        angles.resize(columns);
        for (std::size_t i = 0; i < columns; ++i)
          angles[i] = diamond_angle(points[i].u, points[i].v);
      };
      const std::size_t begin = task * kRows, end = std::min(rows, begin + kRows);
      read(begin, below, angles_below);
      for (std::size_t row = begin; row < end; ++row) {
        throw_if_stopped();
        above.swap(below);
        angles_above.swap(angles_below);
        read(row + 1, below, angles_below);
        for (std::size_t c = 0; c + 1 < columns; ++c)
          wedges_.for_each_reached(std::array{above[c], above[c + 1], below[c], below[c + 1]},
                                   std::array{angles_above[c], angles_above[c + 1], angles_below[c],
                                              angles_below[c + 1]},
                                   [&](std::uint32_t wedge) {
                                     SheetPart::Cells& cells = parts_[wedge].rows_[row];
                                     if (cells.behind == 0)
                                       cells.first = static_cast<std::uint32_t>(c);
                                     cells.behind = static_cast<std::uint32_t>(c) + 1;
                                   });
      }
    });
    for (SheetPart& part : parts_) {
      std::uint32_t place = 0;
      for (SheetPart::Cells& cells : part.rows_) {
        cells.place = place;
        place += cells.behind - cells.first;
      }
      part.count_ = 2 * place;
    }
  }

  void add_triangles() {
    for (std::uint32_t t = 0; t < triangles_.count(); ++t) {
      throw_if_stopped(t);
      const auto [a, b, c] = triangles_.corners(t);
      const std::array corners{vertices_[a], vertices_[b], vertices_[c]};
      std::array<double, 3> angles{};
      std::ranges::transform(corners, angles.begin(),
                             [](ProfilePoint p) { return diamond_angle(p.u, p.v); });
      wedges_.for_each_reached(corners, angles, [&](std::uint32_t wedge) {
        std::vector<std::uint32_t>& listed = parts_[wedge].listed_;
        if (listed.empty() || listed.back() != t) listed.push_back(t);
      });
    }
    for (SheetPart& part : parts_) part.count_ = static_cast<std::uint32_t>(part.listed_.size());
  }

  std::vector<SheetPart> parts() && { return std::move(parts_); }

private:
  const SheetTriangles& triangles_;
  SheetVertices vertices_;
  const View& view_;
  Wedges wedges_;
  std::vector<SheetPart> parts_;
};

std::vector<SheetPart> parts_in_wedges(const Surface& surface, const SheetTriangles& triangles,
                                       const View& view, std::span<const AzimuthWedge> wedges) {
  PartsOfSheet parts(surface, triangles, view, wedges);
  if (const Grid* grid = std::get_if<Grid>(&surface))
    parts.add_cells(*grid);
  else
    parts.add_triangles();
  return std::move(parts).parts();
}

PartVertices::PartVertices(const Surface& surface, const View& view, const SheetPart& part)
    : tin_(std::get_if<Tin>(&surface)), view_(&view) {
  if (tin_) return;
  const Grid& grid = std::get<Grid>(surface);
  columns_ = static_cast<std::uint32_t>(grid.columns);
  const std::vector<SheetPart::Cells> whole_rows(
      part.is_all() ? static_cast<std::size_t>(grid.rows) - 1 : 0, {0, columns_ - 1, 0});
  const std::vector<SheetPart::Cells>& cells = part.is_all() ? whole_rows : part.rows();
  struct Row {
    std::uint32_t first, behind;
    std::size_t place;
  };
  std::vector<Row> rows;
  std::size_t count = 0;
  for (std::size_t row = 0; row <= cells.size(); ++row) {
    Row of{std::numeric_limits<std::uint32_t>::max(), 0, count};
    for (const std::size_t beside : {row - 1, row})
      if (beside < cells.size() && cells[beside].behind > 0) {
        of.first = std::min(of.first, cells[beside].first);
        of.behind = std::max(of.behind, cells[beside].behind + 1);
      }
    if (of.behind == 0) of.first = 0;
    rows.push_back(of);
    rows_.push_back(static_cast<std::ptrdiff_t>(count) - static_cast<std::ptrdiff_t>(of.first));
    count += of.behind - of.first;
  }
  own_.resize(count);
  std::visit(
      [&](const auto& lattice, const auto& heights) {
        constexpr std::size_t kRows = 64;
        on_all_cores((rows.size() + kRows - 1) / kRows, [&](std::size_t task) {
          for (std::size_t r = task * kRows; r < std::min(rows.size(), (task + 1) * kRows); ++r)
            for (std::uint32_t c = rows[r].first; c < rows[r].behind; ++c)
              own_[rows[r].place + c - rows[r].first] =
                  to_profile_frame(view, lattice.vertex_m(static_cast<int>(c), static_cast<int>(r),
                                                          heights[r * columns_ + c]));
        });
      },
      grid.lattice, grid.heights_m);
}

} // namespace orograph
