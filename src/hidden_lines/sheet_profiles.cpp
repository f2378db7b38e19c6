// SPDX-License-Identifier: GPL-3.0-or-later
#include "hidden_lines/sheet_profiles.hpp"

#include "geometry/on_all_cores.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>

namespace orograph {
namespace {

// Where a profile passes a triangle.
struct Passage {
  std::uint32_t profile;
  std::uint32_t span : 30, on_rim : 1; ///< along its nearer edge
  std::uint32_t takes_left : 1;        ///< as a span has it
  std::uint32_t triangle;
};

// The middle of what a plane cuts of a triangle whose corners are in front of it or not; none where
// it only touches it, to rounding.
template <class InFront>
std::optional<double> middle_of_cut(const std::array<ProfilePoint, 3>& corners, double depth_m,
                                    double rounding_m, const InFront& in_front) {
  std::array<double, 2> u{};
  std::size_t count = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const ProfilePoint &a = corners[k], &b = corners[(k + 1) % 3];
    if (in_front(a) == in_front(b)) continue;
    u[count++] = a.u + (depth_m - a.v) / (b.v - a.v) * (b.u - a.u);
  }
  if (count < 2 || std::abs(u[0] - u[1]) <= rounding_m) return std::nullopt;
  return 0.5 * (u[0] + u[1]);
}

// A list of rising numbers, in which what comes next is mostly near what was asked last.
class Rising {
public:
  explicit Rising(std::span<const double> numbers) : numbers_(numbers) {}
  std::size_t count() const { return numbers_.size(); }
  // The number of the first that is greater.
  std::size_t behind(double number) {
    constexpr int kMostSteps = 8;
    for (int i = 0; i < kMostSteps; ++i) {
      if (at_ < numbers_.size() && numbers_[at_] <= number)
        ++at_;
      else if (at_ > 0 && numbers_[at_ - 1] > number)
        --at_;
      else
        return at_;
    }
    at_ = static_cast<std::size_t>(std::upper_bound(numbers_.begin(), numbers_.end(), number) -
                                   numbers_.begin());
    return at_;
  }

private:
  std::span<const double> numbers_;
  std::size_t at_ = 0;
};

// Of the profiles' depths, by number: those from `first` to `behind`, itself not included, are a
// vertex's own, and those before are nearer.
struct AmongDepths {
  std::uint32_t first, behind;
};

class PassagesOfTriangles {
public:
  PassagesOfTriangles(const SheetInWork& sheet, std::span<const TimedProfile> profiles,
                      std::span<const double> depths_m, std::vector<Passage>& out)
      : sheet_(sheet), depths_m_(depths_m), depths_(depths_m),
        rounding_m_(4 * position_rounding_m(sheet.work.placed.reach_m, sheet.work.sector.view)),
        out_(out) {
    for (const TimedProfile& of : profiles) {
      spans_.emplace_back(of.profile.profile.u_m);
      profiles_.push_back(&of.profile.profile);
    }
  }

  // Of some rows of a grid's cells. Most triangles have all corners between the same two depths.
  void add_rows(std::uint32_t columns, std::uint32_t begin, std::uint32_t end) {
    columns_ = columns;
    SheetPart::Cells north; // of the row
    for (std::uint32_t row = begin; row <= end; ++row) {
      const SheetPart::Cells south = row == end ? SheetPart::Cells{} : cells_of(row);
      above_.swap(below_);
      among_above_.swap(among_below_);
      read_row(row, both(north, south));
      for (std::uint32_t c = north.first; c < north.behind; ++c) {
        const AmongDepths &nw = among_above_[c], &ne = among_above_[c + 1], &sw = among_below_[c],
                          &se = among_below_[c + 1];
        const std::uint32_t first = std::min(nw.first, se.first),
                            behind = std::max(nw.behind, se.behind);
        const std::uint32_t lower = 2 * ((row - 1) * (columns - 1) + c);
        add_of_row(lower, (row - 1) * columns, std::min(first, sw.first),
                   std::max(behind, sw.behind));
        add_of_row(lower + 1, (row - 1) * columns, std::min(first, ne.first),
                   std::max(behind, ne.behind));
      }
      north = south;
    }
  }

  void add_triangle(std::uint32_t triangle) {
    const auto [a, b, c] = sheet_.sheet.triangles.corners(triangle);
    const std::array corners{sheet_.vertices[a], sheet_.vertices[b], sheet_.vertices[c]};
    const auto [nearest, farthest] = std::minmax({corners[0].v, corners[1].v, corners[2].v});
    const std::uint32_t first = among(nearest).first, behind = among(farthest).behind;
    if (!sheet_.sheet.walls.empty() && sheet_.sheet.walls.has(triangle))
      add_wall(triangle, corners, first, behind);
    else
      add(triangle, corners, first, behind);
  }

private:
  SheetPart::Cells cells_of(std::uint32_t row) const {
    return sheet_.part.is_all() ? SheetPart::Cells{0, columns_ - 1, 0} : sheet_.part.rows()[row];
  }
  static SheetPart::Cells both(const SheetPart::Cells& a, const SheetPart::Cells& b) {
    if (a.behind == 0 || b.behind == 0) return a.behind == 0 ? b : a;
    return {std::min(a.first, b.first), std::max(a.behind, b.behind), 0};
  }

  AmongDepths among(double depth_m) {
    const std::size_t behind = depths_.behind(depth_m);
    std::size_t first = behind;
    while (first > 0 && depths_m_[first - 1] == depth_m) --first;
    return {static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(behind)};
  }

  void read_row(std::uint32_t row, const SheetPart::Cells& cells) {
    if (cells.behind == 0) return;
    sheet_.vertices.read(row, cells.first, cells.behind + 1, below_);
    among_below_.resize(below_.size());
    for (std::uint32_t c = cells.first; c <= cells.behind; ++c)
      among_below_[c] = among(below_[c].v);
  }

  void add_of_row(std::uint32_t triangle, std::uint32_t first_vertex, std::uint32_t first,
                  std::uint32_t behind) {
    if (first >= behind || !sheet_.sheet.triangles.is_there(triangle)) return;
    const auto at = [&](std::uint32_t vertex) {
      const std::uint32_t of_row = vertex - first_vertex;
      return of_row < columns_ ? above_[of_row] : below_[of_row - columns_];
    };
    const auto [a, b, c] = sheet_.sheet.triangles.corners(triangle);
    add(triangle, {at(a), at(b), at(c)}, first, behind);
  }

  // A span along an edge belongs to the triangle in front of it, and is asked before that edge
  // covers anything; where there is none, to the one behind, before the edge itself.
  void add(std::uint32_t triangle, const std::array<ProfilePoint, 3>& corners, std::uint32_t first,
           std::uint32_t behind) {
    const double nearest = std::min({corners[0].v, corners[1].v, corners[2].v});
    for (std::uint32_t at = first; at < behind; ++at) {
      const double depth_m = depths_m_[at];
      const bool on_rim = depth_m == nearest;
      const auto middle = on_rim ? middle_of_cut(corners, depth_m, rounding_m_,
                                                 [&](ProfilePoint of) { return of.v <= depth_m; })
                                 : middle_of_cut(corners, depth_m, rounding_m_,
                                                 [&](ProfilePoint of) { return of.v < depth_m; });
      if (!middle) continue;
      const std::size_t right = spans_[at].behind(*middle);
      if (right == 0 || right == spans_[at].count()) continue;
      out_.push_back({at, static_cast<std::uint32_t>(right) - 1, on_rim, false, triangle});
    }
  }

  // A profile crosses it straight up or down, in a span of its own between what it crosses of two
  // edges.
  void add_wall(std::uint32_t triangle, const std::array<ProfilePoint, 3>& corners,
                std::uint32_t first, std::uint32_t behind) {
    if (!sheet_.has_place(triangle)) return; // it has no width
    for (std::uint32_t at = first; at < behind; ++at) {
      const double depth_m = depths_m_[at];
      ProfilePoint at_wall;
      double low_m = std::numeric_limits<double>::infinity(), high_m = -low_m;
      for (std::size_t k = 0; k < 3; ++k) {
        const ProfilePoint &a = corners[k], &b = corners[(k + 1) % 3];
        if ((a.v < depth_m) == (b.v < depth_m)) continue;
        const ProfilePoint crossing = point_between(a, b, (depth_m - a.v) / (b.v - a.v));
        at_wall = crossing;
        low_m = std::min(low_m, crossing.z);
        high_m = std::max(high_m, crossing.z);
      }
      if (!(low_m < high_m)) continue;
      // At an end of the wall there is none of it on one side.
      double to_left = 0, to_right = 0;
      for (const ProfilePoint& corner : corners) {
        const double way = way_to_left(sheet_.work.sector.view, at_wall, corner);
        to_left = std::max(to_left, way);
        to_right = std::max(to_right, -way);
      }
      const double u = at_wall.u;
      const Profile& profile = *profiles_[at];
      const std::vector<double>&u_m = profile.u_m, &z_m = profile.z_m;
      const double rounding_m = 0x1p-36 * (std::abs(u) + std::abs(depth_m));
      for (std::size_t i = spans_[at].behind(u + rounding_m); i-- > 0 && u_m[i] >= u - rounding_m;)
        if (profile.after[i] == Span::wall) {
          const double middle_m = 0.5 * (z_m[i] + z_m[i + 1]);
          if (middle_m >= low_m && middle_m <= high_m)
            out_.push_back(
                {at, static_cast<std::uint32_t>(i), false, to_left >= to_right, triangle});
        }
    }
  }

  const SheetInWork& sheet_;
  std::span<const double> depths_m_;
  Rising depths_;
  double rounding_m_;         ///< of what is between two crossings
  std::vector<Rising> spans_; ///< by profile: its vertices' u
  std::vector<const Profile*> profiles_;
  std::vector<Passage>& out_;
  std::uint32_t columns_ = 0;
  std::vector<ProfilePoint> above_, below_; ///< of a row of cells, by column
  std::vector<AmongDepths> among_above_, among_below_;
};

// Slivers that no triangle has been found for go with the span beside them.
void fill_slivers(const Profile& profile, std::vector<SheetSpan>& spans) {
  const auto is_ground = [&](std::size_t i) {
    return profile.after[i] != Span::gap && profile.after[i] != Span::wall;
  };
  for (std::size_t i = 1; i < spans.size(); ++i)
    if (!spans[i].is_there && is_ground(i) && is_ground(i - 1)) spans[i] = spans[i - 1];
  for (std::size_t i = spans.size(); i-- > 1;)
    if (!spans[i - 1].is_there && is_ground(i - 1) && is_ground(i)) spans[i - 1] = spans[i];
}

} // namespace

std::vector<SheetProfile> sheet_profiles(const SheetInWork& sheet,
                                         std::span<TimedProfile> profiles) {
  std::vector<double> depths_m;
  for (const TimedProfile& of : profiles) depths_m.push_back(of.profile.planned.depth_m);
  std::vector<SheetProfile> out;
  for (TimedProfile& of : profiles)
    out.push_back({&of.profile, std::vector<SheetSpan>(of.profile.profile.size())});
  const auto take = [&](const std::vector<Passage>& passages) {
    for (const auto& [profile, number, is_on_rim, takes_left, triangle] : passages) {
      SheetSpan& span = out[profile].spans[number];
      if (span.is_there && (is_on_rim || has_front(span.turn))) continue;
      const SheetStep step = is_on_rim ? SheetStep::on_rim : SheetStep::inside;
      span = SheetSpan(turn_of(sheet.order.place(triangle), step), true,
                       sheet.sheet.is_up[triangle] != 0, takes_left != 0);
    }
  };
  // Rows of cells, or triangles of a TIN; so many at a time, so that passages need little memory.
  const Grid* const grid = std::get_if<Grid>(&sheet.work.terrain.surface);
  const auto columns = grid ? static_cast<std::uint32_t>(grid->columns) : 0;
  constexpr std::uint32_t kTrianglesOfTask = 1U << 15U, kTasks = 32;
  const std::uint32_t of_task =
      grid ? std::max(1U, kTrianglesOfTask / (2 * (columns - 1))) : kTrianglesOfTask;
  const std::uint32_t count =
      grid ? static_cast<std::uint32_t>(grid->rows) - 1 : sheet.part.count();
  std::vector<std::vector<Passage>> of_tasks(kTasks);
  for (std::uint32_t first = 0; first < count; first += kTasks * of_task) {
    throw_if_stopped();
    on_all_cores(kTasks, [&](std::size_t task) {
      std::vector<Passage>& found = of_tasks[task];
      found.clear();
      const std::uint32_t begin =
                              std::min(count, first + static_cast<std::uint32_t>(task) * of_task),
                          end = std::min(count, begin + of_task);
      if (begin == end) return;
      PassagesOfTriangles passages(sheet, profiles, depths_m, found);
      if (grid)
        passages.add_rows(columns, begin, end);
      else
        sheet.part.for_each(begin, end,
                            [&](std::uint32_t t, std::uint32_t) { passages.add_triangle(t); });
    });
    std::ranges::for_each(of_tasks, take);
  }
  on_all_cores(out.size(),
               [&](std::size_t i) { fill_slivers(profiles[i].profile.profile, out[i].spans); });
  return out;
}

} // namespace orograph
