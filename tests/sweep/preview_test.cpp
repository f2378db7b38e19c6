// SPDX-License-Identifier: GPL-3.0-or-later
// Drawings in small, read back.
#include "cli/sweep/page.hpp"
#include "draw/preview.hpp"
#include "tests/catch.hpp"
#include "tests/support/random.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

using namespace orograph;

namespace {

using Lines = std::vector<std::vector<Vec2>>;

// Path data of relative moves and lines in tenths of a millimetre, by the grammar of SVG.
Lines parsed(const std::string& path) {
  Lines lines;
  Vec2 at;
  char command = 0;
  const char* c = path.c_str();
  while (*c != 0) {
    if (std::isalpha(static_cast<unsigned char>(*c)) != 0) command = *c++;
    REQUIRE((command == 'm' || command == 'l'));
    double step[2] = {};
    for (double& number : step) {
      char* end = nullptr;
      number = static_cast<double>(std::strtol(c, &end, 10));
      REQUIRE(end != c);
      c = end;
    }
    at = at + Vec2{0.1 * step[0], 0.1 * step[1]};
    if (command == 'm') {
      lines.emplace_back();
      command = 'l'; // what follows a move without a letter is a line
    }
    lines.back().push_back(at);
  }
  return lines;
}

double distance(Vec2 p, Vec2 a, Vec2 b) {
  const Vec2 along = b - a;
  const double square = dot(along, along);
  const double t = square > 0 ? std::clamp(dot(p - a, along) / square, 0.0, 1.0) : 0;
  return length(p - (a + t * along));
}

double distance(Vec2 p, const Lines& lines) {
  double least = std::numeric_limits<double>::infinity();
  for (const auto& line : lines)
    for (std::size_t i = 1; i < line.size(); ++i)
      least = std::min(least, distance(p, line[i - 1], line[i]));
  return least;
}

Lines strokes_of(const Layer& layer) {
  Lines lines;
  for (const Stroke& stroke : layer.strokes) {
    const auto points = layer.points(stroke);
    lines.emplace_back(points.begin(), points.end());
  }
  return lines;
}

Layer layer_called(const std::string& name, double grey = 0) {
  Layer layer;
  layer.name = name;
  layer.grey = grey;
  return layer;
}

// Profiles: waves, from below to above; other layers: `silhouettes` of random walks.
Drawing random_drawing(Random& random, int profiles, int walks, int points) {
  Drawing drawing;
  drawing.page = {200, 150, 5};
  const auto add = [&](Layer& layer, const std::vector<Vec2>& line, int profile) {
    layer.strokes.push_back({static_cast<std::uint32_t>(layer.page_mm.size()),
                             static_cast<std::uint32_t>(line.size()), profile});
    layer.page_mm.insert(layer.page_mm.end(), line.begin(), line.end());
  };
  Layer waves = layer_called("profiles"), others = layer_called("silhouettes", 0.5);
  for (int p = 0; p < profiles; ++p) {
    std::vector<Vec2> line;
    for (int i = 0; i < points; ++i)
      line.push_back({10 + 180.0 * i / points,
                      140 - 130.0 * p / profiles + 3 * std::sin(0.37 * i + p) + random.share()});
    add(waves, line, 3 * p); // not all profiles have strokes
  }
  for (int w = 0; w < walks; ++w) {
    std::vector<Vec2> line{{random.between(10, 190), random.between(10, 140)}};
    for (int i = 1; i < points; ++i) {
      const Vec2 next = line.back() + Vec2{random.between(-2, 2), random.between(-2, 2)};
      line.push_back({std::clamp(next.x, 5.0, 195.0), std::clamp(next.y, 5.0, 145.0)});
    }
    add(others, line, -1);
  }
  others.colour = Colour{0x12, 0xab, 0};
  drawing.layers = {waves, others, layer_called("border")};
  return drawing;
}

std::size_t bytes_of(const Preview& preview) {
  std::size_t bytes = 0;
  for (const PreviewLayer& layer : preview.layers) bytes += layer.path.size();
  return bytes;
}

} // namespace

TEST_CASE("a small drawing is whole in its preview, within a pixel") {
  Random random(10);
  constexpr double kTolerance_mm = 0.12 + 0.0708; // simplified, then rounded to tenths
  for (int i = 0; i < 30; ++i) {
    const Drawing drawing =
        random_drawing(random, random.whole(0, 20), random.whole(0, 4), random.whole(2, 60));
    const Preview preview = preview_of(drawing);
    CHECK(preview.width_mm == 200);
    CHECK(preview.height_mm == 150);
    std::size_t at = 0;
    for (const Layer& layer : drawing.layers) {
      if (layer.strokes.empty()) continue;
      REQUIRE(at < preview.layers.size());
      const PreviewLayer& small = preview.layers[at++];
      CHECK(small.name == layer.name);
      CHECK(small.grey == layer.grey);
      CHECK(small.colour == (layer.colour ? "#12ab00" : ""));
      CHECK(small.pen_mm == layer.pen_width_mm);
      const Lines drawn = strokes_of(layer), read = parsed(small.path);
      CHECK(read.size() == drawn.size());
      double off = 0, missing = 0;
      for (const auto& line : read)
        for (const Vec2 p : line) off = std::max(off, distance(p, drawn));
      for (const auto& line : drawn)
        for (const Vec2 p : line) missing = std::max(missing, distance(p, read));
      CHECK(off < kTolerance_mm);
      CHECK(missing < kTolerance_mm);
    }
    CHECK(at == preview.layers.size()); // empty layers are left out
  }
}

TEST_CASE("however large a drawing is, its preview isn't") {
  Random random(11);
  for (const auto& [profiles, walks, points] :
       {std::tuple{300, 0, 300}, {0, 400, 100}, {2, 0, 60000}, {1000, 300, 20}, {0, 20000, 2}}) {
    const Drawing drawing = random_drawing(random, profiles, walks, points);
    const Preview preview = preview_of(drawing);
    const std::size_t bytes = bytes_of(preview);
    INFO(profiles << " profiles, " << walks << " walks of " << points << ": " << bytes);
    CHECK(bytes <= 30000);
    CHECK(bytes > 4000);
    for (const PreviewLayer& layer : preview.layers)
      for (const auto& line : parsed(layer.path))
        for (const Vec2 p : line) {
          REQUIRE((p.x > 4.9 && p.x < 195.1));
          REQUIRE((p.y > 4.9 && p.y < 145.1));
        }
  }
}

TEST_CASE("every so many profiles are in a preview, and all other lines") {
  Random random(12);
  const Drawing drawing = random_drawing(random, 200, 1, 12);
  const Preview preview = preview_of(drawing);
  REQUIRE(preview.layers.size() == 2);
  const std::size_t kept = parsed(preview.layers[0].path).size();
  CHECK(kept <= 80);
  CHECK(kept >= 50);
  CHECK(parsed(preview.layers[1].path).size() == 1);
}

TEST_CASE("of profiles with levels the high ones are in a preview, and runs of a line are one") {
  Drawing drawing;
  Layer layer = layer_called("profiles");
  for (std::int32_t number = 0; number < 200; ++number) {
    const double y = 10 + 0.6 * number;
    const auto first = static_cast<std::uint32_t>(layer.page_mm.size());
    // Two runs of 0.5 mm would be left out one by one.
    layer.page_mm.insert(layer.page_mm.end(), {{10, y}, {10.5, y}, {10.5, y}, {11, y}});
    for (const std::uint32_t run : {0U, 2U}) {
      Stroke stroke{first + run, 2, number};
      stroke.level = number % 4 == 3 ? 2 : number % 2; // every fourth is the last to go
      layer.strokes.push_back(stroke);
    }
  }
  drawing.page = {200, 150, 5};
  drawing.layers = {layer};
  const Preview preview = preview_of(drawing);
  REQUIRE(preview.layers.size() == 1);
  const Lines read = parsed(preview.layers[0].path);
  CHECK(read.size() == 50);
  for (std::size_t i = 0; i < read.size(); ++i) {
    CHECK(std::abs(read[i].front().y - (10 + 0.6 * (4 * static_cast<double>(i) + 3))) < 0.051);
    CHECK(std::abs(read[i].back().x - read[i].front().x) == 1);
  }
}

TEST_CASE("previews of next to nothing") {
  CHECK(preview_of({}).layers.empty());
  Drawing drawing;
  Layer layer = layer_called("silhouettes");
  layer.page_mm = {{10, 10}, {10.01, 10}, {50, 50}, {50, 50.7}};
  layer.strokes = {{0, 2}};
  drawing.layers = {layer};
  CHECK(preview_of(drawing).layers.empty());
  drawing.layers[0].strokes.push_back({2, 2});
  const Preview preview = preview_of(drawing);
  REQUIRE(preview.layers.size() == 1);
  CHECK(preview.layers[0].path == "m500 500l0 7");
}
