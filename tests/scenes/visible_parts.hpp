// SPDX-License-Identifier: GPL-3.0-or-later
// What is visible of a view before anything is laid out, and whether two drawings of one view show
// the same.
#pragma once

#include "hidden_lines/instruments.hpp"
#include "map/check.hpp"
#include "placing/placed_view.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace orograph {

/// A line, or a span of a profile, and what is seen of it: places along it, begin and end in turn,
/// rising.
struct SeenOfLine {
  std::size_t sector;
  ProfileLine whole;
  bool is_edge;
  std::vector<double> seen;
};

/// Keeps all that it is shown.
class VisibleParts : public LineObserver {
public:
  explicit VisibleParts(const PlacedView& placed) : placed_(placed) {}
  void see(const SeenProfile& seen) override;
  void see(const SeenLines& seen) override;

  std::vector<SeenOfLine> lines;

private:
  std::size_t number_of(const Sector& sector) const {
    return static_cast<std::size_t>(&sector - placed_.sectors.data());
  }
  const PlacedView& placed_;
};

struct VisibleDifference {
  std::size_t stretches = 0; ///< longer than 1e-9 mm that only one of the two shows
  std::size_t tied = 0;      ///< of these, those that the ray walk calls tied
  std::string first_wrong;   ///< of the others
  std::size_t wrong() const { return stretches - tied; }
};

/// REQUIRES the same lines in the same order, of one view.
VisibleDifference difference(const VisibleParts& a, const VisibleParts& b, const PlacedView& placed,
                             const std::vector<Judge>& judges);

} // namespace orograph
