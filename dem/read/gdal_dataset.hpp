// SPDX-License-Identifier: GPL-3.0-or-later
// A GDAL dataset that closes itself.
#pragma once

#include <memory>

class GDALDataset;

namespace orograph {

struct CloseDataset {
  void operator()(GDALDataset* dataset) const;
};
using Dataset = std::unique_ptr<GDALDataset, CloseDataset>;

} // namespace orograph
