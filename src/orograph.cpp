// SPDX-License-Identifier: GPL-3.0-or-later
#include "orograph.hpp"

#include "dem/read/read_terrain.hpp"
#include "dem/read/terrain_in_memory.hpp"
#include "geometry/on_all_cores.hpp"
#include "map/check_spec.hpp"
#include "map/describe_map.hpp"
#include "map/draw_level.hpp"
#include "map/look_around.hpp"
#include "map/name_places.hpp"
#include "placing/level_of_detail.hpp"
#include "placing/observer.hpp"
#include "placing/placed_view.hpp"
#include "placing/read_overlays.hpp"
#include "solids/read_scene.hpp"

#include <memory>
#include <optional>
#include <utility>

namespace orograph {
namespace {

// Runs `work`. What it is about is there and was in order, so that what can't be done with it is
// the request's fault, whatever the stages say that don't know.
template <class Work>
void as_requested(const Work& work) {
  try {
    work();
  } catch (const Error& error) {
    if (error.code() != ErrorCode::input) throw;
    throw Error(error.wrong(), error.right(), ErrorCode::request);
  }
}

} // namespace

Terrain::Terrain(std::shared_ptr<const TerrainData> data) : data_(std::move(data)) {}

Terrain Terrain::read(const std::vector<std::string>& paths, const ReadOptions& options,
                      const Control& control) {
  if (paths.empty())
    throw Error("no file is named", "name one, or several rasters", ErrorCode::request);
  std::shared_ptr<const TerrainData> data;
  on_cores(control.jobs, control.stop, [&] {
    data = std::make_shared<TerrainData>(read_terrain(paths, options, control.progress));
  });
  return Terrain(std::move(data));
}

Terrain Terrain::of(const GridInput& input) {
  return Terrain(std::make_shared<TerrainData>(terrain_of(input)));
}
Terrain Terrain::of(const TinInput& input) {
  return Terrain(std::make_shared<TerrainData>(terrain_of(input)));
}

const std::string& Terrain::crs_wkt() const {
  return data_->map.crs_wkt;
}
const std::string& Terrain::name() const {
  return data_->source;
}
const std::vector<std::string>& Terrain::notes() const {
  return data_->notes;
}

Solids Solids::read(const std::string& path) {
  Solids solids;
  solids.scene_ = std::make_shared<const SceneFile>(read_scene(path));
  return solids;
}

Overlays Overlays::read(const std::vector<OverlayInput>& inputs, const Terrain& terrain,
                        const Control& control) {
  Overlays out;
  on_cores(control.jobs, control.stop, [&] {
    out.overlays_ =
        std::make_shared<const std::vector<Overlay>>(read_overlays(inputs, *terrain.data_));
  });
  return out;
}
std::vector<std::string> Overlays::notes() const {
  std::vector<std::string> out;
  if (overlays_)
    for (const Overlay& overlay : *overlays_)
      out.insert(out.end(), overlay.notes.begin(), overlay.notes.end());
  return out;
}

struct Session::Kept {
  Kept(std::shared_ptr<const TerrainData> of, Solids on_it, Overlays over_it, Overlays named)
      : terrain(std::move(of)), solids(std::move(on_it)), overlays(std::move(over_it)),
        names(std::move(named)) {}

  TerrainForViews terrain;
  Solids solids;
  Overlays overlays, names;
};

Session::Session(Terrain terrain, Solids solids, Overlays overlays, Overlays names)
    : kept_(std::make_shared<Kept>(std::move(terrain.data_), std::move(solids), std::move(overlays),
                                   std::move(names))) {}

namespace {

// An eye of `view` on this terrain, and all that it looks at.
template <class Ask>
void look_around(TerrainForViews& whole, const ViewSpec& view, const Control& control,
                 const Ask& ask) {
  as_requested([&] {
    check_eye_spec(view);
    on_cores(control.jobs, control.stop, [&] {
      const TerrainOfView terrain(whole, view);
      const std::vector<BorderEdge> border = border_of(terrain->surface);
      ask(LookAround(*terrain, border, observer_of(view, *terrain)));
    });
  });
}

} // namespace

std::vector<PlaceSight> Session::sights(const ViewSpec& view, const std::vector<Vec2>& places,
                                        double above_m, const Control& control) const {
  check_sights(places, above_m);
  std::vector<PlaceSight> out;
  look_around(kept_->terrain, view, control, [&](const LookAround& around) {
    out = around.sights(places, above_m, control.progress);
  });
  return out;
}

Skyline Session::skyline(const ViewSpec& view, double step_deg, const Control& control) const {
  check_skyline_step(step_deg);
  Skyline out;
  look_around(kept_->terrain, view, control,
              [&](const LookAround& around) { out = around.skyline(step_deg, control.progress); });
  return out;
}

Map Session::draw(const MapSpec& asked, const Control& control) const {
  Map map;
  as_requested([&] {
    check_spec(asked, kept_->solids.scene_ != nullptr);
    const auto& names = kept_->names.overlays_;
    const Overlay* const named = names && !names->empty() ? &names->front() : nullptr;
    on_cores(control.jobs, control.stop, [&] {
      const MapSpec spec = with_room_for_names(asked, named);
      TerrainOfView terrain(kept_->terrain, spec.view);
      const SceneFile* const solids = kept_->solids.scene_.get();
      const std::optional<LevelOfDetail> level = choose_level(terrain, spec, solids);
      PlacedView placed = placed_view(terrain, spec, solids);
      if (kept_->overlays.overlays_) placed.overlays = *kept_->overlays.overlays_;
      placed.names = named;
      map = draw_level(terrain, placed, spec, level, control.progress);
      describe_map(map, terrain, placed, spec);
    });
  });
  return map;
}

} // namespace orograph
