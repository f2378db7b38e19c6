// SPDX-License-Identifier: GPL-3.0-or-later
// Points from text.
#include "dem/read/map_shapes.hpp"
#include "geometry/error.hpp"
#include "geometry/on_all_cores.hpp"
#include "text/words.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <fstream>

namespace orograph {
namespace {

using Fields = std::vector<std::string_view>;

// Of a line. Two million columns took 40 s until they were refused.
constexpr std::size_t kMostBytes = 1'000'000, kMostColumns = 1000;

bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\r';
}

bool is_no_text(char c) {
  return static_cast<unsigned char>(c) < ' ' && !is_blank(c);
}

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

char separator_of(std::string_view line) {
  for (const char c : {';', '\t', ','})
    if (line.find(c) != std::string_view::npos) return c;
  return ' ';
}

std::size_t field_end(std::string_view line, char separator) {
  return std::min(separator == ' ' ? line.find_first_of(" \t") : line.find(separator), line.size());
}

// A field in quotes may hold the separator.
void split(std::string_view line, char separator, Fields& fields) {
  fields.clear();
  line = separator == '\t' ? line : trimmed(line);
  while (true) {
    while (!line.empty() && is_blank(line.front()) && line.front() != separator)
      line.remove_prefix(1);
    std::size_t end = 0;
    if (const std::size_t close = line.find('"', 1);
        line.starts_with('"') && close != std::string_view::npos) {
      fields.push_back(line.substr(1, close - 1));
      end = close + 1 + field_end(line.substr(close + 1), separator);
    } else {
      end = field_end(line, separator);
      fields.push_back(trimmed(line.substr(0, end)));
    }
    if (end == line.size()) return;
    line.remove_prefix(end + 1);
    if (separator == ' ') line = trimmed(line);
  }
}

// Many programs end each line with a separator.
void drop_empty_end(Fields& fields, std::size_t wanted) {
  if (fields.size() == wanted + 1 && fields.back().empty()) fields.pop_back();
}

constexpr std::array<std::array<std::string_view, 5>, 3> usual_names{
    {{"x", "easting", "east", "e", ""},
     {"y", "northing", "north", "n", ""},
     {"z", "elevation", "height", "elev", "h"}}};
constexpr std::array<std::string_view, 6> degree_names{"lon",       "lat",      "long",
                                                       "longitude", "latitude", "lng"};

bool is_in_degrees(const std::string& name) {
  return std::find(degree_names.begin(), degree_names.end(), name) != degree_names.end();
}

[[noreturn]] void refuse_degrees(const std::string& path, std::string_view name) {
  throw Error(fmt::format("{} has its points in degrees (column '{}'), which isn't supported yet",
                          path, name),
              fmt::format("project them first, to a UTM zone for example: ogr2ogr -s_srs EPSG:4326 "
                          "-t_srs EPSG:32632 -oo X_POSSIBLE_NAMES=lon* -oo Y_POSSIBLE_NAMES=lat* "
                          "-oo Z_POSSIBLE_NAMES=z,h*,ele* projected.gpkg {}",
                          path));
}

// The place of each wanted column among the names.
std::array<std::size_t, 3> places_of(const Fields& names, const std::string& path,
                                     const std::array<std::string, 3>& columns) {
  std::vector<std::string> lower;
  for (const std::string_view name : names) lower.push_back(in_lower_case(name));
  const auto find = [&](const std::string& name) -> std::optional<std::size_t> {
    const auto count = std::count(lower.begin(), lower.end(), name);
    if (count > 1)
      throw Error(fmt::format("{} has {} columns named '{}'", path, count, name),
                  "give each its own name in the first line");
    if (count == 0) return std::nullopt;
    return static_cast<std::size_t>(std::find(lower.begin(), lower.end(), name) - lower.begin());
  };
  const bool as_usual = columns == std::array<std::string, 3>{"x", "y", "z"};
  std::array<std::size_t, 3> places{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    std::optional<std::size_t> place = find(in_lower_case(columns[axis]));
    for (std::size_t i = 0; as_usual && !place && i < usual_names[axis].size(); ++i)
      if (!usual_names[axis][i].empty()) place = find(std::string(usual_names[axis][i]));
    if (!place && as_usual && axis < 2)
      for (const std::string& name : lower)
        if (is_in_degrees(name)) refuse_degrees(path, name);
    if (!place)
      throw Error(fmt::format("{} has no column '{}'", path, columns[axis]),
                  fmt::format("its columns are {}; name three with `columns` X,Y,Z",
                              fmt::join(names, ", ")));
    if (is_in_degrees(lower[*place])) refuse_degrees(path, names[*place]);
    places[axis] = *place;
  }
  return places;
}

[[noreturn]] void refuse_value(const std::string& path, std::size_t line, std::string_view text,
                               std::string_view name) {
  const std::string place = fmt::format("{}, line {}", path, line);
  if (text.empty())
    throw Error(fmt::format("{}: {} is empty", place, name), "take points without it out");
  const bool comma = text.find(',') != std::string_view::npos;
  throw Error(fmt::format("{}: {} is '{}'", place, name, text.substr(0, 40)),
              comma ? "write numbers with a decimal point" : "it must be a finite number");
}

// The lines of a file, with their numbers; empty ones and comments are left out.
class Lines {
public:
  explicit Lines(const std::string& path) : path_(path), file_(path) {
    if (!file_) throw Error(fmt::format("{}: can't be read", path), "give the path of a text file");
  }
  bool next() {
    while (std::getline(file_, text_)) {
      ++number_;
      if (text_.size() > kMostBytes)
        throw Error(fmt::format("{}, line {} has more than 1,000,000 bytes", path_, number_),
                    "give one point a line");
      if (number_ == 1 && text_.starts_with("\xEF\xBB\xBF")) text_.erase(0, 3);
      if (std::any_of(text_.begin(), text_.end(), is_no_text) || text_.starts_with("\xFF\xFE") ||
          text_.starts_with("\xFE\xFF"))
        throw Error(fmt::format("{} isn't plain text (line {})", path_, number_),
                    "give points as text in UTF-8, one a line");
      const std::string_view line = trimmed(text_);
      if (!line.empty() && line.front() != '#') return true;
    }
    if (file_.bad()) throw Error(fmt::format("{} can't be read to its end", path_), "try a copy");
    return false;
  }
  std::string_view text() const { return text_; }
  std::size_t number() const { return number_; }

private:
  const std::string& path_;
  std::ifstream file_;
  std::string text_;
  std::size_t number_ = 0;
};

} // namespace

MapShapes read_points(const std::string& path, const std::array<std::string, 3>& columns) {
  MapShapes shapes;
  shapes.path = path;
  Lines lines(path);
  if (!lines.next()) throw Error(fmt::format("{} is empty", path), "give one point a line");

  const char separator = separator_of(lines.text());
  Fields fields;
  split(lines.text(), separator, fields);
  drop_empty_end(fields, fields.size() - 1);
  const std::size_t count = fields.size();
  if (count > kMostColumns)
    throw Error(fmt::format("{} has {} columns, more than 1000", path, count),
                "keep the three that a point needs");
  const bool has_names = !std::all_of(fields.begin(), fields.end(),
                                      [](auto f) { return number_of<double>(f).has_value(); });
  std::array<std::size_t, 3> places{0, 1, 2};
  if (has_names) {
    places = places_of(fields, path, columns);
  } else {
    if (count != 3)
      throw Error(fmt::format("{} has {} columns and no line that names them", path, count),
                  "name them in a first line, such as x,y,z");
    shapes.notes.push_back("The columns have no names: they are taken as x, y, z.");
  }

  const auto add_point = [&] {
    throw_if_stopped(lines.number());
    split(lines.text(), separator, fields);
    drop_empty_end(fields, count);
    if (fields.size() != count)
      throw Error(
          fmt::format("{}, line {} has {} columns", path, lines.number(), fields.size()),
          fmt::format("it must have {} as the first line{}", count,
                      separator == ',' && fields.size() == 2 * count
                          ? "; write numbers with a decimal point, or columns with semicolons"
                          : ""));
    std::array<double, 3> xyz{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto value = number_of<double>(fields[places[axis]]);
      if (!value || !std::isfinite(*value))
        refuse_value(path, lines.number(), fields[places[axis]], columns[axis]);
      xyz[axis] = *value;
    }
    shapes.points.push_back({xyz[0], xyz[1], xyz[2]});
  };
  if (!has_names) add_point();
  while (lines.next()) add_point();
  if (shapes.points.empty())
    throw Error(fmt::format("{} has names of columns but no points", path),
                "give one point a line");
  return shapes;
}

} // namespace orograph
