// SPDX-License-Identifier: GPL-3.0-or-later
// Where a silhouette cuts a contour off, the contour ends on it: in memory, before anything is
// rounded to the page's step.
#include "dem/approximate/tin_of_grid.hpp"
#include "hidden_lines/sector_pass.hpp"
#include "placing/placed_view.hpp"
#include "placing/sector.hpp"
#include "profiles/cut_surface.hpp"
#include "tests/catch.hpp"
#include "tests/scenes/random_scene.hpp"
#include "tests/scenes/sector_found.hpp"
#include "tests/scenes/vary_view.hpp"
#include "tests/support/grid_of.hpp"
#include "tests/support/random.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

namespace orograph::contour_ends_test {
namespace {

const std::uint64_t kScenes = last_seed(200);
// Of shares of a piece of a contour: what is nearer to its end is at it.
constexpr double kRounding = 1e-9;

RandomScene with_contours(std::uint64_t seed, double tolerance_mm, Random& random) {
  RandomScene scene = random_scene(seed, 40);
  Style& style = scene.spec.style;
  style.layers = {"contours", "silhouettes", "border", "voids"};
  style.outline = Outline::by_layer;
  style.visibility_tolerance_mm = tolerance_mm;
  style.silhouette_jump = 0; // what is no fold is left out else, though it hides
  vary_view(seed, scene.terrain, scene.spec, random);
  if (seed % 2 == 0) {
    const Grid grid = grid_of(scene.terrain);
    scene.terrain.surface = tin_of(grid);
  }
  return scene;
}

bool is_contour(LineKind kind) {
  return kind == LineKind::contour || kind == LineKind::index_contour;
}

struct PageSegment {
  Vec2 from, to;
};

double distance_mm(Vec2 p, const PageSegment& s) {
  const Vec2 way = s.to - s.from;
  const double squared = dot(way, way);
  const double t = squared > 0 ? std::clamp(dot(p - s.from, way) / squared, 0.0, 1.0) : 0;
  return length(p - (s.from + t * way));
}

// The piece that is line number `i`.
const GroundLine& piece_of(const LinesOfView& lines, std::uint32_t i) {
  return lines.on_ground.lines[i - (lines.listed.size() - lines.on_ground.lines.size())];
}

class SectorOnPage {
public:
  SectorOnPage(const Surface& surface, const Sector& sector, std::span<const ProfilePoint> points)
      : sector_(sector), ends_(surface, sector.view, {points, sector.to_view.back()}) {}

  ProfilePoint at(const EdgeLine& line, double t) const {
    const ProfileLine whole = ends_(line.edge);
    return point_between(whole.from, whole.to, t);
  }
  bool has_page(ProfilePoint p) const { return image_of(p).z > 0; }
  Vec2 page(ProfilePoint p) const {
    const Vec3 image = image_of(p);
    return {image.x / image.z, image.y / image.z};
  }
  // Adds what of a line has a picture on this side of the eye, but far beside the page.
  void add(ProfilePoint from, ProfilePoint to, std::vector<PageSegment>& out) const {
    constexpr double kLeast = 1e-3;
    if (image_of(from).z > image_of(to).z) std::swap(from, to);
    const double least = image_of(from).z, most = image_of(to).z;
    if (!(most > 0)) return;
    if (least < kLeast * most)
      from = point_between(from, to, (kLeast * most - least) / (most - least));
    out.push_back({page(from), page(to)});
  }

private:
  Vec3 image_of(ProfilePoint p) const {
    return sector_.to_page.of(project_homogeneous(sector_.view, p));
  }
  const Sector& sector_;
  EdgeEnds ends_;
};

// All visible lines that hide, and the section where the near plane cuts the ground.
std::vector<PageSegment> cutting_lines(const TerrainData& terrain, const PlacedView& placed,
                                       const Sector& sector, const SectorFound& pass,
                                       const SectorOnPage& on_page) {
  std::vector<PageSegment> out;
  for (const LinePart& part : pass.visible) {
    const EdgeLine& line = pass.pictures.line(part.line);
    if (!is_contour(line.kind))
      on_page.add(on_page.at(line, part.t_begin), on_page.at(line, part.t_end), out);
  }
  if (!sector.view.is_perspective()) return out;
  Profile cut;
  SurfaceCutter(terrain.surface, sector.view, placed.level.triangles, placed.for_cutters)
      .cut(sector.view.near_m, cut);
  for (std::uint32_t i = 0; i + 1 < cut.size(); ++i)
    if (cut.after[i] != Span::gap)
      on_page.add({cut.u_m[i], cut.depth_m, cut.z_m[i]},
                  {cut.u_m[i + 1], cut.depth_m, cut.z_m[i + 1]}, out);
  return out;
}

// Places where visible parts of contours end though the contour goes on.
std::vector<ProfilePoint> cut_ends(const SectorFound& pass, const SectorOnPage& on_page) {
  struct Node {
    int all = 0, seen = 0; // pieces that meet there
  };
  std::map<std::pair<std::uint32_t, std::uint32_t>, Node> nodes; // by feature and number
  for (const GroundLine& piece : pass.lines.on_ground.lines)
    for (const std::uint32_t end : {piece.ends.from, piece.ends.to})
      ++nodes[{piece.feature, end}].all;
  const auto for_each_end = [&](const auto& take) {
    for (const LinePart& part : pass.visible) {
      if (!is_contour(pass.pictures.line(part.line).kind)) continue;
      const GroundLine& piece = piece_of(pass.lines, part.line);
      for (const auto& [t, is_at, end] :
           {std::tuple{part.t_begin, part.t_begin <= kRounding, piece.ends.from},
            {part.t_end, part.t_end >= 1 - kRounding, piece.ends.to}})
        take(part, t, is_at ? &nodes[{piece.feature, end}] : nullptr);
    }
  };
  for_each_end([](const LinePart&, double, Node* node) { node ? void(++node->seen) : void(); });
  std::vector<ProfilePoint> out;
  for_each_end([&](const LinePart& part, double t, const Node* node) {
    if (!node || (node->seen == 1 && node->all > 1))
      out.push_back(on_page.at(pass.pictures.line(part.line), t));
  });
  return out;
}

struct Ends {
  std::uint64_t all = 0, far = 0,
                beside_borders = 0; // farther than 1e-6 mm from what cuts them off
  double greatest_mm = 0;
};

Ends ends_of_scenes(double tolerance_mm) {
  Ends ends;
  for (std::uint64_t seed = 1; seed <= kScenes; ++seed) {
    Random random(seed);
    const RandomScene scene = with_contours(seed, tolerance_mm, random);
    INFO("seed " << seed << ": " << scene.what);
    std::optional<PlacedView> placed = placed_if_any(scene.terrain, scene.spec);
    if (!placed) continue;
    const Style& style = scene.spec.style;
    const Instruments instruments{.hidden_ground = true, .order_always = seed % 4 == 1};
    HiddenKinds contours; // whose hidden parts are asked for are listed
    contours.add(LineKind::contour);
    const LinesOfView lines =
        lines_of_view(scene.terrain, *placed, style, instruments, nullptr, contours);
    for (const Sector& sector : placed->sectors) {
      const SectorFound pass(scene.terrain, *placed, sector, lines, style, instruments);
      const SectorOnPage on_page(scene.terrain.surface, sector, lines.on_ground.points);
      const std::vector<PageSegment> cutting =
          cutting_lines(scene.terrain, *placed, sector, pass, on_page);
      const View& view = sector.view;
      const double nearest_m = std::max(view.near_m, view.drawn_from_m);
      // Beside the end of a border there is nothing: what is lower is hidden up to there.
      std::vector<ProfilePoint> border;
      for (const EdgeLine& line : lines.listed)
        if (line.kind == LineKind::border || line.kind == LineKind::void_edge)
          for (const double t : {0.0, 1.0})
            if (const ProfilePoint p = on_page.at(line, t);
                !view.is_perspective() || p.v > view.near_m)
              border.push_back(p);
      for (const ProfilePoint at : cut_ends(pass, on_page)) {
        if (view.is_perspective() && at.v <= nearest_m * (1 + kRounding)) continue;
        if (!on_page.has_page(at)) continue;
        const Vec2 page = on_page.page(at), plane = project(view, at);
        const auto& [low, high] = placed->frame_mm;
        if (!(page.x > low.x && page.x < high.x && page.y > low.y && page.y < high.y)) continue;
        if (std::ranges::any_of(border, [&](ProfilePoint p) {
              const Vec2 end = project(view, p);
              return p.v < at.v && std::abs(end.x - plane.x) <= kRounding && end.y > plane.y;
            })) {
          ++ends.beside_borders;
          continue;
        }
        double nearest_mm = std::numeric_limits<double>::infinity();
        for (const PageSegment& segment : cutting)
          nearest_mm = std::min(nearest_mm, distance_mm(page, segment));
        INFO("ends at " << page.x << ", " << page.y << ", " << at.v << " m away");
        // Lines that are tied may end anywhere within the tolerance.
        CHECK(nearest_mm <= std::max(1e-6, tolerance_mm));
        ends.greatest_mm = std::max(ends.greatest_mm, nearest_mm);
        ends.far += nearest_mm > 1e-6 ? 1 : 0;
        ++ends.all;
      }
    }
  }
  WARN(ends.all << " ends, at most " << ends.greatest_mm << " mm from what cuts them off, "
                << ends.far << " of them farther than 1e-6 mm; " << ends.beside_borders
                << " straight below the end of a border");
  return ends;
}

} // namespace

TEST_CASE("contours that a silhouette cuts off end on it") {
  const Ends exact = ends_of_scenes(0), tied = ends_of_scenes(Style{}.visibility_tolerance_mm);
  for (const Ends& ends : {exact, tied}) {
    CHECK(ends.all > 20 * kScenes);
    CHECK(ends.beside_borders < ends.all / 100);
  }
  CHECK(exact.far <= exact.all / 1000);
  CHECK(tied.far <=
        tied.all / 100); // within the tolerance, where a contour runs along a silhouette
}

} // namespace orograph::contour_ends_test
