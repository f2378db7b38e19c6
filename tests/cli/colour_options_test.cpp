// SPDX-License-Identifier: GPL-3.0-or-later
// --palette and --colour, to the layers that they make; and what the command draws with them.
#include "map/layer_table.hpp"
#include "tests/cli/given_options.hpp"
#include "tests/cli/made_files.hpp"
#include "tests/cli/run_program.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace orograph::colour_options_test {
namespace {

using namespace given_options;

// What a layer is drawn in; none: it is grey, or isn't drawn.
std::optional<Colour> colour_in(const RenderSettings& settings, std::string_view name) {
  for (const LayerRow& row : layer_table())
    if (row.name == name)
      if (const auto layer = layer_of(row, settings.map.style)) return layer->ink();
  return std::nullopt;
}

bool is_blue(const Colour& c) {
  return c[2] > c[1] && c[1] > c[0] && c[2] - c[0] > 60;
}
bool is_brown(const Colour& c) {
  return c[0] > c[1] && c[1] > c[2] && c[0] - c[2] > 60;
}
// To an eye.
bool is_dark(const Colour& c) {
  return *std::ranges::max_element(c) < 64;
}

const Arguments kAllLayers{
    "--layers",
    "profiles,mesh,hachures,walls,block,contours,graticule,grid,edges,waterlines,shores,border,"
    "drape,voids,silhouettes,skyline,solids,pen-up"};

Arguments all_layers_and(const Arguments& more) {
  Arguments arguments = kAllLayers;
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

// Label to colour of each layer of an SVG.
std::map<std::string, std::string> colours_of(const std::string& svg) {
  std::map<std::string, std::string> colours;
  const std::string label = "inkscape:label=\"", stroke = "stroke=\"";
  for (std::size_t at = svg.find(label); at != std::string::npos; at = svg.find(label, at + 1)) {
    const std::size_t name = svg.find(' ', at + label.size()) + 1;
    const std::size_t colour = svg.find(stroke, at) + stroke.size();
    colours[svg.substr(name, svg.find('"', name) - name)] = svg.substr(colour, 7);
  }
  return colours;
}

} // namespace

TEST_CASE("layers are grey unless a palette or a colour is asked for") {
  const RenderSettings plain = given(kAllLayers);
  for (const LayerRow& row : layer_table()) {
    INFO(row.name);
    CHECK(!colour_in(plain, row.name));
    if (const auto layer = layer_of(row, plain.map.style)) CHECK(layer->grey == row.grey);
  }
  CHECK(given({"--palette", "mono"}).map.style.palette == Palette::mono);
  CHECK(!colour_in(given(all_layers_and({"--palette", "mono"})), "shores"));
}

TEST_CASE("the palette of maps has each layer in the colour that maps have") {
  const RenderSettings map = given(all_layers_and({"--palette", "map"}));
  for (const LayerRow& row : layer_table())
    if (!row.is_hidden() && row.source != LineSource::lettering && !is_of_underside(row))
      CHECK(colour_in(map, row.name));
  const RenderSettings both = given({"--palette", "map", "--underside", "draw"});
  for (const char* side : {"underside", "underside-edges"}) CHECK(colour_in(both, side));
  const RenderSettings told = given({"--underside", "draw", "--colour", "underside=#112233"});
  for (const char* side : {"underside", "underside-edges"})
    CHECK(colour_in(told, side) == Colour{0x11, 0x22, 0x33});
  for (const char* water : {"shores", "waterlines"}) CHECK(is_blue(*colour_in(map, water)));
  for (const char* height : {"contours", "index-contours"})
    CHECK(is_brown(*colour_in(map, height)));
  for (const char* edge : {"border", "voids"}) CHECK(is_grey(*colour_in(map, edge)));
  for (const char* rock : {"profiles", "silhouettes", "skyline"})
    CHECK(is_dark(*colour_in(map, rock)));
  const Colour drape = *colour_in(map, "drape");
  CHECK(drape[0] > 2 * std::max(drape[1], drape[2])); // red
}

TEST_CASE("hidden lines have the colour of those that are seen, lighter, unless told") {
  const auto sum = [](const Colour& colour) { return colour[0] + colour[1] + colour[2]; };
  const RenderSettings map =
      given({"--palette", "map", "--contours", "auto", "--hidden-layers", "contours,shores"});
  for (const std::string name : {"contours", "index-contours", "shores"}) {
    const Colour seen = *colour_in(map, name), hidden = *colour_in(map, "hidden-" + name);
    CHECK(sum(hidden) > sum(seen));
    CHECK((hidden[0] < hidden[2]) == (seen[0] < seen[2]));
  }
  const RenderSettings told = given({"--contours", "auto", "--hidden-layers", "contours,border",
                                     "--colour", "contours=#000000,hidden-border=#102030"});
  CHECK(*colour_in(told, "hidden-contours") == Colour{115, 115, 115}); // 0.55 of black
  CHECK(*colour_in(told, "hidden-border") == Colour{0x10, 0x20, 0x30});
}

TEST_CASE("a colour goes before the palette, and with a layer to what comes with it") {
  const Colour brown{165, 42, 42}, blue{0, 0, 255}, ink{1, 2, 3};
  const RenderSettings two = given({"--palette", "map", "--contours", "auto", "--colour",
                                    "profiles=#010203,contours=brown", "--colour", "shores=BLUE"});
  CHECK(colour_in(two, "profiles") == ink);
  CHECK(colour_in(two, "contours") == brown);
  CHECK(colour_in(two, "index-contours") == brown);
  CHECK(colour_in(two, "shores") == blue);
  CHECK(is_dark(*colour_in(two, "skyline"))); // the palette's
  const RenderSettings own = given({"--contours", "auto", "--flat", "waterlines", "--colour",
                                    "contours=brown,index-contours=blue,shores=blue"});
  CHECK(colour_in(own, "contours") == brown);
  CHECK(colour_in(own, "index-contours") == blue);
  CHECK(colour_in(own, "waterlines") == blue);
  CHECK(!colour_in(own, "profiles"));
  // Index contours that nobody wants don't come with a colour.
  const RenderSettings none =
      given({"--contours", "auto", "--index-every", "0", "--colour", "contours=brown"});
  CHECK_FALSE(none.map.style.asks_for("index-contours"));

  // A program's grey goes before the palette as well.
  Style style;
  style.palette = Palette::map;
  style.layers = {"shores"};
  style.layers[0].grey = 0.3;
  const auto row = std::ranges::find(layer_table(), "shores", &LayerRow::name);
  CHECK(!layer_of(*row, style)->ink());
  CHECK(layer_of(*row, style)->grey == 0.3);
  style.layers[0].colour = blue;
  CHECK(layer_of(*row, style)->ink() == blue);
  style.layers.emplace_back("waterlines").grey = 0.4;
  const auto water = std::ranges::find(layer_table(), "waterlines", &LayerRow::name);
  CHECK(!layer_of(*water, style)->ink());
}

TEST_CASE("colours in a drawing, in a settings file, and beside pens") {
  const MadeFolder folder;
  folder.write("hill.asc",
               ascii_grid(60, 60, [](int column, int row) { return hill_m(column, row, 60); }));
  folder.write("colours.toml", "palette = 'map'\ncolour = ['contours=green', 'skyline=red', "
                               "'mesh=pink']\n");
  folder.write("pens.toml", "[[pen]]\nwidth = 0.2\ncolour = 'navy'\n");
  const auto drawn = [&](std::vector<std::string> more) {
    more.insert(more.begin(), {"render", "hill.asc", "out.svg", "--overwrite", "--quiet"});
    const ProgramRun run = run_orograph(more, {.folder = folder.path()});
    INFO(run.err);
    REQUIRE(run.exit_code == 0);
    return folder.read("out.svg");
  };
  const std::string plain = drawn({"--contours", "auto"});
  CHECK(colours_of(plain).at("contours") == "#333333");
  CHECK((drawn({"--contours", "auto", "--palette", "mono"}) == plain));
  const auto colours = colours_of(drawn({"--contours", "auto", "--settings", "colours.toml"}));
  CHECK(colours.at("contours") == "#008000");
  CHECK(colours.at("index-contours") == "#008000");
  CHECK(colours.at("skyline") == "#ff0000");
  CHECK(!colours.contains("mesh")); // settings serve many drawings
  const auto by_pen = colours_of(drawn({"--settings", "colours.toml", "--pens", "pens.toml"}));
  REQUIRE(by_pen.size() == 1);
  CHECK(by_pen.begin()->second == "#000080");
  // Pens go before the palette, which has what no pen draws.
  folder.write("fine.toml", "[[pen]]\nwidth = 0.2\ncolour = 'navy'\nname = 'fine'\n"
                            "layers = ['contours', 'profiles']\n");
  const auto beside = colours_of(drawn({"--contours", "auto", "--palette", "map", "--colour",
                                        "skyline=red", "--pens", "fine.toml"}));
  CHECK(beside.at("fine") == "#000080");
  CHECK(!beside.contains("contours"));
  CHECK(is_brown(colour_of(beside.at("index-contours"))));
  CHECK(beside.at("skyline") == "#ff0000");
  // But for the colours it is the same ink.
  std::string coloured = drawn({"--contours", "auto", "--palette", "map"}), grey = plain;
  CHECK((coloured != grey));
  for (std::string* svg : {&coloured, &grey})
    for (std::size_t at = svg->find('#'); at != std::string::npos; at = svg->find('#', at))
      svg->erase(at, 7);
  CHECK((coloured == grey));
}

} // namespace orograph::colour_options_test
