// SPDX-License-Identifier: GPL-3.0-or-later
// Hard cases of the clip as text files, *.clip.txt: each goes through `clip`, `clip_recursive` and,
// where no tolerance is given, the exact clip. A file holds, a line each:
//   # the caption, which says what must come out
//   tolerance Y
//   list drawn|occluder|compared      begins a list; then its segments, left to right:
//   X0 Y0 X1 Y1
//   zigzag COUNT WIDTH HEIGHT         segments: teeth side by side from X = 0
//   visible none|all|X0 X1 [X0 X1 …]  of the list: what is drawn
//   repeat COUNT RISE DRAWN           the list COUNT times more, each higher by RISE; in all DRAWN
//                                     pieces of them are visible
#include "horizon/clip.hpp"
#include "tests/catch.hpp"
#include "tests/reference/compare_clips.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <optional>
#include <sstream>

namespace orograph::clip_cases_test {
namespace {

struct Wanted {
  std::optional<std::vector<double>> ends; ///< of visible pieces, in pairs
  bool all = false;
};

struct Case {
  std::string caption;
  double tolerance = 0;
  FlatScene lists;
  std::vector<Role> roles;
  std::vector<Wanted> wanted; ///< of each list
  struct Run {
    std::size_t first, count, drawn;
  };
  std::vector<Run> runs; ///< of repeated lists
};

Role role_of(const std::string& word) {
  if (word == "drawn") return Role::drawn_occluder;
  if (word == "occluder") return Role::occluder;
  REQUIRE(word == "compared");
  return Role::compared;
}

// strtod, unlike a stream, reads denormals and hexadecimal digits.
std::vector<double> numbers_in(std::istringstream& words) {
  std::vector<double> out;
  for (std::string word; words >> word;) {
    char* end = nullptr;
    out.push_back(std::strtod(word.c_str(), &end));
    INFO(word);
    REQUIRE(*end == '\0');
  }
  return out;
}

void add_segment(Case& scene, double x0, double y0, double x1, double y1) {
  auto& segments = scene.lists.back();
  const std::uint64_t id =
      (static_cast<std::uint64_t>(scene.lists.size() - 1) << 32U) | segments.size();
  segments.push_back({x0, y0, x1, y1, id});
}

void add_list(Case& scene, Role role) {
  scene.lists.emplace_back();
  scene.roles.push_back(role);
  scene.wanted.emplace_back();
}

void repeat(Case& scene, std::size_t count, double rise, std::size_t drawn) {
  const std::vector<Segment> model = scene.lists.back();
  scene.runs.push_back({scene.lists.size(), count, drawn});
  for (std::size_t i = 1; i <= count; ++i) {
    add_list(scene, scene.roles.back());
    const double up = static_cast<double>(i) * rise;
    for (const Segment& s : model) add_segment(scene, s.x0, s.y0 + up, s.x1, s.y1 + up);
  }
}

Case read_case(const std::filesystem::path& path) {
  Case scene;
  std::ifstream file(path);
  for (std::string line; std::getline(file, line);) {
    INFO(path.filename() << ": " << line);
    std::istringstream words(line);
    std::string word;
    if (!(words >> word)) continue;
    if (word == "#") {
      scene.caption += line.substr(2) + " ";
    } else if (word == "tolerance") {
      scene.tolerance = numbers_in(words).at(0);
    } else if (word == "list") {
      words >> word;
      add_list(scene, role_of(word));
    } else if (word == "zigzag") {
      const auto n = numbers_in(words);
      for (int i = 0; i < n.at(0); ++i) {
        const double x = i * n.at(1);
        add_segment(scene, x, 0, x + n[1] / 2, n.at(2));
        add_segment(scene, x + n[1] / 2, n[2], x + n[1], 0);
      }
    } else if (word == "visible") {
      Wanted& wanted = scene.wanted.back();
      wanted.ends.emplace();
      std::string rest = line.substr(line.find("visible") + 7);
      std::istringstream ends(rest);
      wanted.all = rest.find("all") != std::string::npos;
      if (!wanted.all && rest.find("none") == std::string::npos) wanted.ends = numbers_in(ends);
    } else if (word == "repeat") {
      const auto n = numbers_in(words);
      repeat(scene, static_cast<std::size_t>(n.at(0)), n.at(1), static_cast<std::size_t>(n.at(2)));
    } else {
      std::istringstream segment(line);
      const auto n = numbers_in(segment);
      REQUIRE(n.size() == 4);
      REQUIRE(n[0] < n[2]);
      add_segment(scene, n[0], n[1], n[2], n[3]);
    }
  }
  REQUIRE(!scene.caption.empty());
  REQUIRE(!scene.lists.empty());
  return scene;
}

// Visible pieces of a list, those that meet joined, as pairs of ends.
std::vector<double> ends_of(const std::vector<Piece>& visible) {
  std::vector<double> ends;
  for (const Piece& piece : visible) {
    if (!ends.empty() && ends.back() == piece.x_begin)
      ends.back() = piece.x_end;
    else
      ends.insert(ends.end(), {piece.x_begin, piece.x_end});
  }
  return ends;
}

void check_list(const std::vector<Segment>& segments, const Wanted& wanted,
                const std::vector<Piece>& visible) {
  if (!wanted.ends) return;
  if (wanted.all) {
    REQUIRE(visible.size() == segments.size());
    for (std::size_t i = 0; i < visible.size(); ++i) {
      CHECK(visible[i].t_begin == 0);
      CHECK(visible[i].t_end == 1);
    }
    return;
  }
  const auto ends = ends_of(visible);
  REQUIRE(ends.size() == wanted.ends->size());
  // A picture of 200 mm holds the list: 1e-9 mm on it, or a few roundings of the coordinates.
  double greatest = 0;
  for (const Segment& s : segments) greatest = std::max({greatest, std::abs(s.x0), std::abs(s.x1)});
  const double near = std::max(5e-12 * (segments.back().x1 - segments.front().x0),
                               4 * std::numeric_limits<double>::epsilon() * greatest);
  for (std::size_t i = 0; i < ends.size(); ++i) {
    CAPTURE(i, ends[i], (*wanted.ends)[i]);
    CHECK(std::abs(ends[i] - (*wanted.ends)[i]) <= near);
  }
}

void check_case(const Case& scene) {
  Horizon horizon = initial_horizon(), by_recursion = initial_horizon();
  ClipWorkspace workspace;
  std::vector<std::size_t> drawn;
  for (std::size_t i = 0; i < scene.lists.size(); ++i) {
    CAPTURE(i);
    ClipOptions options;
    options.role = scene.roles[i];
    options.tolerance = {scene.tolerance, Homography{}, scene.tolerance};
    clip(scene.lists[i], horizon, options, workspace);
    drawn.push_back(workspace.visible.size());
    check_list(scene.lists[i], scene.wanted[i], workspace.visible);
    const ClipResult result = clip_recursive(scene.lists[i], by_recursion, options);
    REQUIRE(result.visible == workspace.visible);
    by_recursion = result.horizon;
  }
  for (const auto& [first, count, wanted] : scene.runs) {
    std::size_t sum = 0;
    for (std::size_t i = first; i < first + count; ++i) sum += drawn[i];
    CHECK(sum == wanted);
  }
  if (scene.tolerance > 0) return;
  const ClipDifferences differences = compare_clips(scene.lists, scene.roles);
  INFO(differences.first_wrong);
  CHECK(differences.wrong == 0);
}

} // namespace

TEST_CASE("hard cases of the clip come out as they say") {
  int count = 0;
  for (const auto& entry :
       std::filesystem::directory_iterator(OROGRAPH_SOURCE_DIR "/tests/cases")) {
    if (!entry.path().string().ends_with(".clip.txt")) continue;
    const Case scene = read_case(entry.path());
    INFO(entry.path().filename() << ": " << scene.caption);
    check_case(scene);
    ++count;
  }
  CHECK(count >= 15);
}

} // namespace orograph::clip_cases_test
