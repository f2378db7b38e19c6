// SPDX-License-Identifier: GPL-3.0-or-later
// Reading heights on other cores while GDAL and PROJ understand the CRS, which only one can do.
#pragma once

#include "dem/read/raster_shares.hpp"

#include <memory>
#include <optional>

namespace orograph {

/// What has to be known of the CRS before heights can be read, their unit, is assumed; where that
/// was wrong they are thrown away.
class EarlyHeights {
public:
  EarlyHeights();
  /// Waits for what has begun.
  ~EarlyHeights();

  /// Begins to read all of a source whose lattice is known. Does nothing where only a part of it
  /// may be wanted, where shares can't be read, and where there is one core only.
  void begin(const RasterSource& source, const ReadOptions& options);

  struct Heights {
    ReadHeights values;
    bool has_unwritten;
  };
  /// All heights in the order of a Grid. Nothing where none were begun, for another code or another
  /// size, and where anything went wrong: then the usual way tells what it is.
  std::optional<Heights> take(const HeightCode& code, int columns, int rows);

private:
  struct Reading;
  std::unique_ptr<Reading> reading_;
};

} // namespace orograph
