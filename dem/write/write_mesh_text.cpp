// SPDX-License-Identifier: GPL-3.0-or-later
// OFF, ascii PLY and OBJ: a list of vertices, a list of triangles.
#include "dem/write/tin_writers.hpp"
#include "geometry/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <fstream>
#include <initializer_list>
#include <string_view>

namespace orograph {
namespace {

// Text on its way to a file, in large pieces.
class TextFile {
public:
  TextFile(const std::string& path, const std::string& name) : name_(name) {
    errno = 0;
    file_.open(path, std::ios::binary | std::ios::trunc);
    check();
  }

  void add(std::string_view text) {
    text_ += text;
    if (text_.size() >= kPiece) write();
  }
  // The shortest decimals that read back to the same number.
  template <class Number>
  void add_number(Number number) {
    char decimals[32];
    const auto end = std::to_chars(std::begin(decimals), std::end(decimals), number).ptr;
    add({decimals, static_cast<std::size_t>(end - decimals)});
  }
  void finish() {
    write();
    file_.close();
    check();
  }

private:
  static constexpr std::size_t kPiece = 1 << 16;

  void write() {
    file_.write(text_.data(), static_cast<std::streamsize>(text_.size()));
    text_.clear();
    check();
  }
  void check() const {
    if (file_) return;
    throw Error(fmt::format("{} can't be written ({})", name_,
                            errno == 0 ? "no reason given" : std::strerror(errno)),
                "a disk with room for it, and a folder that you may write to");
  }

  std::string name_, text_;
  std::ofstream file_;
};

std::string on_one_line(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
  return text;
}

void add_comments(const Terrain& terrain, std::string_view mark, TextFile& to) {
  const auto begin = [&](std::string_view what) {
    for (const std::string_view text : {mark, std::string_view(" orograph: "), what}) to.add(text);
  };
  begin("units ");
  to.add_number(terrain.map.unit_m);
  to.add(" ");
  to.add_number(terrain.map.height_unit_m);
  to.add("\n");
  if (!terrain.map.crs_wkt.empty()) {
    begin("crs ");
    to.add(on_one_line(terrain.map.crs_wkt));
    to.add("\n");
  }
  if (terrain.surface_error_m > 0) {
    begin("surface_error_m ");
    to.add_number(terrain.surface_error_m);
    to.add("\n");
  }
}

void add_header(const Terrain& terrain, const Tin& tin, TinFormat format, TextFile& to) {
  const std::size_t vertices = tin.vertices_m.size(), triangles = tin.triangles.size();
  if (format == TinFormat::off) {
    to.add("OFF\n");
    add_comments(terrain, "#", to);
    to.add(fmt::format("{} {} 0\n", vertices, triangles));
  } else if (format == TinFormat::ply) {
    to.add("ply\nformat ascii 1.0\n");
    add_comments(terrain, "comment", to);
    to.add(fmt::format("element vertex {}\nproperty double x\nproperty double y\n"
                       "property double z\nelement face {}\n"
                       "property list uchar int vertex_indices\nend_header\n",
                       vertices, triangles));
  } else {
    add_comments(terrain, "#", to);
  }
}

} // namespace

void write_mesh_text(const Terrain& terrain, const std::string& path, TinFormat format,
                     const std::string& name) {
  const Tin& tin = std::get<Tin>(terrain.surface);
  const bool is_obj = format == TinFormat::obj;
  TextFile to(path, name);
  add_header(terrain, tin, format, to);
  for (const Vec3& vertex_m : tin.vertices_m) {
    const Vec3 at = terrain.map.to_map(vertex_m);
    if (is_obj) to.add("v ");
    to.add_number(at.x);
    to.add(" ");
    to.add_number(at.y);
    to.add(" ");
    to.add_number(at.z);
    to.add("\n");
  }
  const std::uint32_t first = is_obj ? 1 : 0; // OBJ counts vertices from 1
  for (const auto& triangle : tin.triangles) {
    to.add(is_obj ? "f" : "3");
    for (const std::uint32_t vertex : triangle) {
      to.add(" ");
      to.add_number(vertex + first);
    }
    to.add("\n");
  }
  to.finish();
}

} // namespace orograph
