// SPDX-License-Identifier: GPL-3.0-or-later
// What is asked of a map: its view, its lines and its page, whatever the terrain.
#pragma once

#include "draw/colour.hpp"
#include "draw/page_request.hpp"
#include "draw/page_text.hpp"
#include "draw/pen_order.hpp"
#include "geometry/angle.hpp"
#include "placing/furniture_spec.hpp"
#include "placing/label_spec.hpp"
#include "placing/view_file.hpp"
#include "profiles/plan_request.hpp"
#include "view/projection.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace orograph {

/// A place that a user names, for the eye or for what it looks at.
struct GivenPlace {
  double x = 0, y = 0; ///< map coordinates, or longitude and latitude in degrees
  std::optional<double>
      z; ///< above the datum of the file's heights, in their unit; none: no height

  GivenPlace(double east, double north) : x(east), y(north) {}
  GivenPlace(Vec3 place) : x(place.x), y(place.y), z(place.z) {}
  bool operator==(const GivenPlace&) const = default;
};

/// Of a standing person, above the ground.
constexpr double kEyeHeight_m = 2;

enum class Curvature { automatic, on, off };

/// Of a panorama, from its left to its right side: clockwise from north, from less to more.
struct AzimuthRange {
  Angle from, to;
};
/// From a panorama's lower side to its upper one, above the horizontal.
struct AltitudeRange {
  Angle low, high;
};

/// Where the eye is and how it looks. A view from a file goes before all that follows it here, but
/// for what has no place in such a file: curvature and refraction.
struct ViewSpec {
  std::optional<ViewFile> file;
  std::string file_name; ///< what messages call that file

  Projection projection = Projection::perspective;
  Oblique oblique = kCavalier; ///< oblique only
  /// Where the viewer stands, seen from the target: azimuth clockwise from north, elevation above
  /// the horizontal, 0 to 90 degrees. Without an eye.
  Angle from_azimuth = Angle::degrees(180), from_elevation = Angle::degrees(25);
  Horizontal elevation_above = Horizontal::of_target; ///< perspective only
  bool from_auto = false; ///< both chosen, to show most ground with most relief
  /// Horizontal; in perspective, or a panorama's: up to 360 degrees, which it has where nothing is
  /// given.
  std::optional<Angle> field_of_view;
  /// Of a panorama; instead of a field of view, and of a direction or a point to look at, which
  /// else are in its middle. None of them: from north to north.
  std::optional<AzimuthRange> azimuth_range;
  std::optional<AltitudeRange> altitude_range;          ///< of a panorama; none: what is seen
  std::optional<double> distance_m;                     ///< eye to target in space
  std::optional<GivenPlace> eye_map, look_at_map;       ///< in map coordinates
  std::optional<GivenPlace> eye_lonlat, look_at_lonlat; ///< longitude and latitude, WGS 84
  std::optional<double> eye_height_m;                   ///< above the ground; none: kEyeHeight_m
  /// The eye goes to the highest ground within so many metres, as high above it as it was.
  std::optional<double> eye_summit_m;
  std::optional<Angle> look_azimuth; ///< from true north where it is known
  /// Upwards; beside `look_azimuth`. None, and nothing to look at either: the picture's window is
  /// shifted so that skyline and foreground fill it (placing/frame_eye_view.hpp).
  std::optional<Angle> pitch;
  Angle roll; ///< the picture turns clockwise by it
  Curvature curvature = Curvature::automatic;
  double refraction = 0.13;           ///< K: share of the earth's curvature that rays follow
  std::optional<double> exaggeration; ///< none: chosen from the terrain

  bool has_eye() const { return eye_map || eye_lonlat; }
};

/// A layer to be drawn, by its name in the table of layers (map/layer_table.hpp).
struct LayerSpec {
  std::string name;
  std::optional<double> weight; ///< of its pen beside the profiles'; none: the table's
  std::optional<double> grey;   ///< 0 black to 1 white; none: the palette's
  std::optional<Colour> colour; ///< instead of any grey; none: the palette's

  bool operator==(const LayerSpec&) const = default;

  LayerSpec(const char* layer) : name(layer) {}
  LayerSpec(std::string layer) : name(std::move(layer)) {}
};

/// Pen widths between profiles that read well on real terrain (docs/how-it-works.md).
constexpr double kPenWidthsApart = 4;

/// Shorter ink is a crumb.
constexpr double kCrumb_mm = 0.5;

/// Aerial perspective that one sees as depth and not as fog.
constexpr double kHazeInPerspective = 0.3;

enum class Occluder { surface, profiles };
/// What is drawn of water: its shores, with profiles and border, or with lines along the shores.
enum class FlatGround { shore, draw, waterlines };
/// Whether lines are as far apart on the page as the plan says, wherever the ground is, or planes
/// are on level ground.
enum class Spread { even, planes };
/// Whether the ground is solid all the way down, or a sheet of which one sees both sides.
enum class Underside { omit, draw };
/// Whether terrain's border, where it is the horizon, is drawn as skyline, or as border as
/// elsewhere.
enum class Outline { one, by_layer };

/// What layers are drawn in, unless they are told: black and greys, or the colours that maps have.
enum class Palette { mono, map };

/// Where light falls from on the ground.
struct LightSpec {
  bool of_picture =
      true; ///< its azimuth turns with the picture: 0 is away from the viewer, 270 left
  Angle azimuth = Angle::degrees(285), altitude = Angle::degrees(40);
  double contrast = 1;     ///< 0: all ground is as dark as level ground
  double smooth_mm = 1;    ///< light falls on the ground's mean over about this, on the page
  bool by_density = false; ///< darkness by how close lines are, with pens of one width
};

/// Of lines that carry light.
struct LineWidths {
  double least_mm, greatest_mm;
};

/// Contours: lines of one height.
struct ContourSpec {
  std::vector<double> levels = {}; ///< just these, rising; empty: every `interval`
  std::optional<double> interval =
      {};            ///< none: so that there are about 25 over the relief, or fewer
  double offset = 0; ///< a level; the others are whole intervals from it
  std::optional<double> unit_m =
      {};              ///< of all of these, in metres; none: that of the file's heights
  int index_every = 5; ///< every how many-th interval has index contours; 0: none
  bool ticks = false;  ///< down the slope from those around lower ground
};

/// A mesh of lines on the ground, as far apart everywhere in plan.
struct MeshSpec {
  std::optional<double> spacing_m;
  int count = 40;          ///< else: lines across the terrain's longer side
  bool x = true, y = true; ///< lines of one x, and of one y
  bool along_view = false; ///< x to the right and y away from the viewer; else on the map
};

/// Hachures: lines down the slope of the ground, smoothed over about 1.5 mm of the page.
struct HachureSpec {
  double spacing_mm = 0.8;       ///< between lines, on the page, wherever the ground is
  double from_deg = 5;           ///< of slope: what is gentler has none
  double heaviest_from_deg = 45; ///< what is as steep, or steeper, has the widest
};

/// Whether a block's walls are hatched.
enum class BlockSides { lines, outline };

/// Walls from the terrain's border down to a base.
struct BlockSpec {
  std::optional<double> base = {};   ///< height; none: below the lowest by 0.15 of the relief
  std::optional<double> unit_m = {}; ///< of the base, in metres; none: that of the file's heights
  std::optional<BlockSides> sides = {}; ///< none: hatched, unless contours go across the walls
};

/// How large the cells of the surface are that is drawn.
struct DetailSpec {
  bool of_file = false; ///< as large as the file's: its own surface
  std::optional<double> cell_mm =
      {}; ///< about so large on the page; none: as the lines' spacing asks
  /// Instead: as large as may be with every point within this, on the page, of where the file's
  /// surface has it (docs/decisions/0062-certified-levels.md).
  std::optional<double> error_mm = {};
};

/// Which lines are drawn, and how exactly.
struct Style {
  DetailSpec detail; ///< where lines keep their places on the ground, the file's unless `cell_mm`
  std::optional<PlanRequest> plan; ///< none: four pen widths on the page
  Spread spread = Spread::even;    ///< of a plan in millimetres
  Occluder occluder = Occluder::surface;
  Underside underside = Underside::omit;
  double visibility_tolerance_mm = 1e-4;
  double simplify_mm = 0.02;
  double silhouette_jump = 0.003; ///< share of the depth by which the ground behind is farther
  /// Widest gap between two ends of a ridge, a shore or the like that are drawn as one line, and
  /// then judged as one by `min_stroke_mm`.
  double join_mm = 0.15;
  /// Shores are drawn as smoothly as this far from their places allows, where lines go on paper;
  /// 0: not at all.
  double shore_smooth_mm = 0.3;
  /// None: what the eye takes for a crumb, where lines go on paper; 0 where they keep their places
  /// on the ground.
  std::optional<double> min_stroke_mm;
  FlatGround flat = FlatGround::shore;
  ContourSpec contours;
  MeshSpec mesh;
  HachureSpec hachures;
  BlockSpec block;
  double overlay_above_m = 0;          ///< how much higher than the ground overlays are drawn
  std::optional<double> graticule_deg; ///< between meridians, and parallels; none: some six of them
  std::optional<double> grid_m;        ///< between eastings, and northings; none: some six of them
  Outline outline = Outline::one;
  std::vector<LayerSpec> layers{"profiles", "shores", "border", "silhouettes", "skyline", "solids"};
  Palette palette = Palette::mono;
  double pen_width_mm = 0.15;
  std::optional<LineWidths> light_widths; ///< none: half and double the pen's
  std::optional<LightSpec> light = LightSpec{};
  std::optional<double> haze; ///< share of their darkness that the farthest lines lose; none: 0.3
                              ///< in perspective

  /// What is asked of a layer; null where it isn't to be drawn.
  const LayerSpec* layer(std::string_view name) const {
    for (const LayerSpec& spec : layers)
      if (spec.name == name) return &spec;
    return nullptr;
  }
  bool asks_for(std::string_view name) const { return layer(name) != nullptr; }
  bool draws_index_contours() const {
    return asks_for("index-contours") ||
           (asks_for("contours") && contours.levels.empty() && contours.index_every > 0);
  }
  bool hatches_block() const {
    const bool has_contours = asks_for("contours") || draws_index_contours();
    const BlockSides otherwise = has_contours ? BlockSides::outline : BlockSides::lines;
    return asks_for("block") && block.sides.value_or(otherwise) == BlockSides::lines;
  }
  bool draws_waterlines() const { return flat == FlatGround::waterlines || asks_for("waterlines"); }
  double haze_in(bool perspective) const {
    return haze.value_or(perspective ? kHazeInPerspective : 0);
  }
};

struct MapSpec {
  ViewSpec view;
  Style style;
  PageRequest page;
  std::string title;          ///< empty: the terrain's file name, or the first's and how many more
  LetterSpec letters;         ///< of all texts on the page
  LabelSpec labels;           ///< names and labels; the same
  FurnitureSpec furniture;    ///< around the picture; where lines keep their places it isn't drawn
  bool ground_points = false; ///< lines keep their places on the ground; hidden ones stay whole
  /// Of each layer's strokes. Where lines keep their places on the ground it is the drawing's.
  PenOrder pen_order = PenOrder::drawing;
  std::uint64_t check = 0; ///< points to ask of the ray walk
  /// The same of what is drawn, asked of the file's own surface, where that isn't drawn.
  std::uint64_t check_of_file = 0;

  double min_stroke_mm() const {
    return style.min_stroke_mm.value_or(ground_points ? 0 : kCrumb_mm);
  }
};

} // namespace orograph
