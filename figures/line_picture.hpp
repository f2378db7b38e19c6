// SPDX-License-Identifier: GPL-3.0-or-later
// A picture of straight lines in space, as a drawing on a small page.
#pragma once

#include "geometry/box.hpp"
#include "geometry/vec.hpp"

#include <Eigen/Core>

#include <string>
#include <vector>

namespace orograph {

/// From the faintest to the heaviest, in drawing order.
enum class LineOf { cut_away, turned_away, ray, volume, window, section, axis, house };
constexpr std::size_t kPens = 8;

/// A line on the picture plane, x to the right and y up.
struct PictureLine {
  Vec2 from, to;
  LineOf pen = LineOf::house;
  bool arrow = false; ///< with a head at its end
};

/// Where a matrix of the pipeline puts a point: x and y over w. REQUIRES w > 0 there.
Vec2 picture_of(const Eigen::Matrix4d& matrix, Vec3 p);

class LinePicture {
public:
  void add(const PictureLine& line) { lines_.push_back(line); }
  void add(const Eigen::Matrix4d& matrix, Vec3 from, Vec3 to, LineOf pen, bool arrow = false) {
    add({picture_of(matrix, from), picture_of(matrix, to), pen, arrow});
  }
  /// A dot.
  void mark(Vec2 place) { dots_.push_back(place); }

  /// The smallest box around all.
  Box2 box() const;
  /// Writes it as SVG, `window` of the picture plane as large as fits on the page, over an older
  /// file. Throws the Errors of write_drawing, and one if a line leaves the page.
  void write(const std::string& path, const std::string& title, const Box2& window) const;

private:
  std::vector<PictureLine> lines_;
  std::vector<Vec2> dots_;
};

} // namespace orograph
