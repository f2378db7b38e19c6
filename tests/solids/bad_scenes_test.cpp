// SPDX-License-Identifier: GPL-3.0-or-later
// Bad scenes, and the whole line that each is told: the cases of bad_scenes.txt.
#include "geometry/error.hpp"
#include "tests/catch.hpp"
#include "tests/solids/made_scene_files.hpp"

using namespace orograph;

namespace {

struct Case {
  std::string name, error;
  std::vector<std::pair<std::string, std::string>> files; // the last one is read
};

std::vector<Case> read_cases() {
  std::ifstream file(std::string(OROGRAPH_SOURCE_DIR) + "/tests/solids/bad_scenes.txt");
  std::vector<Case> cases;
  std::string line;
  while (std::getline(file, line)) {
    const auto rest = [&](const char* word) { return line.substr(std::string(word).size()); };
    if (line.starts_with("case: ")) cases.push_back({rest("case: "), "", {}});
    if (line.starts_with("file: ")) cases.back().files.emplace_back(rest("file: "), "");
    if (line.starts_with("  ")) cases.back().files.back().second += line.substr(2) + "\n";
    if (line.starts_with("error: ")) cases.back().error = rest("error: ");
  }
  return cases;
}

std::string error_of(const std::string& path) {
  try {
    read_scene(path);
  } catch (const Error& error) {
    return error.what();
  }
  return "none";
}

std::string without(std::string text, const std::string& words) {
  for (auto at = text.find(words); at != std::string::npos; at = text.find(words))
    text.erase(at, words.size());
  return text;
}

} // namespace

TEST_CASE("each bad scene is told in one line, with file and line") {
  const std::vector<Case> cases = read_cases();
  CHECK(cases.size() > 80);
  for (const Case& one : cases) {
    const TempFolder folder;
    std::string path;
    for (const auto& [name, text] : one.files) path = write_file(folder, name, text);
    INFO("case: " << one.name);
    CHECK(without(error_of(path), folder.path().string() + "/") == one.error);
  }
}

TEST_CASE("what isn't a scene file at all") {
  const TempFolder folder;
  const auto told = [&](const std::string& path) {
    return without(error_of(path), folder.path().string() + "/");
  };
  const std::string right = ": give a scene in TOML, with tables [part.NAME] and [[place]]";
  std::string large;
  large.resize(10'000'001, '#');
  CHECK(told(folder.file("nowhere.toml")) == "nowhere.toml: no such file" + right);
  CHECK(error_of(folder.path().string()) == folder.path().string() + " is a folder" + right);
  CHECK(told(write_file(folder, "large.toml", large)) ==
        "large.toml is too large for a scene (over 10 MB)" + right);
}
