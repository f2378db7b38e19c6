// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/read/map_shapes.hpp"
#include "tests/dem/read/refused.hpp"
#include "tests/dem/temp_folder.hpp"
#include "tests/support/random.hpp"

#include <cstdio>
#include <limits>

namespace orograph::read_points_test {
namespace {

const std::array<std::string, 3> xyz{"x", "y", "z"};

MapShapes points_in(const std::string& text, const std::array<std::string, 3>& columns = xyz) {
  const TempFolder folder;
  write_text(folder.file("a.csv"), text);
  return read_points(folder.file("a.csv"), columns);
}

void refused(const std::string& text, const std::vector<std::string>& words,
             const std::array<std::string, 3>& columns = xyz) {
  ReadOptions options;
  options.columns = columns;
  const TempFolder folder;
  write_text(folder.file("a.csv"), text);
  INFO(text);
  std::vector<std::string> all = words;
  all.emplace_back("a.csv");
  check_message(message_of(folder.file("a.csv"), options), all);
}

const std::vector<Vec3> three{{1, 2.5, 3}, {-4, 5e2, 6}, {7, 8, 9}};

} // namespace

TEST_CASE("points in every form of text") {
  for (const char* text :
       {"x,y,z\n1,2.5,3\n-4,5e2,6\n7,8,9\n", "x;y;z\n1;2.5;3\n-4;5e2;6\n7;8;9",
        "x\ty\tz\n1\t2.5\t3\n-4\t5e2\t6\n7\t8\t9\n", "x y z\n1 2.5 3\n  -4   5e2 6 \n7 8 9\n",
        "X, Y, Z\r\n 1, 2.5, 3\r\n-4, 5e2, 6\r\n+7, 8, 9\r\n",
        "\xEF\xBB\xBF# by hand\n\n\"X\",\"Y\",\"Z\"\n1,2.5,3\n# between\n-4,5e2,6\n\n7,8,9\n",
        "x,y,z,\n1,2.5,3,\n-4,5e2,6,\n7,8,9,\n", "\"x\" \"y\" \"z\"\n1 2.5 3\n-4 5e2 6\n7 8 9\n",
        "z,n,name,x,y\n3,0,\"a, b\",1,2.5\n6,0,,-4,5e2\n9,0,c,7,8\n",
        "Easting,Northing,Elevation\n1,2.5,3\n-4,5e2,6\n7,8,9\n",
        "id,E,N,height\n1,1,2.5,3\n2,-4,5e2,6\n3,7,8,9\n",
        // As pdal writes it.
        "\"X\",\"Y\",\"Z\",\"Intensity\"\n1.000,2.500,3.000,0.000\n-4,500,6,0\n7,8,9,0\n"}) {
    INFO(text);
    const MapShapes shapes = points_in(text);
    CHECK(shapes.points == three);
    CHECK(shapes.notes.empty());
  }
}

TEST_CASE("three columns without names are x, y, z") {
  for (const char* text : {"1 2.5 3\n-4 5e2 6\n7 8 9\n", "1,2.5,3\n-4,500,6\n7,8,9\n",
                           "# x y z\n1\t2.5\t3\n-4\t500\t6\n7\t8\t9\n"}) {
    const MapShapes shapes = points_in(text);
    CHECK(shapes.points == three);
    REQUIRE(shapes.notes.size() == 1);
    CHECK(shapes.notes[0].find("x, y, z") != std::string::npos);
  }
  refused("1,1000,2000,3,tree\n", {"no column 'x'"});
  refused("1,1000,2000,3\n", {"4 columns", "no line that names"});
  refused("1,2\n3,4\n", {"2 columns"});
}

TEST_CASE("columns are found by the names that are given") {
  const std::string text = "Rechts;Hoch;Hoehe;x\n1;2.5;3;0\n-4;5e2;6;0\n7;8;9;0\n";
  CHECK(points_in(text, {"rechts", "HOCH", "Hoehe"}).points == three);
  refused(text, {"no column 'y'", "Rechts, Hoch, Hoehe, x", "`columns`"});
  refused(text, {"no column 'height'"}, {"Rechts", "Hoch", "height"});
  refused("x,y,z,X\n1,2,3,4\n", {"2 columns named 'x'"});
}

TEST_CASE("columns in degrees are refused") {
  refused("lon,lat,ele\n6.8,45.8,4808\n", {"degrees", "'lon'", "ogr2ogr"});
  refused("name,Latitude,Longitude,height\na,45.8,6.8,4808\n", {"degrees", "ogr2ogr"});
  refused("lon,lat,ele\n6.8,45.8,4808\n", {"degrees"}, {"lon", "lat", "ele"});
}

TEST_CASE("bad lines are named by their number") {
  const std::string good = "x,y,z\n1,2,3\n";
  refused(good + "# c\n1,2,abc\n", {"line 4", "z is 'abc'"});
  refused(good + "\n1,,3\n", {"line 4", "y is empty"});
  refused(good + "1,2,\n", {"line 3", "z is empty"});
  refused(good + "1,2\n", {"line 3", "2 columns", "3 as the first line"});
  refused(good + "1,2,3,4\n", {"line 3", "4 columns"});
  refused(good + "1,5,2,5,3,5\n", {"line 3", "6 columns", "decimal point"});
  refused("x;y;z\n1,5;2,5;3,5\n", {"line 2", "x is '1,5'", "decimal point"});
  for (const char* bad : {"nan", "NaN", "inf", "-inf", "1e999", "0x10", "1_000", "--", "1 2"})
    refused(good + "1,2," + bad + "\n", {"line 3", "z is '" + std::string(bad) + "'", "finite"});
  refused("x y z\n1 2 3\n1 2\n", {"line 3", "2 columns"});
  refused("1 2 3\n1 2 z\n", {"line 2", "z is 'z'"});
}

TEST_CASE("what isn't text with points is refused") {
  refused("", {"empty"});
  refused("# only a comment\n", {"empty"});
  refused("x,y,z\n", {"no points"});
  refused(std::string("x,y,z\n1,2,3\n\0\1\2\n", 17), {"line 3", "plain text"});
  refused(std::string("\xFF\xFEx\0,\0y\0", 8), {"plain text"});
  refused("x,y,z\n1,2,3\n\x1b[31m,2,3\n", {"line 3", "plain text"});
  refused("x,y,z\n0,0,0\n1e10,0,0\n0,1,0\n", {"no place on earth", "1e+10"});
  refused("x,y,z\n0,0,-1e38\n1,0,0\n0,1,0\n", {"no place on earth"});
}

TEST_CASE("numbers are read as they were written, however many there are") {
  Random random(7);
  std::vector<Vec3> wanted;
  std::string text = "x,y,z\n";
  for (int i = 0; i < 5000; ++i) {
    wanted.push_back({random.between(4e5, 5e5), random.between(-5e6, 5e6),
                      random.between(-1, 1) * std::pow(10, random.whole(-12, 4))});
    char line[100];
    std::snprintf(line, sizeof line, "%.17g,%.17g,%.17g\n", wanted.back().x, wanted.back().y,
                  wanted.back().z);
    text += line;
  }
  CHECK(points_in(text).points == wanted);
}

TEST_CASE("a line of too many columns or bytes is refused by its limit") {
  const TempFolder folder;
  std::string names = "x,y,z";
  for (int i = 0; i < 1000; ++i) names += ",a";
  std::ofstream(folder.file("wide.csv")) << names << "\n";
  std::ofstream(folder.file("long.csv")) << "x,y,z\n" << std::string(1'000'001, '1') << "\n";
  const auto told = [&](const char* name) -> std::string {
    try {
      read_points(folder.file(name), {"x", "y", "z"});
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  };
  CHECK(told("wide.csv").find("1003 columns, more than 1000") != std::string::npos);
  CHECK(told("long.csv").find("line 2 has more than 1,000,000 bytes") != std::string::npos);
}

} // namespace orograph::read_points_test
