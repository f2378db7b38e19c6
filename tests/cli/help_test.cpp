// SPDX-License-Identifier: GPL-3.0-or-later
// The table of options, the help, the man page and the README agree.
#include "cli/options/help.hpp"
#include "cli/options/options.hpp"
#include "tests/catch.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

using namespace orograph;

namespace {

struct Tables {
  RenderSettings render_settings;
  SweepSettings sweep_settings;
  MergeSettings merge_settings;
  AccuracySettings accuracy_settings;
  InfoSettings info_settings;
  TinSettings tin_settings;
  FragmentationSettings fragmentation_settings;
  VisibleSettings visible_settings;
  std::vector<Command> commands{render_command(render_settings),
                                sweep_command(sweep_settings),
                                merge_command(merge_settings),
                                accuracy_command(accuracy_settings),
                                info_command(info_settings),
                                tin_command(tin_settings),
                                fragmentation_command(fragmentation_settings),
                                visible_command(visible_settings)};
};

std::string without_backslashes(std::string text) {
  std::erase(text, '\\');
  return text;
}

/// Commands of a page of documentation, continued lines joined.
std::vector<std::string> commands_in(const std::filesystem::path& page) {
  std::ifstream file(page);
  std::vector<std::string> commands;
  std::string line, joined;
  while (std::getline(file, line)) {
    joined += line;
    if (joined.ends_with('\\')) {
      joined.back() = ' ';
      continue;
    }
    if (joined.find("orograph render") != std::string::npos ||
        joined.find("orograph sweep") != std::string::npos ||
        joined.find("orograph merge") != std::string::npos ||
        joined.find("orograph accuracy") != std::string::npos ||
        joined.find("orograph fragmentation") != std::string::npos ||
        joined.find("orograph info") != std::string::npos ||
        joined.find("orograph tin") != std::string::npos)
      commands.push_back(joined);
    joined.clear();
  }
  return commands;
}

/// "--fov", "--view-from": wherever a word begins with two dashes and a letter.
std::vector<std::string> long_options_in(const std::string& text) {
  std::vector<std::string> names;
  const auto is_letter = [](char c) { return c >= 'a' && c <= 'z'; };
  for (auto at = text.find(" --"); at != std::string::npos; at = text.find(" --", at + 1)) {
    const auto begin = text.begin() + static_cast<std::ptrdiff_t>(at) + 1;
    const auto end =
        std::find_if_not(begin, text.end(), [&](char c) { return c == '-' || is_letter(c); });
    if (end - begin > 2 && is_letter(begin[2])) names.emplace_back(begin, end);
  }
  return names;
}

} // namespace

TEST_CASE("every option stands in the help and in the man page") {
  const Tables tables;
  const std::string man = without_backslashes(man_page(tables.commands));
  for (const auto& command : tables.commands) {
    const std::string help = command_help(command, HelpLength::all);
    CHECK(program_help(tables.commands).find(command.name) != std::string::npos);
    for (const auto& option : command.options) {
      INFO(command.name << " " << option.name);
      CHECK(help.find(option.name + (option.value.empty() ? "" : " " + option.value)) !=
            std::string::npos);
      CHECK(man.find(option.name) != std::string::npos);
      CHECK_FALSE(option.help.empty());
      CHECK(option.take);
      // What takes a number says in which unit or range, in the help as in its refusal.
      if (!option.allowed.empty()) CHECK(man.find(option.allowed) != std::string::npos);
    }
  }
}

TEST_CASE("help fits a terminal and is plain text") {
  const Tables tables;
  for (const auto& command : tables.commands) {
    for (const HelpLength length : {HelpLength::daily, HelpLength::all}) {
      std::istringstream lines(command_help(command, length));
      std::string line;
      while (std::getline(lines, line)) {
        INFO(line);
        CHECK(line.size() <= 80);
        CHECK_FALSE(line.ends_with(' '));
        CHECK(line.find('\t') == std::string::npos);
      }
    }
  }
}

TEST_CASE("the man page has no line that troff would take for an unknown macro") {
  const Tables tables;
  std::istringstream lines(man_page(tables.commands));
  std::string line;
  const std::set<std::string> macros{".TH", ".SH", ".SS", ".TP", ".B", ".br"};
  while (std::getline(lines, line)) {
    INFO(line);
    CHECK_FALSE(line.empty());
    if (line.front() == '.' || line.front() == '\'')
      CHECK(macros.contains(line.substr(0, line.find(' '))));
  }
}

TEST_CASE("the pages for readers use options that there are") {
  const Tables tables;
  std::set<std::string> known;
  for (const auto& command : tables.commands)
    for (const auto& option : command.options) known.insert(option.name);
  const std::filesystem::path root = OROGRAPH_SOURCE_DIR;
  for (const char* page : {"README.md", "docs/how-it-works.md", "data_samples/README.md"})
    for (const auto& command : commands_in(root / page))
      for (const auto& name : long_options_in(command)) {
        INFO(page << ": " << command);
        CHECK(known.contains(name));
      }
  CHECK(long_options_in("orograph render a --fov 3 --view-from 1/2") ==
        std::vector<std::string>{"--fov", "--view-from"});
}

TEST_CASE("messages name options that there are") {
  const Tables tables;
  // Of orograph itself, and of programs that hints tell to run.
  std::set<std::string> known{"--version", "--man",     "--json-usage", "--completion", "--calc",
                              "--formats", "--outfile", "--writers",    "--type"};
  for (const auto& command : tables.commands)
    for (const auto& option : command.options) known.insert(option.name);
  const std::filesystem::path root = OROGRAPH_SOURCE_DIR;
  int named = 0;
  for (const char* folder : {"cli", "dem", "profiles", "src"})
    for (const auto& entry : std::filesystem::recursive_directory_iterator(root / folder)) {
      if (entry.path().extension() != ".cpp") continue;
      std::ifstream file(entry.path());
      std::string line;
      while (std::getline(file, line)) {
        if (line.find('"') == std::string::npos) continue;
        std::replace(line.begin(), line.end(), '"', ' ');
        for (const auto& name : long_options_in(line)) {
          INFO(entry.path() << ": " << line);
          CHECK(known.contains(name));
          ++named;
        }
      }
    }
  CHECK(named > 100);
}

TEST_CASE("--help shows what people use every day, and how to see the rest") {
  const Tables tables;
  const Command& render = tables.commands.front();
  const std::string daily = command_help(render, HelpLength::daily),
                    all = command_help(render, HelpLength::all);
  std::size_t shown = 0;
  for (const Option& option : render.options) {
    if (option.is_positional()) continue;
    const bool is_daily = is_among(render.daily, option.name);
    const std::string entry = option.name + (option.value.empty() ? "" : " " + option.value);
    INFO(entry);
    CHECK((daily.find(" " + entry + "\n") != std::string::npos ||
           daily.find(" " + entry + "  ") != std::string::npos) == is_daily);
    CHECK(all.find(" " + entry) != std::string::npos);
    shown += is_daily ? 1 : 0;
  }
  CHECK(static_cast<std::ptrdiff_t>(shown) ==
        std::ranges::count(render.daily, ' ') + 1); // each is an option
  CHECK(shown >= 38);
  CHECK(shown <= 43);
  CHECK(daily.find("more options: orograph render --help-all shows all") != std::string::npos);
  CHECK(all.find("more options") == std::string::npos);
  CHECK(std::count(daily.begin(), daily.end(), '\n') < 200);
}

TEST_CASE("programs are told each option with its kind, range, words and default") {
  const Tables tables;
  for (const auto& command : tables.commands) {
    const auto usage = nlohmann::json::parse(usage_json(command));
    CHECK(usage["name"] == command.name);
    REQUIRE(usage["input_arguments"].size() == command.options.size());
    for (std::size_t i = 0; i < command.options.size(); ++i) {
      const Option& option = command.options[i];
      const auto& told = usage["input_arguments"][i];
      INFO(told.dump());
      CHECK((told["name"] == option.name || "--" + told["name"].get<std::string>() == option.name));
      CHECK((told["type"] == "boolean") == option.is_switch());
      // What is said may be given.
      if (told.contains("default")) CHECK(option.take(told["default"]));
      const bool is_one = !option.is_list_of_words();
      if (told.contains("choices") && is_one)
        for (const auto& word : told["choices"]) CHECK(option.take(word));
      if (told["type"] == "real" || told["type"] == "integer") {
        for (const char* end : {"min_value", "max_value"}) {
          if (!told.contains(end)) continue;
          const double limit = told[end];
          const bool is_included = told[std::string(end) + "_is_included"];
          const std::string text = fmt::format("{}", limit);
          CHECK(option.take(text) == is_included);
          const double beyond = limit + (std::string_view(end) == "min_value" ? -1 : 1);
          CHECK_FALSE(option.take(fmt::format("{}", beyond)));
        }
      }
      if (told["type"] == "integer") CHECK_FALSE(option.take("1.5"));
    }
  }
}

TEST_CASE("programs are told what people know of some options") {
  const Tables tables;
  const auto usage = nlohmann::json::parse(usage_json(tables.commands.front()));
  const auto of = [&](const std::string& name) {
    for (const auto& told : usage["input_arguments"])
      if (told["name"] == name) return told;
    FAIL("no " << name);
    return usage;
  };
  CHECK(of("fov")["type"] == "real");
  CHECK(of("fov")["max_value"] == 360);
  CHECK(of("fov")["max_value_is_included"] == true);
  CHECK(of("fov")["default"] == "30");
  CHECK(of("fov")["unit"] == "degrees");
  CHECK(of("projection")["choices"] ==
        nlohmann::json{"perspective", "orthographic", "oblique", "cylindrical", "equirectangular"});
  CHECK(of("of")["choices"].size() == 10);
  CHECK(of("layers")["list"] == true);
  CHECK(of("layers")["choices"][0] == "profiles");
  CHECK(of("view")["extensions"] == nlohmann::json{"toml", "json"});
  CHECK(of("drape")["repeatable"] == true);
  CHECK(of("exaggeration")["type"] == "string");
  CHECK(of("view-from")["between"] == "/");
  CHECK(of("crop")["type"] == "boolean");
  CHECK(of("INPUT")["required"] == true);
}
