// SPDX-License-Identifier: GPL-3.0-or-later
// Names as the command prints them: what its options choose, what its report tells, and what it
// says where something is wrong.
#include "tests/catch.hpp"
#include "tests/cli/made_files.hpp"
#include "tests/cli/run_program.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace orograph::label_options_test {
namespace {

using Words = std::vector<std::string>;
using Json = nlohmann::json;

// Two cones of 300 m and 250 m, 500 m apart; the terrain ends on their slopes, at 100 m and 160 m.
void write_files(const MadeFolder& folder) {
  folder.write("cones.asc", ascii_grid(80, 80, [](int column, int row) {
                 return std::max({300 - 10 * std::hypot(column - 20, row - 40),
                                  250 - 10 * std::hypot(column - 70, row - 40), 0.0});
               }));
  folder.write("names.csv", "name,other,x,y,ele,count\nHigh,Hoch,205,395,303,1\n"
                            "Low,Tief,705,395,,9\nNowhere,Nirgends,-9000,0,,3\n,,400,400,,2\n");
}

ProgramRun render(const MadeFolder& folder, Words more) {
  RunConditions there;
  there.folder = folder.path();
  more.insert(more.begin(), {"render", "cones.asc", "map.svg", "--overwrite", "--layers",
                             "skyline,border", "--report", "map.json"});
  return run_orograph(more, there);
}

Json report_of(const MadeFolder& folder, Words more) {
  more.insert(more.begin(), {"--labels", "names.csv"});
  const ProgramRun run = render(folder, more);
  INFO(run.err);
  REQUIRE(run.exit_code == 0);
  return Json::parse(folder.read("map.json"));
}

std::string listed(const Json& names) {
  std::string list;
  for (const Json& name : names) list += name.at("name").get<std::string>() + "|";
  return list;
}

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

} // namespace

TEST_CASE("Options choose names, and the report tells of each") {
  const MadeFolder folder;
  write_files(folder);
  const Json names = report_of(folder, {"--projection", "orthographic"}).at("names");
  CHECK(listed(names.at("chosen")) == "High|Low|");
  CHECK(names.at("elsewhere") == 0); // what is beside the terrain isn't read
  CHECK(names.at("unnamed") == 1);
  const Json& high = names.at("chosen").at(0);
  CHECK(high.at("map") == Json{205.0, 395.0, 300.0});
  CHECK(high.at("prominence_m") == 200);
  CHECK(high.at("prominence_is_at_least") == true);
  CHECK(names.at("chosen").at(1).at("prominence_m") == 90);
  CHECK(high.at("azimuth_deg").is_null());
  CHECK(high.at("corners_mm").size() == 4);
  CHECK(has(folder.read("map.svg"), ">High</text>"));

  const auto chosen = [&](const Words& more) {
    return listed(report_of(folder, more).at("names").at("chosen"));
  };
  CHECK(chosen({"--label-max", "1"}) == "High|");
  CHECK(chosen({"--label-max", "1", "--label-weight", "count"}) == "Low|");
  CHECK(chosen({"--label-field", "other"}) == "Hoch|Tief|");
  CHECK(chosen({"--label-where", "name = 'Low'"}) == "Low|");
  CHECK(chosen({"--label-elevation", "m"}) == "High 303 m|Low 250 m|");
  CHECK(chosen({"--label-elevation", "ft"}) == "High 994 ft|Low 820 ft|");
  const Words eye{"--eye",           "5,395,150", "--projection",     "cylindrical",
                  "--azimuth-range", "0:180",     "--altitude-range", "-30:60"};
  Words near = eye;
  near.insert(near.end(), {"--label-range", "0.3"});
  CHECK(chosen(near) == "High|");
  const Json of_eye = report_of(folder, eye).at("names"); // one cone behind the other
  CHECK(listed(of_eye.at("hidden")) == "Low|");
  CHECK(of_eye.at("hidden").at(0).at("hidden_mm") > 0.2);
  CHECK(of_eye.at("hidden").at(0).at("distance_m").get<double>() == Approx(700));
  CHECK(of_eye.at("chosen").at(0).at("azimuth_deg").get<double>() == Approx(90));
}

TEST_CASE("The report tells of furniture, where it is and what it says") {
  const MadeFolder folder;
  write_files(folder);
  CHECK_FALSE(report_of(folder, {}).contains("furniture"));
  const Json furniture =
      report_of(folder, {"--furniture", "map", "--title", std::string(300, 'm'), "--source", "S"})
          .at("furniture");
  CHECK(furniture.at("left_out").empty());
  REQUIRE(furniture.at("letters").size() == 1);
  std::string pieces;
  for (const Json& piece : furniture.at("pieces")) {
    const std::string name = piece.at("piece");
    pieces += name + " ";
    CHECK(piece.at("box_mm").at(0) < piece.at("box_mm").at(2));
    CHECK(piece.at("box_mm").at(1) < piece.at("box_mm").at(3));
    CHECK(piece.at("cut").size() == (name == "title" ? 1 : 0));
    if (name == "source") CHECK(piece.at("texts") == Json{"S"});
    if (name == "title") CHECK(piece.at("cut") == Json{std::string(300, 'm')});
  }
  CHECK(pieces == "window title north scale caption source ");
}

TEST_CASE("What is wrong with labels is one line that says what would be right") {
  const MadeFolder folder;
  write_files(folder);
  const std::vector<std::pair<Words, std::string>> wrong{
      {{"--label-max", "3"}, "--label-max has no meaning without names: give --labels FILE too"},
      {{"--labels", "none.csv"}, "none.csv"},
      {{"--labels", "names.csv", "--label-field", "title"}, "has no field title: one of name,"},
      {{"--labels", "names.csv", "--label-range", "3"}, "no meaning without an eye"},
      {{"--labels", "names.csv", "--label-angle", "30"}, "no meaning but in a panorama"},
      {{"--labels", "names.csv", "--of", "geojson"}, "in formats for a GIS, which have no page"},
      {{"--labels", "names.csv", "--label-where", "x >"}, "x >"},
      {{"--contour-labels"}, "no meaning without index contours"},
      {{"--coordinate-labels"}, "no meaning without lines that have coordinates"}};
  for (const auto& [words, said] : wrong) {
    const ProgramRun run = render(folder, words);
    INFO(words[0] << ": " << run.err);
    CHECK(run.exit_code != 0);
    CHECK(has(run.err, said));
    CHECK(fault_of_message(run.err) == "");
  }
}

} // namespace orograph::label_options_test
