// SPDX-License-Identifier: GPL-3.0-or-later
// SVG: well-formed, in millimetres, strokes only.
#include "draw/round_drawing.hpp"
#include "tests/catch.hpp"
#include "tests/draw/made_drawing.hpp"
#include "tests/support/random.hpp"
#include "write/write_drawing.hpp"

#include <cpl_minixml.h>
#include <fmt/format.h>
#include <tbb/global_control.h>

#include <string>

using namespace orograph;

namespace {

std::string svg_of(const Drawing& drawing) {
  const TemporaryFolder folder;
  write_drawing(drawing, folder.file("map.svg"), {.format = Format::svg});
  return content_of(folder.file("map.svg"));
}

Drawing small_drawing() {
  Drawing drawing;
  drawing.page = {148, 210.5, 7};
  drawing.layers = {empty_layer("border", 0.25, 0.5), empty_layer("profiles")};
  add_stroke(drawing.layers[0], {{10, 20.5}, {10.1234, 20.05}, {100, 7}});
  add_stroke(drawing.layers[1], {{0.0001, 0}, {140, 203.5}});
  add_stroke(drawing.layers[1], {{8, 8}, {9, 9}});
  return drawing;
}

} // namespace

TEST_CASE("the whole of a small SVG") {
  CHECK(svg_of(small_drawing()) ==
        R"(<?xml version="1.0" encoding="UTF-8"?>
<svg xmlns="http://www.w3.org/2000/svg" xmlns:inkscape="http://www.inkscape.org/namespaces/inkscape" version="1.1" width="148mm" height="210.5mm" viewBox="0 0 148 210.5">
<title></title>
<desc></desc>
<g id="layer1" inkscape:groupmode="layer" inkscape:label="1 border" fill="none" stroke="#808080" stroke-width="0.25" style="fill:none;stroke:#808080;stroke-width:0.25;stroke-linecap:round;stroke-linejoin:round">
<path d="M10,20.5L10.1234,20.05 100,7"/>
</g>
<g id="layer2" inkscape:groupmode="layer" inkscape:label="2 profiles" fill="none" stroke="#000000" stroke-width="0.15" style="fill:none;stroke:#000000;stroke-width:0.15;stroke-linecap:round;stroke-linejoin:round">
<path d="M0.0001,0L140,203.5"/>
<path d="M8,8L9,9"/>
</g>
</svg>
)");
}

TEST_CASE("title, description and layer names stay text, whatever is in them") {
  Drawing drawing = small_drawing();
  drawing.title = "</title><script>\"Höhe\" & 山 \xFF\x01";
  drawing.description = "a > b ]]> <!--";
  drawing.layers[0].name = "\"><x y=\"";
  const std::string svg = svg_of(drawing);
  CPLXMLNode* const root = CPLParseXMLString(svg.c_str());
  REQUIRE(root != nullptr);
  CHECK(std::string(CPLGetXMLValue(root, "=svg.title", "")) ==
        "</title><script>\"Höhe\" & 山 \xEF\xBF\xBD\xEF\xBF\xBD");
  CHECK(std::string(CPLGetXMLValue(root, "=svg.desc", "")) == "a > b ]]> <!--");
  CHECK(std::string(CPLGetXMLValue(root, "=svg.g.inkscape:label", "")) == "1 \"><x y=\"");
  CPLDestroyXMLNode(root);
}

TEST_CASE("an SVG of many texts has every stroke once and in order, however many cores print it") {
  // Strokes of few and of very many points, in several layers.
  Drawing drawing = small_drawing();
  Random random(5);
  for (Layer& layer : drawing.layers)
    for (int s = 0; s < 400; ++s) {
      Stroke stroke;
      stroke.first_point = static_cast<std::uint32_t>(layer.page_mm.size());
      stroke.point_count = static_cast<std::uint32_t>(s == 7 ? 40000 : random.whole(2, 400));
      for (std::uint32_t i = 0; i < stroke.point_count; ++i)
        layer.page_mm.push_back({rounded_to_page_step(random.between(7, 141)),
                                 rounded_to_page_step(random.between(7, 203))});
      layer.strokes.push_back(stroke);
    }
  std::string paths;
  for (const Layer& layer : drawing.layers)
    for (const Stroke& stroke : layer.strokes) {
      const auto points = layer.points(stroke);
      for (std::size_t i = 0; i < points.size(); ++i)
        paths += fmt::format("{}{},{}",
                             i == 0   ? "M"
                             : i == 1 ? "L"
                                      : " ",
                             points[i].x, points[i].y);
      paths += '\n';
    }
  const std::string svg = svg_of(drawing);
  std::string found;
  for (std::size_t at = 0; (at = svg.find("d=\"M", at)) != svg.npos;) {
    const std::size_t end = svg.find('"', at += 3);
    found += svg.substr(at, end - at) + '\n';
  }
  CHECK(found == paths);
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  CHECK(svg_of(drawing) == svg);
}
