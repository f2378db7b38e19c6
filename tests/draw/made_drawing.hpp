// SPDX-License-Identifier: GPL-3.0-or-later
// Drawings and folders for the tests of writing.
#pragma once

#include "draw/drawing.hpp"

#include <cstddef>
#include <filesystem>
#include <initializer_list>
#include <string>
#include <vector>

namespace orograph {

/// A folder that goes with what is in it.
class TemporaryFolder {
public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  std::string file(const std::string& name) const { return (path_ / name).string(); }
  /// Sorted names of all that is in it.
  std::vector<std::string> names() const;

private:
  std::filesystem::path path_;
};

std::string content_of(const std::string& path);
void fill_file(const std::string& path, const std::string& content);

Layer empty_layer(const std::string& name, double pen_width_mm = 0.15, double grey = 0);

/// Appends a stroke, without map points.
void add_stroke(Layer& layer, std::initializer_list<Vec2> page_mm, int profile = -1);

/// Two layers of waves, black and grey, with map points in UTM zone 32: sound by `find_fault`.
Drawing made_drawing(int strokes = 40, int points_in_stroke = 30);

} // namespace orograph
