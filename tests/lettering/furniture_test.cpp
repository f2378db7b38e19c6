// SPDX-License-Identifier: GPL-3.0-or-later
// Furniture on random pages: no box overlaps another or the picture's window, all is within the
// margins, and where there is none the drawing is what it was.
#include "orograph.hpp"
#include "tests/catch.hpp"
#include "tests/library/made_ground.hpp"
#include "tests/support/random.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

namespace orograph::furniture_test {
namespace {

constexpr int kSide = 24;

const Session& session() {
  static const Session one(Terrain::of(borrowed(rough_heights(kSide), kSide)));
  return one;
}

std::vector<Furniture> all_of(bool is_panorama, bool has_eye) {
  std::vector<Furniture> all{Furniture::title, Furniture::subtitle, Furniture::neatline,
                             Furniture::caption, Furniture::source};
  if (has_eye) all.push_back(Furniture::viewpoint);
  if (is_panorama)
    all.insert(all.end(), {Furniture::azimuths, Furniture::altitudes});
  else
    all.insert(all.end(), {Furniture::north, Furniture::scale});
  return all;
}

MapSpec random_spec(Random& random) {
  MapSpec spec;
  spec.style.layers = {"skyline", "border", "silhouettes"};
  spec.view.projection =
      random.pick({Projection::perspective, Projection::orthographic, Projection::oblique,
                   Projection::cylindrical, Projection::equirectangular});
  const bool is_round = is_panorama(spec.view.projection);
  if (is_round || (spec.view.projection == Projection::perspective && random.chance(0.5)))
    spec.view.eye_map = middle(kSide);
  spec.view.from_azimuth = Angle::degrees(random.whole(0, 359));
  spec.view.from_elevation = Angle::degrees(random.pick({5, 20, 45, 90}));
  if (spec.view.has_eye() && random.chance(0.5)) {
    spec.view.field_of_view = Angle::degrees(random.whole(20, 150));
    spec.view.look_azimuth = Angle::degrees(random.whole(0, 359));
  }
  if (is_round) spec.page.strips = random.whole(1, 4);
  spec.page.width_mm = random.whole(60, 600);
  if (random.chance(0.7))
    spec.page.height_mm = random.whole(150, 600);
  else
    spec.page.height_mm.reset();
  spec.page.crop = random.chance(0.3);
  spec.page.margin_mm = random.pick({0, 10, 15});
  spec.letters.kind = random.chance(0.5) ? LetterKind::font : LetterKind::stroke;
  for (const Furniture piece : all_of(is_round, spec.view.has_eye()))
    if (random.chance(0.8)) spec.furniture.pieces.push_back(piece);
  const auto words = [&] {
    return random.pick({std::string(), std::string("Short"), std::string(300, 'm'),
                        std::string("הר <&> \"x\" 🏔 \t"),
                        std::string("A title of some words")});
  };
  spec.title = words();
  spec.furniture.subtitle = words();
  spec.furniture.source = words();
  spec.furniture.date = words();
  spec.furniture.text_mm = random.between(1.8, 4);
  spec.furniture.title_mm = random.between(3, 10);
  return spec;
}

bool overlap(const Box2& a, const Box2& b) {
  constexpr double kTouch_mm = 1e-6;
  return a.low.x < b.high.x - kTouch_mm && b.low.x < a.high.x - kTouch_mm &&
         a.low.y < b.high.y - kTouch_mm && b.low.y < a.high.y - kTouch_mm;
}

// The first that is wrong.
std::string fault_of(const Map& map) {
  if (const auto fault = find_fault(map.drawing)) return *fault;
  struct Piece {
    std::string piece;
    Box2 box_mm;
  };
  std::vector<Piece> boxes;
  for (const FurnitureFacts& one : map.facts.furniture)
    if (one.box_mm) boxes.push_back({one.piece, *one.box_mm});
  for (std::size_t i = 0; i < boxes.size(); ++i)
    for (std::size_t k = 0; k < i; ++k)
      if (overlap(boxes[i].box_mm, boxes[k].box_mm))
        return boxes[i].piece + " overlaps " + boxes[k].piece;
  for (const Layer& layer : map.drawing.layers) {
    for (const PageText& text : layer.texts)
      for (const Piece& window : boxes)
        if (window.piece == "window" && !text.text.empty() && overlap(text.box_mm(), window.box_mm))
          return "the text " + text.text + " is in the picture";
    if (layer.name == "furniture") continue;
    for (const Vec2 p : layer.page_mm)
      if (std::none_of(boxes.begin(), boxes.end(), [&](const Piece& one) {
            return one.piece == "window" && p.x >= one.box_mm.low.x - 1e-3 &&
                   p.x <= one.box_mm.high.x + 1e-3 && p.y >= one.box_mm.low.y - 1e-3 &&
                   p.y <= one.box_mm.high.y + 1e-3;
          }))
        return "a line of " + layer.name + " is outside of the picture";
  }
  return {};
}

} // namespace

TEST_CASE("On random pages nothing overlaps and all is within the margins") {
  Random random(29);
  int drawn = 0, refused = 0;
  for (std::uint64_t seed = 1; seed <= last_seed(300); ++seed) {
    const MapSpec spec = random_spec(random);
    if (!spec.furniture.any()) continue;
    std::optional<Map> map;
    try {
      map = session().draw(spec);
    } catch (const UsageError& error) { // a page that is too small for it says so
      INFO(error.what());
      CHECK(std::string(error.what()).find("page") != std::string::npos);
      ++refused;
      continue;
    }
    if (map->facts.furniture.empty()) continue; // nothing of the terrain is seen
    ++drawn;
    INFO("map " << seed << " with " << static_cast<int>(spec.view.projection) << " on "
                << map->drawing.page.width_mm << " x " << map->drawing.page.height_mm);
    CHECK(fault_of(*map) == "");
  }
  CHECK(drawn >= enough(200));
  CHECK(refused <= 80);
}

TEST_CASE("Without furniture a drawing is what it was, whatever letters are asked for") {
  MapSpec spec;
  const std::string bytes = drawn_bytes(session(), spec);
  spec.letters.kind = LetterKind::stroke;
  spec.letters.family = "Another";
  spec.furniture.subtitle = "not printed";
  CHECK((drawn_bytes(session(), spec) == bytes));
}

TEST_CASE("Furniture is the same on any number of threads, and isn't drawn on the ground") {
  MapSpec spec;
  spec.furniture.pieces = all_of(false, false);
  spec.title = "A map";
  Control one, four;
  one.jobs = 1;
  four.jobs = 4;
  CHECK((drawn_bytes(session(), spec, one) == drawn_bytes(session(), spec, four)));
  spec.ground_points = true;
  const Map map = session().draw(spec);
  CHECK(map.facts.furniture.empty());
  for (const Layer& layer : map.drawing.layers) CHECK(layer.name != "furniture");
}

TEST_CASE("A bar is as long as it says at the scale that is asked for") {
  MapSpec spec;
  spec.view.projection = Projection::orthographic;
  spec.furniture.pieces = {Furniture::scale};
  spec.page.scale = 10000;
  const Map map = session().draw(spec);
  const auto layer = std::find_if(map.drawing.layers.begin(), map.drawing.layers.end(),
                                  [](const Layer& one) { return one.name == "furniture"; });
  REQUIRE(layer != map.drawing.layers.end());
  const auto bar = layer->points(layer->strokes.front());
  CHECK(std::abs(bar[1].x - bar[0].x - 50) < 1e-3); // 500 m
  std::string texts;
  for (const PageText& text : layer->texts) texts += text.text + "|";
  CHECK(texts == "0|250|500 m|1:10\u00a0000|");
}

TEST_CASE("Pieces that have no meaning in a view are refused") {
  MapSpec spec;
  for (const Furniture piece : {Furniture::azimuths, Furniture::altitudes, Furniture::viewpoint}) {
    spec.furniture.pieces = {piece};
    CHECK_THROWS_AS(session().draw(spec), UsageError);
  }
  spec.view.projection = Projection::cylindrical;
  spec.view.eye_map = middle(kSide);
  for (const Furniture piece : {Furniture::north, Furniture::scale}) {
    spec.furniture.pieces = {piece};
    CHECK_THROWS_AS(session().draw(spec), UsageError);
  }
  spec.furniture.pieces = {Furniture::azimuths};
  spec.furniture.text_mm = -1;
  CHECK_THROWS_AS(session().draw(spec), UsageError);
}

} // namespace orograph::furniture_test
