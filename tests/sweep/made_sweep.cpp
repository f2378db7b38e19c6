// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/sweep/made_sweep.hpp"

#include "tests/catch.hpp"

#include <sys/stat.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>

namespace orograph {

namespace fs = std::filesystem;

Words words(const std::string& text) {
  std::istringstream stream(text);
  return {std::istream_iterator<std::string>(stream), {}};
}

Words operator+(Words a, const Words& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

const Words kSmall = words("--page 60x45 --margin 2 --profiles 12");

void make_terrains(const MadeFolder& folder) {
  constexpr int kSize = 24, kFine = 120;
  const auto hill = [](int column, int row) { return hill_m(column, row, kSize); };
  folder.write("hill.asc", ascii_grid(kSize, kSize, hill));
  folder.write("utm.asc", ascii_grid(kSize, kSize, hill));
  folder.write("utm.prj", kUtm32);
  folder.write("other.asc", ascii_grid(kSize, kSize, [&](int column, int row) {
                 return hill(column, row) + (column == 3 && row == 4 ? 1 : 0);
               }));
  folder.write("fine.asc",
               ascii_grid(kFine, kFine,
                          [](int column, int row) { return hill_m(column, row, kFine); },
                          {.cell = 2}));
}

ProgramRun run(const MadeFolder& folder, const Words& arguments,
               std::optional<std::uint64_t> largest_file_bytes) {
  return run_orograph(arguments,
                      {.folder = folder.path(), .largest_file_bytes = largest_file_bytes});
}

void run_well(const MadeFolder& folder, const Words& arguments) {
  const ProgramRun ended = run(folder, arguments);
  std::string line;
  for (const std::string& word : arguments) line += " " + word;
  INFO("orograph" << line << "\n" << ended.err);
  REQUIRE(ended.exit_code == 0);
}

std::map<std::string, std::string> contents(const MadeFolder& folder, const std::string& name) {
  std::map<std::string, std::string> files;
  const fs::path root = folder.path(name);
  for (const auto& entry : fs::recursive_directory_iterator(root))
    if (entry.is_regular_file()) {
      std::ifstream file(entry.path(), std::ios::binary);
      files[fs::relative(entry.path(), root).string()] = {std::istreambuf_iterator<char>(file), {}};
    }
  return files;
}

std::string differences(const std::map<std::string, std::string>& a,
                        const std::map<std::string, std::string>& b) {
  std::string text;
  for (const auto& [path, bytes] : a) {
    const auto other = b.find(path);
    if (other == b.end())
      text += "only one has " + path + "\n";
    else if (other->second != bytes)
      text += path + " differs\n";
  }
  for (const auto& [path, ignored] : b)
    if (!a.contains(path)) text += "only the other has " + path + "\n";
  return text;
}

std::map<std::string, FileIdentity> identities(const MadeFolder& folder, const std::string& name) {
  std::map<std::string, FileIdentity> files;
  const fs::path root = folder.path(name);
  for (const auto& entry : fs::recursive_directory_iterator(root)) {
    struct stat facts {};
    if (::stat(entry.path().c_str(), &facts) == 0 && S_ISREG(facts.st_mode))
      files[fs::relative(entry.path(), root).string()] = {
          facts.st_ino, static_cast<std::uint64_t>(facts.st_size),
          facts.st_mtim.tv_sec * 1'000'000'000 + facts.st_mtim.tv_nsec};
  }
  return files;
}

std::string line_text(const std::string& coordinates) {
  return R"({"type":"FeatureCollection","features":[{"type":"Feature","properties":{},)"
         R"("geometry":{"type":"LineString","coordinates":[)" +
         coordinates + "]}}]}";
}

} // namespace orograph
