// SPDX-License-Identifier: GPL-3.0-or-later
// Triangles of PLY, in text and binary: a header tells what its elements hold.
#include "dem/read/map_shapes.hpp"
#include "geometry/error.hpp"
#include "text/words.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <utility>

namespace orograph {
namespace {

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

// The elements that hold the triangles.
struct MeshElements {
  const Element& vertices;
  const Element& faces;
};

MeshElements mesh_elements(const Header& header, const std::string& path) {
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
  return {vertex, face};
}

bool names_corners(const Property& property) {
  return property.name.starts_with("vertex_ind") && property.count_bytes > 0;
}

// Walks over all values of the body, once.
class Walk {
public:
  Walk(const Header& header, MapShapes& shapes)
      : header_(header), mesh_(mesh_elements(header, shapes.path)), shapes_(shapes),
        path_(shapes.path), rest_(header.body) {}

  void run() {
    for (const Element& element : header_.elements) {
      if (element.properties.empty()) continue; // of any number there is nothing in the file
      for (std::size_t i = 0; i < element.count; ++i) {
        if (&element == &mesh_.vertices) shapes_.points.emplace_back();
        for (const Property& property : element.properties) pass(element, i, property);
      }
    }
    const bool more = header_.coding == Coding::text ? !next_word(rest_).empty() : !rest_.empty();
    if (more)
      throw Error(fmt::format("{} holds more than its header says", path_),
                  "the counts of its elements are wrong");
  }

private:
  void pass(const Element& element, std::size_t index, const Property& property) {
    if (property.count_bytes == 0) {
      const double value = next_value(property.bytes, property.is_real, element, index);
      if (&element == &mesh_.vertices && property.is_real) take_coordinate(property, index, value);
      return;
    }
    const double count = next_value(property.count_bytes, false, element, index);
    if (&element == &mesh_.faces && names_corners(property))
      return take_face(property, index, count);
    for (double i = 0; i < count; ++i) next_value(property.bytes, property.is_real, element, index);
  }

  void take_coordinate(const Property& property, std::size_t index, double value) {
    Vec3& point = shapes_.points.back();
    double* const axis = property.name == "x"   ? &point.x
                         : property.name == "y" ? &point.y
                         : property.name == "z" ? &point.z
                                                : nullptr;
    if (!axis) return;
    if (!std::isfinite(value))
      throw Error(fmt::format("{}: {} {} of {} has {} = {}", path_, mesh_.vertices.name, index + 1,
                              mesh_.vertices.count, property.name, value),
                  "it must be a finite number");
    *axis = value;
  }

  void take_face(const Property& property, std::size_t index, double count) {
    if (count != 3)
      throw Error(fmt::format("{}: face {} of {} has {} corners", path_, index + 1,
                              mesh_.faces.count, count),
                  triangulate_faces);
    std::array<std::uint32_t, 3> corners;
    for (std::uint32_t& corner : corners) {
      const double value = next_value(property.bytes, false, mesh_.faces, index);
      // Those of a binary file are without a sign here: what is below 0 is too great.
      if (!(value >= 0 && value < static_cast<double>(mesh_.vertices.count)) ||
          value != std::floor(value))
        throw Error(fmt::format("{}: face {} names a vertex that isn't there", path_, index + 1),
                    fmt::format("the file has {} vertices", mesh_.vertices.count));
      corner = static_cast<std::uint32_t>(value);
    }
    shapes_.triangles.push_back(corners);
  }

  // Of whole numbers in binary the sign isn't taken: a negative one is too many. A number of four
  // bytes is rounded to these in text, too.
  double next_value(std::size_t bytes, bool real, const Element& element, std::size_t index) {
    if (header_.coding == Coding::text) {
      const std::string_view word = next_word(rest_);
      if (word.empty()) refuse_end(element, index);
      std::optional<double> value = number_of<double>(word);
      if (real && bytes == 4) value = number_of<float>(word);
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
  const MeshElements mesh_;
  MapShapes& shapes_;
  const std::string& path_;
  std::string_view rest_;
};

} // namespace

void take_ply(std::string_view text, MapShapes& shapes) {
  const Header header = header_of(text, shapes.path);
  Walk(header, shapes).run();
}

} // namespace orograph
