// SPDX-License-Identifier: GPL-3.0-or-later
#include "figures/line_picture.hpp"

#include "draw/drawing.hpp"
#include "draw/round_drawing.hpp"
#include "geometry/error.hpp"
#include "view/pipeline.hpp"
#include "write/write_drawing.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace orograph {
namespace {

struct Ink {
  const char* name;
  double pen_width_mm, grey;
};
// In the order of LineOf.
constexpr std::array<Ink, kPens> kInks{{{"cut-away", 0.16, 0.62},
                                        {"turned-away", 0.14, 0.45},
                                        {"rays", 0.14, 0.5},
                                        {"volume", 0.22, 0.45},
                                        {"window", 0.3, 0.3},
                                        {"section", 0.24, 0},
                                        {"axes", 0.24, 0},
                                        {"house", 0.38, 0}}};

constexpr Page kPage{80, 61, 1};
constexpr Box2 kPicture_mm{{2, 2}, {78, 59}}; // dots and arrowheads reach out of it
constexpr double kHead_mm = 1.8, kHeadHalfWidth_mm = 0.55, kDot_mm = 0.35;

void add_stroke(Layer& layer, std::initializer_list<Vec2> points) {
  layer.strokes.push_back({static_cast<std::uint32_t>(layer.page_mm.size()),
                           static_cast<std::uint32_t>(points.size())});
  layer.page_mm.insert(layer.page_mm.end(), points);
}

void add_head(Layer& layer, Vec2 from, Vec2 tip) {
  const double whole_mm = length(tip - from);
  if (whole_mm < kHead_mm) return; // seen end on
  const Vec2 back = (kHead_mm / whole_mm) * (from - tip);
  const Vec2 aside = (kHeadHalfWidth_mm / kHead_mm) * Vec2{-back.y, back.x};
  add_stroke(layer, {tip + back + aside, tip, tip + back - aside});
}

// The window and more around it, in the proportions of `kPicture_mm`.
Box2 widened(const Box2& window) {
  const double scale =
      std::max(window.width() / kPicture_mm.width(), window.height() / kPicture_mm.height());
  const Vec2 half = (scale / 2) * Vec2{kPicture_mm.width(), kPicture_mm.height()};
  return {window.centre() - half, window.centre() + half};
}

} // namespace

Vec2 picture_of(const Eigen::Matrix4d& matrix, Vec3 p) {
  const Eigen::Vector4d image = matrix * Eigen::Vector4d(p.x, p.y, p.z, 1);
  return {image.x() / image.w(), image.y() / image.w()};
}

Box2 LinePicture::box() const {
  Box2 all;
  for (const PictureLine& line : lines_) {
    all.include(line.from);
    all.include(line.to);
  }
  for (const Vec2 dot : dots_) all.include(dot);
  return all;
}

void LinePicture::write(const std::string& path, const std::string& title,
                        const Box2& window) const {
  Drawing drawing;
  drawing.page = kPage;
  drawing.title = title;
  for (const Ink& ink : kInks) {
    Layer& layer = drawing.layers.emplace_back();
    layer.name = ink.name;
    layer.pen_width_mm = ink.pen_width_mm;
    layer.grey = ink.grey;
  }
  const Eigen::Matrix4d to_page = workstation_transformation(widened(window), kPicture_mm);
  const auto page_mm = [&](Vec2 p) { return picture_of(to_page, {p.x, p.y, 0}); };
  for (const PictureLine& line : lines_) {
    Layer& layer = drawing.layers[static_cast<std::size_t>(line.pen)];
    const Vec2 from = page_mm(line.from), to = page_mm(line.to);
    add_stroke(layer, {from, to});
    if (line.arrow) add_head(layer, from, to);
  }
  for (const Vec2 dot : dots_) {
    const Vec2 at = page_mm(dot), across{kDot_mm, 0}, upward{0, kDot_mm};
    add_stroke(drawing.layers[static_cast<std::size_t>(LineOf::house)],
               {at - across, at - upward, at + across, at + upward, at - across});
  }
  for (Layer& layer : drawing.layers) round_to_page_step(layer);
  std::erase_if(drawing.layers, [](const Layer& layer) { return layer.strokes.empty(); });
  if (const auto fault = find_fault(drawing)) throw Error(path + " would be no drawing", *fault);
  write_drawing(drawing, path, {.format = Format::svg, .overwrite = true});
}

} // namespace orograph
