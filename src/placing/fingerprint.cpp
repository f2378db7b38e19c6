// SPDX-License-Identifier: GPL-3.0-or-later
#include "placing/fingerprint.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <cstring>
#include <utility>
#include <variant>

namespace orograph {
namespace {

class Mixer {
public:
  void add(const void* data, std::size_t bytes) {
    const char* at = static_cast<const char*>(data);
    for (; bytes >= sizeof(std::uint64_t); bytes -= sizeof(std::uint64_t)) {
      mix(word(at, sizeof(std::uint64_t)));
      at += sizeof(std::uint64_t);
    }
    if (bytes > 0) mix(word(at, bytes));
  }
  template <class Values>
  void add_all(const Values& values) {
    mix(values.size());
    if (values.size() > 0) add(values.data(), values.size() * sizeof(values[0]));
  }
  std::uint64_t state() const { return state_; }

private:
  static std::uint64_t word(const char* at, std::size_t bytes) {
    std::uint64_t value = 0;
    std::memcpy(&value, at, bytes);
    return value;
  }
  // A step of the finalizer of MurmurHash3 (Appleby, public domain): every bit comes to count.
  void mix(std::uint64_t value) {
    state_ = (state_ ^ value) * 0xff51afd7ed558ccdULL;
    state_ ^= state_ >> 33;
  }

  std::uint64_t state_ = 0x9e3779b97f4a7c15ULL;
};

void add(Mixer& mixer, const Grid& grid) {
  // Three corners tell a lattice.
  for (const auto& [column, row] :
       {std::pair{0, 0}, {grid.columns - 1, 0}, {grid.columns - 1, grid.rows - 1}}) {
    const Vec3 place =
        std::visit([&](const auto& l) { return l.vertex_m(column, row, 0); }, grid.lattice);
    mixer.add(&place, sizeof place);
  }
  const int size[] = {grid.columns, grid.rows};
  mixer.add(size, sizeof size);
  std::visit([&](const auto& heights) { mixer.add_all(heights); }, grid.heights_m);
}

void add(Mixer& mixer, const Tin& tin) {
  mixer.add_all(tin.vertices_m);
  mixer.add_all(tin.triangles);
}

void add(Mixer& mixer, const Solid& solid) {
  mixer.add_all(solid.vertices_m);
  mixer.add_all(solid.triangles);
  for (const SolidEdge& edge : solid.edges) {
    const std::uint32_t values[] = {edge.from, edge.to, edge.left, edge.right, edge.smooth};
    mixer.add(values, sizeof values);
  }
}

void add(Mixer& mixer, const ScenePlace& place) {
  const double values[] = {place.x, place.y, place.height.value_or(0)};
  mixer.add(values, sizeof values);
  const std::uint32_t kinds[] = {place.lonlat, place.height.has_value()};
  mixer.add(kinds, sizeof kinds);
}

void add(Mixer& mixer, const SolidInstance& instance) {
  const std::uint64_t numbers[] = {instance.place, instance.solid};
  mixer.add(numbers, sizeof numbers);
  const auto& [x, y, z, origin] = instance.to_place;
  const double matrix[] = {x.x, x.y, x.z, 0, y.x,      y.y,      y.z,      0,
                           z.x, z.y, z.z, 0, origin.x, origin.y, origin.z, 1};
  mixer.add(matrix, sizeof matrix);
}

std::string text_of(const Mixer& mixer) {
  return fmt::format("{:016x}", mixer.state());
}

} // namespace

std::string fingerprint(const TerrainData& terrain) {
  Mixer mixer;
  std::visit([&](const auto& surface) { add(mixer, surface); }, terrain.surface);
  mixer.add_all(terrain.map.crs_wkt);
  const double frame[] = {terrain.map.origin.x, terrain.map.origin.y, terrain.map.unit_m,
                          terrain.map.height_unit_m};
  mixer.add(frame, sizeof frame);
  return text_of(mixer);
}

std::string fingerprint(const SceneFile& scene) {
  Mixer mixer;
  for (const Solid& solid : scene.solids) add(mixer, solid);
  for (const ScenePlace& place : scene.places) add(mixer, place);
  for (const SolidInstance& instance : scene.instances) add(mixer, instance);
  return text_of(mixer);
}

std::string fingerprint(std::string_view text) {
  Mixer mixer;
  mixer.add_all(text);
  return text_of(mixer);
}

} // namespace orograph
