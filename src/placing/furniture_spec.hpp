// SPDX-License-Identifier: GPL-3.0-or-later
// What stands around a picture, on its page.
#pragma once

#include <string>
#include <vector>

namespace orograph {

/// Pieces of furniture, in the order in which they are listed.
enum class Furniture {
  title,
  subtitle,
  neatline,  ///< around the picture
  north,     ///< an arrow, as the view has it at the picture's middle
  scale,     ///< a bar in parallel views, else the scale at the picture's middle
  caption,   ///< view, exaggeration, curvature
  source,    ///< of the data, and the date
  azimuths,  ///< of a panorama: a scale under each strip
  altitudes, ///< of a panorama: a scale to the left of each strip, with the dip of the horizon
  viewpoint  ///< coordinates and height of the eye
};

/// Sizes are letters' ems.
struct FurnitureSpec {
  std::vector<Furniture> pieces;      ///< none: the picture has all of the page
  std::string subtitle, source, date; ///< printed as they are; empty: left out
  double title_mm = 6, subtitle_mm = 3.6, text_mm = 2.5;
  double gap_mm = 2.5; ///< between pieces, and between them and the picture

  bool any() const { return !pieces.empty(); }
  bool has(Furniture piece) const {
    for (const Furniture one : pieces)
      if (one == piece) return true;
    return false;
  }
};

} // namespace orograph
