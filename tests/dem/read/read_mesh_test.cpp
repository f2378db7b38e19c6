// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/frame/local_frame.hpp"
#include "dem/read/map_shapes.hpp"
#include "tests/dem/read/refused.hpp"
#include "tests/dem/read/tin_of_file.hpp"

#include <bit>
#include <cstdint>

namespace orograph::read_mesh_test {
namespace {

// Two triangles over a square of 10 m, on both sides of the diagonal from 0 to 2.
const std::string off = "OFF\n4 2 0\n0 0 1\n10 0 2\n10 10 3.5\n0 10 4\n3 0 1 2\n3 0 2 3\n";
const std::string obj = "v 0 0 1\nv 10 0 2\nv 10 10 3.5\nv 0 10 4\nf 1 2 3\nf 1 3 4\n";
const std::string ply_header = "ply\nformat ascii 1.0\nelement vertex 4\nproperty double x\n"
                               "property double y\nproperty double z\nelement face 2\n"
                               "property list uchar int vertex_indices\nend_header\n";
const std::string ply = ply_header + "0 0 1\n10 0 2\n10 10 3.5\n0 10 4\n3 0 1 2\n3 0 2 3\n";
const std::string stl =
    "solid hill\nfacet normal 0 0 1\nouter loop\nvertex 0 0 1\nvertex 10 0 2\nvertex 10 10 3.5\n"
    "endloop\nendfacet\nfacet normal 0 0 1\nouter loop\nvertex 0 0 1\nvertex 10 10 3.5\n"
    "vertex 0 10 4\nendloop\nendfacet\nendsolid hill\n";

const std::vector<std::array<Corner, 3>> square{
    {Corner{0, 0, 1}, Corner{10, 0, 2}, Corner{10, 10, 3.5}},
    {Corner{0, 0, 1}, Corner{10, 10, 3.5}, Corner{0, 10, 4}}};

template <class Value>
void append(std::string& bytes, Value value, bool big_endian = false) {
  std::array<char, sizeof value> raw = std::bit_cast<std::array<char, sizeof value>>(value);
  if (big_endian) std::reverse(raw.begin(), raw.end());
  bytes.append(raw.data(), raw.size());
}

constexpr std::array<std::array<float, 3>, 4> corners{
    {{0, 0, 1}, {10, 0, 2}, {10, 10, 3.5}, {0, 10, 4}}};
constexpr std::array<std::array<int, 3>, 2> faces{{{0, 1, 2}, {0, 2, 3}}};

std::string binary_stl() {
  std::string bytes(80, ' ');
  append(bytes, std::uint32_t{2});
  for (const auto& face : faces) {
    for (int i = 0; i < 3; ++i) append(bytes, 0.F);
    for (const int corner : face)
      for (const float c : corners[static_cast<std::size_t>(corner)]) append(bytes, c);
    append(bytes, std::uint16_t{0});
  }
  return bytes;
}

std::string binary_ply(bool big_endian, const std::string& count_type = "uchar") {
  std::string bytes = ply_header;
  const auto replace = [&](const std::string& old, const std::string& with) {
    bytes.replace(bytes.find(old), old.size(), with);
  };
  replace("ascii", big_endian ? "binary_big_endian" : "binary_little_endian");
  replace("list uchar", "list " + count_type);
  for (const auto& corner : corners)
    for (const float c : corner) append(bytes, static_cast<double>(c), big_endian);
  for (const auto& face : faces) {
    if (count_type == "uchar")
      append(bytes, std::uint8_t{3});
    else
      append(bytes, std::uint32_t{3}, big_endian);
    for (const int corner : face) append(bytes, corner, big_endian);
  }
  return bytes;
}

TerrainData read_back(const std::string& name, const std::string& text,
                      const ReadOptions& options = {}) {
  const TempFolder folder;
  write_text(folder.file(name), text);
  return read_terrain(folder.file(name), options);
}

void refused(const std::string& name, const std::string& text,
             const std::vector<std::string>& words, const ReadOptions& options = {}) {
  const TempFolder folder;
  write_text(folder.file(name), text);
  INFO(text.substr(0, 500));
  std::vector<std::string> all = words;
  all.push_back(name);
  check_message(message_of(folder.file(name), options), all);
}

std::string changed(std::string text, const std::string& old, const std::string& with) {
  const std::size_t at = text.find(old);
  REQUIRE(at != std::string::npos);
  return text.replace(at, old.size(), with);
}

} // namespace

TEST_CASE("the same triangles from every mesh format") {
  CHECK(triangles_on_map(read_back("a.off", off)) == square);
  CHECK(triangles_on_map(read_back("a.OBJ", obj)) == square);
  CHECK(triangles_on_map(read_back("a.ply", ply)) == square);
  CHECK(triangles_on_map(read_back("a.stl", stl)) == square);
  CHECK(triangles_on_map(read_back("a.stl", binary_stl())) == square);
  CHECK(triangles_on_map(read_back("a.ply", binary_ply(false))) == square);
  CHECK(triangles_on_map(read_back("a.ply", binary_ply(true))) == square);
  CHECK(triangles_on_map(read_back("a.ply", binary_ply(false, "uint"))) == square);
  // By the first bytes where the extension tells nothing.
  CHECK(triangles_on_map(read_back("mesh", off)) == square);
  CHECK(triangles_on_map(read_back("mesh.data", ply)) == square);
  // A binary STL may begin with the word of a text one.
  CHECK(triangles_on_map(read_back("a.stl", "solid" + binary_stl().substr(5))) == square);
}

TEST_CASE("forms of text that mean the same") {
  CHECK(triangles_on_map(read_back("a.off", "# made by hand\n" + off)) == square);
  CHECK(triangles_on_map(read_back("a.off", changed(off, "OFF\n", "OFF "))) == square);
  CHECK(triangles_on_map(read_back("a.off", changed(off, "10 0 2\n", "\n 1e1 0 2 # b\n#c\n"))) ==
        square);
  CHECK(triangles_on_map(read_back("a.off", off + "\n\n# the end")) == square);
  CHECK(triangles_on_map(read_back("a.off", changed(off, "3 0 1 2", "3 0 1 2 255 0 0"))) == square);
  CHECK(triangles_on_map(read_back("a.obj", changed(obj, "f 1 2 3", "f 1/1/1 2/2/2 3//3"))) ==
        square);
  CHECK(triangles_on_map(read_back("a.obj", changed(obj, "f 1 3 4", "f -4 -2 -1"))) == square);
  CHECK(triangles_on_map(read_back("a.obj", "mtllib a.mtl\no hill\n" + obj)) == square);
  CHECK(triangles_on_map(read_back("a.obj", changed(obj, "f 1 2 3", "f 1\t2\t3"))) == square);
  std::string windows;
  for (const char c : off) windows += c == '\n' ? "\r\n" : std::string(1, c);
  CHECK(triangles_on_map(read_back("a.off", windows)) == square);
}

TEST_CASE("without a comment a mesh is in metres") {
  const TerrainData terrain = read_back("a.off", off);
  CHECK(terrain.map.unit_m == 1);
  CHECK(terrain.map.crs_name == "none");
  CHECK(terrain.map.origin == Vec2{0, 10});
  CHECK(tin_in(terrain).vertices_m[0] == Vec3{0, -10, 1});
  CHECK(terrain.surface_error_m == 0);
  CHECK(has_word(terrain.notes, "no CRS: its coordinates and heights are taken as metres"));
}

TEST_CASE("comments tell the CRS, the units and the error") {
  const std::string wkt = "LOCAL_CS[\"site grid\",UNIT[\"foot\",0.3048]]";
  const std::string told =
      "orograph: surface_error_m 2.5\n# orograph: crs " + wkt + "\n# orograph: units 0.3048 1\n";
  const auto check = [&](const TerrainData& terrain) {
    CHECK(terrain.surface_error_m == 2.5);
    CHECK(terrain.map.unit_m == 0.3048);
    CHECK(terrain.map.unit_name == "foot");
    CHECK(terrain.map.height_unit_m == 1);
    CHECK(terrain.map.crs_name == "site grid");
    CHECK(tin_in(terrain).vertices_m[1].x == 10 * 0.3048);
    CHECK(tin_in(terrain).vertices_m[1].z == 2);
    CHECK(terrain.notes.empty());
  };
  check(read_back("a.off", changed(off, "OFF\n", "OFF\n# " + told)));
  check(read_back("a.obj", "# " + told + obj));
  std::string comments = "comment " + told;
  for (std::size_t at; (at = comments.find("# ")) != std::string::npos;)
    comments.replace(at, 2, "comment ");
  check(read_back("a.ply", changed(ply, "element vertex", comments + "element vertex")));

  const TerrainData units_only = read_back("a.off", off + "# orograph: units 0.3048 0.3048\n");
  CHECK(units_only.map.crs_name == "none");
  CHECK(units_only.map.height_unit_name == "foot");
  CHECK(has_word(units_only.notes, "foot"));
  const TerrainData epsg = read_back("a.obj", "# orograph: crs EPSG:2229\n" + obj);
  CHECK(std::abs(epsg.map.unit_m - 1200. / 3937.) < 1e-12);
  CHECK(epsg.map.height_unit_m == epsg.map.unit_m);
  CHECK(has_word(read_back("a.obj", "# orograph: crs nonsense\n" + obj).notes, "can't be underst"));
  CHECK(has_word(read_back("a.obj", "# orograph: crs +proj=utm +zone=32 +title=\xff\n" + obj).notes,
                 "can't be underst"));
  std::string latin1 = epsg.map.crs_wkt;
  latin1.replace(latin1.find("NAD83"), 5, "R\xe9union");
  CHECK(read_back("a.obj", "# orograph: crs " + latin1 + "\n" + obj).map.crs_name != "none");
  const TerrainData last_counts =
      read_back("a.obj", "# orograph: crs EPSG:4326\n# orograph: crs EPSG:2229\n" + obj);
  CHECK(last_counts.map.crs_wkt == epsg.map.crs_wkt);
  // Not one of our comments.
  CHECK(read_back("a.obj", "o orograph: surface_error_m 3\n" + obj).surface_error_m == 0);
  refused("a.obj", "# orograph: surface_error_m -1\n" + obj, {"surface_error_m", "metres"});
  refused("a.obj", "# orograph: units 0 1\n" + obj, {"units", "metres"});
  refused("a.obj", "# orograph: crs EPSG:4326\n" + obj, {"degrees"});
}

TEST_CASE("the earth's radii are those where the triangles are") {
  const TerrainData terrain =
      read_back("a.obj", "# orograph: crs EPSG:32632\nv 500000 5205164 1\nv 500010 5205164 2\n"
                         "v 500010 5205174 3\nf 1 2 3\n");
  REQUIRE(terrain.map.radii);
  CHECK(terrain.map.radii->meridian_m == Approx(euler_radius_m({}, 47, Angle())).epsilon(1e-6));
}

TEST_CASE("a window keeps the triangles inside it") {
  ReadOptions options;
  options.bbox = Box2{{0, 0}, {10, 10}};
  CHECK(triangles_on_map(read_back("a.off", off, options)) == square);
  // Vertex 3 is moved outside: so is its triangle, and the origin follows what is kept.
  options.bbox = Box2{{0, 0}, {10, 10.5}};
  const TerrainData cut = read_back("a.off", changed(off, "0 10 4", "0 11 4"), options);
  CHECK(tin_in(cut).triangles.size() == 1);
  CHECK(tin_in(cut).vertices_m.size() == 3);
  CHECK(cut.map.origin == Vec2{0, 10});
  options.bbox = Box2{{20, 20}, {30, 30}};
  refused("a.off", off, {"holds nothing", "reaches from 0,0 to 10,10"}, options);
  options.bbox = Box2{{30, 20}, {20, 30}};
  const TempFolder folder;
  write_text(folder.file("a.off"), off);
  check_message(message_of(folder.file("a.off"), options), {"window", "is empty", "south-west"});
}

TEST_CASE("a vertex without a triangle doesn't move the origin") {
  const TerrainData terrain =
      read_back("a.off", changed(changed(off, "4 2 0", "5 2 0"), "0 10 4\n", "0 10 4\n-9 99 0\n"));
  CHECK(terrain.map.origin == Vec2{0, 10});
  CHECK(tin_in(terrain).vertices_m.size() == 4);
}

TEST_CASE("OFF with wrong counts is refused") {
  refused("a.off", changed(off, "4 2 0", "5 2 0"), {"5 vertices and 2 faces", "6 lines"});
  refused("a.off", changed(off, "4 2 0", "4 3 0"), {"4 vertices and 3 faces", "truncated"});
  refused("a.off", changed(off, "4 2 0", "4 1 0"), {"4 vertices and 1 faces", "6 lines"});
  refused("a.off", changed(off, "4 2 0", "5 1 0"), {"5 vertices and 1 faces", "four numbers"});
  refused("a.off", changed(off, "4 2 0", "3 3 0"), {"line 6"});
  refused("a.off", changed(off, "4 2 0", "4000000000 2 0"), {"4000000000 vertices"});
  refused("a.off", changed(off, "4 2 0", "4 18446744073709551615 0"), {"faces", "6 lines"});
  refused("a.off", changed(off, "4 2 0", "-4 2 0"), {"line 2", "counts"});
  refused("a.off", changed(off, "4 2 0\n", ""), {"counts"});
  refused("a.off", changed(off, "4 2 0\n", "4 2\n"), {"counts"});
}

TEST_CASE("OFF's faces name vertices by whole numbers") {
  for (const char* const face : {"0 -1 2", "0 1.7 2", "0 4 2", "0 1e30 2", "0 nan 2"})
    refused("a.off", changed(off, "3 0 1 2", std::string("3 ") + face),
            {"line 7", "a vertex that isn't there", "vertices are 0 to 3"});
}

TEST_CASE("PLY with wrong counts is refused") {
  refused("a.ply", changed(ply, "face 2", "face 3"), {"ends at face 3 of 3"});
  refused("a.ply", changed(ply, "face 2", "face 1"), {"more than its header says"});
  refused("a.ply", changed(ply, "vertex 4", "vertex 5"), {"a.ply"});
  refused("a.ply", changed(ply, "vertex 4", "vertex 3"), {"a.ply"});
  refused("a.ply", changed(ply, "vertex 4", "vertex 99999999999"), {"ends at", "99999999999"});
  std::string bytes = binary_ply(false);
  refused("a.ply", changed(bytes, "face 2", "face 3"), {"ends at face 3 of 3"});
  refused("a.ply", changed(bytes, "face 2", "face 1"), {"more than"});
  refused("a.ply", bytes + "!", {"more than"});
}

TEST_CASE("elements of PLY that hold nothing take no time") {
  CHECK(triangles_on_map(
            read_back("a.ply", changed(ply, "element face",
                                       "element note 9999999999999999\nelement face"))) == square);
}

TEST_CASE("meshes that end early are refused, wherever they do") {
  const TempFolder folder;
  const auto check_cuts = [&](const std::string& name, const std::string& text,
                              std::size_t still_whole) {
    for (std::size_t size = 0; size + still_whole < text.size(); size += 2) {
      write_text(folder.file(name), text.substr(0, size));
      INFO(name << " cut at " << size);
      check_message(message_of(folder.file(name)), {name});
    }
  };
  check_cuts("a.off", off, 2); // without the last line's end, and with an index of one digit less
  check_cuts("a.ply", ply, 2);
  check_cuts("a.ply", binary_ply(true), 0);
  check_cuts("a.stl", binary_stl(), 0);
  check_cuts("a.stl", stl, 6); // the name after endsolid
}

TEST_CASE("faces that aren't triangles are refused with a hint") {
  refused("a.off", changed(off, "3 0 1 2", "4 0 1 2 3"), {"line 7", "4 corners", "triangle"});
  refused("a.off", changed(off, "3 0 1 2", "2 0 1"), {"line 7", "2 corners"});
  refused("a.off", changed(off, "3 0 1 2", "99999999999 0 1 2"), {"line 7", "corners"});
  refused("a.off", changed(off, "3 0 1 2", "3.5 0 1 2"), {"line 7", "no face"});
  refused("a.obj", changed(obj, "f 1 2 3", "f 1 2 3 4"), {"line 5", "4 corners", "triangle"});
  refused("a.obj", changed(obj, "f 1 2 3", "f 1 2"), {"line 5", "2 corners"});
  refused("a.ply", changed(ply, "3 0 1 2", "4 0 1 2 3"), {"face 1 of 2", "4 corners"});
  refused("a.stl", changed(stl, "vertex 10 0 2\n", ""), {"line 6", "2 corners"});
}

TEST_CASE("faces of vertices that aren't there are refused") {
  refused("a.off", changed(off, "3 0 2 3", "3 0 2 4"), {"line 8"});
  refused("a.off", changed(off, "3 0 2 3", "3 0 2 -1"), {"line 8"});
  refused("a.off", changed(off, "3 0 2 3", "3 0 2"), {"line 8"});
  refused("a.off", changed(off, "3 0 2 3", "3 0 2 x"), {"line 8"});
  for (const char* bad : {"5", "0", "-5", "99999999999", "x"})
    refused("a.obj", changed(obj, "f 1 3 4", std::string("f 1 3 ") + bad), {});
  refused("a.ply", changed(ply, "3 0 2 3", "3 0 2 4"), {"face 2", "4 vertices"});
  refused("a.ply", changed(ply, "3 0 2 3", "3 0 2 -1"), {"face 2", "4 vertices"});
}

TEST_CASE("coordinates that are no numbers are refused") {
  for (const std::string bad : {"nan", "NaN", "inf", "-inf", "1e999", "x", "1,5", "--1"}) {
    refused("a.off", changed(off, "10 0 2\n", "10 0 " + bad + "\n"), {"line 4", bad});
    refused("a.obj", changed(obj, "v 10 0 2\n", "v 10 " + bad + " 2\n"), {"line 2", bad});
    refused("a.ply", changed(ply, "10 0 2\n", bad + " 0 2\n"), {"vertex 2 of 4"});
    refused("a.stl", changed(stl, "10 0 2\n", "10 0 " + bad + "\n"), {"line 5", bad});
  }
  refused("a.off", changed(off, "10 0 2\n", "10 0\n"), {"line 4", "2 coordinates"});
  std::string bytes = binary_stl();
  const float nan = std::numeric_limits<float>::quiet_NaN();
  bytes.replace(84 + 50 + 12 + 32, 4, reinterpret_cast<const char*>(&nan), 4);
  refused("a.stl", bytes, {"triangle 2 of 2", "nan"});
  std::string normal = binary_stl(); // which isn't read
  normal.replace(84 + 50, 4, reinterpret_cast<const char*>(&nan), 4);
  CHECK(triangles_on_map(read_back("a.stl", normal)) == square);
}

TEST_CASE("places that are none on earth are refused") {
  refused("a.off", changed(off, "10 0 2", "1e30 0 2"), {"1e+30", "no place on earth"});
  refused("a.obj", changed(obj, "v 10 0 2", "v 10 -2e9 2"), {"-2000000000", "no place on earth"});
  refused("a.ply", changed(ply, "10 0 2", "10 0 -1e38"), {"no place on earth"});
}

TEST_CASE("files that are no meshes are refused") {
  std::string noise;
  for (unsigned i = 0; i < 3000; ++i) noise += static_cast<char>((i * 2654435761U) >> 13U);
  for (const char* name : {"a.off", "a.ply", "a.obj", "a.stl"}) {
    refused(name, noise, {});
    refused(name, "", {"empty"});
    refused(name, "\n", {});
    refused(name, "not a mesh\n", {});
    const TempFolder folder;
    check_message(message_of(folder.file(name)), {name, "no such file"});
  }
  refused("a.off", ply, {"isn't OFF"});
  refused("a.ply", off, {"isn't PLY"});
  refused("a.off", "OFF\n0 0 0\n", {"no faces"});
  refused("a.off", "4OFF\n0 0 0\n", {"4OFF"});
  refused("a.off", "OFF BINARY\n0 0 0\n", {"BINARY"});
  refused("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n", {"a.obj"});
  refused("a.obj", "x 0 0 0\n" + obj, {"line 1"});
  refused("a.ply", changed(ply, "vertex_indices", "corners"), {"vertex_indices"});
  refused("a.ply", changed(ply, "double z", "double h"), {"have no z"});
  refused("a.ply", changed(ply, "double z", "int z"), {"no z of type"});
  refused("a.ply", changed(ply, "ascii", "utf8"), {"line 2", "format"});
  refused("a.ply", changed(ply, "property double x", "property x"), {"line 4"});
  refused("a.ply", changed(ply, "list uchar", "list float"), {"line 8"});
  refused("a.ply",
          "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\n"
          "property float z\nend_header\n1 2 3\n",
          {"no faces", "text"});
}

} // namespace orograph::read_mesh_test
