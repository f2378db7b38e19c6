// SPDX-License-Identifier: GPL-3.0-or-later
// Whether a place on a line of a sheet with two sides is drawn as it is seen, by the walk.
#pragma once

#include "horizon/compare.hpp"
#include "profiles/slab_lines.hpp"
#include "reference/sheet_walk.hpp"

namespace orograph {

class SheetJudge {
public:
  /// REQUIRES that surface and view outlive it.
  SheetJudge(const Surface& surface, const View& view, const TieTolerance& tolerance)
      : walk_(surface, view), view_(&view), tolerance_(tolerance) {}
  /// From now on it judges another view of the same surface.
  void set_view(const View& view, const TieTolerance& tolerance);

  /// What a line lies on, and as what a place of it is drawn; an edge as both.
  struct Drawn {
    bool is_on_upper_alone;
    bool as_upper, as_underside;
  };
  enum class Verdict { right, drawn_wrong, missing, unsure };
  struct Answer {
    Verdict verdict;
    SheetWalk::Sight sight;
  };
  /// Of the place at share t. Unsure as well where it is otherwise a little to either side, and of
  /// views that see the sheet straight from above or below.
  Answer ask(const ProfileLine& line, double t, const Drawn& drawn) const;

private:
  SheetWalk walk_;
  const View* view_;
  TieTolerance tolerance_;
};

} // namespace orograph
