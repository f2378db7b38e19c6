// SPDX-License-Identifier: GPL-3.0-or-later
// What CGAL's mesh readers pass over: wrong counts, faces of many corners, numbers that are none.
#include "dem/read/map_shapes.hpp"
#include "geometry/error.hpp"
#include "text/words.hpp"

#include <fmt/format.h>

#include <cstring>
#include <utility>

namespace orograph {
namespace {

std::string place(const std::string& path, const DataLines& lines) {
  return fmt::format("{}, line {}", path, lines.number());
}

void check_coordinates(std::string_view words, const DataLines& lines, const std::string& path) {
  for (int axis = 0; axis < 3; ++axis) {
    const std::string_view word = next_word(words);
    if (word.empty())
      throw Error(fmt::format("{} has {} coordinates", place(path, lines), axis),
                  "a vertex has three, x y z");
    if (!is_finite_number(word))
      throw Error(fmt::format("{} has the coordinate '{:.40}'", place(path, lines), word),
                  "it must be a finite number");
  }
}

void check_corners(long long corners, const DataLines& lines, const std::string& path) {
  if (corners != 3)
    throw Error(fmt::format("{} has a face with {} corners", place(path, lines), corners),
                triangulate_faces);
}

struct OffCounts {
  bool plain = true; ///< no colours, normals or the like
  std::size_t vertices = 0, faces = 0;
};

OffCounts off_counts(DataLines& lines, const std::string& path) {
  const char* const form = "the file must begin with OFF and the counts of vertices, faces, edges";
  if (!lines.next()) throw Error(fmt::format("{} is empty", path), form);
  std::string_view words = lines.line();
  const std::string_view keyword = next_word(words);
  if (!keyword.ends_with("OFF")) throw Error(fmt::format("{} isn't OFF", path), form);
  if (keyword.find_first_of("4n") != std::string_view::npos || words.find("BINARY") < words.size())
    throw Error(fmt::format("{} is of the kind '{}{}'", path, keyword, words),
                "write it as plain OFF, in text and with three coordinates");
  if (count_words(words) == 0 && lines.next()) words = lines.line();
  const auto vertices = number_of<std::size_t>(next_word(words));
  const auto faces = number_of<std::size_t>(next_word(words));
  const auto edges = number_of<std::size_t>(next_word(words));
  if (!vertices || !faces || !edges || !next_word(words).empty())
    throw Error(fmt::format("{} has no counts", place(path, lines)), form);
  return {keyword == "OFF", *vertices, *faces};
}

void check_off(std::string_view text, const std::string& path) {
  DataLines lines(text);
  const OffCounts counts = off_counts(lines, path);
  std::size_t found = 0;
  for (DataLines rest = lines; rest.next();) ++found;
  const std::string told = fmt::format("{} says that it has {} vertices and {} faces", path,
                                       counts.vertices, counts.faces);
  if (counts.vertices > found || counts.faces != found - counts.vertices)
    throw Error(fmt::format("{} but {} lines follow", told, found),
                found < counts.vertices + counts.faces ? "the file is truncated or its counts wrong"
                                                       : "its counts are wrong");
  for (std::size_t i = 0; i < counts.vertices && lines.next(); ++i) {
    if (counts.plain && count_words(lines.line()) == 4)
      throw Error(fmt::format("{} but its line {} has four numbers", told, lines.number()),
                  "its counts are wrong, or it isn't plain OFF");
    check_coordinates(lines.line(), lines, path);
  }
  while (lines.next()) {
    std::string_view words = lines.line();
    const auto corners = number_of<long long>(next_word(words));
    if (!corners)
      throw Error(fmt::format("{} is no face", place(path, lines)),
                  "a face is the number of its corners and as many vertices");
    check_corners(*corners, lines, path);
    for (int i = 0; i < 3; ++i) { // CGAL takes 1.7 for 1, and -1 for what the machine makes of it
      const std::string_view word = next_word(words);
      const auto corner = number_of<std::size_t>(word);
      if (!corner || *corner >= counts.vertices)
        throw Error(fmt::format("{}: a face names '{:.40}', a vertex that isn't there",
                                place(path, lines), word),
                    fmt::format("vertices are 0 to {}", counts.vertices - 1));
    }
  }
}

void check_obj(std::string_view text, const std::string& path) {
  for (DataLines lines(text); lines.next();) {
    std::string_view words = lines.line();
    const std::string_view keyword = next_word(words);
    if (keyword == "v") check_coordinates(words, lines, path);
    if (keyword == "f") check_corners(static_cast<long long>(count_words(words)), lines, path);
  }
}

// Text or binary: the first five letters alone don't tell.
bool is_binary_stl(std::string_view text) {
  if (!text.starts_with("solid")) return true;
  if (text.size() < 84) return false;
  std::uint32_t count = 0;
  std::memcpy(&count, text.data() + 80, 4);
  return text.size() == 84 + std::uint64_t{50} * count;
}

void check_stl(std::string_view text, const std::string& path) {
  if (!is_binary_stl(text)) {
    for (DataLines lines(text); lines.next();) {
      std::string_view words = lines.line();
      if (next_word(words) == "vertex") check_coordinates(words, lines, path);
    }
    return;
  }
  std::uint32_t count = 0;
  if (text.size() >= 84) std::memcpy(&count, text.data() + 80, 4);
  if (text.size() < 84 || text.size() != 84 + std::uint64_t{50} * count)
    throw Error(fmt::format("{} has {} bytes, which isn't STL", path, text.size()),
                fmt::format("binary STL of {} triangles has {}; the file may be truncated", count,
                            84 + std::uint64_t{50} * count));
  for (std::size_t face = 0; face < count; ++face) {
    float corners[9]; // after the normal
    std::memcpy(corners, text.data() + 84 + 50 * face + 12, sizeof corners);
    for (const float c : corners)
      if (!std::isfinite(c))
        throw Error(
            fmt::format("{}: triangle {} of {} has the coordinate {}", path, face + 1, count, c),
            "it must be a finite number");
  }
}

// PLY tells in a header what its elements hold.
enum class Coding { text, little_endian, big_endian };

struct Property {
  std::string_view name;
  std::size_t bytes = 0;       ///< of a value
  std::size_t count_bytes = 0; ///< of a list's count; 0 where it isn't a list
  bool is_real = false;
};

struct Element {
  std::string_view name;
  std::size_t count = 0;
  std::vector<Property> properties;
};

struct Header {
  Coding coding = Coding::text;
  std::vector<Element> elements;
  std::string_view body;
};

[[noreturn]] void refuse_header(const std::string& path, std::size_t line, const char* right) {
  throw Error(fmt::format("{}, line {} isn't what a PLY header has", path, line), right);
}

std::size_t bytes_of(std::string_view type) {
  constexpr std::array<std::pair<std::string_view, std::size_t>, 16> types{{{"char", 1},
                                                                            {"int8", 1},
                                                                            {"uchar", 1},
                                                                            {"uint8", 1},
                                                                            {"short", 2},
                                                                            {"int16", 2},
                                                                            {"ushort", 2},
                                                                            {"uint16", 2},
                                                                            {"int", 4},
                                                                            {"int32", 4},
                                                                            {"uint", 4},
                                                                            {"uint32", 4},
                                                                            {"float", 4},
                                                                            {"float32", 4},
                                                                            {"double", 8},
                                                                            {"float64", 8}}};
  for (const auto& [name, bytes] : types)
    if (name == type) return bytes;
  return 0;
}

bool is_real(std::string_view type) {
  return type.starts_with("float") || type == "double";
}

Property property_of(std::string_view words, const std::string& path, std::size_t line) {
  Property property;
  std::string_view type = next_word(words);
  if (type == "list") {
    const std::string_view count_type = next_word(words);
    property.count_bytes = is_real(count_type) ? 0 : bytes_of(count_type);
    if (property.count_bytes == 0) refuse_header(path, line, "a list has a whole count");
    type = next_word(words);
  }
  property.bytes = bytes_of(type);
  property.is_real = is_real(type);
  property.name = next_word(words);
  if (property.bytes == 0 || property.name.empty())
    refuse_header(path, line, "a property has a type, such as double, and a name");
  return property;
}

Header header_of(std::string_view text, const std::string& path) {
  Header header;
  std::size_t number = 0;
  while (!text.empty()) {
    const std::size_t end = text.find('\n');
    std::string_view words = text.substr(0, end);
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    ++number;
    const std::string_view keyword = next_word(words);
    if (number == 1 && keyword != "ply")
      throw Error(fmt::format("{} isn't PLY", path), "its first line must be 'ply'");
    if (number == 2) {
      const std::string_view coding = next_word(words);
      if (keyword != "format" ||
          !(coding == "ascii" || coding == "binary_little_endian" || coding == "binary_big_endian"))
        refuse_header(path, number, "the second line names the format, such as ascii 1.0");
      if (coding != "ascii")
        header.coding = coding == "binary_big_endian" ? Coding::big_endian : Coding::little_endian;
    }
    if (keyword == "element") {
      const std::string_view name = next_word(words);
      const auto count = number_of<std::size_t>(next_word(words));
      if (!count) refuse_header(path, number, "an element has a name and a count");
      header.elements.push_back({name, *count, {}});
    }
    if (keyword == "property") {
      if (header.elements.empty()) refuse_header(path, number, "properties follow an element");
      header.elements.back().properties.push_back(property_of(words, path, number));
    }
    if (keyword == "end_header") {
      header.body = text;
      return header;
    }
  }
  throw Error(fmt::format("{} ends before its header does", path), "the file is truncated");
}

const Element& element_of(const Header& header, std::string_view name, std::string_view plural,
                          const std::string& path, const char* hint) {
  for (const Element& element : header.elements)
    if (element.name == name || element.name == plural) return element;
  throw Error(fmt::format("{} has no {}", path, plural), hint);
}

void check_elements(const Header& header, const std::string& path) {
  const Element& vertex = element_of(header, "vertex", "vertices", path, "it must hold triangles");
  for (const char* axis : {"x", "y", "z"}) {
    bool found = false;
    for (const Property& p : vertex.properties)
      found = found || (p.name == axis && p.is_real && p.count_bytes == 0);
    if (!found)
      throw Error(fmt::format("{}: its vertices have no {} of type float or double", path, axis),
                  "they need x, y and z");
  }
  const Element& face =
      element_of(header, "face", "faces", path,
                 "points alone go in as text, a line of x y z each, to be triangulated");
  bool found = false;
  for (const Property& p : face.properties)
    found = found || ((p.name == "vertex_indices" || p.name == "vertex_index") &&
                      p.count_bytes > 0 && p.bytes == 4 && !p.is_real);
  if (!found)
    throw Error(fmt::format("{}: its faces have no list vertex_indices of type int or uint", path),
                "write it again with one");
  if (face.count == 0) throw Error(fmt::format("{} has no faces", path), "it must hold triangles");
}

// Walks over all values, only to see that they are there, finite where they are coordinates, and
// three where they are a face's corners.
class Walk {
public:
  Walk(const Header& header, const std::string& path)
      : header_(header), path_(path), rest_(header.body) {}

  void run() {
    for (const Element& element : header_.elements)
      for (std::size_t i = 0; i < element.count; ++i)
        for (const Property& property : element.properties) pass(element, i, property);
    const bool more = header_.coding == Coding::text ? !next_word(rest_).empty() : !rest_.empty();
    if (more)
      throw Error(fmt::format("{} holds more than its header says", path_),
                  "the counts of its elements are wrong");
  }

private:
  void pass(const Element& element, std::size_t index, const Property& property) {
    if (property.count_bytes == 0) {
      const double value = next_value(property.bytes, property.is_real, element, index);
      if (property.is_real && !std::isfinite(value) &&
          (property.name == "x" || property.name == "y" || property.name == "z"))
        throw Error(fmt::format("{}: {} {} of {} has {} = {}", path_, element.name, index + 1,
                                element.count, property.name, value),
                    "it must be a finite number");
      return;
    }
    const double count = next_value(property.count_bytes, false, element, index);
    if (property.name.starts_with("vertex_ind") && element.name.starts_with("face") && count != 3)
      throw Error(
          fmt::format("{}: face {} of {} has {} corners", path_, index + 1, element.count, count),
          triangulate_faces);
    for (double i = 0; i < count; ++i) next_value(property.bytes, property.is_real, element, index);
  }

  // Whole numbers are only counts here: their sign doesn't matter, a negative one is too many.
  double next_value(std::size_t bytes, bool real, const Element& element, std::size_t index) {
    if (header_.coding == Coding::text) {
      const std::string_view word = next_word(rest_);
      if (word.empty()) refuse_end(element, index);
      const auto value = number_of<double>(word);
      if (!value)
        throw Error(fmt::format("{}: {} {} of {} has the value '{:.40}'", path_, element.name,
                                index + 1, element.count, word),
                    "it must be a number");
      return *value;
    }
    if (rest_.size() < bytes) refuse_end(element, index);
    std::uint64_t raw = 0;
    for (std::size_t i = 0; i < bytes; ++i) {
      const std::size_t from = header_.coding == Coding::big_endian ? i : bytes - 1 - i;
      raw = raw << 8U | static_cast<unsigned char>(rest_[from]);
    }
    rest_.remove_prefix(bytes);
    if (!real) return static_cast<double>(raw);
    double value = 0;
    if (bytes == 8) {
      std::memcpy(&value, &raw, 8);
      return value;
    }
    const auto narrow = static_cast<std::uint32_t>(raw);
    float single = 0;
    std::memcpy(&single, &narrow, 4);
    return single;
  }

  [[noreturn]] void refuse_end(const Element& element, std::size_t index) const {
    throw Error(
        fmt::format("{} ends at {} {} of {}", path_, element.name, index + 1, element.count),
        "the file is truncated or the counts in its header are wrong");
  }

  const Header& header_;
  const std::string& path_;
  std::string_view rest_;
};

void check_ply(std::string_view text, const std::string& path) {
  const Header header = header_of(text, path);
  check_elements(header, path);
  Walk(header, path).run();
}

} // namespace

const char* const triangulate_faces =
    "every face must be a triangle; mesh programs split them (MeshLab: Turn into a Pure-Triangular "
    "Mesh, Blender: Triangulate Faces)";

void check_mesh(MeshFormat format, std::string_view text, const std::string& path) {
  switch (format) {
  case MeshFormat::off:
    return check_off(text, path);
  case MeshFormat::ply:
    return check_ply(text, path);
  case MeshFormat::obj:
    return check_obj(text, path);
  case MeshFormat::stl:
    return check_stl(text, path);
  }
}

} // namespace orograph
