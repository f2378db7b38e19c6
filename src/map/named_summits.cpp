// SPDX-License-Identifier: GPL-3.0-or-later
#include "map/named_summits.hpp"

#include "dem/height_at.hpp"
#include "geometry/error.hpp"
#include "geometry/on_all_cores.hpp"
#include "map/look_around.hpp"
#include "map/parallel_sight.hpp"
#include "placing/highest_vertex.hpp"
#include "placing/observer.hpp"
#include "profiles/seen_ground.hpp"
#include "profiles/slab_lines.hpp"
#include "solids/solids_in_view.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <tuple>
#include <utility>
#include <variant>

#include "naming/dominance.hpp"
#include "naming/prominence.hpp"

namespace orograph {
namespace {

constexpr double kSummitWithin_m = 150, kSummitWithinCells = 2;
constexpr double kSeenBelow_mm = 0.2; // under the horizon
constexpr double kHazesOfRange = 3;   // a twentieth of what one nearby counts

// On its way through the stages.
struct Found {
  std::size_t place; ///< number
  HighestVertex summit;
  ProfilePoint at;
  Vec2 page_mm;
  double distance_m;
  std::optional<Bearing> bearing = std::nullopt;
  double hidden_mm = 0;
  std::optional<Prominence> prominence = std::nullopt;
};

std::optional<Vec2> on_page(const PlacedView& placed, ProfilePoint at) {
  const Vec3 page = placed.on_page(at);
  if (!(page.z > 0)) return std::nullopt;
  const Vec2 mm{page.x / page.z, page.y / page.z};
  const Box2& frame = placed.frame_mm;
  if (!(mm.x >= frame.low.x && mm.x <= frame.high.x && mm.y >= frame.low.y && mm.y <= frame.high.y))
    return std::nullopt;
  return mm;
}

std::vector<Found> within_picture(const TerrainData& terrain, const PlacedView& placed,
                                  const MapSpec& spec, const std::vector<PlaceName>& places) {
  std::vector<Vec2> at;
  for (const PlaceName& place : places) at.push_back(place.map);
  const double cell_m = placed.file ? cell_size_m(terrain.surface) : placed.cell_m;
  const double within_m = std::max(kSummitWithin_m, kSummitWithinCells * cell_m);
  const auto highest = highest_vertices(terrain, at, within_m);
  const bool has_range = spec.view.has_eye();
  const double range_m = spec.labels.range_m.value_or(kHazesOfRange * spec.labels.haze_m);
  std::vector<Found> out;
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (!highest[i]) continue;
    const std::uint32_t vertex = highest[i]->vertex;
    const ProfilePoint where = line_of(terrain.surface, placed.view, {vertex, vertex}).from;
    const double distance_m = std::hypot(where.u, where.v);
    // One that the eye stands on is under its feet.
    if (has_range && (distance_m > range_m || distance_m <= within_m)) continue;
    if (const auto mm = on_page(placed, where))
      out.push_back({i, *highest[i], where, *mm, distance_m});
  }
  return out;
}

double under_mm(const PlacedView& placed, ProfilePoint at, double by_m) {
  const Vec3 here = placed.on_page(at), there = placed.on_page({at.u, at.v, at.z + by_m});
  if (!(there.z > 0)) return std::numeric_limits<double>::infinity();
  return length(Vec2{there.x / there.z - here.x / here.z, there.y / there.z - here.y / here.z});
}

// By how much a vertex would have to be higher at least to be seen from an eye: what the surface at
// some places of the way hides of it. Most summits of a tile are hidden by far, and this takes a
// twentieth of the time of a look at each edge in front of them.
double hidden_at_least_m(const Grid& grid, const View& view, ProfilePoint at) {
  constexpr int kPlaces = 32; // twice as many take longer than they save
  double hidden_m = 0;
  Vec3 nearby_m = to_ground_m(view, at);
  for (int i = kPlaces - 1; i > 0; --i) {
    const double share = static_cast<double>(i) / kPlaces;
    const Vec3 there = to_ground_m(view, {share * at.u, share * at.v, 0});
    const auto z_m = height_at(grid, {there.x, there.y}, nearby_m);
    if (!z_m) continue;
    nearby_m = {there.x, there.y, *z_m};
    const double rise_m = to_profile_frame(view, {there.x, there.y, *z_m}).z - view.eye_z_m;
    hidden_m = std::max(hidden_m, rise_m / share - (at.z - view.eye_z_m));
  }
  return hidden_m;
}

void look_around(const TerrainData& terrain, const PlacedView& placed, std::vector<Found>& found) {
  constexpr std::size_t kManyPlaces = 100; // take longer than bounds of blocks save
  const Grid* const grid = std::get_if<Grid>(&terrain.surface);
  Observer observer = observer_of(placed, terrain.map);
  std::vector<BorderEdge> of_file;
  if (placed.file) { // whose ground may be higher than what is drawn at the eye's feet
    of_file = border_of(terrain.surface);
    if (const auto ground = height_at(terrain.surface, observer.view.depth_origin_m))
      observer.view.eye_z_m = std::max(observer.view.eye_z_m, *ground * observer.view.exaggeration);
  }
  const std::vector<BorderEdge>& border = placed.file ? of_file : placed.border;
  std::optional<BlockBounds> bounds;
  if (grid && found.size() >= kManyPlaces && !placed.file && placed.extent.turned_over == 0)
    bounds = block_bounds(*grid);
  const LookAround around = bounds ? LookAround(terrain, border, observer, *bounds)
                                   : LookAround(terrain, border, observer);
  if (grid)
    on_all_cores(found.size(), [&](std::size_t i) {
      Found& one = found[i];
      one.hidden_mm = under_mm(placed, one.at, hidden_at_least_m(*grid, placed.view, one.at));
    });
  std::vector<std::size_t> asked;
  std::vector<Vec2> places;
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (found[i].hidden_mm > kSeenBelow_mm) {
      found[i].bearing = around.bearing_of(found[i].summit.map, found[i].at);
      continue;
    }
    asked.push_back(i);
    places.push_back(found[i].summit.map);
  }
  const std::vector<PlaceSight> sights = around.sights(places, 0);
  for (std::size_t k = 0; k < asked.size(); ++k) {
    Found& one = found[asked[k]];
    one.bearing = sights[k].bearing;
    one.hidden_mm =
        sights[k].state == PlaceState::hidden ? under_mm(placed, one.at, sights[k].hidden_m) : 0;
  }
}

void look_at(const TerrainData& terrain, const PlacedView& placed, std::vector<Found>& found) {
  if (placed.view.is_perspective()) return look_around(terrain, placed, found);
  const ParallelSight sight(terrain, placed);
  on_all_cores(found.size(), [&](std::size_t i) {
    const double y = sight.hidden_y(found[i].at);
    // Straight down heights move nothing.
    if (y > 0 && placed.view.y_per_z > 0)
      found[i].hidden_mm = under_mm(placed, found[i].at, y / placed.view.y_per_z);
  });
}

// What stands on a summit, or beside it, is a part of it.
bool stands_on(const SolidInView& solid, Vec3 summit, double cell_m) {
  Box2 plan;
  for (const Vec3& vertex : solid.vertices) plan.include({vertex.x, vertex.y});
  return summit.x >= plan.low.x - cell_m && summit.x <= plan.high.x + cell_m &&
         summit.y >= plan.low.y - cell_m && summit.y <= plan.high.y + cell_m;
}

// The same of solids, in the sector that looks towards a summit: how much of an upright line over
// it they hide from its foot on.
void look_past_solids(const TerrainData& terrain, const PlacedView& placed,
                      std::vector<Found>& found) {
  if (placed.solids.empty()) return;
  std::vector<SolidsInView> in_sectors;
  for (const Sector& sector : placed.sectors) in_sectors.emplace_back(placed.solids, sector.view);
  std::vector<Share> hidden;
  for (Found& one : found) {
    const SolidsInView* solids = nullptr;
    ProfilePoint at{0, -std::numeric_limits<double>::infinity(), 0};
    for (const SolidsInView& of_sector : in_sectors) {
      const std::uint32_t vertex = one.summit.vertex;
      const ProfilePoint there = line_of(terrain.surface, of_sector.view(), {vertex, vertex}).from;
      if (there.v > at.v) std::tie(solids, at) = std::pair(&of_sector, there);
    }
    constexpr double kLine_mm = 100;
    const double line_m = kLine_mm / placed.mm_per_step(one.at, {0, 0, 1});
    if (!solids || !std::isfinite(line_m)) continue; // straight down
    const Vec3 foot = as_vec(at), top{foot.x, foot.y, foot.z + line_m};
    const LineInView line = line_in_view(solids->view(), foot, top);
    hidden.clear();
    solids->for_each_before(line.box, [&](std::size_t number) {
      const SolidInView& solid = solids->solids()[number];
      if (stands_on(solid, foot, placed.cell_m)) return;
      for (const TriangleShadow& by : solid.shadows)
        if (SolidsInView::overlap(by.box, line.box))
          if (const auto share = hidden_share(by.shadow, foot, top)) hidden.push_back(*share);
    });
    unite(hidden, solids->sliver_m() / line_m);
    if (!hidden.empty() && hidden[0].begin * line_m <= solids->sliver_m())
      one.hidden_mm = std::max(one.hidden_mm, hidden[0].end * kLine_mm);
  }
}

// Across the way to the eye, in the ground frame.
Vec2 across(const View& view, ProfilePoint at) {
  Vec2 way = view.is_perspective() ? at.u * view.right + at.v * view.forward : view.forward;
  const double size = length(way);
  way = size > 0 ? 1 / size * way : view.forward;
  return {way.y, 0 - way.x};
}

// By shape, unless a field of the file says it.
std::vector<double> statures(const TerrainData& terrain, const PlacedView& placed,
                             const LabelSpec& labels, const std::vector<PlaceName>& places,
                             std::span<Found> seen) {
  std::vector<double> out(seen.size());
  if (!labels.weight_field.empty()) {
    for (std::size_t i = 0; i < seen.size(); ++i) out[i] = places[seen[i].place].weight.value_or(0);
    return out;
  }
  std::vector<std::uint32_t> asked;
  for (const Found& one : seen)
    if (!places[one.place].prominence_m) asked.push_back(one.summit.vertex);
  const std::vector<Prominence> answers = prominences(terrain.surface, asked);
  auto answer = answers.begin();
  for (Found& one : seen) {
    const auto& told = places[one.place].prominence_m;
    one.prominence = told ? Prominence{*told, false} : *answer++;
  }
  const Grid* const grid = std::get_if<Grid>(&terrain.surface);
  std::optional<TinIndex> index;
  if (!grid && !seen.empty()) index.emplace(std::get<Tin>(terrain.surface));
  on_all_cores(seen.size(), [&](std::size_t i) {
    const Found& one = seen[i];
    const Vec2 aside = across(placed.view, one.at);
    const double dominance =
        grid ? dominance_m(*grid, one.summit.vertex, aside)
             : dominance_m(std::get<Tin>(terrain.surface), *index, one.summit.vertex, aside);
    out[i] = stature(dominance, one.prominence->m);
  });
  return out;
}

SummitOnPage as_told(const Found& found, const PlaceName& place, const TerrainData& terrain,
                     LabelElevation elevation) {
  SummitOnPage out;
  out.page_mm = found.page_mm;
  NameFacts& facts = out.facts;
  facts.text =
      text_with_height(place.text, place.height_m.value_or(found.summit.height_m), elevation);
  facts.state = found.hidden_mm > kSeenBelow_mm ? NameState::hidden : NameState::crowded_out;
  facts.map = found.summit.map;
  facts.height = found.summit.height_m / terrain.map.height_unit_m;
  facts.bearing = found.bearing;
  facts.hidden_mm = found.hidden_mm;
  if (found.prominence) {
    facts.prominence_m = found.prominence->m;
    facts.prominence_is_at_least = found.prominence->is_at_least;
  }
  return out;
}

} // namespace

SummitsOnPage named_summits(const TerrainData& terrain, const PlacedView& placed,
                            const MapSpec& spec, const std::vector<PlaceName>& places) {
  if (terrain.map.earth && std::holds_alternative<Tin>(terrain.surface))
    throw Error("names can't be put on a terrain in degrees that the view's planes cut",
                "a view without a front or back plane");
  std::vector<Found> found = within_picture(terrain, placed, spec, places);
  look_at(terrain, placed, found);
  look_past_solids(terrain, placed, found);
  std::ranges::sort(found, [&](const Found& a, const Found& b) {
    const bool a_hidden = a.hidden_mm > kSeenBelow_mm, b_hidden = b.hidden_mm > kSeenBelow_mm;
    return std::tuple(a_hidden, b.summit.height_m, a.place) <
           std::tuple(b_hidden, a.summit.height_m, b.place);
  });
  const auto first_hidden =
      std::ranges::find_if(found, [](const Found& one) { return one.hidden_mm > kSeenBelow_mm; });
  const std::span<Found> seen(found.begin(), first_hidden);
  const std::vector<double> stature = statures(terrain, placed, spec.labels, places, seen);
  std::vector<NamedSummit> summits;
  for (std::size_t i = 0; i < seen.size(); ++i) {
    NamedSummit& summit = summits.emplace_back();
    summit.text = places[seen[i].place].text;
    summit.height_m = seen[i].summit.height_m;
    summit.east = places[seen[i].place].map.x;
    summit.north = places[seen[i].place].map.y;
    summit.stature = stature[i];
    if (spec.view.has_eye()) summit.distance_m = seen[i].distance_m;
  }
  const RankedNames ranks = ranked(summits, spec.labels.haze_m);
  SummitsOnPage out;
  out.elsewhere = places.size() - found.size();
  const auto told = [&](const Found& one) {
    return as_told(one, places[one.place], terrain, spec.labels.elevation);
  };
  for (const std::size_t i : ranks.order) {
    out.summits.push_back(told(seen[i]));
    out.summits.back().weight = ranks.weights[i];
  }
  for (auto one = first_hidden; one != found.end(); ++one) out.summits.push_back(told(*one));
  return out;
}

} // namespace orograph
