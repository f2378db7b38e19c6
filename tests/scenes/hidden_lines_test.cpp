// SPDX-License-Identifier: GPL-3.0-or-later
// Hidden lines: hidden where the ray walk says so, and together with the visible ones the whole
// line.
#include "dem/approximate/tin_of_grid.hpp"
#include "geometry/error.hpp"
#include "hidden_lines/sector_pass.hpp"
#include "map/check.hpp"
#include "map/draw_map.hpp"
#include "map/layer_table.hpp"
#include "placing/placed_view.hpp"
#include "reference/judge.hpp"
#include "reference/sight.hpp"
#include "tests/catch.hpp"
#include "tests/scenes/random_overlay.hpp"
#include "tests/scenes/random_scene.hpp"
#include "tests/scenes/random_solid_scene.hpp"
#include "tests/scenes/same_drawing.hpp"
#include "tests/scenes/sector_found.hpp"
#include "tests/scenes/vary_view.hpp"
#include "tests/support/grid_of.hpp"
#include "tests/support/random.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <span>
#include <string>

namespace orograph::hidden_lines_test {
namespace {

const std::uint64_t kScenes = last_seed(150);

constexpr std::array kLayers{"profiles", "contours", "mesh",  "drape",      "shores",
                             "border",   "voids",    "edges", "silhouettes"};

// Every line of a scene, hidden ones as well, as it is found and not as it looks good.
RandomScene with_hidden(std::uint64_t seed, Random& random) {
  // Of large ones whole blocks are hidden.
  RandomScene scene = random_scene(seed, seed % 10 == 1 ? 150 : 24);
  Style& style = scene.spec.style;
  style.layers = {"skyline"};
  for (const char* layer : kLayers) {
    style.layers.emplace_back(layer);
    style.layers.emplace_back("hidden-" + std::string(layer));
  }
  style.light.reset();
  style.haze = 0;
  style.outline = Outline::by_layer;
  style.flat = FlatGround::draw;
  style.simplify_mm = style.silhouette_jump = style.join_mm = style.shore_smooth_mm = 0;
  style.min_stroke_mm = 0;
  style.contours.index_every = random.whole(0, 3);
  style.mesh.along_view = random.chance(0.4);
  style.mesh.count = random.whole(1, 12);
  scene.spec.ground_points = true; // no dashes
  vary_view(seed, scene.terrain, scene.spec, random);
  if (seed % 2 == 0) {
    const Grid grid = grid_of(scene.terrain);
    scene.terrain.surface = tin_of(grid);
  }
  return scene;
}

// Where a linear function that is `a` at 0 and `b` at 1 isn't negative, `t` is cut to that.
struct Within {
  double begin = 0, end = 1;
  void cut(double a, double b) {
    if (a < 0 && b < 0) end = begin;
    if (a < 0 && b >= 0) begin = std::max(begin, a / (a - b));
    if (a >= 0 && b < 0) end = std::min(end, a / (a - b));
  }
};

// Length on the page of what of a line of a sector is in front of it and in the frame.
double length_mm(const PlacedView& placed, const Sector& sector, const ProfileLine& line,
                 double from_m) {
  Within within;
  if (std::isfinite(from_m) && sector.view.is_perspective())
    within.cut(line.from.v - from_m, line.to.v - from_m);
  const auto page = [&](double t) {
    return sector.to_page.of(
        project_homogeneous(sector.view, point_between(line.from, line.to, t)));
  };
  const Vec3 a = page(0), b = page(1);
  const auto& [low, high] = placed.frame_mm;
  constexpr double kSlack_mm = 1e-9; // a picture that fills the frame touches its sides
  within.cut(a.x - (low.x - kSlack_mm) * a.z, b.x - (low.x - kSlack_mm) * b.z);
  within.cut((high.x + kSlack_mm) * a.z - a.x, (high.x + kSlack_mm) * b.z - b.x);
  within.cut(a.y - (low.y - kSlack_mm) * a.z, b.y - (low.y - kSlack_mm) * b.z);
  within.cut((high.y + kSlack_mm) * a.z - a.y, (high.y + kSlack_mm) * b.z - b.y);
  if (!(within.begin < within.end)) return 0;
  const Vec3 begin = page(within.begin), end = page(within.end);
  return std::hypot(begin.x / begin.z - end.x / end.z, begin.y / begin.z - end.y / end.z);
}

// Spans of profiles as they were cut.
class Spans : public LineObserver {
public:
  explicit Spans(const PlacedView& placed) : placed_(placed) {}
  void see(const SeenProfile& seen) override {
    const Profile& profile = seen.profile;
    for (std::uint32_t i = 0; i + 1 < profile.size(); ++i) {
      if (profile.after[i] == Span::gap) continue;
      const ProfileLine span{{profile.u_m[i], profile.depth_m, profile.z_m[i]},
                             {profile.u_m[i + 1], profile.depth_m, profile.z_m[i + 1]}};
      profiles_mm += length_mm(placed_, seen.sector, span, 0);
    }
  }
  bool asks_lines() const override { return false; }
  void see(const SeenLines&) override {}

  double profiles_mm = 0;

private:
  const PlacedView& placed_;
};

struct Asked {
  std::uint64_t points = 0, ties = 0, wrong = 0;
};

// The parts of one line, one behind another.
void ask_parts(const Judge& judge, const SectorFound& pass, std::span<const LinePart> parts,
               bool visible, Random& random, Asked& asked) {
  const LinePictures& lines = pass.pictures;
  for (const LinePart& part : parts) {
    const double t = part.t_begin + random.between(0.02, 0.98) * (part.t_end - part.t_begin);
    const double x = project(lines.sector().view, lines.point(part.line, t)).x;
    if (!(x >= pass.range.begin && x <= pass.range.end)) continue;
    if (lines.is_moved(lines.line(part.line).edge)) continue; // from the eye's own plane
    ++asked.points;
    const Verdict verdict =
        judge.verdict(lines.whole(part.line), t, lines.is_edge(part.line), visible);
    if (verdict == Verdict::tied)
      ++asked.ties;
    else if ((verdict == Verdict::visible) != visible)
      ++asked.wrong;
  }
}

struct Faults {
  std::size_t overlaps = 0, gaps = 0;
};

// Of what should be one behind another from where a line comes to lie in front of the eye.
Faults faults_along(const SectorFound& pass) {
  const LinePictures& pictures = pass.pictures;
  const std::vector<EdgeLine>& listed = pass.lines.listed;
  constexpr double kSlit = 2e-9; // what hidden_parts leaves out, and rounding
  std::map<std::uint32_t, std::vector<LinePart>> by_line;
  for (const std::vector<LinePart>* parts : {&pass.visible, &pass.found.hidden})
    for (const LinePart& part : *parts) by_line[part.line].push_back(part);
  const View& view = pictures.sector().view;
  Faults faults;
  for (std::uint32_t k = 0; k < listed.size(); ++k) {
    if (!listed[k].drawn) continue;
    const ProfileLine whole = pictures.whole(k);
    Within within;
    const double drawn_m = std::max(view.near_m, view.drawn_from_m);
    if (view.is_perspective()) within.cut(whole.from.v - drawn_m, whole.to.v - drawn_m);
    std::vector<LinePart>& parts = by_line[k];
    std::sort(parts.begin(), parts.end(),
              [](const LinePart& a, const LinePart& b) { return a.t_begin < b.t_begin; });
    double at = within.begin;
    for (const LinePart& part : parts) {
      faults.overlaps += part.t_begin < at - kSlit ? 1 : 0;
      faults.gaps += part.t_begin > at + kSlit ? 1 : 0;
      at = part.t_end;
    }
    faults.gaps += at < within.end - kSlit ? 1 : 0;
  }
  return faults;
}

double ink_mm(const Drawing& drawing, const std::string& name, std::size_t& points) {
  double sum = 0;
  for (const Layer& layer : drawing.layers) {
    if (layer.name != name) continue;
    points += layer.page_mm.size();
    for (const Stroke& stroke : layer.strokes) sum += line_length_mm(layer.points(stroke));
  }
  return sum;
}

} // namespace

TEST_CASE("the ray walk sees no hidden line, and hidden and visible parts are the line", "[slow]") {
  Asked hidden, visible;
  std::uint64_t refused = 0, two_sectors = 0;
  for (std::uint64_t seed = 1; seed <= kScenes; ++seed) {
    Random random(seed);
    const RandomScene scene = with_hidden(seed, random);
    const Style& style = scene.spec.style;
    INFO("seed " << seed << ": " << scene.what);
    std::optional<PlacedView> placed = placed_if_any(scene.terrain, scene.spec);
    if (!placed) {
      ++refused;
      continue;
    }
    const Overlay overlay = random_overlay(scene.terrain, random);
    placed->overlays = std::span(&overlay, 1);
    two_sectors += placed->sectors.size() > 1 ? 1 : 0;
    const Instruments instruments{.hidden_ground = true, .order_always = seed % 4 == 1};
    const LinesOfView lines =
        lines_of_view(scene.terrain, *placed, style, instruments, nullptr, hidden_kinds(style));
    const std::vector<Judge> judges = judges_of(scene.terrain.surface, *placed, 1e-4);
    for (std::size_t i = 0; i < placed->sectors.size(); ++i) {
      const Sector& sector = placed->sectors[i];
      const SectorFound pass(scene.terrain, *placed, sector, lines, style, instruments);
      ask_parts(judges[i], pass, pass.found.hidden, false, random, hidden);
      ask_parts(judges[i], pass, pass.visible, true, random, visible);
      CHECK(hidden.wrong == 0);
      CHECK(visible.wrong == 0);

      const Faults faults = faults_along(pass);
      CHECK(faults.overlaps == 0);
      CHECK(faults.gaps == 0);
    }
  }
  WARN(hidden.points << " points of hidden parts asked, " << hidden.ties << " tied; "
                     << visible.points << " of visible parts, " << visible.ties << " tied; "
                     << two_sectors << " of two sectors, " << refused << " refused");
  CHECK(hidden.points > 100 * kScenes);
  CHECK(hidden.ties < hidden.points / 3);
  CHECK(two_sectors > kScenes / 20);
  CHECK(refused < kScenes / 4);
}

TEST_CASE("what solids hide of lines is hidden, and all else that isn't seen") {
  std::size_t by_solids = 0, hidden = 0;
  for (std::uint64_t seed = 1; seed <= kScenes / 2; ++seed) {
    SolidScene made = random_solid_scene(seed);
    Style& style = made.spec.style;
    style.silhouette_jump = 0;
    style.outline = Outline::by_layer;
    style.layers = {"contours",     "hidden-contours", "edges",
                    "hidden-edges", "border",          "hidden-border"};
    PlacedView placed = placed_view(made.terrain, made.spec);
    placed.solids = made.standing;
    INFO("seed " << seed << ": " << made.what);
    const Instruments instruments{.hidden_ground = true};
    const LinesOfView lines =
        lines_of_view(made.terrain, placed, style, instruments, nullptr, hidden_kinds(style));
    const Sector& sector = placed.sectors.front();
    const SectorFound pass(made.terrain, placed, sector, lines, style, instruments);
    // Silhouettes hide and aren't drawn here; all others are one or the other everywhere.
    const Faults faults = faults_along(pass);
    CHECK(faults.overlaps == 0);
    CHECK(faults.gaps == 0);
    const SolidSight sight(made.standing, sector.view);
    const std::vector<Judge> judges = judges_of(made.terrain.surface, placed, 1e-4);
    Random random(seed);
    for (const LinePart& part : pass.found.hidden) {
      const double t = part.t_begin + random.between(0.02, 0.98) * (part.t_end - part.t_begin);
      const ProfilePoint at = pass.pictures.point(part.line, t);
      const double x = project(sector.view, at).x;
      if (!(x >= pass.range.begin && x <= pass.range.end) || !random.chance(0.2)) continue;
      ++hidden;
      if (judges.front().verdict(pass.pictures.whole(part.line), t,
                                 pass.pictures.is_edge(part.line), false) != Verdict::visible)
        continue;
      const SightAnswer answer = sight.ask(at, 1e-7L, {});
      CHECK((answer.hidden || answer.unsure));
      by_solids += answer.surely_hidden() ? 1 : 0;
    }
  }
  WARN(hidden << " points of hidden parts asked, " << by_solids << " hidden by solids alone");
  CHECK(by_solids > kScenes);
}

TEST_CASE("visible and hidden ink is that of the line within the frame", "[slow]") {
  double hidden_mm = 0, greatest_mm = 0;
  std::uint64_t scenes = 0;
  std::string where;
  for (std::uint64_t seed = 1; seed <= kScenes; ++seed) {
    Random random(seed);
    const RandomScene scene = with_hidden(seed, random);
    INFO("seed " << seed << ": " << scene.what);
    std::optional<PlacedView> placed = placed_if_any(scene.terrain, scene.spec);
    if (!placed) continue;
    const Overlay overlay = random_overlay(scene.terrain, random);
    placed->overlays = std::span(&overlay, 1);
    Spans spans(*placed);
    Instruments instruments{.order_always = seed % 4 == 1};
    instruments.observers = {&spans};
    const Map map = draw_map(
        scene.terrain, *placed, scene.spec, [](double) {}, instruments);
    const Drawing& drawing = map.drawing;
    const bool has_all = map.facts.counts.dropped_strokes == 0; // none is another's picture
    scenes += has_all ? 1 : 0;
    const LinesOfView lines =
        lines_of_view(scene.terrain, *placed, scene.spec.style, {.hidden_ground = true}, nullptr,
                      hidden_kinds(scene.spec.style));
    std::map<LineKind, double> whole_mm;
    for (const Sector& sector : placed->sectors) {
      const double from_m = std::max(sector.view.near_m, sector.view.drawn_from_m);
      const EdgeEnds ends(scene.terrain.surface, sector.view,
                          {lines.on_ground.points, sector.to_view.back()});
      for (const EdgeLine& line : lines.listed) {
        if (!line.drawn) continue;
        const ProfileLine whole = ends(line.edge);
        // What lies between two sectors as a whole is the first one's.
        const bool is_between =
            sector.keeps_strip &&
            std::max(std::abs(whole.from.v), std::abs(whole.to.v)) <= sector.view.near_m;
        whole_mm[line.kind] += length_mm(
            *placed, sector, whole, is_between ? -std::numeric_limits<double>::infinity() : from_m);
      }
    }
    const auto check = [&](std::vector<std::string> names, double expected_mm) {
      std::size_t points = 0;
      double seen_mm = 0, unseen_mm = 0;
      for (const std::string& name : names) {
        seen_mm += ink_mm(drawing, name, points);
        unseen_mm += ink_mm(drawing, "hidden-" + name, points);
      }
      INFO(names.front() << ": " << seen_mm << " visible, " << unseen_mm << " hidden");
      hidden_mm += unseen_mm;
      const double difference = std::abs(seen_mm + unseen_mm - expected_mm);
      if (has_all && difference > greatest_mm) {
        greatest_mm = difference;
        where = names.front() + " of seed " + std::to_string(seed);
      }
      const double rounding_mm = 1.5 * kPageStep_mm * static_cast<double>(points + 10);
      if (has_all)
        CHECK(difference <= rounding_mm);
      else
        CHECK(seen_mm + unseen_mm <= expected_mm + rounding_mm);
    };
    check({"profiles"}, spans.profiles_mm);
    check({"contours", "index-contours"},
          whole_mm[LineKind::contour] + whole_mm[LineKind::index_contour]);
    check({"mesh"}, whole_mm[LineKind::mesh]);
    check({"drape"}, whole_mm[LineKind::drape]);
    check({"shores"}, whole_mm[LineKind::shore]);
    check({"border"}, whole_mm[LineKind::border]);
    check({"voids"}, whole_mm[LineKind::void_edge]);
    check({"edges"}, whole_mm[LineKind::edge]);
    check({"silhouettes", "skyline"}, whole_mm[LineKind::silhouette]);
  }
  WARN(hidden_mm << " mm hidden; " << scenes
                 << " scenes in which no stroke is another's picture; sums differ by up to "
                 << greatest_mm << " mm, in " << where);
  CHECK(hidden_mm > 1000.0 * kScenes);
  CHECK(scenes > kScenes / 2);
}

TEST_CASE("visible lines are the same with hidden ones and without") {
  for (std::uint64_t seed = 1; seed <= kScenes / 3; ++seed) {
    Random random(seed);
    RandomScene scene = with_hidden(seed, random);
    if (seed % 4 < 2) { // as lines go on paper, with even tone and light
      const Style plain;
      scene.spec.ground_points = false;
      scene.spec.style.light = plain.light;
      scene.spec.style.plan = PageSpacing{2};
      scene.spec.style.join_mm = plain.join_mm;
      scene.spec.style.simplify_mm = plain.simplify_mm;
      scene.spec.style.silhouette_jump = plain.silhouette_jump;
      scene.spec.style.outline = plain.outline;
      // Planes that even tone leaves out but for their hidden parts may be tied with others, and be
      // those that are drawn.
      std::erase(scene.spec.style.layers, LayerSpec("hidden-profiles"));
    }
    INFO("seed " << seed << ": " << scene.what);
    const auto drawn = [&](const MapSpec& spec) -> std::optional<Drawing> {
      try {
        return draw_map(scene.terrain, placed_view(scene.terrain, spec), spec, [](double) {})
            .drawing;
      } catch (const Error&) {
        return std::nullopt;
      }
    };
    std::optional<Drawing> with = drawn(scene.spec);
    MapSpec spec = scene.spec;
    std::erase_if(spec.style.layers,
                  [](const LayerSpec& layer) { return layer.name.starts_with("hidden-"); });
    std::optional<Drawing> without = drawn(spec);
    REQUIRE(with.has_value() == without.has_value());
    if (!with) continue;
    CHECK(!find_fault(*with));
    std::erase_if(with->layers, [](const Layer& layer) { return layer.is_hidden; });
    CHECK(difference(*with, *without) == "");
  }
}

} // namespace orograph::hidden_lines_test
