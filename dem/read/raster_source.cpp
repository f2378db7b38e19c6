// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/read/raster_source.hpp"

#include "dem/read/crs_frame.hpp"
#include "dem/read/length_units.hpp"
#include "dem/read/netcdf_header.hpp"
#include "dem/read/raster_shares.hpp"
#include "dem/read/xyz_places.hpp"
#include "geometry/error.hpp"

#include <cpl_string.h>
#include <cpl_vsi.h>
#include <fmt/format.h>
#include <gdal_priv.h>
#include <ogr_spatialref.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <string_view>
#include <system_error>

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

// Band `number`, counted from 1. Throws Error where there is none or it doesn't hold heights:
// colours, a palette, complex numbers.
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

// Classic netCDF holds its values as they are, and GDAL reads 0 where the file has ended: one of
// 288 bytes makes heights of gigabytes.
void check_whole(GDALDataset& dataset, GDALRasterBand& band, const std::string& path) {
  if (std::string_view(dataset.GetDriverName()) != "netCDF") return;
  const CPLStringList files(dataset.GetFileList());
  VSILFILE* const file = files.size() > 0 ? VSIFOpenL(files[0], "rb") : nullptr;
  if (file == nullptr) return;
  std::array<char, 3> begin{};
  const bool is_classic = VSIFReadL(begin.data(), 1, begin.size(), file) == begin.size() &&
                          std::string_view(begin.data(), begin.size()) == "CDF";
  VSIFSeekL(file, 0, SEEK_END);
  const auto size = static_cast<double>(VSIFTellL(file));
  VSIFCloseL(file);
  const double needed = static_cast<double>(GDALGetDataTypeSizeBytes(band.GetRasterDataType())) *
                        dataset.GetRasterXSize() * dataset.GetRasterYSize();
  if (is_classic && size < needed)
    throw Error(fmt::format("{} is cut off: it has {:.0f} bytes, and its heights take {:.0f}", path,
                            size, needed),
                "fetch it again");
}

// The overview `level` of the same file, after checking that there is one.
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

void set_horizontal(MapFrame& map, const OGRSpatialReference* crs, const std::string& path,
                    Vec2 centre, std::vector<std::string>& notes) {
  map.crs_name = "none";
  if (!tells_place(crs)) {
    notes.push_back("The file has no CRS: its coordinates are taken as metres.");
    return;
  }
  set_crs(map, *crs, path, FileKind::raster, centre);
}

// What is given goes before what the file says. Where eastings are in feet, heights of no unit may
// be either: a guess would be wrong by a factor of three.
void set_vertical(MapFrame& map, const OGRSpatialReference* crs, const std::string& given,
                  const std::string& in_file, const std::string& path,
                  std::vector<std::string>& notes) {
  const std::string& written = given.empty() ? in_file : given;
  if (written.empty() && crs && set_height_unit(map, *crs)) return;
  if (written.empty()) {
    if (map.unit_m != 1)
      throw Error(fmt::format("{} names no unit of height, and its coordinates are in units of "
                              "{:.6g} m ({})",
                              path, map.unit_m, map.unit_name),
                  "say which: `height_unit` m, ft or us-ft");
    notes.push_back("The file names no unit of height: metres are taken.");
    return;
  }
  if (!given.empty() && !in_file.empty() && given != in_file)
    notes.push_back(
        fmt::format("Heights are taken as {}, though the file says {}.", given, in_file));
  const auto unit = length_unit(written);
  if (!unit)
    throw Error(
        fmt::format("{}: heights in '{}' can't be brought to metres", path, written),
        "units known are m, ft, us-ft, km, dm, cm and mm; 'gdal_edit.py -units m' sets one");
  map.height_unit_m = unit->metres;
  map.height_unit_name = unit->name;
}

[[noreturn]] void refuse_place(const std::string& path, const char* told_by, const char* option) {
  throw Error(fmt::format("{}: its place is told by {} only", path, told_by),
              fmt::format("bring it to a grid first: gdalwarp {}{} grid.tif", option, path));
}

// Whether there is a geotransform, and not the one that stands for none.
bool has_georeference(GDALDataset& dataset) {
  std::array<double, 6> gt{};
  const std::array<double, 6> unset{0, 1, 0, 0, 0, 1};
  return dataset.GetGeoTransform(gt.data()) == CE_None && gt != unset;
}

// Where vertices' coordinates are rounded so much that their cells aren't of one size any more.
void refuse_far(const RasterLattice& lattice, const std::string& path) {
  const Box2 box = box_of(lattice);
  const double farthest = std::max({-box.low.x, -box.low.y, box.high.x, box.high.y}),
               apart = std::nextafter(farthest, HUGE_VAL) - farthest,
               cell = std::min(length(lattice.pixel_step), length(lattice.line_step));
  constexpr double kMostRounding = 1e-3; // of a cell: far below what a page shows of one
  if (apart <= kMostRounding * cell) return;
  throw Error(
      fmt::format("{}: its coordinates reach {:.5g}, where numbers are {:.3g} apart, which is "
                  "too much for cells of {:.5g}",
                  path, farthest, apart, cell),
      "set its place anew: gdal_edit.py -a_ullr WEST NORTH EAST SOUTH " + path);
}

// From the geotransform: vertices at cell centres, in map coordinates. Without one, cells of size
// 1 with line 0 in the north, and a doubt. Throws Error where the place is told by control points,
// RPCs or geolocation arrays only, the geotransform doesn't span a plane, or is too far away.
RasterLattice raster_lattice(GDALDataset& dataset, const std::string& path,
                             std::vector<std::string>& doubts) {
  std::array<double, 6> gt{};
  dataset.GetGeoTransform(gt.data());
  if (!has_georeference(dataset)) {
    if (dataset.GetGCPCount() > 0) refuse_place(path, "ground control points", "-tps ");
    if (dataset.GetMetadata("RPC")) refuse_place(path, "rational polynomials (RPC)", "-rpc ");
    if (dataset.GetMetadata("GEOLOCATION")) refuse_place(path, "geolocation arrays", "-geoloc ");
    doubts.push_back(
        "The file has no georeference: cells are taken as 1 m, with the first row in the north.");
    gt = {0, 1, 0, 0, 0, -1};
  }
  RasterLattice lattice;
  lattice.pixels = dataset.GetRasterXSize();
  lattice.lines = dataset.GetRasterYSize();
  lattice.pixel_step = {gt[1], gt[4]};
  lattice.line_step = {gt[2], gt[5]};
  lattice.first = Vec2{gt[0], gt[3]} + 0.5 * lattice.pixel_step + 0.5 * lattice.line_step;
  if (!spans_a_plane(lattice))
    throw Error(fmt::format("{}: its geotransform has no area", path),
                "pixel and line steps must be finite and span a cell; see gdalinfo");
  refuse_far(lattice, path);
  return lattice;
}

// CRS and units of `band`; the origin stays to be set. `centre` is in map coordinates.
// `height_unit`, if it isn't empty, goes before the file's own. Throws Error for a geocentric CRS,
// for an unknown height unit, and where none is told though the CRS's own isn't the metre.
MapFrame raster_map_frame(GDALDataset& dataset, GDALRasterBand& band, const std::string& path,
                          Vec2 centre, const std::string& height_unit,
                          std::vector<std::string>& notes) {
  const OGRSpatialReference* crs = dataset.GetSpatialRef();
  MapFrame map;
  set_horizontal(map, crs, path, centre, notes);
  set_vertical(map, crs, height_unit, band.GetUnitType(), path, notes);
  return map;
}

// The same ground with the overview's fewer, larger cells. Their ratio is seldom a whole number.
RasterLattice coarser(const RasterLattice& full, int pixels, int lines) {
  const double across = static_cast<double>(full.pixels) / pixels;
  const double down = static_cast<double>(full.lines) / lines;
  return {pixels, lines, full.position((across - 1) / 2, (down - 1) / 2), across * full.pixel_step,
          down * full.line_step};
}

// Of GeoTIFF, as GDAL names them when it ignores one that is cut off or of a wrong type.
constexpr std::array<std::string_view, 9> kTagsOfPlaceAndHeights{
    "GeoPixelScale",   "GeoTiePoints",    "TransformationMatrix",
    "GeoKeyDirectory", "GeoDoubleParams", "GeoASCIIParams",
    "GDALNoDataValue", "GDALMetadata",    "GeoTIFF tags"};

[[noreturn]] void refuse_damaged(const std::string& path, const std::string& reason) {
  throw Error(
      fmt::format("{}: what tells its place or its heights is damaged ({})", path, reason),
      "fetch it again, or set what is lost: gdal_edit.py with -a_ullr, -a_srs or -a_nodata");
}

// A warning about one of the tags is refused; the others become doubts.
void take_warnings(const GdalMessages& messages, RasterSource& source) {
  for (const std::string& warning : messages.warnings()) {
    for (const std::string_view tag : kTagsOfPlaceAndHeights)
      if (warning.find(tag) != std::string::npos) refuse_damaged(source.path, warning);
    source.doubts.push_back("GDAL warns: " + warning + ".");
  }
}

// Drivers that have the CRS in a file of its own take one that can't be opened, or isn't one, for
// none.
void refuse_unread_crs(GDALDataset& dataset, const std::string& path) {
  const std::string_view driver = dataset.GetDriverName();
  const bool has_own_file = driver == "AAIGrid" || driver == "GRASSASCIIGrid" || driver == "EHdr";
  if (!has_own_file || dataset.GetSpatialRef() != nullptr) return;
  for (const char* const extension : {".prj", ".PRJ"}) {
    const std::string crs_path = std::filesystem::path(path).replace_extension(extension).string();
    std::error_code ignored;
    if (std::filesystem::exists(crs_path, ignored))
      throw Error(
          fmt::format("{}, which tells the CRS of {}, can't be read as one", crs_path, path),
          "mend it, or take it away if the CRS isn't known");
  }
}

double bytes_of_block(GDALDataset& dataset, GDALRasterBand& band) {
  int pixels = 0, lines = 0;
  band.GetBlockSize(&pixels, &lines);
  const char* order = dataset.GetMetadataItem("INTERLEAVE", "IMAGE_STRUCTURE");
  const int bands = order && std::string_view(order) == "PIXEL" ? dataset.GetRasterCount() : 1;
  return 1.0 * pixels * lines * bands * GDALGetDataTypeSizeBytes(band.GetRasterDataType());
}

GDALRasterBand& band_of(const RasterSource& source, const ReadOptions& options) {
  const Dataset& dataset = source.overview ? source.overview : source.full;
  return *dataset->GetRasterBand(options.band);
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
  check_netcdf_header(path);
  messages.forget();
  Dataset dataset(GDALDataset::Open(path.c_str(),
                                    GDAL_OF_RASTER | GDAL_OF_READONLY | GDAL_OF_VERBOSE_ERROR,
                                    nullptr, options.List(), nullptr));
  if (!dataset) refuse(path, messages);
  if (dataset->GetRasterCount() == 0) refuse_container(*dataset, path);
  if (std::string_view(dataset->GetDriverName()) == "XYZ") check_xyz_places(path);
  return dataset;
}

RasterSource open_source(const std::string& path, const ReadOptions& options,
                         const std::function<void(const RasterSource&)>& on_lattice) {
  GdalMessages messages;
  RasterSource source;
  source.path = path;
  source.full = open_raster(path, options.open_options, messages);
  take_warnings(messages, source);
  messages.forget(); // drivers that were asked before may have failed
  GDALRasterBand& band = height_band(*source.full, path, options.band);
  check_whole(*source.full, band, path);
  refuse_unread_crs(*source.full, path);
  source.has_place = has_georeference(*source.full);
  source.lattice = raster_lattice(*source.full, path, source.doubts);
  source.order = grid_order(source.lattice);
  source.in_float = fits_float(band);
  source.block_bytes = bytes_of_block(*source.full, band);
  if (on_lattice) on_lattice(source);
  source.map = raster_map_frame(*source.full, band, path, box_of(source.lattice).centre(),
                                options.height_unit, source.notes);
  source.code = height_code(band, source.map.height_unit_m);
  // GDAL looks at place and CRS only when it is asked for them.
  take_warnings(messages, source);
  if (messages.has_failure()) refuse_damaged(path, messages.last_failure());
  const CPLStringList files(source.full->GetFileList());
  for (int i = 0; i < files.size(); ++i) source.files.emplace_back(files[i]);
  source.notes.insert(source.notes.begin(), source.doubts.begin(), source.doubts.end());
  if (options.overview) {
    source.overview = open_overview(path, options.open_options, band, *options.overview, messages);
    source.lattice = coarser(source.lattice, source.overview->GetRasterXSize(),
                             source.overview->GetRasterYSize());
    source.order = grid_order(source.lattice);
  }
  return source;
}

void close(RasterSource& source) {
  source.overview.reset();
  source.full.reset();
}

void open_again(RasterSource& source, const ReadOptions& options) {
  GdalMessages messages;
  source.full = open_raster(source.path, options.open_options, messages);
  GDALRasterBand& band = height_band(*source.full, source.path, options.band);
  if (options.overview)
    source.overview =
        open_overview(source.path, options.open_options, band, *options.overview, messages);
}

void read_part(RasterSource& source, const ReadOptions& options, const RasterWindow& part,
               int width, int column, int row, ReadHeights& heights,
               HeightDifferences* differences) {
  const RasterWindow window = raster_window(source.order, part);
  const GridOrder order = order_within(source.order, part, width, column, row);
  const auto file = differences ? std::nullopt : shared_file(source, options);
  const SharesRead shares =
      file ? read_in_shares(*file, window, order, source.code, heights) : SharesRead{};
  if (shares.all_well) {
    if (shares.has_unwritten) note_unwritten(source);
    return;
  }
  GDALRasterBand& band = band_of(source, options);
  for (const std::string& warning :
       read_heights(band, window, order, source.code, source.path, heights, differences)) {
    source.doubts.push_back("GDAL warns: " + warning + ".");
    source.notes.push_back(source.doubts.back());
  }
  if (!source.code.nodata && has_unwritten_blocks(band, window)) note_unwritten(source);
}

// They read as nodata, or as 0 where the file has none: perhaps a sea, perhaps a writer that was
// killed.
void note_unwritten(RasterSource& source) {
  source.notes.push_back("Parts of the file were never written: their heights are taken as 0.");
}

} // namespace orograph
