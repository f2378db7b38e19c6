// SPDX-License-Identifier: GPL-3.0-or-later
// How evenly profiles lie on the page: at random points of visible ground that isn't level, the gap
// between the two neighbouring profiles, across the lines' direction, over the spacing asked for.
// Points with a silhouette, the border or another surface before one of the two are counted apart.
//
//   evenness [--csv FILE] [POINTS [SEED]] <VIEWS     1000 points a view and seed 1 unless told
//                                                    otherwise
//
// VIEWS has a line for each view: a name, the DEM, options of `orograph render`.
#include "bench/csv_file.hpp"
#include "bench/page/gaps.hpp"
#include "bench/page/view_list.hpp"
#include "geometry/error.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <iterator>
#include <numeric>

using namespace orograph;

namespace {

constexpr const char* kColumns =
    "view,spacing_mm,points,silhouette,border,jump,even_share,q05,q25,q50,q75,q95";

double spacing_mm(const ListedView& view) {
  const Style& style = view.settings.map.style;
  if (!style.plan) return 4 * style.pen_width_mm;
  if (const auto* spacing = std::get_if<PageSpacing>(&*style.plan)) return spacing->mm;
  throw Error(view.name + " asks for no spacing on the page", "give one in mm, or none");
}

void tell(const std::string& name, const std::string& spacing, const Evenness& found,
          CsvFile& csv) {
  const auto& [profiles, silhouette, border, jump] = found.points;
  const auto& [q05, q25, q50, q75, q95] = found.quantiles;
  fmt::print("{:24} {:5} {:5.1f} % of {:5}   {:5.2f} {:5.2f} {:5.2f} {:5.2f} {:5.2f}   "
             "apart {:4} {:4} {:4}\n",
             name, spacing, 100 * found.even_share, profiles, q05, q25, q50, q75, q95, silhouette,
             border, jump);
  csv.add(fmt::format("{},{},{},{},{},{},{:.4f},{:.3f},{:.3f},{:.3f},{:.3f},{:.3f}", name, spacing,
                      profiles, silhouette, border, jump, found.even_share, q05, q25, q50, q75,
                      q95));
}

void measure(std::size_t points, std::uint64_t seed, CsvFile& csv) {
  const auto views = view_list({std::istreambuf_iterator<char>(std::cin), {}});
  fmt::print("{:24} {:5} gaps within {}-{}   quantiles 5 25 50 75 95 %           silhouette border "
             "jump\n",
             "view", "mm", kEvenGap.low, kEvenGap.high);
  std::vector<Gap> all;
  for (const ListedView& listed : views) {
    const double asked_mm = spacing_mm(listed);
    const ViewOnPage view(listed);
    const PageGround ground(view.grid(), view.placed());
    const std::vector<Gap> gaps =
        gaps_of(ground, GapLines(view.drawing()), view.placed().frame_mm, asked_mm, points, seed);
    tell(listed.name, fmt::format("{}", asked_mm), evenness_of(gaps), csv);
    all.insert(all.end(), gaps.begin(), gaps.end());
  }
  tell("all", "", evenness_of(all), csv);
}

} // namespace

int main(int argc, char** argv) {
  CsvFile csv(csv_asked(argc, argv), kColumns);
  const int points = argc > 1 ? std::atoi(argv[1]) : 1000, seed = argc > 2 ? std::atoi(argv[2]) : 1;
  if (argc > 3 || points < 1 || seed < 0) {
    std::fputs("usage: evenness [--csv FILE] [POINTS [SEED]] <VIEWS\n"
               "(a line for each view: NAME DEM OPTIONS)\n",
               stderr);
    return 2;
  }
  try {
    measure(static_cast<std::size_t>(points), static_cast<std::uint64_t>(seed), csv);
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "evenness: error: %s\n", error.what());
    return 1;
  }
}
