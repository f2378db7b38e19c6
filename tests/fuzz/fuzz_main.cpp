// SPDX-License-Identifier: GPL-3.0-or-later
// libFuzzer's door to the targets; OROGRAPH_FUZZ_TARGET in the environment names one.
#include "tests/fuzz/fuzz_targets.hpp"

#include <cpl_conv.h>
#include <gdal_priv.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string_view>

#include "gdal/gdal.hpp"

namespace {

const orograph::FuzzTarget* target = nullptr;

// Of GDAL's two hundred drivers, which are all asked of each file: those of formats that terrains
// and maps come in. What is behind them is the same for all.
constexpr std::string_view kDrivers[] = {
    "GTiff",          "VRT",        "AAIGrid", "SRTMHGT", "USGSDEM", "XYZ",
    "EHdr",           "ENVI",       "netCDF",  "HFA",     "PNG",     "GPKG",
    "GeoJSON",        "GeoJSONSeq", "GML",     "OGR_VRT", "CSV",     "DXF",
    "ESRI Shapefile", "FlatGeobuf", "GPX",     "KML",     "SQLite",  "TopoJSON"};

void keep_drivers() {
  const orograph::GdalMessages registered;
  GDALDriverManager& all = *GetGDALDriverManager();
  for (int i = all.GetDriverCount() - 1; i >= 0; --i)
    if (std::ranges::count(kDrivers, std::string_view(all.GetDriver(i)->GetDescription())) == 0)
      all.DeregisterDriver(all.GetDriver(i));
}

} // namespace

extern "C" int LLVMFuzzerInitialize(int*, char***) {
  const char* const name = std::getenv("OROGRAPH_FUZZ_TARGET");
  for (const orograph::FuzzTarget& one : orograph::fuzz_targets())
    if (name != nullptr && one.name == name) target = &one;
  if (target == nullptr) {
    std::fprintf(stderr, "fuzz: no target '%s'; there are", name ? name : "");
    for (const orograph::FuzzTarget& one : orograph::fuzz_targets())
      std::fprintf(stderr, " %.*s", static_cast<int>(one.name.size()), one.name.data());
    std::fprintf(stderr, "\n");
    std::exit(2);
  }
  orograph::set_gdal_for_this_program();
  // What bytes name isn't fetched from anywhere.
  CPLSetConfigOption("CPL_VSIL_CURL_ALLOWED_EXTENSIONS", "none");
  keep_drivers();
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  target->run({data, size});
  return 0;
}
