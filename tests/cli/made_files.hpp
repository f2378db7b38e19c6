// SPDX-License-Identifier: GPL-3.0-or-later
// Files for tests of the command line: a folder that goes away, and small rasters written by hand.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace orograph {

/// A new folder under the system's temporary one; removed with what is in it.
class MadeFolder {
public:
  MadeFolder();
  ~MadeFolder();
  MadeFolder(const MadeFolder&) = delete;
  MadeFolder& operator=(const MadeFolder&) = delete;

  const std::string& path() const { return path_; }
  std::string path(const std::string& name) const { return path_ + "/" + name; }
  /// Returns the file's path.
  std::string write(const std::string& name, std::string_view content) const;
  std::string read(const std::string& name) const;
  /// Names of all files and folders in it, sorted.
  std::vector<std::string> names() const;

private:
  std::string path_;
};

/// Height in metres at a column and a row.
using HeightOf = std::function<double(int column, int row)>;

/// Of the lower left corner, and the length of a cell's side.
struct AsciiPlace {
  double x = 0, y = 0, cell = 10;
};

/// Arc/Info ASCII grid, unless told otherwise with cells of 10 m from (0, 0); "-9999" is nodata.
std::string ascii_grid(int columns, int rows, const HeightOf& height_m,
                       const AsciiPlace& place = {});

/// GeoTIFF of float32, uncompressed, one strip, cells of 10 m, upper left corner at (0, 10 rows);
/// the heights come after the tags.
std::string geotiff(int columns, int rows, const HeightOf& height_m);

/// WKT of UTM zone 32 on WGS 84, for a file of its own beside an ASCII grid.
extern const std::string_view kUtm32;

/// A hill of 200 m in the middle of a slightly sloping plain, so that no ground is level.
double hill_m(int column, int row, int size);

} // namespace orograph
