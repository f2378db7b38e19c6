#include "dem/read_terrain.hpp"

#include "dem/read_raster.hpp"
namespace orograph {
Terrain read_terrain(const std::string& path, const ReadOptions& options) {
  return read_raster(path, options);
}
} // namespace orograph
