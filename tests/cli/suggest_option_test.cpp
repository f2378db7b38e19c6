// SPDX-License-Identifier: GPL-3.0-or-later
// Words of other programs, and what they are told.
#include "cli/options/options.hpp"
#include "cli/options/suggest_option.hpp"
#include "tests/catch.hpp"

#include <algorithm>
#include <cctype>
#include <set>

using namespace orograph;

namespace {

bool has(const Command& command, std::string_view name) {
  return std::any_of(command.options.begin(), command.options.end(),
                     [&](const Option& option) { return option.name == name; });
}

} // namespace

TEST_CASE("each word of other programs leads to an option that there is") {
  RenderSettings render_settings;
  SweepSettings sweep_settings;
  VisibleSettings visible_settings;
  const Command render = render_command(render_settings), sweep = sweep_command(sweep_settings),
                visible = visible_command(visible_settings);
  std::set<std::string_view> seen;
  for (const OtherWord& word : other_words()) {
    INFO(word.word);
    CHECK(seen.insert(word.word).second);
    const Command& command = word.option.empty() || has(render, word.option) ? render
                             : has(sweep, word.option)                       ? sweep
                                                                             : visible;
    CHECK_FALSE(has(command, "--" + std::string(word.word)));
    CHECK((word.option.empty() || has(command, word.option)));
    CHECK((!word.option.empty() || !word.says.empty()));
    // Options that are named beside it.
    for (std::size_t at = word.says.find("--"); at != std::string_view::npos;
         at = word.says.find("--", at + 2)) {
      const auto end = std::find_if(
          word.says.begin() + static_cast<std::ptrdiff_t>(at), word.says.end(),
          [](char c) { return c != '-' && !std::isalpha(static_cast<unsigned char>(c)); });
      CHECK(has(command, std::string(word.says.begin() + static_cast<std::ptrdiff_t>(at), end)));
    }
    const std::string dashes = word.word.starts_with('-') ? "" : "--";
    const std::string told = suggestion(command, dashes + std::string(word.word));
    CHECK(told.find(word.option.empty() ? word.says : word.option) != std::string::npos);
  }
  CHECK(seen.size() > 100);
}

TEST_CASE("meaning goes before spelling, and spelling before nothing") {
  RenderSettings settings;
  TinSettings tin_settings;
  SweepSettings sweep_settings;
  const Command render = render_command(settings), tin = tin_command(tin_settings),
                sweep = sweep_command(sweep_settings);
  const auto names = [](const Command& command, const std::string& name, const std::string& part) {
    INFO(name << ": " << suggestion(command, name));
    CHECK(suggestion(command, name).find(part) != std::string::npos);
  };
  for (const char* name : {"--azimuth", "--elevation", "--altitude", "--elevtion", "--Azimuth",
                           "--view_elevation", "-p", "-p225/30"})
    names(render, name, "--view-from AZ/EL");
  names(render, "--veiw-from", "did you mean --view-from?");
  names(render, "--vertical_exaggeration", "--exaggeration");
  names(render, "-JZ5c", "--exaggeration");
  names(render, "--zscale", "--exaggeration");
  names(render, "--width", "--pen-width");
  names(render, "--sun", "--light");
  names(render, "--contour-interval", "--contours");
  names(render, "--skirt", "--block");
  names(render, "--cmap", "and the ground none");
  names(render, "--panorama", "(cylindrical goes all round)?");
  names(render, "--output", "did you mean OUTPUT (named without an option)?");
  names(render, "-of", "--of");
  names(render, "--exag", "--exaggeration");
  CHECK(suggestion(render, "--zzzzzzzzzzzz").empty());
  // Only what the command has: tin has no view, a sweep has its own.
  CHECK(suggestion(tin, "--azimuth").find("view-from") == std::string::npos);
  names(tin, "--region", "--bbox");
  names(sweep, "--azim", "--azimuth");
  names(sweep, "--view-from", "did you mean --azimuth LIST (and --elevation)?");
}
