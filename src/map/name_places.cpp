// SPDX-License-Identifier: GPL-3.0-or-later
#include "map/name_places.hpp"

#include "dem/height_at.hpp"
#include "draw/break_lines.hpp"
#include "draw/round_drawing.hpp"
#include "map/layer_table.hpp"
#include "map/named_summits.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "naming/ink_map.hpp"
#include "naming/names_above.hpp"
#include "naming/names_beside.hpp"
#include "naming/place_names.hpp"

namespace orograph {
namespace {

constexpr double kLongestClimbing_mm = 45; // what rooms above panoramas are made for
constexpr double kLongestOfPicture = 0.5;  // of level names, in widths of it
constexpr double kOffEnd_mm = 0.6;         // from names to where their room ends, or a neatline
constexpr double kHighest_m = 8888;        // of names whose heights aren't known yet

PageText text_of_size(std::string text, double size_mm) {
  PageText out;
  out.text = std::move(text);
  out.size_mm = size_mm;
  return out;
}

void grow(Sides& room, const Sides& by) {
  room = {room.left + by.left, room.top + by.top, room.right + by.right, room.bottom + by.bottom};
}

RoomForNames room_above(const MapSpec& spec, const Overlay& names, Lettering& lettering) {
  const LabelSpec& labels = spec.labels;
  TextExtent longest = lettering.set(text_of_size("x", labels.size_mm)).extent;
  if (labels.angle == Angle())
    return room_for_names(longest, labels.size_mm, labels.angle, labels.rows);
  for (const PlaceName& place : place_names(names, labels).places) {
    const std::string text =
        text_with_height(place.text, place.height_m.value_or(kHighest_m), labels.elevation);
    const PageText set =
        lettering.set_within(text_of_size(text, labels.size_mm), kLongestClimbing_mm);
    longest.width_mm = std::max(longest.width_mm, set.extent.width_mm);
  }
  return room_for_names(longest, labels.size_mm, labels.angle, labels.rows);
}

bool labels_coordinates(const MapSpec& spec) {
  return spec.labels.coordinates && !is_panorama(spec.view.projection);
}

Box2 inside(const Box2& room) {
  constexpr Vec2 kOff_mm{kOffEnd_mm, kOffEnd_mm};
  return {room.low + kOff_mm, room.high - kOff_mm};
}

// A strip on the page, and the highest of the lines that are drawn of it.
StripRoom strip_room(const Box2& frame_mm, const Sides& room, const Drawing& drawing) {
  StripRoom out;
  out.box_mm = inside({{frame_mm.low.x - room.left, frame_mm.low.y - room.top},
                       {frame_mm.high.x + room.right, frame_mm.high.y + room.bottom}});
  // The least y of each tenth of a millimetre.
  constexpr double kColumn_mm = 0.1;
  const auto column = [low = frame_mm.low.x](double x) {
    return static_cast<std::int64_t>(std::floor((x - low) / kColumn_mm));
  };
  std::vector<double> highest(static_cast<std::size_t>(column(frame_mm.high.x) + 1),
                              std::numeric_limits<double>::infinity());
  const auto last = static_cast<std::int64_t>(highest.size()) - 1;
  for (const Layer& layer : drawing.layers)
    for (const Stroke& stroke : layer.strokes) {
      const auto points = layer.points(stroke);
      if (layer.is_pen_way || points[0].y < frame_mm.low.y - kPageStep_mm ||
          points[0].y > frame_mm.high.y + kPageStep_mm)
        continue;
      for (std::size_t i = 1; i < points.size(); ++i) {
        const auto [left, right] = std::minmax({column(points[i - 1].x), column(points[i].x)});
        const double y = std::min(points[i - 1].y, points[i].y);
        for (auto c = std::max<std::int64_t>(left, 0); c <= std::min(right, last); ++c)
          highest[static_cast<std::size_t>(c)] = std::min(highest[static_cast<std::size_t>(c)], y);
      }
    }
  out.highest_mm = [column, last, highest = std::move(highest)](double from, double to) {
    double y = std::numeric_limits<double>::infinity();
    for (auto c = std::max<std::int64_t>(column(from), 0); c <= std::min(column(to), last); ++c)
      y = std::min(y, highest[static_cast<std::size_t>(c)]);
    return y;
  };
  return out;
}

struct StripsOfPage {
  std::vector<PanoramaStrip> strips; ///< one at least
  std::vector<StripRoom> rooms;

  std::size_t of(double x_mm) const {
    std::size_t strip = 0;
    while (strip + 1 < strips.size() && x_mm > strips[strip].end_mm) ++strip;
    return strip;
  }
};

StripsOfPage strips_of(const PlacedView& placed, const MapSpec& spec, const Drawing& drawing) {
  StripsOfPage out;
  out.strips = placed.panorama->strips;
  if (out.strips.empty()) out.strips.push_back({placed.frame_mm.high.x, {0, 0}});
  double begin_mm = placed.frame_mm.low.x;
  for (const PanoramaStrip& strip : out.strips) {
    const Box2& frame = placed.frame_mm;
    out.rooms.push_back(strip_room({Vec2{begin_mm, frame.low.y} + strip.shift_mm,
                                    Vec2{strip.end_mm, frame.high.y} + strip.shift_mm},
                                   spec.page.strip_room_mm, drawing));
    begin_mm = strip.end_mm;
  }
  return out;
}

// Puts names on the page; those that have no place are none of them.
std::vector<PlacedName> placed_names(const PlacedView& placed, const MapSpec& spec,
                                     const Drawing& drawing, std::vector<NameToPlace>& names,
                                     TakenRoom& taken) {
  const LabelSpec& labels = spec.labels;
  std::optional<std::size_t> most;
  if (labels.most) most = static_cast<std::size_t>(*labels.most);
  if (!placed.panorama)
    return names_beside(names, inside(placed.frame_mm), InkMap(drawing.page, drawing.layers), most,
                        taken);
  const StripsOfPage strips = strips_of(placed, spec, drawing);
  for (NameToPlace& name : names) {
    name.strip = strips.of(name.summit_mm.x);
    name.summit_mm = name.summit_mm + strips.strips[name.strip].shift_mm;
  }
  return labels.angle == Angle() ? names_in_rows(names, strips.rooms, labels.rows, most)
                                 : names_slanted(names, strips.rooms, labels.angle, most);
}

// Longer ones are cut off.
double longest_name_mm(const PlacedView& placed, const LabelSpec& labels) {
  if (placed.panorama && labels.angle != Angle()) return kLongestClimbing_mm;
  const double picture_mm =
      placed.panorama ? placed.panorama->strip_boxes_mm().front().width() : placed.frame_mm.width();
  return std::max(kLongestClimbing_mm, kLongestOfPicture * picture_mm);
}

// A small triangle.
void add_mark(Vec2 summit_mm, Layer& layer) {
  constexpr double kHigh_mm = 0.7, kLow_mm = 0.4, kAside_mm = 0.64; // less than kSummitMark_mm
  Stroke stroke;
  stroke.first_point = static_cast<std::uint32_t>(layer.page_mm.size());
  stroke.point_count = 4;
  layer.strokes.push_back(stroke);
  for (const Vec2 by : {Vec2{0, -kHigh_mm}, Vec2{kAside_mm, kLow_mm}, Vec2{-kAside_mm, kLow_mm},
                        Vec2{0, -kHigh_mm}})
    layer.page_mm.push_back(summit_mm + by);
}

void add_leader(const Leader& leader, Layer& layer) {
  Stroke stroke;
  stroke.first_point = static_cast<std::uint32_t>(layer.page_mm.size());
  stroke.point_count = 2;
  layer.strokes.push_back(stroke);
  for (const Vec2 at : {leader.from_mm, leader.to_mm}) layer.page_mm.push_back(at);
}

struct TextsOnPage {
  Layer leaders, labels;
  TakenRoom taken;
  std::vector<TurnedBox> marks = {}; ///< of summits
};

NamesFacts put_names(const TerrainData& terrain, const PlacedView& placed, const MapSpec& spec,
                     Lettering& lettering, const Drawing& drawing, TextsOnPage& texts) {
  PlaceNames given = place_names(*placed.names, spec.labels);
  NamesFacts facts;
  facts.unnamed = given.unnamed;
  facts.unnamed += std::erase_if(
      given.places, [](const PlaceName& place) { return on_one_line(place.text).empty(); });
  // Patches far away have hills, not every summit.
  SummitsOnPage found =
      named_summits(placed.file ? *placed.file : terrain, placed, spec, given.places);
  facts.elsewhere = found.elsewhere;
  const double longest_mm = longest_name_mm(placed, spec.labels);
  std::vector<NameToPlace> names;
  for (SummitOnPage& summit : found.summits) {
    summit.facts.text = on_one_line(summit.facts.text);
    if (summit.facts.state == NameState::hidden) continue;
    names.push_back(
        {summit.page_mm, summit.weight,
         lettering.set_within(text_of_size(summit.facts.text, spec.labels.size_mm), longest_mm)});
  }
  // Those that are seen come first, by rank.
  for (PlacedName& name : placed_names(placed, spec, drawing, names, texts.taken)) {
    found.summits[name.name].facts.state = NameState::chosen;
    if (name.leader) {
      add_leader(*name.leader, texts.leaders);
      texts.taken.take(box_of(name.leader->from_mm, name.leader->to_mm, spec.labels.halo_mm));
    }
    if (!placed.panorama) {
      const Vec2 summit_mm = names[name.name].summit_mm;
      add_mark(summit_mm, texts.labels);
      texts.marks.push_back(box_of(summit_mm, summit_mm, kSummitMark_mm));
    }
    texts.labels.texts.push_back(lettering.set(std::move(name.text)));
    found.summits[name.name].facts.corners_mm = texts.labels.texts.back().corners_mm();
    texts.taken.take(box_of(texts.labels.texts.back()));
  }
  round_to_page_step(texts.leaders);
  round_to_page_step(texts.labels);
  for (SummitOnPage& summit : found.summits) facts.names.push_back(std::move(summit.facts));
  std::ranges::stable_sort(facts.names, {}, [](const NameFacts& name) {
    return name.state == NameState::chosen ? 0 : name.state == NameState::crowded_out ? 1 : 2;
  });
  return facts;
}

ProfilePoint as_profile_point(Vec3 scene) {
  return {scene.x, scene.y, scene.z};
}

// Where the ground rises at a place, as a direction on the page.
std::optional<Vec2> uphill_on_page(const TerrainData& terrain, const PlacedView& placed,
                                   ProfilePoint at) {
  const Vec3 ground = to_ground_m(placed.view, at);
  const double step_m = placed.cell_m;
  const auto slope = [&](Vec2 way) -> std::optional<double> {
    const Vec2 here{ground.x, ground.y};
    const auto ahead = height_at(terrain.surface, here + step_m * way),
               behind = height_at(terrain.surface, here - step_m * way);
    if (!ahead || !behind) return std::nullopt;
    return 0.5 * (*ahead - *behind);
  };
  const auto east = slope({1, 0}), north = slope({0, 1});
  if (!east || !north || (*east == 0 && *north == 0)) return std::nullopt;
  const double size = std::hypot(*east, *north);
  const Vec3 up{ground.x + *east / size * step_m, ground.y + *north / size * step_m,
                ground.z + size};
  const Vec3 from = placed.on_page(at), to = placed.on_page(to_profile_frame(placed.view, up));
  if (!(from.z > 0 && to.z > 0)) return std::nullopt;
  return Vec2{to.x / to.z - from.x / from.z, to.y / to.z - from.y / from.z};
}

// Whether a line leaves the picture or the terrain at one of its points.
bool leaves(const TerrainData& terrain, const PlacedView& placed, ProfilePoint end,
            ProfilePoint beside) {
  const Vec3 page = placed.on_page(end);
  const Vec2 mm{page.x / page.z, page.y / page.z};
  const Box2& frame = placed.frame_mm;
  constexpr double kAtFrame_mm = 0.01;
  if (std::min({mm.x - frame.low.x, frame.high.x - mm.x, mm.y - frame.low.y, frame.high.y - mm.y}) <
      kAtFrame_mm)
    return true;
  const Vec3 to = to_ground_m(placed.view, end), from = to_ground_m(placed.view, beside);
  const Vec2 way{to.x - from.x, to.y - from.y};
  const double size = length(way);
  if (!(size > 0)) return false;
  const Vec2 there = Vec2{to.x, to.y} + 0.5 * placed.cell_m / size * way;
  return !height_at(terrain.surface, there);
}

Layer* layer_named(Drawing& drawing, std::string_view name) {
  const auto found = std::ranges::find(drawing.layers, name, &Layer::name);
  return found == drawing.layers.end() ? nullptr : &*found;
}

// Labels have the pens and colours of their lines.
void label_lines(const TerrainData& terrain, const PlacedView& placed, const MapSpec& spec,
                 const LinesToLabel& lines, Lettering& lettering, Drawing& drawing,
                 TakenRoom& taken) {
  const double size_mm = spec.labels.size_mm;
  const SetText set = [&](PageText text) { return lettering.set(std::move(text)); };
  Layer* const contours = layer_named(drawing, "index-contours");
  if (contours && !lines.contours.strokes.empty())
    contours->texts = contour_labels(
        lines.contours, 0.8 * size_mm, placed.frame_mm, InkMap(drawing.page, drawing.layers), set,
        [&](Vec3 at) { return uphill_on_page(terrain, placed, as_profile_point(at)); }, taken);
  if (placed.panorama) return;
  const Sides& around = spec.page.room_mm;
  const Box2 room{placed.frame_mm.low - Vec2{around.left, around.top},
                  placed.frame_mm.high + Vec2{around.right, around.bottom}};
  if (spec.furniture.has(Furniture::neatline)) { // none goes through it
    const auto& [low, high] = placed.frame_mm;
    const std::array<Vec2, 4> corners{low, Vec2{high.x, low.y}, high, Vec2{low.x, high.y}};
    for (std::size_t k = 0; k < 4; ++k)
      taken.take(box_of(corners[k], corners[(k + 1) % 4], 0.5 * spec.labels.halo_mm));
  }
  for (const auto& [name, of] : {std::pair{"graticule", &lines.graticule}, {"grid", &lines.grid}})
    if (Layer* layer = layer_named(drawing, name))
      layer->texts = coordinate_labels(
          *of, 0.8 * size_mm, room, set,
          [&](Vec3 end, Vec3 beside) {
            return leaves(terrain, placed, as_profile_point(end), as_profile_point(beside));
          },
          taken);
}

bool is_of_terrain(const Layer& layer) {
  switch (layer_row(layer.name).source) {
  case LineSource::profiles:
  case LineSource::underside:
  case LineSource::edges:
  case LineSource::ground:
  case LineSource::skyline:
    return true;
  case LineSource::solids:
  case LineSource::hidden_solids:
  case LineSource::lettering:
  case LineSource::pen_way:
    break;
  }
  return false;
}

} // namespace

std::size_t NamesFacts::count(NameState state) const {
  return static_cast<std::size_t>(std::ranges::count(names, state, &NameFacts::state));
}

std::string NamesFacts::chosen() const {
  std::string list;
  for (const NameFacts& name : names)
    if (name.state == NameState::chosen) list += (list.empty() ? "" : "; ") + name.text;
  return list;
}

MapSpec with_room_for_names(const MapSpec& spec, const Overlay* names) {
  MapSpec out = spec;
  if (spec.ground_points) return out;
  const bool has_names_above = names && is_panorama(spec.view.projection);
  if (!has_names_above && !labels_coordinates(spec)) return out;
  Lettering lettering(spec.letters);
  if (has_names_above) {
    const RoomForNames room = room_above(spec, *names, lettering);
    grow(out.page.strip_room_mm, {0, room.above_mm + kOffEnd_mm, room.right_mm + kOffEnd_mm, 0});
  }
  if (labels_coordinates(spec)) {
    const TextExtent number =
        lettering.set(text_of_size("0000000 E", 0.8 * spec.labels.size_mm)).extent;
    constexpr double kOff_mm = 1.2;
    const double high_mm = number.ascent_mm + number.descent_mm + kOff_mm,
                 wide_mm = number.width_mm + kOff_mm;
    grow(out.page.room_mm, {wide_mm, high_mm, wide_mm, high_mm});
  }
  return out;
}

std::optional<NamesFacts> name_places(const TerrainData& terrain, const PlacedView& placed,
                                      const MapSpec& spec, const LinesToLabel& lines,
                                      Lettering& lettering, Drawing& drawing) {
  TextsOnPage texts{
      layer_of_lettering("leaders", spec.style), layer_of_lettering("labels", spec.style), {}, {}};
  std::optional<NamesFacts> facts;
  if (placed.names) facts = put_names(terrain, placed, spec, lettering, drawing, texts);
  label_lines(terrain, placed, spec, lines, lettering, drawing, texts.taken);

  std::vector<TurnedBox> boxes = texts.marks;
  const auto add_boxes = [&](const Layer& layer) {
    for (const PageText& text : layer.texts) boxes.push_back(box_of(text, spec.labels.halo_mm));
  };
  for (const Layer& layer : drawing.layers) add_boxes(layer);
  add_boxes(texts.labels);
  for (Layer& layer : drawing.layers)
    if (is_of_terrain(layer)) break_lines(layer, boxes, spec.min_stroke_mm());
  const auto behind = [&] { return std::ranges::find(drawing.layers, true, &Layer::is_pen_way); };
  for (Layer* layer : {&texts.leaders, &texts.labels})
    if (!layer->strokes.empty() || !layer->texts.empty())
      drawing.layers.insert(behind(), std::move(*layer));
  return facts;
}

} // namespace orograph
