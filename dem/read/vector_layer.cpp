// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/read/vector_layer.hpp"

#include "geometry/error.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include <cstddef>

namespace orograph {

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
