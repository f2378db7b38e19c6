// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/read/vector_layer.hpp"

#include "dem/read/netcdf_header.hpp"
#include "geometry/error.hpp"

#include <cpl_string.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include <algorithm>
#include <cstddef>

namespace orograph {

Dataset open_vector(const std::string& path, const std::vector<std::string>& options) {
  check_netcdf_header(path);
  CPLStringList open_options;
  for (const std::string& option : options) open_options.AddString(option.c_str());
  open_options.AddString("@WRITE_GFS=NO"); // @: drivers that don't know it aren't to warn
  return Dataset(GDALDataset::Open(path.c_str(),
                                   GDAL_OF_VECTOR | GDAL_OF_READONLY | GDAL_OF_VERBOSE_ERROR,
                                   nullptr, open_options.List(), nullptr));
}

void add_doubts(const GdalMessages& messages, const std::string& path,
                std::vector<std::string>& doubts) {
  constexpr std::size_t kMostTold = 5;
  std::size_t told = 0, left_out = 0;
  for (const auto* const said : {&messages.failures(), &messages.warnings()})
    for (const std::string& message : *said) {
      std::string doubt = fmt::format("GDAL warns of {}: {}.", path, message);
      if (std::find(doubts.begin(), doubts.end(), doubt) != doubts.end()) continue;
      if (told == kMostTold) {
        ++left_out;
        continue;
      }
      doubts.push_back(std::move(doubt));
      ++told;
    }
  if (left_out > 0)
    doubts.push_back(fmt::format("GDAL warns of {} {} times more.", path, left_out));
}

OGRLayer& layer_of(GDALDataset& dataset, const std::string& path, const std::string& wanted,
                   const std::string& right) {
  std::vector<OGRLayer*> layers;
  for (OGRLayer* layer : dataset.GetLayers())
    if (layer->GetGeomType() != wkbNone) layers.push_back(layer);
  std::vector<std::string> names;
  for (OGRLayer* layer : layers) names.emplace_back(layer->GetName());
  for (std::size_t i = 0; i < layers.size(); ++i)
    if (names[i] == wanted) return *layers[i];
  if (layers.empty())
    throw Error(fmt::format("{} has no layer with geometries", path),
                "see 'ogrinfo' for what it holds");
  if (!wanted.empty())
    throw Error(fmt::format("{} has no layer '{}'", path, wanted),
                fmt::format("its layers are {}", fmt::join(names, ", ")));
  if (layers.size() > 1)
    throw Error(fmt::format("{} has {} layers: {}", path, layers.size(), fmt::join(names, ", ")),
                right);
  return *layers.front();
}

std::vector<std::string> field_names(OGRLayer& layer) {
  const OGRFeatureDefn& fields = *layer.GetLayerDefn();
  std::vector<std::string> names;
  for (int i = 0; i < fields.GetFieldCount(); ++i)
    names.emplace_back(fields.GetFieldDefn(i)->GetNameRef());
  return names;
}

} // namespace orograph
