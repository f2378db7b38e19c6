// SPDX-License-Identifier: GPL-3.0-or-later
// Drawings from bytes, written and read back.
#include "draw/drawing.hpp"
#include "draw/round_drawing.hpp"
#include "tests/fuzz/bytes.hpp"
#include "tests/fuzz/scratch_file.hpp"
#include "tests/write/seen_gcode.hpp"
#include "tests/write/seen_hpgl.hpp"
#include "write/write_drawing.hpp"

#include <fmt/format.h>

#include <fstream>
#include <iterator>
#include <string>

namespace orograph {
namespace {

const Page kPage{300, 200, 0};

// Layers of strokes within the page, with places that often touch and often are a step apart.
Drawing drawing_of(Bytes& bytes) {
  Drawing drawing;
  drawing.page = kPage;
  for (int i = bytes.whole(0, 12); i > 0; --i) drawing.title += static_cast<char>(bytes.next());
  const int layers = bytes.whole(1, 3);
  for (int i = 0; i < layers; ++i) {
    Layer& layer = drawing.layers.emplace_back();
    layer.name = fmt::format("layer {}", i);
    layer.pen = Pen{.number = i + 1};
    for (int c = bytes.whole(0, 6); c > 0; --c) layer.pen->name += static_cast<char>(bytes.next());
    Vec2 at{bytes.next() * 1.0, bytes.next() * 0.7};
    const int strokes = bytes.whole(0, 12);
    for (int s = 0; s < strokes; ++s) {
      Stroke stroke;
      stroke.first_point = static_cast<std::uint32_t>(layer.page_mm.size());
      const int points = bytes.whole(2, 9);
      for (int p = 0; p < points; ++p) {
        const int kind = bytes.whole(0, 4);
        const double step = kind == 0 ? 0 : kind == 1 ? kPageStep_mm : kind == 2 ? 0.01 : 1;
        if (kind == 4) at = {bytes.next() * 1.17, bytes.next() * 0.78};
        at = at + step * Vec2{bytes.whole(-9, 9) * 1.0, bytes.whole(-9, 9) * 1.0};
        at = {rounded_to_page_step(std::clamp(at.x, 0.0, kPage.width_mm)),
              rounded_to_page_step(std::clamp(at.y, 0.0, kPage.height_mm))};
        layer.page_mm.push_back(at);
      }
      stroke.point_count = static_cast<std::uint32_t>(points);
      if (line_length_mm(layer.points(stroke)) > 0) layer.strokes.push_back(stroke);
    }
  }
  return drawing;
}

std::string written(const Drawing& drawing, const std::string& name, const WriteOptions& options) {
  const std::string path = scratch_folder() + "/" + name;
  WriteOptions with_overwrite = options;
  with_overwrite.overwrite = true;
  write_drawing(drawing, path, with_overwrite);
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

Vec2 with_y_up(Vec2 page_mm) {
  return {page_mm.x, kPage.height_mm - page_mm.y};
}

} // namespace

void fuzz_svg(FuzzBytes all) {
  Bytes bytes(all);
  const Drawing drawing = drawing_of(bytes);
  const std::string svg = written(drawing, "map.svg", {.format = Format::svg});
  std::size_t at = 0;
  const auto next_path = [&]() -> std::string {
    at = svg.find("d=\"M", at);
    if (at == svg.npos) return "";
    const std::size_t end = svg.find('"', at += 3);
    return svg.substr(at, end - at);
  };
  for (const Layer& layer : drawing.layers)
    for (const Stroke& stroke : layer.strokes) {
      std::string path;
      for (const Vec2 point : layer.points(stroke))
        path += fmt::format("{}{},{}",
                            path.empty()                  ? "M"
                            : path.find('L') == path.npos ? "L"
                                                          : " ",
                            point.x, point.y);
      expect(next_path() == path, "SVG has another path than " + path);
    }
  expect(next_path().empty(), "SVG has one path more");
  expect(svg.ends_with("</svg>\n"), "SVG has no end");
  // Of its text nothing but words and its own tags may be left.
  for (const char c : svg)
    expect(static_cast<unsigned char>(c) >= ' ' || c == '\n' || c == '\t' || c == '\r',
           "SVG holds a control character");
}

void fuzz_hpgl(FuzzBytes all) {
  Bytes bytes(all);
  Device device = read_device("generic");
  device.relative = bytes.whole(0, 1) == 1;
  device.longest = static_cast<std::size_t>(bytes.whole(40, 255));
  const Drawing drawing = drawing_of(bytes);
  const std::string hpgl = written(drawing, "map.hpgl", {.format = Format::hpgl, .device = device});
  const SeenHpgl seen = seen_hpgl(hpgl, device.unit_mm);
  const std::string fault =
      fault_of_moves(drawing, seen.moves, with_y_up, 0.5 * device.unit_mm + 1e-9);
  expect(fault.empty(), fault);
  expect(seen.longest <= device.longest, "an instruction too long");
}

void fuzz_gcode(FuzzBytes all) {
  Bytes bytes(all);
  const bool has_z = bytes.whole(0, 1) == 1;
  Device device = read_device(has_z ? "grbl-z" : "grbl-servo");
  device.decimals = bytes.whole(1, 4);
  Drawing drawing = drawing_of(bytes);
  // The reader counts pens as they are put in.
  std::erase_if(drawing.layers, [](const Layer& layer) { return layer.strokes.empty(); });
  for (std::size_t i = 0; i < drawing.layers.size(); ++i)
    drawing.layers[i].pen->number = static_cast<int>(i) + 1;
  const std::string gcode =
      written(drawing, "map.gcode", {.format = Format::gcode, .device = device});
  const SeenGcode seen =
      seen_gcode(gcode, [&](double z, double s) { return has_z ? z < 2 : s < 79; });
  expect(seen.fault.empty(), seen.fault);
  const std::string fault =
      fault_of_moves(drawing, seen.moves, with_y_up, 0.5 * device.step_mm() + 1e-9);
  expect(fault.empty(), fault);
  expect(seen.longest <= device.longest, "a line too long");
  expect(seen.ends_up, "the pen stays down");
}

} // namespace orograph
