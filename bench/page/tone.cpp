// SPDX-License-Identifier: GPL-3.0-or-later
// How dark a page is where, beside what a light asks for: drawn as SVG, brought to 600 dpi by
// rsvg-convert, and averaged over windows of 6 mm that show ground all over. For each view: the
// correlation of ranks between asked and measured darkness, their mean distance, and the greatest
// departure of a window from the mean of all, over that mean: on ground of one slope, how uniform
// the tone is; there ranks say nothing, and are nan. All ink counts; `--layers profiles` among a
// view's options leaves other lines out.
//
//   tone [--csv FILE] AZIMUTH ALTITUDE D0 D1 [MAP.svg] <VIEWS
//
// The light's direction in degrees; darkness asked from D0 (faces it) to D1 (turned away). VIEWS as
// for `evenness`. MAP.svg, a map of the only view, is measured in place of one drawn here.
#include "bench/csv_file.hpp"
#include "bench/page/page_tone.hpp"
#include "bench/page/view_list.hpp"
#include "geometry/error.hpp"
#include "write/write_drawing.hpp"

#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <iterator>
#include <limits>
#include <optional>
#include <string>
#include <vector>

using namespace orograph;

namespace {

constexpr double kDpi = 600, kMmOfInch = 25.4, kSameTone = 1e-3;
constexpr const char* kColumns =
    "view,windows,asked_mean,darkness_mean,rank_correlation,mean_absolute_error,greatest_departure";

// A folder of this run, gone with it.
struct Scratch {
  std::filesystem::path folder = std::filesystem::temp_directory_path() /
                                 fmt::format("orograph-tone-{}", static_cast<long>(getpid()));
  Scratch() { std::filesystem::create_directories(folder); }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;
  ~Scratch() {
    std::error_code ignored;
    std::filesystem::remove_all(folder, ignored);
  }
};

void run(std::vector<std::string> words) {
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  pid_t child = 0;
  int status = 0;
  if (posix_spawnp(&child, arguments[0], nullptr, nullptr, arguments.data(), environ) != 0 ||
      waitpid(child, &status, 0) != child || status != 0)
    throw Error(words.front() + " can't be run or fails", "scripts/install-dependencies bench");
}

PagePixels pixels_of(const std::string& svg, const Scratch& scratch) {
  const std::string png = scratch.folder / "page.png", dpi = fmt::format("{}", kDpi);
  run({"rsvg-convert", "--unlimited", "--dpi-x", dpi, "--dpi-y", dpi, "--background-color", "white",
       "--output", png, svg});
  return read_page_pixels(png, kDpi / kMmOfInch);
}

void measure(const ListedView& listed, const AskedTone& asked, std::string svg,
             const Scratch& scratch, CsvFile& csv) {
  const ViewOnPage view(listed);
  if (svg.empty()) {
    svg = scratch.folder / "map.svg";
    WriteOptions writing;
    writing.overwrite = true;
    write_drawing(view.drawing(), svg, writing);
  }
  const PagePixels pixels = pixels_of(svg, scratch);
  const PageGround ground(view.grid(), view.placed());
  std::vector<double> wanted, measured;
  double sum_asked = 0, sum_measured = 0, sum_off = 0;
  for (const ToneWindow& window : tone_windows(ground, view.placed().frame_mm, asked)) {
    wanted.push_back(window.asked);
    measured.push_back(pixels.mean_darkness(window.mm));
    sum_asked += wanted.back();
    sum_measured += measured.back();
    sum_off += std::abs(measured.back() - wanted.back());
  }
  if (wanted.empty())
    throw Error(listed.name + " has no window that shows ground all over", "draw it larger");
  const auto count = static_cast<double>(wanted.size());
  // Ground of one slope asks for one darkness, whose ranks are those of roundings.
  const auto [least, most] = std::ranges::minmax(wanted);
  const double correlation = most - least > kSameTone ? rank_correlation(wanted, measured)
                                                      : std::numeric_limits<double>::quiet_NaN();
  const double departure = greatest_departure(measured);
  fmt::print("{:24} {:7} {:7.3f} {:9.3f} {:>16.3f} {:20.3f} {:17.1f} %\n", listed.name,
             wanted.size(), sum_asked / count, sum_measured / count, correlation, sum_off / count,
             100 * departure);
  csv.add(fmt::format("{},{},{:.4f},{:.4f},{:.4f},{:.4f},{:.4f}", listed.name, wanted.size(),
                      sum_asked / count, sum_measured / count, correlation, sum_off / count,
                      departure));
}

std::optional<AskedTone> asked_by(char** words) {
  std::array<double, 4> numbers{};
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const std::string_view word = words[i];
    const auto [end, error] = std::from_chars(word.begin(), word.end(), numbers[i]);
    if (error != std::errc{} || end != word.end()) return std::nullopt;
  }
  const auto& [azimuth, altitude, light_side, shadow_side] = numbers;
  return AskedTone{Angle::degrees(azimuth), Angle::degrees(altitude), light_side, shadow_side};
}

} // namespace

int main(int argc, char** argv) {
  CsvFile csv(csv_asked(argc, argv), kColumns);
  const auto asked = argc == 5 || argc == 6 ? asked_by(argv + 1) : std::nullopt;
  if (!asked) {
    std::fputs("usage: tone [--csv FILE] AZIMUTH ALTITUDE D0 D1 [MAP.svg] <VIEWS\n"
               "(degrees; darkness, 0 to 1; a line for each view: NAME DEM OPTIONS)\n",
               stderr);
    return 2;
  }
  try {
    const auto views = view_list({std::istreambuf_iterator<char>(std::cin), {}});
    const std::string map = argc == 6 ? argv[5] : "";
    if (!map.empty() && views.size() != 1)
      throw Error("a map is given for several views", "give its own alone");
    fmt::print("{:24} {:7} {:>7} {:>9} {:>16} {:>20} {:>19}\n", "view", "windows", "asked",
               "darkness", "rank correlation", "mean absolute error", "greatest departure");
    const Scratch scratch;
    for (const ListedView& view : views) measure(view, *asked, map, scratch, csv);
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "tone: error: %s\n", error.what());
    return 1;
  }
}
