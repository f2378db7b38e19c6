// SPDX-License-Identifier: GPL-3.0-or-later
// A drawing: layers of strokes on a page, in millimetres, and where each lies on the ground.
#pragma once

#include "draw/colour.hpp"
#include "draw/page_text.hpp"
#include "draw/pen.hpp"
#include "geometry/api.hpp"
#include "geometry/attributes.hpp"
#include "geometry/box.hpp"
#include "geometry/vec.hpp"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <numbers>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace orograph {

struct Page {
  double width_mm = 210, height_mm = 297;
  double margin_mm = 10;

  Box2 inner_mm() const {
    return {{margin_mm, margin_mm}, {width_mm - margin_mm, height_mm - margin_mm}};
  }
};

/// A run of points of its layer, at least two.
struct Stroke {
  std::uint32_t first_point = 0, point_count = 0;
  std::int32_t profile = -1; ///< number, front to back, from 0; -1 for other lines
  double depth_m = std::numeric_limits<double>::quiet_NaN(); ///< NaN where it has no single one
  double width_mm = 0;                                       ///< 0: its layer's pen
  std::int32_t level = 0; ///< of a profile: how often the number of lines is halved before it goes
  /// Share of black that light leaves the ground along it, where that is told instead of shown.
  float darkness = std::numeric_limits<float>::quiet_NaN();
  std::int32_t feature = -1; ///< number of its layer's; -1: none
};

/// Page points are x to the right and y down from the page's upper left corner, rounded to
/// `kPageStep_mm`. Map points (the terrain's CRS, true heights) stand beside them, one for one,
/// where the output is tied to the ground, and are left empty otherwise.
struct Layer {
  std::string name;
  double pen_width_mm = 0.15;
  double grey = 0;                             ///< 0 black to 1 white
  std::optional<Colour> colour = std::nullopt; ///< instead of the grey
  bool is_hidden = false;                      ///< lines that the eye doesn't see
  bool is_pen_way = false; ///< no ink: shows where a pen goes between the other layers' strokes
  /// What draws it, where that is known: then its name, width and colour are the layer's.
  std::optional<Pen> pen = std::nullopt;
  std::vector<Vec2> page_mm;
  std::vector<Vec3> map;
  std::vector<float> depths_m; ///< one for one beside page points, while they are still asked for
  std::vector<Stroke> strokes;
  std::vector<Attributes> features; ///< what strokes are lines of, where they tell
  std::vector<std::string> fields;  ///< that features may have, beside those that they have
  std::vector<PageText> texts;      ///< above the strokes; `Lettering::set` has made them ready

  std::span<const Vec2> points(const Stroke& s) const {
    return std::span(page_mm).subspan(s.first_point, s.point_count);
  }
  /// Its pen's, or else its own; none: it is grey.
  std::optional<Colour> ink() const { return pen ? pen->colour : colour; }
  /// Takes the strokes away.
  void clear() {
    page_mm.clear();
    map.clear();
    depths_m.clear();
    strokes.clear();
  }
};

/// The step of page coordinates in every format: 4 decimals of a millimetre, a hundredth of what a
/// plotter can do.
constexpr double kPageStep_mm = 1e-4;
/// How far that moves a point, at most.
constexpr double page_rounding_mm() {
  return 0.5 * std::numbers::sqrt2 * kPageStep_mm;
}

struct Drawing {
  Page page;
  std::string title;
  std::string description;
  std::string crs_wkt;       ///< of the map points; empty where the terrain has none
  std::vector<Layer> layers; ///< in drawing order
  LetterSpec letters;        ///< of the layers' texts
};

/// Whether no layer has a colour that isn't a grey.
bool is_all_grey(const Drawing& drawing);

/// Of a polyline.
double line_length_mm(std::span<const Vec2> points);

/// Adds another layer's strokes and texts behind those of `layer`.
OROGRAPH_API void append(Layer& layer, const Layer& other);

/// The layer with each stroke cut into dashes, from one of its ends to the other: as many whole
/// ones as fit, dash and gap stretched together so that it begins and ends with a dash. Dashes are
/// strokes of their own, so that a plotter draws them too. A stroke that is shorter than a dash and
/// a gap stays whole. REQUIRES a layer without map points, and lengths above 0.
OROGRAPH_API Layer dashed(const Layer& layer, double dash_mm, double gap_mm);

/// How far a plotter's pen goes to draw a drawing.
struct PenTravel {
  double down_mm = 0;    ///< the strokes' length
  double up_mm = 0;      ///< between strokes
  std::size_t lifts = 0; ///< strokes that don't begin where the pen is
};

/// Of a drawing, and of each of its layers, whose way begins where the layer before it ends.
struct PenTravels {
  PenTravel all;
  std::vector<PenTravel> by_layer;
};

/// Strokes in drawing order, each from its first point, but those that show the pen's way. The pen
/// starts above the page's upper left corner, as plotters do, and its way back after the last
/// stroke isn't counted.
OROGRAPH_API PenTravels pen_travels(const Drawing& drawing);

/// Fills the layers that show a pen's way with its straight moves from stroke to stroke.
OROGRAPH_API void show_pen_way(Drawing& drawing);

/// How fast a plotter's pen is.
struct PenSpeed {
  double down_mm_s = 0, up_mm_s = 0; ///< above 0
  double lift_s = 0;                 ///< up and down again
};
/// At full speed all the way: what it takes to speed up and slow down isn't in it.
OROGRAPH_API double pen_minutes(const PenTravel& travel, const PenSpeed& speed);

/// The first thing that is wrong with a drawing, or nothing: every point finite, on the step and
/// inside the margins; no stroke with fewer than two points or without length; no two equal
/// strokes in a layer (nor one the reverse of the other); texts inside of the margins. What shows a
/// pen's way may be anywhere on the page, and twice.
OROGRAPH_API std::optional<std::string> find_fault(const Drawing& drawing);

} // namespace orograph
