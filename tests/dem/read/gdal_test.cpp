// SPDX-License-Identifier: GPL-3.0-or-later
// A program that uses GDAL itself keeps what it has set there, and several threads may read at
// once.
#include "dem/height_at.hpp"
#include "dem/read/lonlat.hpp"
#include "dem/read/map_shapes.hpp"
#include "dem/read/read_terrain.hpp"
#include "dem/write/write_tin.hpp"
#include "geometry/error.hpp"
#include "tests/catch.hpp"
#include "tests/dem/read/raster_file.hpp"
#include "tests/dem/temp_folder.hpp"

#include <cpl_conv.h>
#include <cpl_error.h>
#include <gdal.h>

#include <atomic>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "gdal/gdal.hpp"

namespace orograph::gdal_test {
namespace {

std::atomic<int> heard = 0;

void CPL_STDCALL hear(CPLErr severity, CPLErrorNum, const char*) {
  if (severity >= CE_Warning) ++heard;
}

// A program that has a handler and settings of its own.
class Host {
public:
  Host() : handler_(CPLSetErrorHandler(hear)), cache_(GDALGetCacheMax64()) {
    GDALSetCacheMax64(77 << 20);
    CPLSetConfigOption("GDAL_PAM_ENABLED", "YES");
    CPLSetThreadLocalConfigOption("OGR_CURRENT_DATE", "1999-12-31T00:00:00.000Z");
    CPLSetThreadLocalConfigOption("GTIFF_DIRECT_IO", "NO");
    heard = 0;
  }
  ~Host() {
    CPLSetErrorHandler(handler_);
    GDALSetCacheMax64(cache_);
    for (const char* name : {"OGR_CURRENT_DATE", "GTIFF_DIRECT_IO"})
      CPLSetThreadLocalConfigOption(name, nullptr);
    CPLSetConfigOption("GDAL_PAM_ENABLED", nullptr);
  }
  Host(const Host&) = delete;
  Host& operator=(const Host&) = delete;

  void check_all_is_as_it_was() const {
    const CPLErrorHandler found = CPLSetErrorHandler(hear);
    CHECK(found == hear);
    CHECK(heard == 0);
    CHECK(GDALGetCacheMax64() == 77 << 20);
    CHECK(option("GDAL_PAM_ENABLED") == "YES");
    CHECK(option("OGR_CURRENT_DATE") == "1999-12-31T00:00:00.000Z");
    CHECK(option("GTIFF_DIRECT_IO") == "NO");
    CPLError(CE_Warning, CPLE_AppDefined, "to the program");
    CHECK(heard == 1);
    heard = 0;
  }

private:
  static std::string option(const char* name) { return CPLGetConfigOption(name, ""); }

  CPLErrorHandler handler_;
  GIntBig cache_;
};

void write_text(const std::string& path, const std::string& text) {
  std::ofstream(path) << text;
}

// What can be asked of the readers and writers, right and wrong.
void use_all(const TempFolder& folder) {
  const auto refuse = [](const std::string& path) { CHECK_THROWS_AS(read_terrain(path), Error); };
  ReadOptions filled;
  filled.fill_voids = 2;
  const TerrainData raster = read_terrain(folder.file("dem.tif"), filled);
  CHECK(height_at(raster.surface, {15, -15}));
  CHECK(lonlat_of_map(raster.map.crs_wkt, raster.map.origin));
  CHECK(!lonlat_of_map("no CRS at all", {}));
  const TerrainData mesh = read_terrain(folder.file("mesh.off"));
  const std::string copy = folder.file("copy.gpkg");
  write_tin(mesh, copy, TinFormat::gpkg);
  read_terrain(copy);
  CHECK_THROWS_AS(write_tin(mesh, folder.file("none/copy.gpkg"), TinFormat::gpkg), Error);
  refuse(folder.file("none.tif"));
  refuse(folder.file("broken.tif"));
  refuse(folder.file("broken.gpkg"));
}

void write_all(const TempFolder& folder) {
  RasterFile raster = counting_raster(60, 40);
  raster.nodata = 7;
  write_raster(raster, folder.file("dem.tif"));
  std::filesystem::copy_file(folder.file("dem.tif"), folder.file("broken.tif"));
  std::filesystem::resize_file(folder.file("broken.tif"), 3000);
  write_text(folder.file("broken.gpkg"), "this is no database");
  write_text(folder.file("mesh.off"),
             "OFF\n# orograph: crs nonsense\n3 1 0\n0 0 1\n9 0 2\n0 9 3\n3 0 1 2\n");
}

} // namespace

TEST_CASE("what a program has set in GDAL stays as it is, whatever is read and written") {
  const TempFolder folder;
  write_all(folder);
  const Host host;
  use_all(folder);
  host.check_all_is_as_it_was();
  for (const auto& entry : std::filesystem::directory_iterator(folder.path()))
    CHECK(entry.path().extension() != ".xml");
}

TEST_CASE("several threads read at once, each with the program's handlers left alone") {
  const TempFolder folder;
  write_all(folder);
  RasterFile large = counting_raster(1500, 1400); // read in shares
  write_raster(large, folder.file("large.tif"));
  const TerrainData alone = read_terrain(folder.file("large.tif"));
  const Host host;
  std::vector<std::thread> threads;
  std::atomic<int> same = 0;
  constexpr int kThreads = 4, kTimes = 3;
  for (int i = 0; i < kThreads; ++i)
    threads.emplace_back([&] {
      for (int k = 0; k < kTimes; ++k) {
        bool refused = false;
        try {
          read_terrain(folder.file("broken.tif"));
        } catch (const Error&) {
          refused = true;
        }
        const TerrainData read = read_terrain(folder.file("large.tif"));
        same += refused &&
                std::get<Grid>(read.surface).heights_m == std::get<Grid>(alone.surface).heights_m;
      }
    });
  for (std::thread& thread : threads) thread.join();
  CHECK(same == kThreads * kTimes);
  host.check_all_is_as_it_was();
}

} // namespace orograph::gdal_test
