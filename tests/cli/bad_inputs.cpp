// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/cli/bad_inputs.hpp"

#include "tests/cli/made_scenes.hpp"

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

namespace orograph {

namespace fs = std::filesystem;

namespace {

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

// Settings, each with one fault in its line 2.
void write_settings(const MadeFolder& folder) {
  const auto write = [&](const std::string& name, const std::string& line) {
    folder.write("set-" + name + ".toml", "# settings\n" + line + "\n");
  };
  write("unknown", "elevtion = 20");
  write("dashed", "--fov = 20");
  write("input", "input = 'hill.asc'");
  write("itself", "settings = 'set-unknown.toml'");
  write("range", "fov = 400");
  write("word", "spread = 'wide'");
  write("latitude", "eye-lonlat = '46,120'");
  write("list", "fov = [20]");
  write("texts", "oo = [['A=1']]");
  write("table", "[view]\nfov = 20");
  write("switch", "portrait = 'yes'");
  write("no-switch", "fov = true");
  write("date", "title = 1979-05-27");
  write("conflict", "fov = 20\nview = 'flat.toml'");
  write("syntax", "fov = = 20");
  write("nested", "fov = " + std::string(100'000, '[') + std::string(100'000, ']'));
  std::string dotted = "a";
  for (int i = 0; i < 50'000; ++i) dotted += ".a";
  write("dots", dotted + " = 1");
  write("huge", "title = '" + std::string(1'000'001, 'a') + "'");
  folder.write("set-syntax.json", "{\n\"settings\": {\n");
  folder.write("set-none.json", "{\"view\": {}}");
  folder.write("set-number.json", "{\"settings\": {\"fov\": 400}}");
  folder.write("set-object.json", "{\"settings\": {\"fov\": {}}}");
  folder.write("set-nested.json", std::string(1'000'000, '[') + std::string(1'000'000, ']'));
}

// Devices and pens, sound but for those that begin with bad-.
void write_plotters(const MadeFolder& folder) {
  const std::string device = "language = 'hpgl'\nname = 'mine'\nunit = 0.025\n";
  folder.write("small-device.toml", device + "pens = 2\nwindow = [0, 0, 4000, 8000]\n");
  folder.write("bad-device.toml", device + "pens = 'two'\n");
  folder.write("bad-syntax.toml", "language = hpgl\n");
  folder.write("one-pen.toml", "[[pen]]\nnumber = 3\nwidth = 0.2\nlayers = ['profiles']\n");
  folder.write("bad-pens.toml", "[[pen]]\nnumber = 1\nwidth = 0\n");
  const std::string field = "[[pen]]\nwidth = 0.2\nfield = 'elevatoin'\n";
  folder.write("field-pens.toml", field + "values = [30]\n[[pen]]\nwidth = 0.2\n");
  folder.write("bad-field-pens.toml", field);
  folder.write("bad-dash-pens.toml", "[[pen]]\nwidth = 0.2\ndash = 2\n");
  folder.write("waiting-pen.toml", "[[pen]]\nnumber = 1\nwidth = 0.2\npause = true\n");
}

} // namespace

void make_bad_inputs(const MadeFolder& folder) {
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
  std::string lost = tiff; // the last of 13 fields tells where the tie-point is
  lost.replace(8 + 2 + 12 * 12 + 8, 4, std::string("\xF0\xFF\xFF\x7F", 4));
  folder.write("lost-place.tif", lost);
  folder.write("remote.vrt",
               "<VRTDataset rasterXSize='9' rasterYSize='9'><VRTRasterBand dataType='Float32' "
               "band='1'><SimpleSource><SourceFilename>/vsicurl/http://127.0.0.1:1/a.tif"
               "</SourceFilename></SimpleSource></VRTRasterBand></VRTDataset>");
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
  write_settings(folder);
  write_plotters(folder);
  folder.write("old.svg", "an older drawing");
  fs::create_directory(folder.path("folder.svg"));
  fs::create_symlink("hill.asc", folder.path("link.asc"));
}

} // namespace orograph
