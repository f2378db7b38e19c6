// SPDX-License-Identifier: GPL-3.0-or-later
// SVG: one user unit is one millimetre; one Inkscape layer for each layer, one path for each
// stroke.
#include "draw/writers.hpp"
#include "draw/xml_text.hpp"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>

namespace orograph {
namespace {

// Page coordinates reach five digits before the point; a hostile drawing's may reach 309.
using Number = std::array<char, 320>;

// With 4 decimals, trailing zeros trimmed.
std::string_view printed(double value_mm, Number& buffer) {
  char* end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value_mm,
                            std::chars_format::fixed, 4)
                  .ptr;
  while (end[-1] == '0') --end;
  if (end[-1] == '.') --end;
  return {buffer.data(), end};
}

std::string printed(double value_mm) {
  Number buffer;
  return std::string(printed(value_mm, buffer));
}

std::string header(const Drawing& drawing) {
  const std::string width = printed(drawing.page.width_mm);
  const std::string height = printed(drawing.page.height_mm);
  std::string text =
      fmt::format("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
                  "<svg xmlns=\"http://www.w3.org/2000/svg\" "
                  "xmlns:inkscape=\"http://www.inkscape.org/namespaces/inkscape\" version=\"1.1\" "
                  "width=\"{0}mm\" height=\"{1}mm\" viewBox=\"0 0 {0} {1}\">\n",
                  width, height);
  text += "<title>" + xml_escaped(drawing.title) + "</title>\n";
  text += "<desc>" + xml_escaped(drawing.description) + "</desc>\n";
  return text;
}

// The number in front of the name is what pen plotters sort layers by. Ink stands both as
// attributes and as style, since some readers know only one of them.
std::string layer_start(const Layer& layer, std::size_t number) {
  const int level = static_cast<int>(std::lround(255 * layer.grey));
  const std::string colour = fmt::format("#{0:02x}{0:02x}{0:02x}", level);
  const std::string width = printed(layer.pen_width_mm);
  return fmt::format("<g id=\"layer{0}\" inkscape:groupmode=\"layer\" inkscape:label=\"{0} {1}\" "
                     "fill=\"none\" stroke=\"{2}\" stroke-width=\"{3}\" "
                     "style=\"fill:none;stroke:{2};stroke-width:{3};"
                     "stroke-linecap:round;stroke-linejoin:round\">\n",
                     number, xml_escaped(layer.name), colour, width);
}

void append_path(std::string& text, std::span<const Vec2> points) {
  Number buffer;
  char command = 'M';
  text += "<path d=\"";
  for (std::size_t i = 0; i < points.size(); ++i) {
    text += i < 2 ? command : ' ';
    command = 'L';
    text += printed(points[i].x, buffer);
    text += ',';
    text += printed(points[i].y, buffer);
  }
  text += "\"/>\n";
}

} // namespace

void write_svg(const Drawing& drawing, ByteSink& out) {
  out.append(header(drawing));
  std::string text;
  for (std::size_t i = 0; i < drawing.layers.size(); ++i) {
    const Layer& layer = drawing.layers[i];
    out.append(layer_start(layer, i + 1));
    for (const Stroke& stroke : layer.strokes) {
      text.clear();
      append_path(text, layer.points(stroke));
      if (!out.append(text)) return; // the sink remembers why
    }
    out.append("</g>\n");
  }
  out.append("</svg>\n");
}

} // namespace orograph
