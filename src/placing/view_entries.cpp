// SPDX-License-Identifier: GPL-3.0-or-later
#include "placing/view_entries.hpp"

#include "geometry/error.hpp"
#include "text/text_of_file.hpp"
#include "text/words.hpp"
#include "view/pipeline.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string_view>

namespace orograph {
namespace {

using Kind = ViewEntry::Kind;

struct Key {
  std::string_view name, example;
  std::size_t count;    // of its numbers; 0 is text
  bool required = true; // has to be there
};

constexpr std::array<Key, 9> kKeys{{{"projection", "\"perspective\"", 0},
                                    {"vrp", "[500000, 100000, 1200]", 3},
                                    {"vpn", "[0, -1, 0.5]", 3},
                                    {"vup", "[0, 0, 1]", 3, false},
                                    {"prp", "[0, 0, 4000]", 3},
                                    {"window", "[-1000, -500, 1000, 500]", 4},
                                    {"front", "2000", 1, false},
                                    {"back", "-2000", 1, false},
                                    {"exaggeration", "1.5", 1, false}}};

std::string place(const std::string& path, const ViewEntry& entry) {
  return entry.line == 0 ? path : fmt::format("{}, line {}", path, entry.line);
}

std::string how_to_give(const Key& key) {
  return fmt::format("give {}, as in {} = {}",
                     key.count == 0   ? "a word"
                     : key.count == 1 ? "a number"
                                      : fmt::format("a list of {} numbers", key.count),
                     key.name, key.example);
}

[[noreturn]] void refuse_unknown(const ViewEntry& entry, const std::string& path) {
  std::array<std::string_view, kKeys.size()> names;
  std::transform(kKeys.begin(), kKeys.end(), names.begin(),
                 [](const Key& key) { return key.name; });
  const std::string_view nearest = nearest_word(entry.key, names);
  std::string hint =
      "a view has projection, vrp, vpn, vup, prp, window, front, back and exaggeration";
  if (!nearest.empty()) hint = fmt::format("did you mean {}? {}", nearest, hint);
  throw Error(fmt::format("{}: unknown key '{}'", place(path, entry), entry.key), hint);
}

const Key& key_of(const ViewEntry& entry, const std::string& path) {
  const auto* const key =
      std::find_if(kKeys.begin(), kKeys.end(), [&](const Key& k) { return k.name == entry.key; });
  if (key == kKeys.end()) refuse_unknown(entry, path);
  return *key;
}

std::string words_for(const ViewEntry& entry) {
  switch (entry.kind) {
  case Kind::text:
    return "text";
  case Kind::number:
    return "a single number";
  case Kind::numbers:
    return fmt::format("a list of {} number{}", entry.numbers.size(),
                       entry.numbers.size() == 1 ? "" : "s");
  case Kind::other:
    break;
  }
  return entry.text;
}

void check_value(const ViewEntry& entry, const std::string& path) {
  const Key& key = key_of(entry, path);
  const Kind wanted = key.count == 0 ? Kind::text : key.count == 1 ? Kind::number : Kind::numbers;
  if (entry.kind != wanted || (wanted != Kind::text && entry.numbers.size() != key.count))
    throw Error(fmt::format("{}: {} is {}", place(path, entry), key.name, words_for(entry)),
                how_to_give(key));
  for (const double number : entry.numbers)
    if (!std::isfinite(number))
      throw Error(fmt::format("{}: {} is not finite", place(path, entry), key.name),
                  how_to_give(key));
}

PhigsProjection projection_of(const ViewEntry& entry, const std::string& path) {
  if (entry.text == "perspective") return PhigsProjection::perspective;
  if (entry.text == "parallel") return PhigsProjection::parallel;
  throw Error(fmt::format("{}: there is no projection '{}'", place(path, entry), entry.text),
              "give \"perspective\" or \"parallel\"");
}

Vec3 vec3_of(const std::vector<double>& n) {
  return {n[0], n[1], n[2]};
}

void set(ViewFile& view, const ViewEntry& entry, const std::string& path) {
  const std::vector<double>& n = entry.numbers;
  if (entry.key == "projection") view.projection = projection_of(entry, path);
  if (entry.key == "vrp") view.vrp_map = vec3_of(n);
  if (entry.key == "vpn") view.vpn = vec3_of(n);
  if (entry.key == "vup") view.vup = vec3_of(n);
  if (entry.key == "prp") view.prp_m = vec3_of(n);
  if (entry.key == "window") view.window_m = {{n[0], n[1]}, {n[2], n[3]}};
  if (entry.key == "front") view.front_m = n[0];
  if (entry.key == "back") view.back_m = n[0];
  if (entry.key == "exaggeration") view.exaggeration = n[0];
}

// The view as the pipeline's stages take it, with planes that stand in for those not given and
// refuse nothing that isn't refused without them.
PhigsView with_planes(const ViewFile& file) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  PhigsView view{file.projection, {}, file.vpn, file.vup, file.prp_m, file.window_m};
  const double eye_n = file.prp_m.z;
  const bool parallel = file.projection == PhigsProjection::parallel;
  view.front_m = file.front_m              ? *file.front_m
                 : !parallel               ? std::nextafter(eye_n, -infinity)
                 : file.back_m.has_value() ? std::nextafter(*file.back_m, infinity)
                                           : 0;
  view.back_m = file.back_m ? *file.back_m : std::nextafter(view.front_m, -infinity);
  return view;
}

void check_view(const ViewFile& file) {
  if (!(file.exaggeration > 0 && file.exaggeration <= 1000))
    throw Error("the exaggeration is not above 0 and up to 1000", "1 draws heights true");
  view_orientation({}, file.vpn, file.vup);
  const bool perspective = file.projection == PhigsProjection::perspective;
  // Without a front plane the stages have none to speak of.
  if (perspective && !file.front_m && file.prp_m.z > 0 && file.back_m &&
      !(*file.back_m < file.prp_m.z))
    throw Error("the back plane lies at the eye (PRP) or behind it",
                "put the back plane at a smaller n than the eye's");
  canonical_volume(with_planes(file));
}

} // namespace

void take_numbers(ViewEntry& entry, std::size_t count,
                  const std::function<std::optional<double>(std::size_t)>& number_at) {
  entry.kind = Kind::numbers;
  for (std::size_t i = 0; i < count; ++i) {
    const std::optional<double> number = number_at(i);
    if (!number) {
      entry.kind = Kind::other;
      entry.text = "a list that doesn't hold numbers alone";
      entry.numbers.clear();
      return;
    }
    entry.numbers.push_back(*number);
  }
}

std::string view_text(const std::string& path, std::size_t most_bytes) {
  return text_of_file(
      path, {most_bytes, "a view", "give a view in TOML, or a report of orograph render (.json)"});
}

ViewFile view_of_entries(const std::vector<ViewEntry>& entries, const std::string& path) {
  for (const ViewEntry& entry : entries) check_value(entry, path);
  for (const Key& key : kKeys)
    if (key.required && std::none_of(entries.begin(), entries.end(),
                                     [&](const ViewEntry& e) { return e.key == key.name; }))
      throw Error(fmt::format("{}: {} is missing", path, key.name), how_to_give(key));
  ViewFile view;
  for (const ViewEntry& entry : entries) set(view, entry, path);
  try {
    check_view(view);
  } catch (const Error& error) {
    throw Error(path, error.what());
  }
  return view;
}

} // namespace orograph
