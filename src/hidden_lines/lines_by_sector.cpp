// SPDX-License-Identifier: GPL-3.0-or-later
#include "hidden_lines/lines_by_sector.hpp"

#include "geometry/on_all_cores.hpp"
#include "geometry/panorama_page.hpp"
#include "hidden_lines/line_pictures.hpp"
#include "placing/sector.hpp"
#include "profiles/slab_lines.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace orograph {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;

// Sectors overlap by a millionth of their width, 1e-7 radians.
constexpr double kBeside = 1e-6;

// From the page's middle, in radians.
struct Azimuths {
  double begin, end;
};

// All round where the eye is on the line, or nearly.
Azimuths azimuths_of(const ProfileLine& line, double rounding_m, double near_m) {
  const auto& [from, to] = line;
  const Vec2 a{from.u, from.v}, along{to.u - from.u, to.v - from.v};
  const double squared = dot(along, along);
  const double share = squared > 0 ? std::clamp(-dot(a, along) / squared, 0.0, 1.0) : 0;
  if (!(length(a + share * along) > 1e3 * rounding_m)) return {-kTurn, kTurn};
  const double begin = PanoramaPage::azimuth(from),
               by = std::remainder(PanoramaPage::azimuth(to) - begin, kTurn);
  const double beside = kBeside + 16 * rounding_m / near_m;
  return {std::min(begin, begin + by) - beside, std::max(begin, begin + by) + beside};
}

std::vector<Azimuths> azimuths_of(const std::vector<Sector>& sectors) {
  std::vector<Azimuths> out;
  for (const Sector& sector : sectors) {
    const XRange shown = page_range(sector);
    out.push_back({sector.azimuth + std::atan(shown.begin), sector.azimuth + std::atan(shown.end)});
  }
  return out;
}

} // namespace

std::vector<std::vector<std::uint32_t>> lines_by_sector(const Surface& surface,
                                                        std::span<const ProfilePoint> points,
                                                        const PlacedView& placed,
                                                        const std::vector<EdgeLine>& lines) {
  using BySector = std::vector<std::vector<std::uint32_t>>;
  const EdgeEnds ends(surface, placed.view, {points, {}});
  const double rounding_m = position_rounding_m(placed.reach_m, placed.view);
  const std::vector<Azimuths> sectors = azimuths_of(placed.sectors); // rising
  const auto add = [&](std::uint32_t i, BySector& found) {
    const auto [begin, end] = azimuths_of(ends(lines[i].edge), rounding_m, placed.view.near_m);
    for (const double turned : {-kTurn, 0.0, kTurn}) {
      auto sector = std::ranges::partition_point(
          sectors, [&](const Azimuths& of) { return of.end < begin + turned; });
      for (; sector != sectors.end() && sector->begin <= end + turned; ++sector) {
        auto& numbers = found[static_cast<std::size_t>(sector - sectors.begin())];
        if (numbers.empty() || numbers.back() != i) numbers.push_back(i);
      }
    }
  };
  constexpr std::size_t kLinesOfTask = 1U << 14U;
  std::vector<BySector> of_tasks((lines.size() + kLinesOfTask - 1) / kLinesOfTask);
  on_all_cores(of_tasks.size(), [&](std::size_t task) {
    of_tasks[task].resize(sectors.size());
    const std::size_t end = std::min(lines.size(), (task + 1) * kLinesOfTask);
    for (std::size_t i = task * kLinesOfTask; i < end; ++i)
      add(static_cast<std::uint32_t>(i), of_tasks[task]);
  });
  BySector out(sectors.size());
  for (std::size_t k = 0; k < sectors.size(); ++k)
    for (const BySector& found : of_tasks)
      out[k].insert(out[k].end(), found[k].begin(), found[k].end());
  return out;
}

} // namespace orograph
