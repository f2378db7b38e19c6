// SPDX-License-Identifier: GPL-3.0-or-later
// Writes pages of made sweeps for the test in the browser. Previews are seeded ridges.
// usage: make_pages FOLDER   or   make_pages TABLE.json PREVIEWS.json PAGE.html
#include "cli/sweep/page.hpp"
#include "tests/support/random.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <fstream>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

namespace orograph {
namespace {

using Json = nlohmann::ordered_json;

// Closes scripts, opens comments, holds the marks of the template, quotes and several alphabets.
const std::string kHostile =
    "</script><b id=\"broken\">&amp;<!--<script>alert('{{previews}}{{table}}')</script>\"\\ Ñandú "
    "山岳";

Json column(const std::string& name, const std::string& unit, const std::string& about) {
  return {{"name", name}, {"unit", unit}, {"about", about}};
}

Json columns() {
  return {column("azimuth_deg", "deg", "where the viewer stands, clockwise from north"),
          column("elevation_deg", "deg", "how steeply the view looks down"),
          column("projection", "", "how the terrain is projected"),
          column("strokes", "", "visible polylines"),
          column("visible_share", "", "share of the ground that is seen"),
          column("pen_down_mm", "mm", "length drawn"),
          column("seconds", "s", "time of the whole view")};
}

Json table(const std::string& title, const std::vector<std::string>& varied, bool crossed) {
  return {{"schema", 1},
          {"program", {{"name", "orograph"}, {"version", "0.0.0"}, {"commit", "made"}}},
          {"title", title},
          {"terrain", title},
          {"varied", varied},
          {"crossed", crossed},
          {"columns", columns()},
          {"views", Json::array()}};
}

Json view(int number, double azimuth_deg, double elevation_deg) {
  const std::string name = fmt::format("view-{:03}", number);
  return {{"view", number},
          {"name", name},
          {"file", name + ".svg"},
          {"error", nullptr},
          {"azimuth_deg", azimuth_deg},
          {"elevation_deg", elevation_deg},
          {"projection", "perspective"},
          {"strokes", 1000 + 7 * number},
          {"visible_share", 0.3 + elevation_deg / 200},
          {"pen_down_mm", 12345.678 + number},
          {"seconds", 0.25 + 0.001 * number}};
}

void fail(Json& row, const std::string& why) {
  row["error"] = why;
  for (const char* measure : {"strokes", "visible_share", "pen_down_mm", "seconds"})
    row[measure] = nullptr;
}

// Ridges from left to right, one below the other, in tenths of a millimetre.
Json preview(Random& random, int points) {
  std::string path;
  for (int ridge = 0; ridge < 20; ++ridge) {
    path += fmt::format("M100 {}l", 400 + 70 * ridge);
    for (int i = 0; i < points / 20; ++i)
      path += fmt::format("{} {} ", 2770 * 20 / points, random.whole(-30, 30));
  }
  return {{"size_mm", {297, 210}},
          {"layers", {{{"name", "profiles"}, {"pen_mm", 0.15}, {"grey", 0}, {"path", path}}}}};
}

void write(const std::string& path, const std::string& text) {
  std::ofstream file(path, std::ios::binary);
  file << text;
  file.close();
  if (!file) throw std::runtime_error("can't write " + path);
}

std::string read(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

void write_page(const std::string& path, const Json& rows, const Json& previews) {
  write(path, sweep_page(rows.dump(), previews.dump()));
}

void write_empty(const std::string& folder) {
  Json rows = table("empty.tif", {"azimuth_deg"}, true);
  rows["views_planned"] = 5; // other shards draw them
  write_page(folder + "/empty.html", rows, Json::array());
}

void write_one(const std::string& folder) {
  Json rows = table("one.tif", {}, true);
  rows["views"].push_back(view(0, 30, 25));
  Random random(1);
  write_page(folder + "/one.html", rows, Json::array({preview(random, 200)}));
}

// 24 azimuths by 3 elevations, the elevation turning fastest; a shard draws number 40.
void write_crossed(const std::string& folder) {
  Json rows = table("crossed.tif", {"azimuth_deg", "elevation_deg"}, true), previews;
  rows["chosen"] = {{"azimuth_deg", 218}, {"elevation_deg", 20}}; // nearest: 225 and 25
  Random random(2);
  for (int number = 0; number < 72; ++number) {
    if (number == 40) continue;
    const int elevations_deg[] = {10, 25, 45};
    const int turn = number / 3;
    rows["views"].push_back(view(number, 15.0 * turn, elevations_deg[number % 3]));
    previews.push_back(preview(random, 200));
  }
  write_page(folder + "/crossed.html", rows, previews);
  write(folder + "/view-000.svg", "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"297mm\" "
                                  "height=\"210mm\" viewBox=\"0 0 297 210\"><path "
                                  "d=\"M10 10L287 200\" stroke=\"#f00\"/></svg>");
}

// A list of 360 views; every ninth failed, and all names are hostile.
void write_zipped(const std::string& folder) {
  Json rows = table(kHostile, {"azimuth_deg", "elevation_deg"}, false), previews;
  rows["columns"][3]["about"] = kHostile;
  Random random(3);
  for (int number = 0; number < 360; ++number) {
    Json row = view(number, number, 10 + 20 * std::sin(number / 57.3) + 20);
    row["name"] = fmt::format("{} {}", number, kHostile);
    row["file"] = fmt::format("javascript:{} #?%{}.svg", number, kHostile);
    row["projection"] = kHostile;
    const bool failed = number % 9 == 4;
    if (failed) fail(row, "no room: " + kHostile);
    rows["views"].push_back(row);
    previews.push_back(failed ? Json() : preview(random, 3000));
  }
  write_page(folder + "/zipped.html", rows, previews);
}

} // namespace
} // namespace orograph

int main(int count, char** arguments) {
  using namespace orograph;
  if (count == 2) {
    const std::string folder = arguments[1];
    write_empty(folder);
    write_one(folder);
    write_crossed(folder);
    write_zipped(folder);
  } else if (count == 4) {
    write(arguments[3], sweep_page(read(arguments[1]), read(arguments[2])));
  } else {
    std::cerr << "usage: make_pages FOLDER, or make_pages TABLE.json PREVIEWS.json PAGE.html\n";
    return 2;
  }
}
