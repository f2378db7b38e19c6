// SPDX-License-Identifier: GPL-3.0-or-later
#include "write/same_file.hpp"

#include "text/words.hpp"

#include <algorithm>
#include <system_error>
#include <utility>
#include <vector>

namespace orograph {
namespace {

namespace fs = std::filesystem;

/// The file names that a GDAL dataset name may hold, besides itself.
std::vector<std::string> file_names_in(const std::string& input) {
  std::vector<std::string> names{input};
  std::string unquoted = input;
  std::replace(unquoted.begin(), unquoted.end(), '"', ':');
  for (auto& part : split(unquoted, ':')) names.push_back(std::move(part));
  for (std::size_t i = 0; i < names.size(); ++i) // grows: /vsigzip//vsitar/a.tar/…
    if (names[i].starts_with("/vsi"))
      if (const auto slash = names[i].find('/', 1); slash != std::string::npos) {
        std::string rest = names[i].substr(slash + 1);
        names.push_back("/" + rest);
        names.push_back(std::move(rest));
      }
  return names;
}

} // namespace

bool same_file(const fs::path& a, const fs::path& b) {
  std::error_code error;
  if (fs::equivalent(a, b, error) && !error) return true;
  const fs::path whole_a = fs::weakly_canonical(fs::absolute(a, error), error);
  if (error) return false;
  const fs::path whole_b = fs::weakly_canonical(fs::absolute(b, error), error);
  return !error && whole_a == whole_b;
}

bool replaces_input(const std::string& input, const std::string& output) {
  for (const auto& name : file_names_in(input))
    // Every folder on the way: one of them may be an archive, and OUTPUT is never a folder.
    for (fs::path part = name; !part.empty(); part = part.parent_path()) {
      std::error_code error;
      if (!fs::is_directory(part, error) && same_file(part, output)) return true;
      if (part == part.root_path() || part == part.parent_path()) break;
    }
  return false;
}

} // namespace orograph
