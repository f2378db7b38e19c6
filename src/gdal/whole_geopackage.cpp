// SPDX-License-Identifier: GPL-3.0-or-later
#include "gdal/whole_geopackage.hpp"

#include <ogrsf_frmts.h>

#include "gdal/gdal.hpp"

namespace orograph {
namespace {

// GDAL makes two that keep a layer's count, and says nothing where it has no memory for one.
constexpr const char* kCountTriggers = "SELECT COUNT(*) FROM sqlite_master WHERE type = 'trigger' "
                                       "AND name LIKE '%feature_count%'";

std::string first_value(GDALDataset& dataset, const char* sql) {
  OGRLayer* const rows = dataset.ExecuteSQL(sql, nullptr, nullptr);
  if (rows == nullptr) return {};
  std::string value;
  if (const OGRFeatureUniquePtr row(rows->GetNextFeature()); row) value = row->GetFieldAsString(0);
  dataset.ReleaseResultSet(rows);
  return value;
}

} // namespace

bool is_whole_geopackage(const std::string& path, const std::string& query,
                         const std::string& expected) {
  const char* const drivers[] = {"GPKG", nullptr};
  const Dataset dataset(GDALDataset::Open(path.c_str(), GDAL_OF_VECTOR, drivers));
  return dataset && first_value(*dataset, "PRAGMA quick_check(1)") == "ok" &&
         first_value(*dataset, query.c_str()) == expected &&
         first_value(*dataset, kCountTriggers) != "1";
}

} // namespace orograph
