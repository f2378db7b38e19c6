// SPDX-License-Identifier: GPL-3.0-or-later
// View files: what is read, what is refused and in which words, and the way there and back.
#include "cli/report/run_report.hpp"
#include "tests/catch.hpp"
#include "tests/cli/made_files.hpp"
#include "tests/view/matrices.hpp"
#include "tests/view/random_phigs_view.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <bit>
#include <cstdint>
#include <limits>
#include <vector>

using namespace orograph;

namespace {

const std::string kPerspective = "projection = \"perspective\"\n"
                                 "vrp = [512000, 118000, 1200.5]\n"
                                 "vpn = [0, -1, 0.25]\n"
                                 "prp = [0, 0, 4000]\n"
                                 "window = [-1000, -500, 1000, 500]\n";

// A cavalier view: lines to the north rise by 45 degrees to the right.
const std::string kParallel = "# comment\r\n"
                              "projection = 'parallel' # another\r\n"
                              "window = [ -1e3, -5e2,\r\n  1_000, 0x1F4, ]\r\n"
                              "vup = [0, 0, 2]\r\nvpn = [0, -1, 0]\r\n"
                              "prp = [-0.70710678118654752, -0.70710678118654752, 1]\r\n"
                              "vrp = [+512000.0, 123456789, 0]\r\n"
                              "front = 2000\r\nback = -2_000.5\r\n";

// Every number's bits, so that -0 isn't 0.
std::vector<std::uint64_t> bits(const ViewFile& view) {
  const Box2& w = view.window_m;
  std::vector<std::uint64_t> all;
  for (const Vec3& p : {view.vrp_map, view.vpn, view.vup, view.prp_m})
    for (const double n : {p.x, p.y, p.z}) all.push_back(std::bit_cast<std::uint64_t>(n));
  for (const double n : {w.low.x, w.low.y, w.high.x, w.high.y})
    all.push_back(std::bit_cast<std::uint64_t>(n));
  for (const auto& plane : {view.front_m, view.back_m}) {
    all.push_back(plane.has_value() ? 1 : 0);
    if (plane) all.push_back(std::bit_cast<std::uint64_t>(*plane));
  }
  all.push_back(std::bit_cast<std::uint64_t>(view.exaggeration));
  all.push_back(view.projection == PhigsProjection::parallel ? 1 : 0);
  return all;
}

ViewFile random_view_file(Random& random) {
  const PhigsView view = random_phigs_view(
      random, random.pick({PhigsProjection::perspective, PhigsProjection::parallel}));
  ViewFile file{view.projection, {}, view.vpn, view.vup, view.prp_m, view.window_m, {}, {}, 1};
  const auto any = [&] {
    const double special = random.pick({-0.0, 5e-324, -1e300, 1e22, 0.1, 123456789012345680.0,
                                        -9007199254740994.0, 1e15, 1.0 / 3});
    return random.chance(0.3) ? special : random.between(-1e7, 1e7);
  };
  file.vrp_map = {any(), any(), any()};
  if (random.chance(0.6)) file.front_m = view.front_m;
  if (random.chance(0.6)) file.back_m = view.back_m;
  file.exaggeration = random.pick({1.0, random.between(0.1, 10)});
  return file;
}

// `text` with the line that begins with `key` replaced (or the new one added).
std::string with(const std::string& text, const std::string& key, const std::string& line) {
  std::string changed;
  bool found = false;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = text.find('\n', at) + 1;
    const std::string old = text.substr(at, end - at);
    const bool is_it = old.starts_with(key + " ");
    found = found || is_it;
    changed += !is_it ? old : line.empty() ? "" : line + "\n";
    at = end;
  }
  return found ? changed : changed + line + "\n";
}

// Says `words`, in one line that begins with the file's name.
void check_refused_file(const std::string& content, const std::string& words,
                        const std::string& name = "my view.toml") {
  const MadeFolder folder;
  const std::string path = folder.write(name, content);
  INFO(content.substr(0, 1000));
  check_refused([&] { read_view(path); }, words);
  check_refused([&] { read_view(path); }, path);
  try {
    read_view(path);
    FAIL("it isn't refused");
  } catch (const Error& error) {
    CHECK(std::string(error.what()).starts_with(path));
  }
}

} // namespace

TEST_CASE("a view file in TOML") {
  const MadeFolder folder;
  const ViewFile a = read_view(folder.write("a.toml", kPerspective));
  CHECK(a.projection == PhigsProjection::perspective);
  CHECK(a.vrp_map == Vec3{512000, 118000, 1200.5});
  CHECK(a.vpn == Vec3{0, -1, 0.25});
  CHECK(a.vup == Vec3{0, 0, 1});
  CHECK(a.prp_m == Vec3{0, 0, 4000});
  CHECK(a.window_m.low == Vec2{-1000, -500});
  CHECK(a.window_m.high == Vec2{1000, 500});
  CHECK(!a.front_m);
  CHECK(!a.back_m);

  // Whatever the name's ending, but for .json.
  const ViewFile b = read_view(folder.write("b", kParallel));
  CHECK(b.projection == PhigsProjection::parallel);
  CHECK(b.vrp_map == Vec3{512000, 123456789, 0});
  CHECK(b.vup == Vec3{0, 0, 2});
  CHECK(b.prp_m == Vec3{-0.70710678118654752, -0.70710678118654752, 1});
  CHECK(b.window_m.low == Vec2{-1000, -500});
  CHECK(b.window_m.high == Vec2{1000, 500});
  CHECK(b.front_m == 2000.0);
  CHECK(b.back_m == -2000.5);
}

TEST_CASE("a view that is written reads back bit for bit", "[slow]") {
  const MadeFolder folder;
  for (std::uint64_t seed = 1; seed <= 1000; ++seed) {
    Random random(seed);
    const ViewFile view = random_view_file(random);
    const std::string text = view_file_text(view);
    INFO("seed " << seed << '\n' << text);
    const ViewFile back = read_view(folder.write("view.toml", text));
    REQUIRE(bits(back) == bits(view));
    REQUIRE(view_file_text(back) == text);
  }
}

TEST_CASE("a view from a run report") {
  const MadeFolder folder;
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    Random random(seed);
    const ViewFile view = random_view_file(random);
    const auto list = [](Vec3 p) { return nlohmann::json{p.x, p.y, p.z}; };
    const auto plane = [](std::optional<double> n) {
      return n ? nlohmann::json(*n) : nlohmann::json();
    };
    const bool parallel = view.projection == PhigsProjection::parallel;
    const Box2& w = view.window_m;
    const nlohmann::json phigs{{"projection", parallel ? "parallel" : "perspective"},
                               {"vrp", list(view.vrp_map)},
                               {"vpn", list(view.vpn)},
                               {"vup", list(view.vup)},
                               {"prp", list(view.prp_m)},
                               {"window", {w.low.x, w.low.y, w.high.x, w.high.y}},
                               {"exaggeration", view.exaggeration},
                               {"front", plane(view.front_m)},
                               {"back", plane(view.back_m)}};
    const nlohmann::json report{{"schema", 1}, {"view", {{"projection", "-"}, {"phigs", phigs}}}};
    INFO("seed " << seed << '\n' << report.dump(2));
    REQUIRE(bits(read_view(folder.write("r.JSON", report.dump(2)))) == bits(view));
  }
  const std::string none = "no report of a run with a view to take over (view.phigs)";
  for (const char* text : {"{}", "[]", "3", "{\"view\": null}", "{\"view\": {\"eye\": null}}",
                           "{\"view\": {\"phigs\": null}}", "{\"view\": {\"phigs\": [1]}}"})
    check_refused_file(text, none, "r.json");
  check_refused_file("", "line 1: this isn't JSON", "r.json");
  check_refused_file("{\n\"view\": {\n\"eye\" 3}}\n", "line 3: this isn't JSON", "r.json");
  check_refused_file(kPerspective, "line 1: this isn't JSON", "r.json");
  const char* deep = "line 1: lists and objects are nested over 100 deep";
  check_refused_file(std::string(100'000, '['), deep, "r.json");
  check_refused_file(std::string(100'000, '[') + std::string(100'000, ']'), deep, "r.json");
  check_refused_file(std::string(20'000'001, ' '), "too large for a view (over 20 MB)", "r.json");
  check_refused_file("{\"x\": 1e999}", "a number is too large", "r.json");
  const auto phigs = [](const std::string& inside) {
    return "{\"view\": {\"phigs\": {" + inside + "}}}";
  };
  check_refused_file(phigs("\"vrrp\": 3"), "unknown key 'vrrp': did you mean vrp?", "r.json");
  check_refused_file(phigs("\"vrp\": null"), "vrp is null", "r.json");
  check_refused_file(phigs("\"vrp\": {}"), "vrp is an object", "r.json");
  check_refused_file(phigs("\"vrp\": [1, 2, \"3\"]"), "doesn't hold numbers alone", "r.json");
  check_refused_file(phigs("\"vrp\": [1, 2]"), "vrp is a list of 2 numbers", "r.json");
  check_refused_file(phigs("\"front\": true"), "front is true or false", "r.json");
  check_refused_file(phigs("\"vrp\": [1, 2, 3]"), "projection is missing", "r.json");
}

TEST_CASE("what is no view file") {
  const MadeFolder folder;
  check_refused([&] { read_view(folder.path("nowhere.toml")); }, "nowhere.toml: no such file");
  check_refused([&] { read_view(folder.path("nowhere.json")); }, "nowhere.json: no such file");
  check_refused([&] { read_view(folder.path()); }, " is a folder");
  check_refused([&] { read_view("/dev/zero"); }, "/dev/zero is too large for a view");
  check_refused_file(std::string(1'000'001, '#'), "is too large for a view (over 1 MB)");
  check_refused_file(ascii_grid(3, 3, [](int, int) { return 1.0; }), "line 1: this isn't TOML");
  check_refused_file(geotiff(3, 3, [](int, int) { return 1.0; }), "line 1: this isn't TOML");
  check_refused_file(kPerspective + "front = \n", "line 6: this isn't TOML");
  check_refused_file(kPerspective + "prp = [0, 0, 9]\n", "line 6: this isn't TOML"); // twice
  check_refused_file("vrp = [0, 0, 99999999999999999999]\n", "line 1: this isn't TOML");
  check_refused_file("vrp = \"\xff\x1b[31m\"\n", "line 1: this isn't TOML");
  check_refused_file(std::string(100'000, '['), "this isn't TOML");
}

TEST_CASE("keys and values that a view file can't have") {
  const auto refused = [](const std::string& key, const std::string& line,
                          const std::string& words) {
    check_refused_file(with(kPerspective, key, line), words);
  };
  refused("windw", "windw = [0, 0, 1, 1]", "line 6: unknown key 'windw': did you mean window? a");
  refused("prp", "prpp = [0, 0, 4000]", "line 4: unknown key 'prpp': did you mean prp? a view has");
  refused("exaggeration", "exaggeration = 0", "the exaggeration is not above 0");
  refused("exaggeration", "exaggeration = -1", "the exaggeration is not above 0");
  refused("exaggeration", "exaggeration = 1001", "up to 1000");
  refused("exaggeration", "exaggeration = [2]", "line 6: exaggeration is a list of 1 number");
  refused("exageration", "exageration = 2", "line 6: unknown key 'exageration': did you mean");
  refused("Front", "Front = 2", "line 6: unknown key 'Front': did you mean front? a view has");
  refused("view", "[view]", "line 6: unknown key 'view': a view has projection, vrp,");
  refused("xyz", "xyz = 1", "line 6: unknown key 'xyz': a view has");
  refused("vrp", "vrpx = 1\na = 2", "line 2: unknown key 'vrpx'"); // the first in the file
  refused("\"", "\"a\\nb\" = 1", "line 6: unknown key 'a?b'");

  refused("projection", "", "projection is missing: give a word, as in projection = \"persp");
  refused("vrp", "", "vrp is missing: give a list of 3 numbers, as in vrp = [500000, 100000,");
  refused("vpn", "", "vpn is missing: give a list of 3 numbers");
  refused("prp", "", "prp is missing: give a list of 3 numbers");
  refused("window", "", "window is missing: give a list of 4 numbers");
  check_refused_file("", "projection is missing");

  refused("projection", "projection = 1", "line 1: projection is a single number: give a word");
  refused("projection", "projection = [1]", "line 1: projection is a list of 1 number: give a");
  refused("projection", "projection = \"Perspective\"",
          "line 1: there is no projection 'Perspective': give \"perspective\" or \"parallel\"");
  refused("vrp", "vrp = 5", "line 2: vrp is a single number: give a list of 3 numbers");
  refused("vrp", "vrp = \"5,6,7\"", "line 2: vrp is text: give a list of 3 numbers");
  refused("vrp", "vrp = {x = 1}", "line 2: vrp is a table: give a list of 3 numbers");
  refused("vrp", "vrp = 2020-01-01", "line 2: vrp is a time: give a list of 3 numbers");
  refused("vrp", "vrp = [[1, 2, 3]]", "line 2: vrp is a list that doesn't hold numbers alone");
  refused("vrp", "vrp = [1, 2, true]", "line 2: vrp is a list that doesn't hold numbers alone");
  refused("vrp", "vrp = [1, 2, \"3\"]", "line 2: vrp is a list that doesn't hold numbers alone");
  refused("vrp", "vrp = []", "line 2: vrp is a list of 0 numbers: give a list of 3");
  refused("vrp", "vrp = [1, 2]", "line 2: vrp is a list of 2 numbers: give a list of 3");
  refused("vpn", "vpn = [1, 2, 3, 4]", "line 3: vpn is a list of 4 numbers: give a list of 3");
  refused("window", "window = [1, 2, 3]", "line 5: window is a list of 3 numbers: give a list");
  refused("front", "front = [1]", "line 6: front is a list of 1 number: give a number");
  refused("back", "back = false", "line 6: back is true or false: give a number");
  refused("vup", "vup = 1", "line 6: vup is a single number");

  refused("vrp", "vrp = [nan, 0, 0]", "line 2: vrp is not finite");
  refused("window", "window = [-1, -1, inf, 1]", "line 5: window is not finite");
  refused("front", "front = -inf", "line 6: front is not finite");
  refused("back", "back = 1e999", "line 6"); // the library's word, or ours
}

TEST_CASE("views that no terrain can be drawn in") {
  const auto refused = [](const std::string& text, const std::string& key, const std::string& line,
                          const std::string& words) {
    check_refused_file(with(text, key, line), words);
  };
  const std::string parallel = with(kPerspective, "projection", "projection = \"parallel\"");
  for (const std::string& text : {kPerspective, parallel}) {
    refused(text, "window", "window = [1, -1, 1, 1]", "the window is empty: umin should be less");
    refused(text, "window", "window = [-1, 1, 1, -1]", "the window is empty");
    refused(text, "prp", "prp = [0, 0, -1]", "(PRP) lies behind the view plane");
    refused(text, "vpn", "vpn = [0, 0, 0]", "(VPN) has length 0");
    refused(text, "vup", "vup = [0, -0.0, 0]", "(VUP) has length 0");
    refused(text, "vpn", "vpn = [0, 0, -3]", "(VPN) is parallel to the view up vector (VUP)");
    refused(text, "front", "front = -5\nback = -5", "the front plane lies at the back plane or");
    refused(text, "front", "front = -6\nback = -5", "the front plane lies at the back plane or");
  }
  refused(kPerspective, "prp", "prp = [0, 0, 0]", "the eye (PRP) lies on the view plane");
  refused(parallel, "prp", "prp = [9, 0, 0]", "the direction of projection lies in the view plane");
  refused(kPerspective, "front", "front = 4000", "the front plane lies at the eye (PRP) or behind");
  refused(kPerspective, "front", "front = 4001\nback = 0", "the front plane lies at the eye (PRP)");
  refused(kPerspective, "back", "back = 4000", "the back plane lies at the eye (PRP) or behind it");
  refused(kPerspective, "back", "back = 1e300", "the back plane lies at the eye (PRP) or behind");

  // As far as they go, and any of the two planes alone.
  const MadeFolder folder;
  const auto accepted = [&](const std::string& text, const std::string& key,
                            const std::string& line) {
    const std::string path = folder.write("view.toml", with(text, key, line));
    INFO(line);
    CHECK_NOTHROW(read_view(path));
  };
  accepted(kPerspective, "front", "front = 3999.999");
  accepted(kPerspective, "back", "back = 3999.999");
  accepted(kPerspective, "front", "front = 3999\nback = 3998.999");
  accepted(kPerspective, "front", "front = -1e300");
  for (const char* line : {"front = 5000", "back = 5000", "front = -1e300", "back = -1e300",
                           "front = 9001\nback = 9000", "back = 1e300"})
    accepted(parallel, "front", line);
}
