// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/report/name_report.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace orograph {
namespace {

using Json = nlohmann::ordered_json;

Json json_of(const NameFacts& name) {
  Json json{{"name", name.text}, {"map", {name.map.x, name.map.y, name.height}}};
  json["azimuth_deg"] = name.bearing ? Json(name.bearing->azimuth_deg) : Json();
  json["altitude_deg"] = name.bearing ? Json(name.bearing->altitude_deg) : Json();
  json["distance_m"] = name.bearing ? Json(name.bearing->distance_m) : Json();
  json["prominence_m"] = name.prominence_m ? Json(*name.prominence_m) : Json();
  json["prominence_is_at_least"] = name.prominence_is_at_least;
  json["hidden_mm"] = name.hidden_mm;
  if (name.corners_mm)
    for (const Vec2 corner : *name.corners_mm) json["corners_mm"].push_back({corner.x, corner.y});
  return json;
}

Json list_of(const NamesFacts& names, NameState state) {
  Json list = Json::array();
  for (const NameFacts& name : names.names)
    if (name.state == state) list.push_back(json_of(name));
  return list;
}

} // namespace

std::string names_in_words(const NamesFacts& names) {
  std::string words = fmt::format("{} of {} names", names.count(NameState::chosen),
                                  names.names.size() + names.elsewhere);
  const auto add = [&](std::size_t count, const char* what) {
    if (count > 0) words += fmt::format(", {} {}", count, what);
  };
  add(names.count(NameState::hidden), "hidden");
  add(names.count(NameState::crowded_out), "without room");
  add(names.elsewhere, "beyond the picture");
  if (names.unnamed > 0) words += fmt::format("; {} places have no name", names.unnamed);
  return words;
}

std::string names_as_json(const NamesFacts& names) {
  return Json{{"chosen", list_of(names, NameState::chosen)},
              {"crowded_out", list_of(names, NameState::crowded_out)},
              {"hidden", list_of(names, NameState::hidden)},
              {"elsewhere", names.elsewhere},
              {"unnamed", names.unnamed}}
      .dump();
}

std::string furniture_as_json(const MapFacts& facts) {
  Json pieces = Json::array(), left_out = Json::array();
  for (const auto& [piece, box, texts, cut] : facts.furniture) {
    if (!box) left_out.push_back(piece);
    if (box)
      pieces.push_back({{"piece", piece},
                        {"box_mm", {box->low.x, box->low.y, box->high.x, box->high.y}},
                        {"texts", texts},
                        {"cut", cut}});
  }
  return Json{{"pieces", pieces}, {"left_out", left_out}, {"letters", facts.lettering}}.dump();
}

} // namespace orograph
