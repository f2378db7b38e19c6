// SPDX-License-Identifier: GPL-3.0-or-later
#include "draw/pen_route.hpp"

#include "draw/point_tree.hpp"
#include "geometry/on_all_cores.hpp"

namespace orograph {

void PenLines::end_line(bool is_ring) {
  line_of_.resize(places_.size(), static_cast<std::uint32_t>(ends_.size()));
  ends_.push_back(static_cast<std::uint32_t>(places_.size()));
  is_ring_.push_back(is_ring);
}

void PenLines::add_open(Vec2 begin, Vec2 end) {
  places_.push_back(begin);
  places_.push_back(end);
  end_line(false);
}

void PenLines::add_ring(std::span<const Vec2> places) {
  places_.insert(places_.end(), places.begin(), places.end());
  end_line(true);
}

std::uint32_t PenLines::exit(std::uint32_t place) const {
  const std::uint32_t line = line_of_[place];
  return is_ring_[line] ? place : first_place(line) + end_place(line) - 1 - place;
}

double way_mm(const PenLines& lines, Vec2 pen, const PenRoute& route) {
  double sum = 0;
  for (const std::uint32_t place : route) {
    sum += plain_length(lines.at(place) - pen);
    pen = lines.at(lines.exit(place));
  }
  return sum;
}

PenRoute nearest_first(const PenLines& lines, Vec2 pen) {
  PointTree left(lines.places());
  PenRoute route;
  route.reserve(lines.size());
  for (auto place = left.nearest(pen); place; place = left.nearest_to_point(lines.exit(*place))) {
    throw_if_stopped(route.size());
    route.push_back(*place);
    const std::uint32_t line = lines.line_of(*place);
    for (std::uint32_t p = lines.first_place(line); p < lines.end_place(line); ++p) left.remove(p);
  }
  return route;
}

} // namespace orograph
