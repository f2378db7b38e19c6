// SPDX-License-Identifier: GPL-3.0-or-later
// Where a drawing lies in a device.
#pragma once

#include "draw/drawing.hpp"
#include "write/device.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace orograph {

/// A point in steps of a device's coordinates.
struct DeviceStep {
  std::int64_t x = 0, y = 0;

  bool operator==(const DeviceStep&) const = default;
};

/// From the page to a device, which it borrows.
class OnDevice {
public:
  /// The page lies in the middle of the smallest paper that holds it, turned where that is how it
  /// fits; in a device without papers with its corner at 0, 0. Throws UsageError where no paper
  /// holds it, and where ink lies outside of the window, and then says which page or margin would
  /// do.
  OnDevice(const Drawing& drawing, const Device& device);

  DeviceStep at(Vec2 page_mm) const;
  /// As a pen draws them: points on one step are one. One at least.
  std::vector<DeviceStep> steps(std::span<const Vec2> page_mm) const;
  /// None: a device without papers.
  const DevicePaper* paper() const { return paper_; }

private:
  void choose_paper(const Page& page);
  void check_window(const Drawing& drawing) const;
  Vec2 device_mm(Vec2 page_mm) const;

  const Device& device_;
  const DevicePaper* paper_ = nullptr;
  bool turned_ = false; ///< by a quarter: the page's right is up
  Vec2 size_mm_;        ///< of the paper, or the page
  Vec2 page_mm_;        ///< size as it lies
  Vec2 origin_mm_;
};

} // namespace orograph
