// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/read/open_raster.hpp"

#include "geometry/error.hpp"

#include <cpl_string.h>
#include <cpl_vsi.h>
#include <fmt/format.h>
#include <gdal_priv.h>

#include <algorithm>
#include <string_view>

namespace orograph {
namespace {

bool is_there(const std::string& path) {
  VSIStatBufL stat;
  return VSIStatExL(path.c_str(), &stat, VSI_STAT_EXISTS_FLAG) == 0;
}

std::string first_file_in(const std::string& archive) {
  const CPLStringList names(VSIReadDirRecursive(archive.c_str()));
  for (int i = 0; i < names.size(); ++i)
    if (const std::string_view name = names[i]; !name.ends_with('/')) return names[i];
  return "FILE";
}

// How to name what is inside, for archives that GDAL doesn't open by themselves.
std::string archive_hint(const std::string& path) {
  if (path.ends_with(".zip"))
    return fmt::format("name the file inside, as in /vsizip/{}/{}", path,
                       first_file_in("/vsizip/" + path));
  if (path.ends_with(".tar") || path.ends_with(".tgz") || path.ends_with(".tar.gz"))
    return fmt::format("name the file inside, as in /vsitar/{}/{}", path,
                       first_file_in("/vsitar/" + path));
  if (path.ends_with(".gz")) return fmt::format("let GDAL unpack it: /vsigzip/{}", path);
  return "";
}

[[noreturn]] void refuse(const std::string& path, const GdalMessages& messages) {
  if (!is_there(path) && path.find(':') == std::string::npos)
    throw Error(fmt::format("{}: no such file", path), "give the path of a DEM");
  if (const std::string hint = archive_hint(path); !hint.empty())
    throw Error(fmt::format("{} is an archive, not a raster", path), hint);
  throw Error(fmt::format("{} can't be opened as a raster ({})", path, messages.last_failure()),
              "give a DEM that GDAL reads, such as GeoTIFF, .hgt or .asc ('gdalinfo --formats' "
              "lists them), or triangles or points in a file with a usual extension");
}

[[noreturn]] void refuse_container(GDALDataset& dataset, const std::string& path) {
  const CPLStringList parts(dataset.GetMetadata("SUBDATASETS"), false);
  const char* first = parts.FetchNameValue("SUBDATASET_1_NAME");
  if (first)
    throw Error(fmt::format("{} holds several rasters", path),
                fmt::format("name one of them, such as '{}'", first));
  throw Error(fmt::format("{} has no bands", path), "give a raster that holds heights");
}

bool is_colour(GDALColorInterp meaning) {
  return meaning >= GCI_RedBand && meaning <= GCI_YCbCr_CrBand;
}

} // namespace

Dataset open_raster(const std::string& path, const std::vector<std::string>& open_options,
                    GdalMessages& messages) {
  CPLStringList options;
  for (const std::string& option : open_options) {
    if (option.find('=') == std::string::npos)
      throw Error(fmt::format("open option '{}' has no value", option), "write NAME=VALUE");
    options.AddString(option.c_str());
  }
  messages.forget();
  Dataset dataset(GDALDataset::Open(path.c_str(),
                                    GDAL_OF_RASTER | GDAL_OF_READONLY | GDAL_OF_VERBOSE_ERROR,
                                    nullptr, options.List(), nullptr));
  if (!dataset) refuse(path, messages);
  if (dataset->GetRasterCount() == 0) refuse_container(*dataset, path);
  return dataset;
}

GDALRasterBand& height_band(GDALDataset& dataset, const std::string& path, int number) {
  const int count = dataset.GetRasterCount();
  if (number < 1 || number > count)
    throw Error(fmt::format("{} has no band {}", path, number),
                count == 1 ? "it has one band, number 1"
                           : fmt::format("its bands are 1 to {}", count));
  GDALRasterBand& band = *dataset.GetRasterBand(number);
  const GDALDataType type = band.GetRasterDataType();
  if (GDALDataTypeIsComplex(type))
    throw Error(fmt::format("{}: band {} holds complex numbers, not heights", path, number),
                "give a band of real numbers");

  const GDALColorInterp meaning = band.GetColorInterpretation();
  if (meaning == GCI_PaletteIndex)
    throw Error(
        fmt::format("{}: band {} holds numbers of a palette's colours, not heights", path, number),
        "give the DEM that the picture was made from");
  // Float bands are sometimes tagged red, green, blue only because there are three of them.
  if (is_colour(meaning) && (type == GDT_Byte || type == GDT_UInt16))
    throw Error(
        fmt::format("{}: band {} holds colours ({}), not heights", path, number,
                    GDALGetColorInterpretationName(meaning)),
        fmt::format("give the DEM itself; if this is Terrain-RGB, decode it with: gdal_calc.py "
                    "-R {0} --R_band=1 -G {0} --G_band=2 -B {0} --B_band=3 --type=Float32 "
                    "--outfile=heights.tif --calc='(R*65536.0+G*256.0+B)*0.1-10000'",
                    path));
  return band;
}

Dataset open_overview(const std::string& path, std::vector<std::string> open_options,
                      GDALRasterBand& full, int level, GdalMessages& messages) {
  const int count = full.GetOverviewCount();
  if (level < 0 || level >= count)
    throw Error(fmt::format("{} has no overview {}", path, level),
                count == 0   ? "it has none; 'gdaladdo' makes them"
                : count == 1 ? "it has one, level 0"
                             : fmt::format("its levels are 0 to {}", count - 1));
  open_options.push_back(fmt::format("OVERVIEW_LEVEL={}", level));
  return open_raster(path, open_options, messages);
}

} // namespace orograph
