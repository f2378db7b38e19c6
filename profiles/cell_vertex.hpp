// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace orograph {

/// A grid's vertex by its place among the others.
struct CellVertex {
  int column, row;
};

} // namespace orograph
