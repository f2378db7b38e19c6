// SPDX-License-Identifier: GPL-3.0-or-later
// A short way for a pen that has lines to draw.
#pragma once

#include "geometry/vec.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace orograph {

/// What a pen draws without being lifted: open lines, to be drawn from either end, and rings, from
/// any of their places to it again.
class PenLines {
public:
  void add_open(Vec2 begin, Vec2 end);
  /// REQUIRES a place at least.
  void add_ring(std::span<const Vec2> places);

  std::size_t size() const { return ends_.size(); }
  const std::vector<Vec2>& places() const { return places_; }
  Vec2 at(std::uint32_t place) const { return places_[place]; }
  std::uint32_t first_place(std::uint32_t line) const { return line == 0 ? 0 : ends_[line - 1]; }
  std::uint32_t end_place(std::uint32_t line) const { return ends_[line]; }
  std::uint32_t line_of(std::uint32_t place) const { return line_of_[place]; }
  bool is_ring(std::uint32_t line) const { return is_ring_[line]; }
  /// Where the pen leaves a line that it begins at `place`.
  std::uint32_t exit(std::uint32_t place) const;

private:
  void end_line(bool is_ring);

  std::vector<Vec2> places_;
  std::vector<std::uint32_t> ends_;    ///< of each line, among the places
  std::vector<std::uint32_t> line_of_; ///< each place
  std::vector<bool> is_ring_;
};

/// The place at which each line is begun, in the order in which they are drawn.
using PenRoute = std::vector<std::uint32_t>;

/// How far the pen goes between lines, from `pen` to the first and on to the last.
double way_mm(const PenLines& lines, Vec2 pen, const PenRoute& route);

/// From `pen` on, always to the nearest place of the lines that are left; of several to the first.
/// Cost about O(n log n) for n places.
PenRoute nearest_first(const PenLines& lines, Vec2 pen);

} // namespace orograph
