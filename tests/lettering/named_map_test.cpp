// SPDX-License-Identifier: GPL-3.0-or-later
// Whole maps with names: no text on another, on a leader or on a line of the terrain, none beyond
// its margins, whether letters are a font's or strokes.
#include "orograph.hpp"
#include "tests/catch.hpp"
#include "tests/lettering/named_maps.hpp"
#include "tests/library/made_ground.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <optional>
#include <string>
#include <vector>

namespace orograph::named_map_test {
namespace {

constexpr int kSide = 60;
using Corners = std::array<Vec2, 4>;

// What of a line from a to b is inside of corners that run clockwise on the page, y down: its
// share.
std::optional<std::pair<double, double>> inside(Vec2 a, Vec2 b, const Corners& box) {
  double from = 0, to = 1;
  for (std::size_t k = 0; k < 4; ++k) {
    const Vec2 side = box[(k + 1) % 4] - box[k];
    const double size = length(side);
    if (size == 0) return std::nullopt;
    const double at_a = cross(side, a - box[k]) / size, at_b = cross(side, b - box[k]) / size;
    if (at_a <= 0 && at_b <= 0) return std::nullopt;
    if (at_a < 0) from = std::max(from, at_a / (at_a - at_b));
    if (at_b < 0) to = std::min(to, at_a / (at_a - at_b));
  }
  if (from >= to) return std::nullopt;
  return std::pair(from, to);
}

double inside_mm(Vec2 a, Vec2 b, const Corners& box) {
  const auto share = inside(a, b, box);
  return share ? (share->second - share->first) * length(b - a) : 0;
}

// Two boxes overlap where a side of one goes through the other, or one is within the other.
bool overlap(const Corners& a, const Corners& b) {
  constexpr double kTouch_mm = 1e-3;
  for (std::size_t k = 0; k < 4; ++k)
    if (inside_mm(a[k], a[(k + 1) % 4], b) > kTouch_mm ||
        inside_mm(b[k], b[(k + 1) % 4], a) > kTouch_mm) {
      // Along a side there is no room between; a little off it there is.
      const Vec2 middle = 0.25 * (a[0] + a[1] + a[2] + a[3]);
      Corners smaller = a;
      for (Vec2& corner : smaller) corner = middle + 0.999 * (corner - middle);
      for (std::size_t i = 0; i < 4; ++i)
        if (inside_mm(smaller[i], smaller[(i + 1) % 4], b) > 0 ||
            inside_mm(b[i], b[(i + 1) % 4], smaller) > 0)
          return true;
    }
  return false;
}

template <class Take>
void for_each_piece(const Layer& layer, const Take& take) {
  for (const Stroke& stroke : layer.strokes) {
    const auto points = layer.points(stroke);
    for (std::size_t i = 1; i < points.size(); ++i) take(points[i - 1], points[i]);
  }
}

bool is_of_terrain(const Layer& layer) {
  return layer.name != "labels" && layer.name != "leaders" && layer.name != "furniture" &&
         !layer.is_pen_way;
}

struct Tally {
  std::size_t texts = 0, names = 0, strokes = 0;
};

// The first that is wrong with texts of a font.
std::string fault_of_texts(const Map& map, Tally& tally) {
  if (const auto fault = find_fault(map.drawing)) return *fault;
  std::vector<const PageText*> texts;
  for (const Layer& layer : map.drawing.layers)
    for (const PageText& text : layer.texts)
      if (!text.text.empty()) texts.push_back(&text);
  tally.texts += texts.size();
  for (std::size_t i = 0; i < texts.size(); ++i)
    for (std::size_t k = 0; k < i; ++k)
      if (overlap(texts[i]->corners_mm(), texts[k]->corners_mm()))
        return texts[i]->text + " is on " + texts[k]->text;
  for (const Layer& layer : map.drawing.layers)
    for (const PageText* text : texts) {
      double on_mm = 0;
      for_each_piece(layer, [&](Vec2 a, Vec2 b) { on_mm += inside_mm(a, b, text->corners_mm()); });
      if (on_mm > 1e-2) return "lines of " + layer.name + " go through " + text->text;
    }
  return {};
}

// Of strokes: all that names are drawn of, but for marks on summits, is in the box of just one.
std::string fault_of_strokes(const Map& map, Tally& tally) {
  if (const auto fault = find_fault(map.drawing)) return *fault;
  std::vector<Corners> boxes;
  for (const NameFacts& name : map.facts.names->names)
    if (name.corners_mm) boxes.push_back(*name.corners_mm);
  tally.names += boxes.size();
  for (std::size_t i = 0; i < boxes.size(); ++i)
    for (std::size_t k = 0; k < i; ++k)
      if (overlap(boxes[i], boxes[k])) return "boxes of names overlap";
  for (const Layer& layer : map.drawing.layers) {
    const bool is_label = layer.name == "labels";
    std::string fault;
    for_each_piece(layer, [&](Vec2 a, Vec2 b) {
      double in_mm = 0;
      for (const Corners& box : boxes) in_mm += inside_mm(a, b, box);
      tally.strokes += is_label ? 1 : 0;
      const double size = length(b - a);
      if (is_label && size > 1.5 && in_mm < 0.5 * size) fault = "a letter is outside of its box";
      if (!is_label && in_mm > 1e-2) fault = "lines of " + layer.name + " go through a name";
    });
    if (!fault.empty()) return fault;
  }
  return {};
}

// No line of the terrain that is as far to the side as a name is above the name's lower end.
std::string fault_above(const Map& map) {
  for (const NameFacts& name : map.facts.names->names) {
    if (!name.corners_mm) continue;
    Box2 box;
    for (const Vec2 corner : *name.corners_mm) box.include(corner);
    const Box2* strip = nullptr;
    for (const FurnitureFacts& one : map.facts.furniture)
      if (one.piece == "window" && one.box_mm->high.y > box.low.y &&
          (!strip || one.box_mm->high.y < strip->high.y))
        strip = &*one.box_mm;
    if (!strip) continue;
    for (const Layer& layer : map.drawing.layers)
      if (is_of_terrain(layer))
        for (const Vec2 p : layer.page_mm)
          if (p.y > strip->low.y && p.y < box.high.y && p.x > box.low.x && p.x < box.high.x)
            return layer.name + " rises into " + name.text;
  }
  return {};
}

} // namespace

TEST_CASE("On random maps no text is on another, on a leader or on a line") {
  const Terrain terrain = Terrain::of(borrowed(rough_heights(kSide), kSide));
  Tally tally;
  int refused = 0;
  // As many as one likes, by hand.
  const char* const asked = std::getenv("OROGRAPH_TEST_MAPS");
  const std::uint64_t maps = asked ? std::strtoull(asked, nullptr, 10) : last_seed(40);
  for (std::uint64_t seed = 1; seed <= maps; ++seed) {
    Random random(seed);
    const Session session(terrain, {}, {},
                          names_of(random_names(random, kSide, random.whole(1, 80)), terrain));
    MapSpec spec = random_named_spec(random, kSide);
    CAPTURE(seed, spec.view.projection, spec.page.width_mm);
    try {
      const Map with_font = session.draw(spec);
      CHECK(fault_of_texts(with_font, tally) == "");
      if (is_panorama(spec.view.projection)) CHECK(fault_above(with_font) == "");
      spec.letters.kind = LetterKind::stroke;
      const Map with_strokes = session.draw(spec);
      CHECK(fault_of_strokes(with_strokes, tally) == "");
    } catch (const UsageError& error) { // a page that is too small for it says so
      INFO(error.what());
      CHECK(std::string(error.what()).find("page") != std::string::npos);
      ++refused;
    }
  }
  if (asked) WARN(maps << " maps: " << tally.texts << " texts, " << tally.names << " names");
  INFO(tally.texts << " texts, " << tally.names << " names, " << tally.strokes << " strokes");
  CHECK(tally.texts >= enough(700));
  CHECK(tally.names >= enough(200));
  CHECK(refused <= static_cast<int>(maps / 4));
}

} // namespace orograph::named_map_test
