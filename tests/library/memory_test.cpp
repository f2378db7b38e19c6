// SPDX-License-Identifier: GPL-3.0-or-later
// Heights and triangles that a program has in memory: borrowed or copied, and refused where they
// are no surface.
#include "tests/catch.hpp"
#include "tests/library/made_ground.hpp"

#include <algorithm>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace orograph::memory_test {

namespace {

constexpr int kSide = 60;

// What an input is refused with.
template <class Input>
void check_refused(Input input, const std::function<void(Input&)>& spoil, ErrorCode code,
                   const std::string& wrong) {
  spoil(input);
  try {
    Terrain::of(input);
    FAIL("taken, but should have been refused: " << wrong);
  } catch (const Error& error) {
    INFO(error.what());
    CHECK(error.code() == code);
    CHECK(error.wrong().find(wrong) != std::string::npos);
    CHECK(error.right().size() > 5);
  }
}

} // namespace

TEST_CASE("an owner is kept for as long as a terrain, a session or a copy of them is there") {
  OwnedHeights heights = rough_heights(kSide);
  const std::weak_ptr<std::vector<float>> owner = heights;
  GridInput input = borrowed(heights, kSide);
  heights.reset();
  auto terrain = std::make_unique<Terrain>(Terrain::of(input));
  input = {};
  CHECK(owner.use_count() == 1);
  auto copy = std::make_unique<Terrain>(*terrain);
  terrain.reset();
  CHECK(!owner.expired());
  auto session = std::make_unique<Session>(*copy);
  copy.reset();
  CHECK(!owner.expired());
  const std::string drawn = drawn_bytes(*session, {});
  CHECK(drawn.size() > 10000);
  auto other = std::make_unique<Session>(*session);
  session.reset();
  CHECK((drawn_bytes(*other, {}) == drawn));
  CHECK(!owner.expired());
  // A map refers to nothing.
  const Map map = other->draw({});
  other.reset();
  CHECK(owner.expired());
  CHECK((bytes_of(map.drawing) == drawn));
}

TEST_CASE("of a terrain in degrees a session keeps the last frame as well, and no other") {
  OwnedHeights heights = rough_heights(kSide);
  const std::weak_ptr<std::vector<float>> owner = heights;
  std::optional<Map> map;
  {
    GridInput input = borrowed(heights, kSide);
    heights.reset();
    input.geotransform = {10, 1.0 / 3600, 0, 47, 0, -1.0 / 3600};
    input.crs = "EPSG:4326";
    const Session session(Terrain::of(input));
    input = {};
    CHECK(owner.use_count() == 1);
    MapSpec spec;
    for (const double exaggeration : {1.0, 1.0, 2.0, 3.0}) {
      spec.view.exaggeration = exaggeration;
      map = session.draw(spec);
      CHECK(owner.use_count() == 2);
    }
  }
  CHECK(owner.expired());
  CHECK(map->facts.counts.strokes > 100);
}

// The contract forbids a program to change borrowed heights; here it tells whose they are.
TEST_CASE("with an owner heights aren't copied, in either precision") {
  const OwnedHeights first = rough_heights(kSide);
  const OwnedHeights changed = rough_heights(kSide);
  std::reverse(changed->begin(), changed->end());
  MapSpec spec;
  spec.style.detail.of_file = true; // smaller cells' heights are rounded to the given precision
  const auto drawn = [&](const OwnedHeights& heights) {
    return drawn_bytes(Session(Terrain::of(borrowed(heights, kSide))), spec);
  };
  const std::string of_first = drawn(first), of_changed = drawn(changed);
  REQUIRE((of_first != of_changed));

  const OwnedHeights shared = std::make_shared<std::vector<float>>(*first);
  const Session session(Terrain::of(borrowed(shared, kSide)));
  *shared = *changed;
  CHECK((drawn_bytes(session, spec) == of_changed));

  const auto doubles = std::make_shared<std::vector<double>>(first->begin(), first->end());
  GridInput in_double = borrowed(first, kSide);
  in_double.heights = std::span<const double>(*doubles);
  in_double.owner = doubles;
  const Session of_doubles(Terrain::of(in_double));
  doubles->assign(changed->begin(), changed->end());
  CHECK((drawn_bytes(of_doubles, spec) == of_changed));
}

TEST_CASE("without an owner heights are copied, and may change or go") {
  OwnedHeights heights = rough_heights(kSide);
  const std::string drawn = drawn_bytes(Session(Terrain::of(borrowed(heights, kSide))), {});
  GridInput input = borrowed(heights, kSide);
  input.owner.reset();
  const Session session(Terrain::of(input));
  std::fill(heights->begin(), heights->end(), 5.0F);
  input = {};
  heights.reset();
  CHECK((drawn_bytes(session, {}) == drawn));
}

TEST_CASE("heights that lie in another way are copied, and their owner is let go") {
  struct Way {
    const char* name;
    std::function<void(GridInput&, std::vector<float>&)> change;
  };
  const std::vector<Way> ways{
      {"rows from the south",
       [](GridInput& input, std::vector<float>&) {
         input.geotransform = {500000, 30, 0, 5000000 - 30.0 * kSide, 0, 30};
       }},
      {"columns from the east",
       [](GridInput& input, std::vector<float>&) {
         input.geotransform = {500000 + 30.0 * kSide, -30, 0, 5000000, 0, -30};
       }},
      {"columns along the north", // transposed
       [](GridInput& input, std::vector<float>&) {
         input.geotransform = {500000, 0, 30, 5000000, -30, 0};
       }},
      {"feet", [](GridInput& input, std::vector<float>&) { input.height_unit_m = 0.3048; }},
      {"a nodata value", [](GridInput& input, std::vector<float>& heights) {
         heights[7] = -9999;
         input.nodata = -9999;
       }}};
  for (const Way& way : ways) {
    INFO(way.name);
    OwnedHeights heights = rough_heights(kSide);
    GridInput input = borrowed(heights, kSide);
    way.change(input, *heights);
    const std::weak_ptr<std::vector<float>> owner = heights;
    const Session session(Terrain::of(input));
    input = {};
    heights.reset();
    CHECK(owner.expired());
    CHECK(session.draw({}).facts.counts.strokes > 100);
  }
}

TEST_CASE("one surface in several ways makes one drawing") {
  const OwnedHeights heights = rough_heights(kSide);
  const std::string drawn = drawn_bytes(Session(Terrain::of(borrowed(heights, kSide))), {});
  GridInput upside_down = borrowed(heights, kSide);
  const auto turned = std::make_shared<std::vector<float>>();
  for (int row = kSide - 1; row >= 0; --row)
    turned->insert(turned->end(), heights->begin() + row * kSide,
                   heights->begin() + (row + 1) * kSide);
  upside_down.heights = std::span<const float>(*turned);
  upside_down.geotransform = {500000, 30, 0, 5000000 - 30.0 * kSide, 0, 30};
  CHECK((drawn_bytes(Session(Terrain::of(upside_down)), {}) == drawn));

  const auto in_half_metres = std::make_shared<std::vector<float>>(*heights);
  for (float& height : *in_half_metres) height *= 2;
  GridInput halved = borrowed(in_half_metres, kSide);
  halved.height_unit_m = 0.5;
  CHECK((drawn_bytes(Session(Terrain::of(halved)), {}) == drawn));
}

TEST_CASE("triangles are copied; their orientation doesn't matter") {
  TinInput input = hill_of_triangles(20);
  const Session session(Terrain::of(input));
  const std::string drawn = drawn_bytes(session, {});
  CHECK(session.draw({}).facts.input.triangles == 2 * 19 * 19);
  for (auto& corners : input.triangles) std::swap(corners[0], corners[2]);
  const Session turned(Terrain::of(input));
  input = {};
  CHECK((drawn_bytes(turned, {}) == drawn));
  CHECK((drawn_bytes(session, {}) == drawn));
}

TEST_CASE("a terrain tells its name, its CRS and what was assumed") {
  const OwnedHeights heights = rough_heights(kSide);
  GridInput input = borrowed(heights, kSide);
  input.name = "the moon's far side";
  const Terrain terrain = Terrain::of(input);
  CHECK(terrain.name() == input.name);
  CHECK(terrain.crs_wkt().find("UTM zone 32N") != std::string::npos);
  CHECK(Session(terrain).draw({}).drawing.title.find(input.name) != std::string::npos);
  input.crs = "";
  CHECK(Terrain::of(input).crs_wkt().empty());
}

TEST_CASE("grids that are no surface are refused") {
  const OwnedHeights heights = rough_heights(kSide);
  using Spoil = std::function<void(GridInput&)>;
  const auto refused = [&](const Spoil& spoil, ErrorCode code, const std::string& wrong) {
    check_refused(borrowed(heights, kSide), spoil, code, wrong);
  };
  refused([](GridInput& i) { i.columns = 1; }, ErrorCode::request, "1 columns and 60 rows");
  refused([](GridInput& i) { i.rows = -4; }, ErrorCode::request, "-4 rows");
  refused([](GridInput& i) { i.rows = 59; }, ErrorCode::request,
          "3600 heights for 60 columns and 59 rows");
  refused([](GridInput& i) { i.heights = std::span<const double>(); }, ErrorCode::request,
          "0 heights");
  refused([](GridInput& i) { i.geotransform = {0, 1, 2, 0, 2, 4}; }, ErrorCode::request,
          "run along one line");
  refused([](GridInput& i) { i.geotransform = {}; }, ErrorCode::request, "not at all");
  refused([](GridInput& i) { i.geotransform[1] = std::numeric_limits<double>::quiet_NaN(); },
          ErrorCode::request, "");
  refused([](GridInput& i) { i.height_unit_m = 0; }, ErrorCode::request, "units of 0 m");
  refused([](GridInput& i) { i.height_unit_m = -1; }, ErrorCode::request, "units of -1 m");
  refused([](GridInput& i) { i.crs = "EPSG:nowhere"; }, ErrorCode::input, "EPSG:nowhere");
  const std::vector<float> none(heights->size(), std::numeric_limits<float>::quiet_NaN());
  refused(
      [&](GridInput& i) {
        i.heights = std::span<const float>(none);
        i.owner.reset();
      },
      ErrorCode::input, "no heights");
}

TEST_CASE("triangles that are no surface are refused, and said which") {
  using Spoil = std::function<void(TinInput&)>;
  const auto refused = [&](const Spoil& spoil, ErrorCode code, const std::string& wrong) {
    check_refused(hill_of_triangles(8), spoil, code, wrong);
  };
  refused([](TinInput& i) { i.triangles.clear(); }, ErrorCode::request, "no triangles");
  refused([](TinInput& i) { i.triangles[3][1] = 64; }, ErrorCode::request,
          "a triangle has point 64, and there are 64");
  refused([](TinInput& i) { i.height_unit_m = 0; }, ErrorCode::request, "units of 0 m");
  refused([](TinInput& i) { i.crs = "nonsense"; }, ErrorCode::input, "nonsense");
  refused([](TinInput& i) { i.points[5][2] = std::numeric_limits<double>::infinity(); },
          ErrorCode::input, "");
  const Spoil fold = [](TinInput& i) { // one more triangle above others
    i.points.push_back({499700, 5000300, 900});
    i.triangles.push_back({0, 60, 64});
  };
  refused(fold, ErrorCode::input, "");
  TinInput folded = hill_of_triangles(8);
  fold(folded);
  folded.repair = true;
  CHECK(Session(Terrain::of(folded)).draw({}).facts.counts.strokes > 10);
}

} // namespace orograph::memory_test
