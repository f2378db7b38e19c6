// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/read/level_index.hpp"

#include "dem/levels/level_windows.hpp"
#include "dem/read/index_blocks.hpp"
#include "dem/read/nested_index.hpp"
#include "geometry/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string_view>
#include <utility>
#include <variant>

namespace orograph {
namespace {

// A file is: these eight bytes, the order mark, the size of what is told and its sum, what is told
// (state, raster's size, bytes of a height, levels, nested cells), and the levels' heights one
// after the other, and the nested cells (dem/read/nested_index.hpp). Numbers are as the machine has
// them: an index is made anew elsewhere rather than turned round.
constexpr std::array<char, 8> kMagic{'o', 'r', 'o', 'l', 'e', 'v', '0', '2'};
constexpr std::size_t kOfAllVersions = 6; // of these
constexpr std::uint32_t kOrderMark = 0x01020304;
constexpr std::uint64_t kMostTold = 1 << 24; // a VRT of 100,000 files
constexpr std::uint32_t kMostLevels = 32;

struct ToldLevel {
  LargerCells cells;
  int columns = 0, rows = 0;
  std::uint64_t sum = 0, at = 0; ///< where its heights begin in the file
};

struct Told {
  std::uint32_t bytes_of_height = 0;
  std::vector<ToldLevel> levels;
  std::vector<std::uint64_t> sums_of_nested;
  std::uint64_t nested_at = 0; ///< where these begin in the file
};

std::uint64_t bytes_of(const ToldLevel& level, std::uint32_t bytes_of_height) {
  return static_cast<std::uint64_t>(level.columns) * static_cast<std::uint64_t>(level.rows) *
         bytes_of_height;
}

ToldLevel take_level(Listener& told, int columns, int rows) {
  ToldLevel level;
  LargerCells& cells = level.cells;
  cells.step = told.take<std::int32_t>();
  cells.columns = columns;
  cells.rows = rows;
  if (cells.step < 2 || cells.step > std::min(columns, rows)) throw Refused{"it is damaged"};
  level.columns = vertices_for(columns, cells.step);
  level.rows = vertices_for(rows, cells.step);
  cells.departure.greatest_m = told.take<double>();
  cells.departure.rms_m = told.take<double>();
  const auto is_length = [](double m) { return std::isfinite(m) && m >= 0; };
  if (!is_length(cells.departure.greatest_m) || !is_length(cells.departure.rms_m))
    throw Refused{"it is damaged"};
  const auto tops = told.take<std::uint32_t>();
  for (std::uint32_t i = 0; i < tops; ++i) {
    Top top{};
    top.height_m = told.take<double>();
    top.column = told.take<std::int32_t>();
    top.row = told.take<std::int32_t>();
    if (!std::isfinite(top.height_m) || top.column < 0 || top.row < 0 || top.column >= columns ||
        top.row >= rows)
      throw Refused{"it is damaged"};
    cells.tops.push_back(top);
  }
  level.sum = told.take<std::uint64_t>();
  return level;
}

template <class Number>
Number read_number(std::istream& file) {
  Number number{};
  if (!file.read(reinterpret_cast<char*>(&number), sizeof number))
    throw Refused{"it ends before its end"};
  return number;
}

// What an index tells, where it is of this state and as long as it says.
Told read_told(std::ifstream& file, const std::string& path, const std::string& state,
               const RasterSet& set) {
  std::array<char, kMagic.size()> magic{};
  if (!file.read(magic.data(), magic.size()) || magic != kMagic)
    throw Refused{"it is no index, or of another version"};
  if (read_number<std::uint32_t>(file) != kOrderMark)
    throw Refused{"it is from a machine with another order of bytes"};
  const auto size = read_number<std::uint64_t>(file), sum = read_number<std::uint64_t>(file);
  std::error_code unknown;
  const std::uint64_t file_size = std::filesystem::file_size(path, unknown);
  const auto begin = static_cast<std::uint64_t>(file.tellg());
  if (unknown || size > kMostTold || size > file_size - begin) throw Refused{"it is damaged"};
  std::string bytes(size, '\0');
  if (!file.read(bytes.data(), static_cast<std::streamsize>(size)) || sum_of(bytes) != sum)
    throw Refused{"it is damaged"};
  Listener listener(bytes);
  if (listener.take_text() != state) throw Refused{"the heights have changed since it was made"};
  Told told;
  const auto columns = listener.take<std::int32_t>(), rows = listener.take<std::int32_t>();
  told.bytes_of_height = listener.take<std::uint32_t>();
  const auto count = listener.take<std::uint32_t>();
  const std::size_t of_heights = set.are_floats() ? sizeof(float) : sizeof(double);
  if (columns != set.grid.columns || rows != set.grid.rows || told.bytes_of_height != of_heights ||
      count > kMostLevels)
    throw Refused{"it is damaged"};
  std::uint64_t at = begin + size;
  for (std::uint32_t i = 0; i < count; ++i) {
    told.levels.push_back(take_level(listener, columns, rows));
    told.levels.back().at = at;
    at += bytes_of(told.levels.back(), told.bytes_of_height);
  }
  told.sums_of_nested = take_nested(listener, columns, rows);
  told.nested_at = at;
  if (at + bytes_of_nested(columns, rows, told.bytes_of_height) != file_size)
    throw Refused{"it is damaged"};
  return told;
}

template <class Height>
ReadHeights read_level(std::ifstream& file, const ToldLevel& level) {
  std::vector<Height> heights(static_cast<std::size_t>(level.columns) *
                              static_cast<std::size_t>(level.rows));
  file.seekg(static_cast<std::streamoff>(level.at));
  read_block(file, heights, level.sum);
  if (!are_heights(heights)) throw Refused{"it is damaged"};
  return heights;
}

std::string not_used(const std::string& path, const Refused& refused) {
  return fmt::format("{} isn't used: {}. Make it anew.", path, refused.why);
}

// A local file's time, to the nanosecond where the disk keeps that.
std::optional<std::string> state_of_file(const std::string& path) {
  std::error_code unknown;
  const std::filesystem::path file(path);
  const auto size = std::filesystem::file_size(file, unknown);
  if (unknown) return std::nullopt;
  const auto time = std::filesystem::last_write_time(file, unknown);
  if (unknown) return std::nullopt;
  return fmt::format("{} {} {}\n", file.filename().string(), size, time.time_since_epoch().count());
}

} // namespace

std::string index_path(const std::vector<std::string>& paths) {
  return paths.front() + ".levels";
}

std::optional<std::string> state_of(const RasterSet& set, const ReadOptions& options) {
  std::string state =
      fmt::format("{} x {} band {} overview {} unit {}\n", set.grid.columns, set.grid.rows,
                  options.band, options.overview.value_or(-1), options.height_unit);
  for (const std::string& option : options.open_options) state += option + "\n";
  for (const RasterSource& source : set.sources) {
    const HeightCode& code = source.code;
    state +=
        fmt::format("{} {} {} {}\n", code.nodata.value_or(0), code.scale, code.offset, code.unit_m);
    for (const std::string& file : source.files) {
      const auto of_file = state_of_file(file);
      if (!of_file) return std::nullopt;
      state += *of_file;
    }
    if (source.files.empty()) return std::nullopt;
  }
  return state;
}

bool is_index(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::array<char, kMagic.size()> magic{};
  return file.read(magic.data(), magic.size()) &&
         std::equal(magic.begin(), magic.begin() + kOfAllVersions, kMagic.begin());
}

void write_index(const std::string& path, const std::string& state,
                 const std::vector<IndexedLevel>& levels) {
  const LargerCells& raster = levels.front().cells;
  const bool in_float = std::holds_alternative<std::vector<float>>(levels.front().heights);
  Teller told;
  told.put_text(state);
  told.put(static_cast<std::int32_t>(raster.columns));
  told.put(static_cast<std::int32_t>(raster.rows));
  told.put(static_cast<std::uint32_t>(in_float ? sizeof(float) : sizeof(double)));
  told.put(static_cast<std::uint32_t>(levels.size()));
  for (const IndexedLevel& level : levels) {
    told.put(static_cast<std::int32_t>(level.cells.step));
    told.put(level.cells.departure.greatest_m);
    told.put(level.cells.departure.rms_m);
    told.put(static_cast<std::uint32_t>(level.cells.tops.size()));
    for (const Top& top : level.cells.tops) {
      told.put(top.height_m);
      told.put(static_cast<std::int32_t>(top.column));
      told.put(static_cast<std::int32_t>(top.row));
    }
    told.put(std::visit([](const auto& heights) { return sum_of(heights); }, level.heights));
  }
  tell_nested(told, *raster.nested);
  std::ofstream file(path, std::ios::binary | std::ios::trunc);
  const auto put = [&](const void* bytes, std::size_t size) {
    file.write(static_cast<const char*>(bytes), static_cast<std::streamsize>(size));
  };
  const std::uint64_t size = told.bytes().size(), sum = sum_of(told.bytes());
  put(kMagic.data(), kMagic.size());
  put(&kOrderMark, sizeof kOrderMark);
  put(&size, sizeof size);
  put(&sum, sizeof sum);
  put(told.bytes().data(), size);
  for (const IndexedLevel& level : levels)
    std::visit(
        [&](const auto& heights) { put(heights.data(), heights.size() * sizeof heights[0]); },
        level.heights);
  write_nested(file, *raster.nested);
  file.close();
  if (!file)
    throw Error("the index can't be written whole", "make room on the disk, about a fifth of what "
                                                    "the heights take");
}

IndexFound find_level(const std::string& path, const std::string& state, const RasterSet& set,
                      int step, bool with_nested) {
  IndexFound found;
  std::ifstream file(path, std::ios::binary);
  if (!file) return found;
  try {
    const Told told = read_told(file, path, state, set);
    for (const ToldLevel& level : told.levels)
      if (level.cells.step == step)
        found.level = IndexedLevel{level.cells, level.columns, level.rows,
                                   set.are_floats() ? read_level<float>(file, level)
                                                    : read_level<double>(file, level)};
    if (found.level && with_nested) {
      file.seekg(static_cast<std::streamoff>(told.nested_at));
      const LargerCells& cells = found.level->cells;
      found.level->cells.nested = std::make_shared<const NestedCells>(
          read_nested(file, told.sums_of_nested, cells.columns, cells.rows, told.bytes_of_height));
    }
  } catch (const Refused& refused) {
    found.level.reset();
    found.why_not = not_used(path, refused);
  }
  return found;
}

IndexState look_at_index(const std::string& path, const std::string& state, const RasterSet& set) {
  IndexState found;
  std::ifstream file(path, std::ios::binary);
  if (!file) return found;
  try {
    for (const ToldLevel& level : read_told(file, path, state, set).levels)
      found.steps.push_back(level.cells.step);
  } catch (const Refused& refused) {
    found.why_not = not_used(path, refused);
  }
  return found;
}

} // namespace orograph
