// SPDX-License-Identifier: GPL-3.0-or-later
// Each drawing of a sweep is, byte for byte, what `orograph render` draws, and all files are the
// same from any number of threads and shards.
#include "tests/catch.hpp"
#include "tests/sweep/made_sweep.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <sstream>

using namespace orograph;

namespace {

const std::string kData = std::string(OROGRAPH_SOURCE_DIR) + "/data_samples/";

// What render is told of each view, by the drawing's name.
using Renders = std::vector<std::pair<std::string, Words>>;

void check_same(const MadeFolder& folder, const Words& inputs, const std::string& format,
                const Words& shared, const Words& varied, const Renders& renders) {
  run_well(folder, Words{"sweep", inputs.front(), "out"} + Words(inputs.begin() + 1, inputs.end()) +
                       words("-q --overwrite -j 2 --of " + format) + shared + varied);
  const auto files = contents(folder, "out");
  CHECK(files.size() == 2 * renders.size() + 4);
  for (const auto& [name, options] : renders) {
    const std::string output = "one." + format;
    run_well(folder, Words{"render", inputs.front(), output} +
                         Words(inputs.begin() + 1, inputs.end()) + words("-q --overwrite") +
                         shared + options);
    INFO(name << " as " << format);
    const auto drawn = files.find(name + "." + format);
    REQUIRE(drawn != files.end());
    CHECK(drawn->second.size() > 400);
    CHECK((drawn->second == folder.read(output)));
  }
}

const Words kViews = words("--azimuth 0:360:72 --elevation 10:50:20");

void sweep_into(const MadeFolder& folder, const std::string& out_dir, const Words& more) {
  run_well(folder, words("sweep hill.asc -q") + Words{out_dir} + kSmall + kViews + more);
}

// Without the last column, which is the seconds.
std::string without_last_column(const std::string& csv) {
  std::istringstream lines(csv);
  std::string line, out;
  while (std::getline(lines, line)) out += line.substr(0, line.rfind(',')) + "\n";
  return out;
}

} // namespace

TEST_CASE("around a terrain, in every format", "[slow]") {
  const MadeFolder folder;
  make_terrains(folder);
  Renders renders;
  for (const char* azimuth : {"000", "123.4", "270"})
    for (const char* elevation : {"05", "90"}) {
      const std::string azimuth_text = fmt::format("{:05.1f}", std::stod(azimuth));
      renders.emplace_back(fmt::format("azimuth-{}_elevation-{}", azimuth_text, elevation),
                           Words{"--view-from", fmt::format("{}/{}", azimuth, elevation)});
    }
  for (const std::string format : {"svg", "geojson", "gpkg", "pdf", "ps", "eps", "png"})
    check_same(folder, {"hill.asc"}, format, kSmall,
               words("--azimuth 0,123.4,270 --elevation 5,90"), renders);
}

TEST_CASE("distances, fields of view, exaggerations, profiles; crossed and together", "[slow]") {
  const MadeFolder folder;
  make_terrains(folder);
  const Words shared = words("--page 60x45 --margin 2 --title Hills --simplify 0.1 --occluder "
                             "profiles --flat draw --layers profiles,silhouettes --check 40");
  Renders renders;
  for (const char* distance : {"0400", "1500"})
    for (const char* fov : {"20", "95"})
      for (const char* exaggeration : {"0.5", "2.0"})
        for (const char* profiles : {"5", "9"})
          renders.emplace_back(fmt::format("distance-{}_fov-{}_exaggeration-{}_profiles-{}",
                                           distance, fov, exaggeration, profiles),
                               Words{"--distance", distance, "--fov", fov, "--exaggeration",
                                     exaggeration, "--profiles", profiles});
  check_same(folder, {"hill.asc"}, "svg", shared,
             words("--distance 400,1500 --fov 20,95 --exaggeration 0.5,2 --profiles 5:9:4"),
             renders);
  check_same(folder, {"hill.asc"}, "geojson", kSmall,
             words("--azimuth 10,20,30 --elevation 40,30,20 --fov 50:70:10 --zip --name z{index}"),
             {{"z0", words("--view-from 10/40 --fov 50")},
              {"z1", words("--view-from 20/30 --fov 60")},
              {"z2", words("--view-from 30/20 --fov 70")}});
  check_same(folder, {"hill.asc"}, "svg", words("--projection orthographic --page 60x45"),
             words("--azimuth 33:53:10"),
             {{"azimuth-33", words("--view-from 33/25")},
              {"azimuth-43", words("--view-from 43/25")},
              {"azimuth-53", words("--view-from 53/25")}});
  // Nothing varies: a sweep of one view.
  check_same(folder, {"hill.asc"}, "pdf", kSmall, {}, {{"view", {}}});
}

TEST_CASE("by pens, within a rectangle, for a plotter", "[slow]") {
  const MadeFolder folder;
  make_terrains(folder);
  folder.write("pens.toml", "[[pen]]\nnumber = 2\nwidth = 0.1\nlayers = ['profiles']\n"
                            "[[pen]]\nnumber = 1\nwidth = 0.4\nspeed = 30\n");
  folder.write("mine.toml",
               "language = 'hpgl'\nname = 'mine'\nunit = 0.05\npens = 2\nwait = 'NR;'\n");
  for (const std::string format : {"svg", "hpgl"})
    check_same(folder, {"hill.asc"}, format,
               words("--page 60x45 --margin 2 --pens pens.toml --pause-between-pens --clip-to "
                     "40x30 --pen-order best") +
                   (format == "hpgl" ? words("--device mine.toml") : Words{}),
               words("--azimuth 20,140"),
               {{"azimuth-020", words("--view-from 20/25")},
                {"azimuth-140", words("--view-from 140/25")}});
}

TEST_CASE("with names, and furniture around each view") {
  const MadeFolder folder;
  make_terrains(folder);
  folder.write("names.csv", "name,x,y\nFirst,120,120\nSecond,60,170\nNowhere,-9000,0\n");
  folder.write("house.toml", "source = 'a survey'\n");
  const Words shared = words("--page 120x90 --layers skyline,border --labels names.csv --furniture "
                             "map --template house.toml --title Hills");
  check_same(
      folder, {"hill.asc"}, "svg", shared, words("--azimuth 20,140"),
      {{"azimuth-020", words("--view-from 20/25")}, {"azimuth-140", words("--view-from 140/25")}});
  const auto rows = nlohmann::json::parse(folder.read("out/sweep.json")).at("views");
  REQUIRE(rows.size() == 2);
  for (const auto& row : rows)
    CHECK(row.at("names").get<int>() + row.at("names_hidden").get<int>() +
              row.at("names_without_room").get<int>() ==
          2);
  // A template decides what is drawn by what it says.
  folder.write("house.toml", "source = 'another'\n");
  const auto other = run(folder, words("sweep hill.asc out -q --resume --azimuth 20,140") + shared);
  CHECK(other.exit_code != 0);
}

TEST_CASE("eyes along a path", "[slow]") {
  const MadeFolder folder;
  make_terrains(folder);
  folder.write("high.geojson", line_text("[400,100,350],[410,100,400]"));
  Renders renders;
  for (const auto& [eye, place] : {std::pair{"0", "120,20"}, {"1", "120,60"}, {"2", "120,100"}})
    for (const char* azimuth : {"000", "090", "350"})
      renders.emplace_back(fmt::format("eye-{}_look-azimuth-{}", eye, azimuth),
                           Words{"--eye", place, "--look-azimuth", azimuth});
  // A CSV has no CRS; what could be degrees in GeoJSON is taken for degrees.
  folder.write("inside.csv", "id,WKT\n1,\"LINESTRING(120 20,120 60,120 100)\"\n");
  check_same(folder, {"hill.asc"}, "svg", kSmall + words("--fov 80 --eye-height 30 --pitch -60"),
             words("--eye-path inside.csv --look-azimuth 0,90,350"), renders);
  check_same(folder, {"hill.asc"}, "gpkg", kSmall,
             words("--eye-path inside.csv --eye-step 40 --fov 60,140 --pitch=-55"),
             {{"eye-0_fov-060", words("--eye 120,20 --look-azimuth 0 --fov 60 --pitch -55")},
              {"eye-0_fov-140", words("--eye 120,20 --look-azimuth 0 --fov 140 --pitch -55")},
              {"eye-1_fov-060", words("--eye 120,60 --look-azimuth 0 --fov 60 --pitch -55")},
              {"eye-1_fov-140", words("--eye 120,60 --look-azimuth 0 --fov 140 --pitch -55")},
              {"eye-2_fov-060", words("--eye 120,100 --look-azimuth 0 --fov 60 --pitch -55")},
              {"eye-2_fov-140", words("--eye 120,100 --look-azimuth 0 --fov 140 --pitch -55")}});
  check_same(folder, {"hill.asc"}, "geojson", kSmall + words("--look-at 120,120"),
             words("--eye-path high.geojson"),
             {{"eye-0", words("--eye 400,100,350")}, {"eye-1", words("--eye 410,100,400")}});
}

TEST_CASE("panoramas along a path, each with the way ahead in its middle", "[slow]") {
  const MadeFolder folder;
  make_terrains(folder);
  folder.write("inside.csv", "id,WKT\n1,\"LINESTRING(60 60,120 60,180 60)\"\n");
  const auto eyes = [](const std::string& more) {
    Renders renders;
    for (const auto& [eye, place] : {std::pair{"0", "60,60"}, {"1", "120,60"}, {"2", "180,60"}})
      renders.emplace_back(fmt::format("eye-{}", eye),
                           words("--eye " + std::string(place) + " " + more));
    return renders;
  };
  const Words cylinder = kSmall + words("--eye-height 30 --strips 2 --projection cylindrical"),
              angles = kSmall + words("--eye-height 30 --projection equirectangular");
  check_same(folder, {"hill.asc"}, "svg", cylinder, words("--eye-path inside.csv"),
             eyes("--look-azimuth 90"));
  check_same(folder, {"hill.asc"}, "geojson", angles, words("--eye-path inside.csv"),
             eyes("--look-azimuth 90"));
  // And with a range of its own, wherever the path leads.
  check_same(folder, {"hill.asc"}, "svg", cylinder,
             words("--eye-path inside.csv --azimuth-range 300:420"),
             eyes("--azimuth-range 300:420"));
}

TEST_CASE("each eye has its own frame on the earth", "[slow]") {
  const MadeFolder folder;
  folder.write("sail.csv", "id,WKT\n1,\"LINESTRING(2.2 0.3,2.5 0.3,2.7 0.6)\"\n");
  const Words whole{kData + "archipelago.tif"};
  const Words shared = kSmall + words("--eye-height 900 --fov 70 --bbox 2.1,0.2,2.8,0.7");
  for (const std::string format : {"svg", "geojson"})
    check_same(
        folder, whole, format, shared,
        words("--eye-path sail.csv --look-azimuth 80 --exaggeration 1,2"),
        {{"eye-0_exaggeration-1", words("--eye 2.2,0.3 --look-azimuth 80 --exaggeration 1")},
         {"eye-0_exaggeration-2", words("--eye 2.2,0.3 --look-azimuth 80 --exaggeration 2")},
         {"eye-1_exaggeration-1", words("--eye 2.5,0.3 --look-azimuth 80 --exaggeration 1")},
         {"eye-1_exaggeration-2", words("--eye 2.5,0.3 --look-azimuth 80 --exaggeration 2")},
         {"eye-2_exaggeration-1", words("--eye 2.7,0.6 --look-azimuth 80 --exaggeration 1")},
         {"eye-2_exaggeration-2", words("--eye 2.7,0.6 --look-azimuth 80 --exaggeration 2")}});
  check_same(
      folder, whole, "svg", kSmall, words("--azimuth 45,300 --exaggeration auto"),
      {{"azimuth-045", words("--view-from 45/25")}, {"azimuth-300", words("--view-from 300/25")}});
}

TEST_CASE("whole views of a list, and what they cut away", "[slow]") {
  const MadeFolder folder;
  make_terrains(folder);
  const std::string common = "projection = 'parallel'\nvrp = [120, 120, 100]\nvpn = [0, -1, 1]\n"
                             "prp = [0, 0, 100]\nwindow = [-150, -150, 150, 150]\n";
  const std::string cut = common + "front = 30\nback = -30\n", eye = common + "exaggeration = 2\n";
  folder.write("whole.toml", common);
  folder.write("cut.toml", cut);
  folder.write("eye.toml", eye);
  folder.write("list.toml", "[[view]]\nname = 'whole'\n" + common + "[[view]]\n" + cut +
                                "[[view]]\nname = 'high up'\n" + eye);
  for (const std::string format : {"svg", "geojson"})
    check_same(folder, {"hill.asc"}, format, words("--page 60x45"),
               words("--views list.toml --profiles 8,12"),
               {{"view-whole_profiles-08", words("--view whole.toml --profiles 8")},
                {"view-whole_profiles-12", words("--view whole.toml --profiles 12")},
                {"view-1_profiles-08", words("--view cut.toml --profiles 8")},
                {"view-1_profiles-12", words("--view cut.toml --profiles 12")},
                {"view-high up_profiles-08", words("--view eye.toml --profiles 8")},
                {"view-high up_profiles-12", words("--view eye.toml --profiles 12")}});
  // On the earth the cut and the frame are both the view's own.
  std::string sea = common;
  sea.replace(sea.find("[120, 120, 100]"), 15, "[2.5, 0.5, 0]");
  sea.replace(sea.find("[-150, -150, 150, 150]"), 22, "[-60000, -60000, 60000, 60000]");
  sea.replace(sea.find("[0, 0, 100]"), 11, "[0, 0, 99000]");
  folder.write("sea.toml", sea + "front = 9000\nback = -9000\n");
  folder.write("whole-sea.toml", sea);
  folder.write("seas.toml", "[[view]]\n" + sea + "front = 9000\nback = -9000\n[[view]]\n" + sea);
  check_same(folder, {kData + "archipelago.tif"}, "svg", kSmall, words("--views seas.toml"),
             {{"view-0", words("--view sea.toml")}, {"view-1", words("--view whole-sea.toml")}});
}

TEST_CASE("a TIN, and terrain made of points") {
  const MadeFolder folder;
  const Words quarry{kData + "quarry_points.csv", "--breaklines",
                     kData + "quarry_breaklines.geojson"};
  check_same(folder, quarry, "svg", kSmall, words("--azimuth 20,200 --name q{azimuth}"),
             {{"q020", words("--view-from 20/25")}, {"q200", words("--view-from 200/25")}});
}

TEST_CASE("threads, shards and merging change no byte of any file", "[slow]") {
  const MadeFolder folder;
  make_terrains(folder);
  const Words no_seconds{"--no-seconds"};
  sweep_into(folder, "one", no_seconds + words("-j 1"));
  const auto expected = contents(folder, "one");
  REQUIRE(expected.size() == 2 * 15 + 4);
  for (const std::string jobs : {"2", "7"}) {
    sweep_into(folder, "j" + jobs, no_seconds + Words{"-j", jobs});
    CHECK(differences(expected, contents(folder, "j" + jobs)) == "");
  }
  for (const int count : {3, 40}) {
    const std::string together = fmt::format("together{}", count);
    Words apart;
    for (int index = count; index >= 1; --index) {
      if (count == 40 && index < 14) continue; // those after the 15th have nothing to draw
      const Words shard{"--shard", fmt::format("{}/{}", index, count)};
      sweep_into(folder, together, no_seconds + shard);
      apart.push_back(fmt::format("part{}of{}", index, count));
      sweep_into(folder, apart.back(), no_seconds + shard + words("-j 2"));
    }
    if (count == 40) {
      // A merge of some tells what is missing, and makes tables of what there is.
      const ProgramRun ended = run(folder, {"merge", together});
      CHECK(ended.exit_code == 1);
      INFO(ended.err);
      CHECK(fault_of_message(ended.err) == "");
      CHECK(ended.err.find("13 of 15 views are missing in together40, "
                           "'azimuth-000_elevation-10' among them") != std::string::npos);
      continue;
    }
    run_well(folder, {"merge", together, "-q"});
    CHECK(differences(expected, contents(folder, together)) == "");
    const std::string merged = fmt::format("merged{}", count);
    run_well(folder, Words{"merge", merged} + apart);
    CHECK(differences(expected, contents(folder, merged)) == "");
    run_well(folder, {"merge", merged}); // once more changes nothing
    CHECK(differences(expected, contents(folder, merged)) == "");
    run_well(folder, Words{"merge"} + apart); // into the first of them
    CHECK(differences(expected, contents(folder, apart.front())) == "");
  }
}

TEST_CASE("of two runs only the seconds differ") {
  const MadeFolder folder;
  make_terrains(folder);
  sweep_into(folder, "a", words("-j 1"));
  sweep_into(folder, "b", words("-j 2"));
  auto a = contents(folder, "a"), b = contents(folder, "b");
  for (auto* files : {&a, &b}) {
    auto& csv = (*files)["sweep.csv"];
    CHECK(csv.substr(0, csv.find('\n')).ends_with(",seconds"));
    csv = without_last_column(csv);
    auto table = nlohmann::ordered_json::parse((*files)["sweep.json"]);
    for (auto& row : table["views"]) {
      CHECK(row["seconds"].get<double>() > 0);
      row.erase("seconds");
    }
    (*files)["sweep.json"] = table.dump();
    files->erase("index.html"); // holds the table
    for (auto& [path, text] : *files)
      if (path.starts_with("rows/")) {
        auto row = nlohmann::ordered_json::parse(text);
        row["row"].erase("seconds");
        text = row.dump();
      }
  }
  CHECK(differences(a, b) == "");
}

TEST_CASE("the tables tell the same, and name every file") {
  const MadeFolder folder;
  make_terrains(folder);
  sweep_into(folder, "out", words("--title comma,\"quote\" --no-seconds"));
  const auto table = nlohmann::ordered_json::parse(folder.read("out/sweep.json"));
  std::istringstream csv(folder.read("out/sweep.csv"));
  std::string line;
  std::getline(csv, line);
  std::string names;
  for (const auto& column : table["columns"])
    names += (names.empty() ? "" : ",") + column["name"].get<std::string>();
  CHECK(line == names);
  CHECK(table["varied"] == nlohmann::json({"azimuth_deg", "elevation_deg"}));
  CHECK(table["views_planned"] == 15);
  // What the page marks is what is chosen where it is asked for.
  run_well(folder, words("render hill.asc one.svg -q --view-from auto --report one.json") + kSmall);
  const auto chosen = nlohmann::json::parse(folder.read("one.json"))["view"];
  CHECK(table["chosen"]["azimuth_deg"] == chosen["view_from_azimuth_deg"]);
  CHECK(table["chosen"]["elevation_deg"] == chosen["elevation_deg"]);
  REQUIRE(table["views"].size() == 15);
  std::size_t view = 0;
  for (const int azimuth : {0, 72, 144, 216, 288})
    for (const int elevation : {10, 30, 50}) {
      const auto& row = table["views"][view];
      CHECK(row["view"] == view);
      CHECK(row["azimuth_deg"] == azimuth);
      CHECK(row["elevation_deg"] == elevation);
      CHECK(row["error"].is_null());
      CHECK(row["file"] == fmt::format("azimuth-{:03}_elevation-{}.svg", azimuth, elevation));
      CHECK(folder.read("out/" + row["file"].get<std::string>()).ends_with("</svg>\n"));
      CHECK(row["visible_share"].get<double>() > 0);
      CHECK(row["visible_share"].get<double>() <= 1 + 1e-9);
      std::getline(csv, line);
      std::istringstream cells(line);
      for (const auto& column : table["columns"]) {
        std::string cell;
        std::getline(cells, cell, ',');
        const auto& value = row[column["name"].get<std::string>()];
        CHECK(cell == (value.is_null()     ? ""
                       : value.is_string() ? value.get<std::string>()
                                           : value.dump()));
      }
      ++view;
    }
}
