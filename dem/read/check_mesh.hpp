// SPDX-License-Identifier: GPL-3.0-or-later
// What CGAL's mesh readers pass over: wrong counts, faces of many corners, numbers that are none.
#pragma once

#include <string>
#include <string_view>

namespace orograph {

/// Each throws Error, with the line where there are lines, if the file's text (`text`, all of it)
/// can't be triangles: it holds more or less than its counts say, a coordinate isn't a finite
/// number, a face hasn't three corners. They leave to the reader what it does check.
void check_off(std::string_view text, const std::string& path);
void check_obj(std::string_view text, const std::string& path);
void check_stl(std::string_view text, const std::string& path);
void check_ply(std::string_view text, const std::string& path);

/// Text or binary: the first five letters alone don't tell.
bool is_binary_stl(std::string_view text);

/// The advice for faces that aren't triangles.
extern const char* const triangulate_faces;

} // namespace orograph
