// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/read/gdal_dataset.hpp"

#include <gdal_priv.h>

namespace orograph {

void CloseDataset::operator()(GDALDataset* dataset) const {
  GDALClose(dataset);
}

} // namespace orograph
