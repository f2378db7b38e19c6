// SPDX-License-Identifier: GPL-3.0-or-later
#include "placing/cell_on_page.hpp"

#include "dem/extent.hpp"
#include "geometry/on_all_cores.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace orograph {
namespace {

// By looking: with half of it a tile of 1200 cells on A4 keeps the noise of satellites' heights;
// three times as much takes side valleys away.
constexpr double kCellsOfSpacing = 0.8;
// Facets show where cells are larger than some lines' spacings; then these are fine enough.
constexpr double kFinestOfSpacing = 1.6;

} // namespace

CellSizes asked_size(const Style& style) {
  if (style.detail.cell_mm) return {*style.detail.cell_mm, *style.detail.cell_mm};
  const double usual_mm = kPenWidthsApart * style.pen_width_mm;
  const auto* plan = style.plan ? std::get_if<PageSpacing>(&*style.plan) : nullptr;
  const double spacing_mm = plan ? plan->mm : usual_mm;
  return {kCellsOfSpacing * spacing_mm, kFinestOfSpacing * spacing_mm};
}

bool is_on_page(const PlacedView& placed, Vec3 on_page) {
  if (!(on_page.z > 0)) return false;
  const Vec2 at{on_page.x / on_page.z, on_page.y / on_page.z};
  const Box2& frame = placed.frame_mm;
  return at.x >= frame.low.x && at.x <= frame.high.x && at.y >= frame.low.y && at.y <= frame.high.y;
}

bool stands_over(const Grid& grid, const std::vector<Box3>& boxes, Vec2 eye_m) {
  // From one box's last vertices to the next one's first there is a cell.
  const auto [column_m, row_m] = steps_of(grid);
  const Vec2 half{0.501 * (std::abs(column_m.x) + std::abs(row_m.x)),
                  0.501 * (std::abs(column_m.y) + std::abs(row_m.y))};
  return std::ranges::any_of(boxes, [&](const Box3& box) {
    return box.low.x - half.x <= eye_m.x && eye_m.x <= box.high.x + half.x &&
           box.low.y - half.y <= eye_m.y && eye_m.y <= box.high.y + half.y;
  });
}

// How large a cell is on the page where it is largest; infinite at the eye's feet.
double greatest_cell_mm(const PlacedView& placed, const Grid& grid) {
  const View& view = placed.view;
  if (view.is_perspective() && stands_over(grid, placed.extent.blocks.boxes, view.depth_origin_m))
    return std::numeric_limits<double>::infinity();
  const GridSteps steps = steps_of(grid);
  const auto in_frame = [&](Vec2 step) {
    return Vec3{dot(step, view.right), dot(step, view.forward), 0};
  };
  const Vec3 across = in_frame(steps.column_m), down = in_frame(steps.row_m);
  const auto greatest_of = [&](const Box3& box) {
    double greatest = 0;
    for (int i = 0; i < 8; ++i) {
      const ProfilePoint at = to_profile_frame(view, corner_of(box, i));
      if (!is_on_page(placed, placed.on_page(at))) continue;
      greatest = std::max({greatest, placed.mm_per_step(at, across), placed.mm_per_step(at, down)});
    }
    return greatest;
  };
  const std::vector<Box3>& boxes = placed.extent.blocks.boxes;
  constexpr std::size_t kBoxesOfTask = 256;
  std::vector<double> of_tasks((boxes.size() + kBoxesOfTask - 1) / kBoxesOfTask, 0.0);
  on_all_cores(of_tasks.size(), [&](std::size_t task) {
    const std::size_t end = std::min(boxes.size(), (task + 1) * kBoxesOfTask);
    for (std::size_t i = task * kBoxesOfTask; i < end; ++i)
      of_tasks[task] = std::max(of_tasks[task], greatest_of(boxes[i]));
  });
  return of_tasks.empty() ? 0 : std::ranges::max(of_tasks);
}

} // namespace orograph
