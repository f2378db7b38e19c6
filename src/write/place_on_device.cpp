// SPDX-License-Identifier: GPL-3.0-or-later
#include "write/place_on_device.hpp"

#include "geometry/error.hpp"
#include "geometry/on_all_cores.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

namespace orograph {
namespace {

// Papers and pages are told to the millimetre, letter to a tenth.
constexpr double kSameSize_mm = 0.5;

bool holds(Vec2 paper_mm, Vec2 page_mm) {
  return page_mm.x <= paper_mm.x + kSameSize_mm && page_mm.y <= paper_mm.y + kSameSize_mm;
}

double area(Vec2 size) {
  return size.x * size.y;
}

// What the pen doesn't reach on the paper's four sides, at most.
double unreached_mm(const DevicePaper& paper, double unit_mm) {
  const Vec2 low{paper.origin_mm.x + unit_mm * paper.window.low.x,
                 paper.origin_mm.y + unit_mm * paper.window.low.y};
  const Vec2 high{paper.origin_mm.x + unit_mm * paper.window.high.x,
                  paper.origin_mm.y + unit_mm * paper.window.high.y};
  return std::max({low.x, low.y, paper.size_mm.x - high.x, paper.size_mm.y - high.y, 0.0});
}

std::string page_that_fits(const DevicePaper& paper, double unit_mm) {
  return fmt::format("`page` {}x{} ({}) with `margin_mm` {:.0f} fits", paper.size_mm.x,
                     paper.size_mm.y, paper.name, std::ceil(unreached_mm(paper, unit_mm)));
}

Box2 ink_box_mm(const Drawing& drawing) {
  Box2 box;
  std::size_t step = 0;
  for (const Layer& layer : drawing.layers) {
    if (layer.is_pen_way) continue;
    for (const Vec2 p : layer.page_mm) {
      throw_if_stopped(step++);
      box.include(p);
    }
  }
  return box;
}

} // namespace

OnDevice::OnDevice(const Drawing& drawing, const Device& device) : device_(device) {
  choose_paper(drawing.page);
  check_window(drawing);
}

void OnDevice::choose_paper(const Page& page) {
  const Vec2 as_it_is{page.width_mm, page.height_mm}, turned{page.height_mm, page.width_mm};
  size_mm_ = page_mm_ = as_it_is;
  if (device_.papers.empty()) return;
  const DevicePaper* largest = &device_.papers.front();
  for (const DevicePaper& paper : device_.papers) {
    if (area(paper.size_mm) > area(largest->size_mm)) largest = &paper;
    const bool fits = holds(paper.size_mm, as_it_is);
    if (!fits && !holds(paper.size_mm, turned)) continue;
    if (paper_ != nullptr && area(paper.size_mm) >= area(paper_->size_mm)) continue;
    paper_ = &paper;
    turned_ = !fits;
  }
  if (paper_ == nullptr)
    throw UsageError(fmt::format("the page of {} x {} mm is larger than any paper of the {}",
                                 page.width_mm, page.height_mm, device_.name),
                     page_that_fits(*largest, device_.unit_mm));
  size_mm_ = paper_->size_mm;
  origin_mm_ = paper_->origin_mm;
  if (turned_) page_mm_ = turned;
}

void OnDevice::check_window(const Drawing& drawing) const {
  const Box2 ink = ink_box_mm(drawing);
  const std::optional<Box2> window =
      paper_ != nullptr ? std::optional<Box2>(paper_->window) : device_.window;
  if (ink.empty() || !window) return;
  const double steps_in_unit = device_.unit_mm / device_.step_mm();
  double beyond = 0; // steps
  for (const Vec2 corner : {ink.low, ink.high}) {
    const DeviceStep at = this->at(corner);
    const auto x = static_cast<double>(at.x), y = static_cast<double>(at.y);
    beyond =
        std::max({beyond, window->low.x * steps_in_unit - x, x - window->high.x * steps_in_unit,
                  window->low.y * steps_in_unit - y, y - window->high.y * steps_in_unit});
  }
  if (beyond <= 0) return;
  const std::string wrong =
      fmt::format("lines reach {:.1f} mm beyond the window of the {}{}", beyond * device_.step_mm(),
                  device_.name, paper_ != nullptr ? " on " + paper_->name : "");
  if (paper_ != nullptr) throw UsageError(wrong, page_that_fits(*paper_, device_.unit_mm));
  const Vec2 reach = device_.unit_mm * window->high;
  throw UsageError(wrong, reach.x >= 1 && reach.y >= 1
                              ? fmt::format("`page` {:.0f}x{:.0f} fits", std::floor(reach.x),
                                            std::floor(reach.y))
                              : "give the device a window to the right of 0, 0 and above it");
}

Vec2 OnDevice::device_mm(Vec2 page_mm) const {
  const Vec2 low_mm{0.5 * (size_mm_.x - page_mm_.x), 0.5 * (size_mm_.y - page_mm_.y)};
  // From the page's corner of least x and greatest y: to the right and down.
  const Vec2 p = turned_ ? Vec2{page_mm.y, page_mm_.y - page_mm.x} : page_mm;
  const double up_mm = low_mm.y + (device_.y_up ? page_mm_.y - p.y : p.y);
  return {low_mm.x + p.x - origin_mm_.x, up_mm - origin_mm_.y};
}

DeviceStep OnDevice::at(Vec2 page_mm) const {
  const Vec2 p = device_mm(page_mm);
  const double step_mm = device_.step_mm();
  return {std::llround(p.x / step_mm), std::llround(p.y / step_mm)};
}

std::vector<DeviceStep> OnDevice::steps(std::span<const Vec2> page_mm) const {
  std::vector<DeviceStep> steps;
  steps.reserve(page_mm.size());
  for (const Vec2 p : page_mm) {
    const DeviceStep step = at(p);
    if (steps.empty() || step != steps.back()) steps.push_back(step);
  }
  return steps;
}

} // namespace orograph
