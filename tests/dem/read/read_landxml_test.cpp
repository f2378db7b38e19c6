// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/read/map_shapes.hpp"
#include "tests/dem/read/refused.hpp"
#include "tests/dem/read/tin_of_file.hpp"

namespace orograph::read_landxml_test {
namespace {

const std::string points = "<P id=\"1\">2000 1000 1</P><P id=\"2\">2000 1010 2</P>"
                           "<P id=\"7\">2010 1010 3.5</P><P id=\"4\">2010 1000 4</P>";
const std::string faces = "<F n=\"2 0 0\">1 2 7</F><F>1 7 4</F>";

std::string surface(const std::string& name, const std::string& pnts = points,
                    const std::string& fcs = faces) {
  return "<Surface name=\"" + name + "\"><SourceData/><Definition surfType=\"TIN\"><Pnts>" + pnts +
         "</Pnts><Faces>" + fcs + "</Faces></Definition></Surface>";
}

std::string document(const std::string& surfaces, const std::string& head = "") {
  return "<?xml version=\"1.0\"?>\n<LandXML "
         "xmlns=\"http://www.landxml.org/schema/LandXML-1.2\">\n" +
         head + "<Surfaces>\n" + surfaces + "\n</Surfaces>\n</LandXML>\n";
}

std::string units(const std::string& attributes, const std::string& system = "Imperial") {
  return "<Units><" + system + " areaUnit=\"acre\" " + attributes + "/></Units>";
}

TerrainData read_back(const std::string& text, const ReadOptions& options = {}) {
  const TempFolder folder;
  write_text(folder.file("site.xml"), text);
  return read_terrain(folder.file("site.xml"), options);
}

void refused(const std::string& text, const std::vector<std::string>& words,
             const ReadOptions& options = {}) {
  const TempFolder folder;
  write_text(folder.file("site.xml"), text);
  INFO(text);
  check_message(message_of(folder.file("site.xml"), options), words);
}

ReadOptions named(const std::string& layer) {
  ReadOptions options;
  options.layer = layer;
  return options;
}

const std::vector<std::array<Corner, 3>> square{
    {Corner{1000, 2000, 1}, Corner{1010, 2000, 2}, Corner{1010, 2010, 3.5}},
    {Corner{1000, 2000, 1}, Corner{1010, 2010, 3.5}, Corner{1000, 2010, 4}}};

} // namespace

TEST_CASE("LandXML points are northing, easting, elevation") {
  const TerrainData terrain = read_back(document(surface("a")));
  CHECK(triangles_on_map(terrain) == square);
  CHECK(terrain.map.origin == Vec2{1000, 2010});
  CHECK(terrain.map.unit_m == 1);
  CHECK(has_word(terrain.notes, "taken as metres"));
}

TEST_CASE("faces marked as invisible are left out") {
  const TerrainData terrain =
      read_back(document(surface("a", points,
                                 "<F>1 2 7</F><F i=\"1\">1 7 4</F><F i=\"0\">4 1 7</F>"
                                 "</Faces><Faces><F i=\"1\">1 2 7</F>")));
  CHECK(triangles_on_map(terrain) == square);
  CHECK(has_word(terrain.notes, "2 faces marked as invisible"));
  refused(document(surface("a", points, "<F i=\"1\">1 2 7</F>")), {"no visible faces"});
}

TEST_CASE("units of LandXML") {
  const auto read = [](const std::string& head) {
    return read_back(document(surface("a"), head)).map;
  };
  CHECK(read(units("linearUnit=\"foot\"")).unit_m == 0.3048);
  CHECK(read(units("linearUnit=\"foot\"")).height_unit_m == 0.3048);
  CHECK(read(units("linearUnit=\"USSurveyFoot\"")).unit_m == 1200. / 3937.);
  CHECK(read(units("linearUnit=\"USSurveyFoot\"")).unit_name == "US survey foot");
  CHECK(read(units("linearUnit=\"USSurveyFoot\" elevationUnit=\"feet\"")).height_unit_m ==
        1200. / 3937.);
  CHECK(read(units("linearUnit=\"meter\"", "Metric")).unit_m == 1);
  CHECK(read(units("linearUnit=\"kilometer\" elevationUnit=\"meter\"", "Metric")).height_unit_m ==
        1);
  CHECK(read(units("linearUnit=\"meter\" elevationUnit=\"feet\"", "Metric")).height_unit_m ==
        0.3048);
  refused(document(surface("a"), units("linearUnit=\"rod\"")), {"'rod'", "USSurveyFoot"});
}

TEST_CASE("the CRS of LandXML is kept where it fits the units") {
  const std::string utm = "<CoordinateSystem epsgCode=\"32632\"/>";
  const TerrainData metres =
      read_back(document(surface("a"), units("linearUnit=\"meter\"", "Metric") + utm));
  CHECK(metres.map.crs_name == "WGS 84 / UTM zone 32N (EPSG:32632)");
  CHECK(metres.notes.empty());
  const TerrainData feet = read_back(document(surface("a"), units("linearUnit=\"foot\"") + utm));
  CHECK(feet.map.crs_name == "none");
  CHECK(feet.map.unit_m == 0.3048);
  CHECK(has_word(feet.notes, "is in metre but its coordinates are in foot"));
  const TerrainData nearly = read_back(document(
      surface("a"), units("linearUnit=\"foot\"") + "<CoordinateSystem epsgCode=\"EPSG:2229\"/>"));
  CHECK(nearly.map.unit_name == "US survey foot");
  CHECK(nearly.map.height_unit_m == nearly.map.unit_m);
  const TerrainData wkt = read_back(document(
      surface("a"), "<CoordinateSystem epsgCode=\"\" "
                    "ogcWktCode=\"LOCAL_CS[&quot;site&quot;,UNIT[&quot;foot&quot;,0.3048]]\"/>"));
  CHECK(wkt.map.crs_name == "site");
  CHECK(wkt.map.height_unit_m == 0.3048);
  const TerrainData unknown =
      read_back(document(surface("a"), "<CoordinateSystem epsgCode=\"999999\"/>"));
  CHECK(unknown.map.crs_name == "none");
  CHECK(has_word(unknown.notes, "isn't known"));
  refused(document(surface("a"), "<CoordinateSystem epsgCode=\"4326\"/>"), {"degrees"});
}

TEST_CASE("one surface of several is picked by name") {
  const std::string two = document(surface("old") + surface("new", points, "<F>1 2 7</F>"));
  refused(two, {"2 surfaces", "'old', 'new'", "`layer`"});
  CHECK(tin_in(read_back(two, named("old"))).triangles.size() == 2);
  CHECK(tin_in(read_back(two, named("new"))).triangles.size() == 1);
  refused(two, {"no surfaces 'newer'", "'old', 'new'"}, named("newer"));
  refused(document(surface("a") + surface("a")), {"2 surfaces 'a'"}, named("a"));
  refused(document(surface("a")), {"'b'", "'a'"}, named("b"));
  CHECK(tin_in(read_back(document(surface("a")), named("a"))).triangles.size() == 2);
}

TEST_CASE("LandXML with a prefix for its namespace") {
  std::string text = document(surface("a"));
  for (std::size_t at = 0; (at = text.find('<', at)) != std::string::npos; ++at)
    if (text[at + 1] != '?') text.insert(at + (text[at + 1] == '/' ? 2 : 1), "lx:");
  CHECK(triangles_on_map(read_back(text)) == square);
}

TEST_CASE("LandXML that can't be a surface is refused") {
  const std::string whole = document(surface("a"));
  refused(whole.substr(0, whole.size() / 2), {"isn't whole XML", "line 4"});
  refused("<LandXML><Surfaces>", {"XML"});
  refused("<LandXML/>", {"holds no surface"});
  refused(document("<Surface name=\"a\"><SourceData/></Surface>"), {"no triangles"});
  refused(document("<Surface name=\"a\"><Definition surfType=\"grid\"/></Surface>"), {"'grid'"});
  refused(document(surface("a", points, "")), {"no visible faces"});
  refused(document(surface("a", points, "<F>1 2</F>")), {"face 1", "2 corners"});
  refused(document(surface("a", points, "<F>1 2 7</F><F>1 2 7 4</F>")), {"face 2", "4 corners"});
  refused(document(surface("a", points, "<F>1 2 3</F>")), {"face 1", "'3'"});
  for (const char* bad : {"2000 1000", "2000 1000 nan", "2000 1000 1 1", "", "a b c"})
    refused(document(surface("a", points + "<P id=\"9\">" + bad + "</P>")),
            {"point 9", "northing, easting, elevation"});
  refused(document(surface("a", points + "<P id=\"7\">0 0 0</P>")), {"two points", "'7'"});
  refused(document(surface("a",
                           "<P id=\"1\">1e10 0 0</P><P id=\"2\">0 0 0</P>"
                           "<P id=\"7\">0 1 0</P>",
                           "<F>1 2 7</F>")),
          {"no place on earth"});
}

} // namespace orograph::read_landxml_test
