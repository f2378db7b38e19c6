// SPDX-License-Identifier: GPL-3.0-or-later
// Which features of a vector file an overlay is made of.
#pragma once

#include <string>

namespace orograph {

struct OverlayInput {
  std::string path = {};
  std::string layer = {}; ///< empty: the only one
  std::string where = {}; ///< empty: all; else as SQL has it behind WHERE
  /// Features beside the terrain too, and those without a place: each is there, in the file's
  /// order.
  bool everywhere = false;
  bool allow_network = false; ///< as in ReadOptions
};

} // namespace orograph
