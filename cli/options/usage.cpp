// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/options/help.hpp"

#include <nlohmann/json.hpp>

#include <cmath>

namespace orograph {
namespace {

using Json = nlohmann::ordered_json;

std::string type_of(const Option& option) {
  if (option.is_switch()) return "boolean";
  if (!option.range) return "string";
  return option.is_whole ? "integer" : "real";
}

void add_range(Json& json, const NumberRange& range) {
  if (std::isfinite(range.low)) {
    json["min_value"] = range.low;
    json["min_value_is_included"] = !range.low_excluded;
  }
  if (std::isfinite(range.high)) {
    json["max_value"] = range.high;
    json["max_value_is_included"] = !range.high_excluded;
  }
  if (!range.unit.empty()) json["unit"] = range.unit;
}

void add_default(Json& json, const Option& option) {
  if (option.by_default.empty()) return;
  // Tables hold values and sentences about what is chosen.
  const bool is_value =
      option.by_default.find(' ') == std::string::npos && option.take(option.by_default);
  json[is_value ? "default" : "default_text"] = option.by_default;
}

Json json_of(const Option& option) {
  Json json{{"name", option.is_positional() ? option.name : option.name.substr(2)},
            {"type", type_of(option)},
            {"description", option.help}};
  if (option.letter != 0) json["short"] = std::string(1, option.letter);
  if (!option.value.empty()) json["metavar"] = option.value;
  if (!option.allowed.empty()) json["allowed"] = option.allowed;
  add_default(json, option);
  if (option.range) add_range(json, *option.range);
  if (const auto words = option.words_to_choose(); !words.empty())
    json[option.is_choice() || option.is_list_of_words() ? "choices" : "words"] = words;
  if (option.is_list_of_words()) json["list"] = true;
  if (option.repeatable) json["repeatable"] = true;
  if (!option.extensions.empty()) json["extensions"] = option.extensions;
  if (option.between != ',') json["between"] = std::string(1, option.between);
  if (option.is_positional())
    json["positional"] = json["required"] = true;
  else
    json["group"] = option.group;
  return json;
}

} // namespace

std::string usage_json(const Command& command) {
  Json arguments = Json::array(), examples = Json::array();
  for (const Option& option : command.options) arguments.push_back(json_of(option));
  for (const Example& example : command.examples)
    examples.push_back({{"command", example.command}, {"description", example.meaning}});
  const Json json{{"name", command.name},
                  {"description", command.summary},
                  {"examples", examples},
                  {"input_arguments", arguments}};
  return json.dump(2) + "\n";
}

} // namespace orograph
