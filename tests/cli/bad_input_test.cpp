// SPDX-License-Identifier: GPL-3.0-or-later
// Bad input, as a user meets it: the cases of bad_input.txt, and disks that are full.
#include "tests/catch.hpp"
#include "tests/cli/made_files.hpp"
#include "tests/cli/made_scenes.hpp"
#include "tests/cli/run_program.hpp"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>

using namespace orograph;
namespace fs = std::filesystem;

namespace {

struct Case {
  std::string name, run, error;
  int exit_code = 0;
};

std::vector<Case> read_cases() {
  std::ifstream file(std::string(OROGRAPH_SOURCE_DIR) + "/tests/cli/bad_input.txt");
  std::vector<Case> cases;
  std::string line;
  while (std::getline(file, line)) {
    if (line.empty() || line.starts_with('#')) continue;
    const auto colon = line.find(':');
    const std::string word = line.substr(0, colon);
    const std::string rest = line.size() > colon + 2 ? line.substr(colon + 2) : "";
    if (word == "case") cases.push_back({.name = rest, .run = {}, .error = {}});
    REQUIRE_FALSE(cases.empty());
    if (word == "run") cases.back().run = rest;
    if (word == "exit") cases.back().exit_code = std::stoi(rest);
    if (word == "error") cases.back().error = rest;
  }
  return cases;
}

std::vector<std::string> words(const std::string& text) {
  std::istringstream stream(text);
  return {std::istream_iterator<std::string>(stream), {}};
}

const std::string kDegrees = "GEOGCS[\"WGS 84\",DATUM[\"WGS_1984\",SPHEROID[\"WGS 84\",6378137,"
                             "298.257223563]],PRIMEM[\"Greenwich\",0],"
                             "UNIT[\"degree\",0.0174532925199433]]";

constexpr int kSize = 40;
double small_hill_m(int column, int row) {
  return hill_m(column, row, kSize);
}

// A view of the hill from the south, but for the lines that are given.
void write_view(const MadeFolder& folder, const std::string& name,
                const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string line :
       {"projection = 'parallel'", "vrp = [200, 200, 100]", "vpn = [0, -1, 1]", "vup = [0, 0, 1]",
        "prp = [0, 0, 100]", "window = [-200, -200, 200, 200]", "front = 1000", "back = -1000"}) {
    const std::string key = line.substr(0, line.find('=') + 1);
    const auto other = std::find_if(lines.begin(), lines.end(),
                                    [&](const std::string& l) { return l.starts_with(key); });
    text += (other == lines.end() ? line : *other) + "\n";
  }
  folder.write(name, text);
}

void make_inputs(const MadeFolder& folder) {
  const auto nothing = [](int, int) { return -9999.0; };
  folder.write("hill.asc", ascii_grid(kSize, kSize, small_hill_m));
  folder.write("row.asc", ascii_grid(9, 1, small_hill_m));
  folder.write("column.asc", ascii_grid(1, 9, small_hill_m));
  folder.write("nodata.asc", ascii_grid(9, 9, nothing));
  folder.write("degrees.asc", ascii_grid(9, 9, small_hill_m));
  folder.write("degrees.prj", kDegrees);
  const auto in_alps = ascii_grid(kSize, kSize, small_hill_m, {.x = 10, .y = 46, .cell = 0.001});
  folder.write("alps.asc", in_alps);
  folder.write("alps.prj", kDegrees);
  folder.write("feet.asc", in_alps);
  folder.write("feet.prj", "COMPD_CS[\"in feet\"," + kDegrees +
                               ",VERT_CS[\"heights in feet\",VERT_DATUM[\"a sea\",2005],"
                               "UNIT[\"foot\",0.3048],AXIS[\"Up\",UP]]]");
  folder.write("bare.asc", ascii_grid(kSize, kSize, small_hill_m));
  folder.write("bare.prj", "PROJCS[\"feet\"," + kDegrees +
                               ",PROJECTION[\"Transverse_Mercator\"],PARAMETER["
                               "\"latitude_of_origin\",0],PARAMETER[\"central_meridian\",3],"
                               "PARAMETER[\"scale_factor\",1],PARAMETER[\"false_easting\",0],"
                               "PARAMETER[\"false_northing\",0],UNIT[\"Foot\",0.3048]]");
  folder.write("quarry.asc", ascii_grid(kSize, kSize, small_hill_m));
  folder.write("quarry.prj", "LOCAL_CS[\"a quarry\",UNIT[\"metre\",1]]");
  folder.write("utm.asc", ascii_grid(kSize, kSize, small_hill_m));
  folder.write("utm.prj", kUtm32);
  folder.write("text.asc", "This is no raster.\n");
  const std::string tiff = geotiff(kSize, kSize, small_hill_m);
  folder.write("cut.tif", tiff.substr(0, tiff.size() / 2));
  folder.write("stub.tif", tiff.substr(0, 20));
  write_view(folder, "flat.toml", {});
  write_view(folder, "parallel-vup.toml", {"vup = [0, -2, 2]"});
  write_view(folder, "empty-window.toml", {"window = [-200, 50, 200, 50]"});
  write_view(folder, "front-behind.toml", {"front = -1000"});
  write_view(folder, "eye-on-plane.toml", {"projection = 'perspective'", "prp = [0, 0, 0]"});
  write_view(folder, "direction-in-plane.toml", {"prp = [10, 5, 0]"});
  write_view(folder, "from-below.toml", {"vpn = [0, -1, -1]"});
  write_view(folder, "all-cut.toml", {"back = 900"});
  write_view(folder, "aside.toml", {"window = [5000, -200, 5400, 200]", "prp = [5200, 0, 9]"});
  write_view(folder, "cuts-hut.toml", {"vpn = [0, -1, 0]", "front = 5"});
  folder.write("holes.asc", ascii_grid(kSize, kSize, [](int column, int row) {
                 return column == 17 && row == 17 ? -9999 : small_hill_m(column, row);
               }));
  make_scenes(folder);
  folder.write("old.svg", "an older drawing");
  fs::create_directory(folder.path("folder.svg"));
  fs::create_symlink("hill.asc", folder.path("link.asc"));
}

const std::vector<std::string> kExtensions{"svg", "pdf", "ps", "eps", "png", "geojson", "gpkg"};

} // namespace

TEST_CASE("bad input gets one line, the right exit code, and leaves no file") {
  const MadeFolder folder;
  make_inputs(folder);
  const auto before = folder.names();
  const std::string hill = folder.read("hill.asc");
  const std::string hut = folder.read("hut.toml"), tetrahedron = folder.read("tetrahedron.off");
  const auto cases = read_cases();
  CHECK(cases.size() > 40);
  for (const auto& c : cases) {
    const auto result = run_orograph(words(c.run), {.folder = folder.path()});
    INFO(c.name << "\norograph " << c.run << "\n" << result.err);
    CHECK(result.exit_code == c.exit_code);
    CHECK(fault_of_message(result.err) == "");
    CHECK(result.err.find(c.error) != std::string::npos);
    CHECK(result.out == "");
    CHECK(folder.names() == before);
    CHECK(folder.read("old.svg") == "an older drawing");
    CHECK(folder.read("hill.asc") == hill);
    CHECK(folder.read("hut.toml") == hut);
    CHECK(folder.read("tetrahedron.off") == tetrahedron);
  }
}

TEST_CASE("a file-size limit is an error in every format, and the old output stays") {
  const MadeFolder folder;
  make_inputs(folder);
  for (const auto& extension : kExtensions)
    for (const bool replaces : {false, true}) {
      const std::string output = "full." + extension;
      if (replaces) folder.write(output, "older");
      const auto before = folder.names();
      std::vector<std::string> arguments{"render", "hill.asc", output};
      if (replaces) arguments.push_back("--overwrite");
      const auto result =
          run_orograph(arguments, {.folder = folder.path(), .largest_file_bytes = 2048});
      INFO(output << ": " << result.err);
      CHECK(result.exit_code == 1);
      CHECK(fault_of_message(result.err) == "");
      CHECK(folder.names() == before);
      if (replaces) CHECK(folder.read(output) == "older");
    }
}

TEST_CASE("a report that doesn't fit is an error, and no report is left") {
  const MadeFolder folder;
  make_inputs(folder);
  const auto whole =
      run_orograph({"render", "hill.asc", "a.svg", "--page", "30x20", "--margin", "1", "--profiles",
                    "2", "--layers", "profiles", "--report", "a.json"},
                   {.folder = folder.path()});
  INFO(whole.err);
  REQUIRE(whole.exit_code == 0);
  const auto svg_size = fs::file_size(folder.path("a.svg"));
  const auto report_size = fs::file_size(folder.path("a.json"));
  REQUIRE(svg_size + 10 < report_size);
  const auto result =
      run_orograph({"render", "hill.asc", "b.svg", "--page", "30x20", "--margin", "1", "--profiles",
                    "2", "--layers", "profiles", "--report", "b.json"},
                   {.folder = folder.path(), .largest_file_bytes = svg_size + 10});
  INFO(result.err);
  CHECK(result.exit_code == 1);
  CHECK(fault_of_message(result.err) == "");
  CHECK_FALSE(fs::exists(folder.path("b.json")));
}

TEST_CASE("a full device on standard output is an error") {
  const MadeFolder folder;
  make_inputs(folder);
  for (const std::string run :
       {"info hill.asc", "render hill.asc - --of svg", "render --help", "--version"}) {
    const auto result =
        run_orograph(words(run), {.folder = folder.path(), .out_path = "/dev/full"});
    INFO(run << ": " << result.err);
    CHECK(result.exit_code == 1);
    CHECK(fault_of_message(result.err) == "");
  }
}

TEST_CASE("a full disk is an error in every format") {
  // A small tmpfs needs the right to mount one: as root, or in a name space of our own.
  const MadeFolder folder;
  make_inputs(folder);
  fs::create_directory(folder.path("disk"));
  const std::string mount = "mount -t tmpfs -o size=16k tmpfs disk && ";
  std::vector<std::string> shell{"unshare", "-m", "sh", "-c", mount + "true"};
  if (RunningProgram(shell, {.folder = folder.path()}).wait().exit_code != 0)
    shell.insert(shell.begin() + 1, "-r");
  if (RunningProgram(shell, {.folder = folder.path()}).wait().exit_code != 0) {
    WARN("no tmpfs can be mounted here; only the file-size limit stands for a full disk");
    return;
  }
  for (const auto& extension : kExtensions) {
    // Most of the disk is taken, so that every format meets its end; then nothing else is on it.
    shell.back() = mount + "head -c 12288 /dev/zero >disk/taken && \"$0\" render hill.asc disk/a." +
                   extension + " --spacing 0.3mm; code=$?; ls -A disk; exit $code";
    auto command = shell;
    command.push_back(OROGRAPH_PROGRAM);
    const auto result = RunningProgram(command, {.folder = folder.path()}).wait();
    INFO(extension << ": " << result.err);
    CHECK(result.exit_code == 1);
    CHECK(fault_of_message(result.err) == "");
    CHECK(result.out == "taken\n");
  }
}
