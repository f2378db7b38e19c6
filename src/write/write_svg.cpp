// SPDX-License-Identifier: GPL-3.0-or-later
// SVG: one user unit is one millimetre; one Inkscape layer for each layer, one path for each
// stroke.
#include "geometry/on_all_cores.hpp"
#include "write/format_text.hpp"
#include "write/writers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string>
#include <vector>

namespace orograph {
namespace {

std::string header(const Drawing& drawing) {
  const std::string width = page_number(drawing.page.width_mm);
  const std::string height = page_number(drawing.page.height_mm);
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

// At its default resolution, of one percent of its speed.
constexpr double kAxiDrawSpeed_mm_s = 8.6979 * 25.4 / 110;

// AxiDraw's layer control: the number that stands first is what plotters sort layers by, then speed
// and height of the pen in percent. A % in front has the layer not drawn, a ! has the plotter wait.
std::string label_of(const Layer& layer, std::size_t number) {
  if (!layer.pen) return fmt::format("{}{} {}", layer.is_pen_way ? "%" : "", number, layer.name);
  const Pen& pen = *layer.pen;
  std::string label = fmt::format("{}{}", pen.waits ? "!" : "", pen.number);
  if (pen.speed_mm_s)
    label += fmt::format("+S{}",
                         std::clamp(std::lround(*pen.speed_mm_s / kAxiDrawSpeed_mm_s), 1L, 110L));
  if (pen.height_percent) label += fmt::format("+H{}", std::lround(*pen.height_percent));
  return label + " " + layer.name;
}

// Ink stands both as
// attributes and as style, since some readers know only one of them.
std::string layer_start(const Layer& layer, std::size_t number) {
  const std::string colour = hex_colour(layer);
  const std::string width = page_number(layer.pen_width_mm);
  return fmt::format("<g id=\"layer{0}\" inkscape:groupmode=\"layer\" inkscape:label=\"{1}\" "
                     "fill=\"none\" stroke=\"{2}\" stroke-width=\"{3}\" "
                     "style=\"fill:none;stroke:{2};stroke-width:{3};"
                     "stroke-linecap:round;stroke-linejoin:round\">\n",
                     number, xml_escaped(label_of(layer, number)), colour, width);
}

// Texts of up to so many points are made side by side.
constexpr std::size_t kPointsOfText = 1 << 14;
constexpr std::size_t kTextsAtOnce = 8;

// The strokes from `first` on that make one text.
std::span<const Stroke> strokes_of_text(const Layer& layer, std::size_t first) {
  std::size_t end = first, points = 0;
  while (end < layer.strokes.size() && (end == first || points < kPointsOfText))
    points += layer.strokes[end++].point_count;
  return std::span(layer.strokes).subspan(first, end - first);
}

// In whole thousandths of a millimetre, where widths are tenths of each other, and as short as may
// be: on a page of 20,000 strokes every character is 20 kB.
void append_width(std::string& text, double width_mm) {
  constexpr double kSteps_a_mm = 1000;
  std::array<char, kPageNumberBytes> buffer;
  const char* const end = print_page_number(
      std::max(std::round(width_mm * kSteps_a_mm), 1.0) / kSteps_a_mm, buffer.data());
  const char* const begin = buffer.data() + (buffer[0] == '0' ? 1 : 0);
  text.append(begin, end);
}

void append_path(std::string& text, std::span<const Vec2> points, double width_mm) {
  std::array<char, 4096> buffer;
  constexpr std::size_t kPointBytes = 2 * kPageNumberBytes + 2;
  char* at = buffer.data();
  char command = 'M';
  text += "<path d=\"";
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (buffer.data() + buffer.size() - at < static_cast<std::ptrdiff_t>(kPointBytes)) {
      text.append(buffer.data(), at);
      at = buffer.data();
    }
    *at++ = i < 2 ? command : ' ';
    command = 'L';
    at = print_page_number(points[i].x, at);
    *at++ = ',';
    at = print_page_number(points[i].y, at);
  }
  text.append(buffer.data(), at);
  text += "\"";
  if (width_mm > 0) { // else the layer's
    text += " class=\"lit\" stroke-width=\"";
    append_width(text, width_mm);
    text += "\"";
  }
  text += "/>\n";
}

std::string text_of(std::span<const Stroke> strokes, const Layer& layer) {
  std::string text;
  for (const Stroke& stroke : strokes) append_path(text, layer.points(stroke), stroke.width_mm);
  return text;
}

// On all cores, and out in order. False once the sink takes no more: it remembers why.
bool write_strokes(const Layer& layer, ByteSink& out) {
  const std::span<const Stroke> first = strokes_of_text(layer, 0);
  if (first.size() == layer.strokes.size()) return out.append(text_of(first, layer));
  std::array<std::string, kTextsAtOnce> texts;
  for (std::size_t taken = 0; taken < layer.strokes.size();) {
    std::vector<std::span<const Stroke>> of_texts;
    while (of_texts.size() < kTextsAtOnce && taken < layer.strokes.size()) {
      of_texts.push_back(strokes_of_text(layer, taken));
      taken += of_texts.back().size();
    }
    on_all_cores(of_texts.size(), [&](std::size_t k) { texts[k] = text_of(of_texts[k], layer); });
    for (std::size_t k = 0; k < of_texts.size(); ++k)
      if (!out.append(texts[k])) return false;
  }
  return true;
}

// Its fill stands as an attribute and as style, as a layer's ink does. Lines of Arabic or Hebrew
// begin on the right.
std::string text_element(const PageText& text, const Layer& layer) {
  const std::string x = page_number(text.at_mm.x), y = page_number(text.at_mm.y);
  std::string element =
      fmt::format("<text x=\"{}\" y=\"{}\" font-size=\"{}\"", x, y, page_number(text.size_mm));
  const bool ends =
      text.runs_leftwards ? text.anchor == TextAnchor::start : text.anchor == TextAnchor::end;
  if (text.runs_leftwards) element += " direction=\"rtl\"";
  if (text.anchor == TextAnchor::middle)
    element += " text-anchor=\"middle\"";
  else if (ends)
    element += " text-anchor=\"end\"";
  if (text.is_bold) element += " font-weight=\"bold\"";
  if (text.is_italic) element += " font-style=\"italic\"";
  if (text.angle != Angle())
    element +=
        fmt::format(" transform=\"rotate({} {} {})\"", page_number(-text.angle.in_degrees()), x, y);
  const std::string colour = hex_colour(layer);
  return element + fmt::format(" xml:space=\"preserve\" fill=\"{0}\" stroke=\"none\" "
                               "style=\"fill:{0};stroke:none\">{1}</text>\n",
                               colour, xml_escaped(text.text));
}

bool write_texts(const Layer& layer, const LetterSpec& letters, ByteSink& out) {
  if (layer.texts.empty()) return true;
  out.append(
      fmt::format("<g font-family=\"{0}, sans-serif\" style=\"font-family:'{0}',sans-serif\">\n",
                  xml_escaped(letters.family)));
  for (const PageText& text : layer.texts)
    if (!text.text.empty() && !out.append(text_element(text, layer))) return false;
  return out.append("</g>\n");
}

} // namespace

void write_svg(const Drawing& drawing, ByteSink& out) {
  out.append(header(drawing));
  for (std::size_t i = 0; i < drawing.layers.size(); ++i) {
    out.append(layer_start(drawing.layers[i], i + 1));
    if (!write_strokes(drawing.layers[i], out)) return;
    if (!write_texts(drawing.layers[i], drawing.letters, out)) return;
    out.append("</g>\n");
  }
  out.append("</svg>\n");
}

} // namespace orograph
